# SPDX-License-Identifier: GPL-3.0-or-later
"""plain_solids.py CATALOGUE - the elastic automaton and the LB solid in plain numpy, written from the
equations of the papers and not from the program: what experiments of the catalogue expect where there
is no closed form. Computes each number and holds it against the one that the experiment names."""
import sys
import numpy as np

EAST, NORTH, WEST, SOUTH = STEPS = [(1, 0), (0, 1), (-1, 0), (0, -1)]
failed = 0


def expect(what, found, value, within, *experiments):
    """`value` as the experiments write it: a number that is changed there must be changed here."""
    global failed
    files = (open(f'{sys.argv[1]}/{name}.yaml').read() for name in experiments)
    named = all(f'value: {value}' in file for file in files)
    holds = abs(found - float(value)) <= within
    print(f'{what}: {found:.10g}, expected {value} +- {within:g}', '' if holds else 'FAILS',
          '' if named else f'this is not what {experiments} expect')
    failed += not (holds and named)


def matrices(c1, c2):
    """B_i (Dong et al. Eqs 24, 29 to 31), with sigma = [[0, 1], [1, 0]]."""
    p0 = np.sqrt(max(0, 1 - c1**2 / 2))
    p1 = np.sqrt(max(0, 1 - c1**2 / 2 - c2**2 / 2))
    p, q = np.array([[p0, p1], [p1, p0]]), np.array([[p1, -p0], [-p0, p1]])
    along = np.diag([c1**2 + c2**2, c1**2]) + p @ p
    across = 4 * np.eye(2) - along
    return [(along + 2 * p) / 4, (across + 2 * q) / 4, (along - 2 * p) / 4, (across - 2 * q) / 4]


class Automaton:
    """6 x 6 cells 1.5 apart, black where i + j is odd, cell [2, 1] displaced by -0.3 along x."""

    def __init__(self, c1, c2, rule, wall=None):
        sites = [(i, j) for j in range(6) for i in range(6)]
        index = {site: n for n, site in enumerate(sites)}
        self.wall = wall
        self.rest = np.array([[6.25 + 1.5 * i, 6.25 + 1.5 * j] for i, j in sites])
        self.u = np.zeros((36, 2))
        self.u[index[2, 1]] = [-0.3, 0]
        self.black = [n for n, (i, j) in enumerate(sites) if (i + j) % 2]
        self.white = [n for n, (i, j) in enumerate(sites) if not (i + j) % 2]
        self.links = [[] for _ in sites]
        b = matrices(c1, c2)
        for n, (i, j) in enumerate(sites):
            for d, (di, dj) in enumerate(STEPS):
                m = b[d] if n in self.black else b[(d + 2) % 4]  # D_i = B_{i+2}
                beside = index.get((i + di, j + dj))
                if beside is None and rule == 'mirror':
                    beside = index[i - di, j - dj]
                along_edge = (i in (0, 5) and di == 0) or (j in (0, 5) and dj == 0)
                if rule == 'trapezoid' and along_edge:
                    m = m / 2
                if beside is not None:
                    self.links[n].append((beside, m))
        self.mass = [sum(m for _, m in links) / 2 for links in self.links]

    def half_step(self, cells):
        """b+ = -b + 2 (sum B)^-1 sum B_i w_i. Returns how many cells would pass the box [0, 20]^2."""
        fresh, met = self.u.copy(), 0
        for n in cells:
            pull = sum(m @ self.u[beside] for beside, m in self.links[n])
            u = np.linalg.solve(self.mass[n], pull) - self.u[n]
            out = np.array([self.wall is not None and not 0 <= x <= 20 for x in self.rest[n] + u])
            met += any(out)
            if self.wall == 'stick' and any(out):
                out[:] = True
            fresh[n] = np.where(out, self.u[n], u)
        self.u = fresh
        return met

    def step(self):
        return self.half_step(self.black) + self.half_step(self.white)

    def velocity(self):
        """V = 2 p over the mass of one colour, p = sum m w - sum m b."""
        white = sum(self.mass[n] @ self.u[n] for n in self.white)
        black = sum(self.mass[n] @ self.u[n] for n in self.black)
        return 2 * np.linalg.solve(sum(self.mass[n] for n in self.white), white - black)

    def energy(self):
        links = [(self.u[n] - self.u[k], m) for n in self.black for k, m in self.links[n]]
        return sum(d @ m @ d for d, m in links) / 2

    def growth(self):
        """The largest eigenvalue of the matrix of one step, in size."""
        columns = []
        for k in range(72):
            self.u = np.zeros((36, 2))
            self.u.flat[k] = 1
            self.step()
            columns.append(self.u.flatten())
        return max(abs(np.linalg.eigvals(np.array(columns).T)))


def drift(body, steps):
    start = body.u.mean(axis=0)
    for _ in range(steps):
        body.step()
    return body.u.mean(axis=0) - start


def bounce(body, steps=250):
    met = [step for step in range(1, steps + 1) if body.step()]
    return met[0], met[-1]


def automata():
    chopard, coupled, paper = (np.sqrt(2), 0), (0.4, 0.5), (0.4, 0.58)
    for name, speeds in ('chopard', chopard), ('coupled', coupled):
        body = Automaton(*speeds, 'bond')
        expect(f'{name}: velocity', body.velocity()[0], '0.04', 1e-12, 'translate')
        expect(f'{name}: energy', body.energy(), '0.09', 1e-13, 'translate', 'bounce', 'bounce-chopard')
        drift(body, 200)
        expect(f'{name}: velocity after 200 steps', body.velocity()[0], '0.04', 1e-12, 'translate')
        expect(f'{name}: energy after 200 steps', body.energy(), '0.09', 1e-12, 'translate')
    body = Automaton(*paper, 'mirror')
    expect('mirror: drift', drift(body, 10000)[0] / 10000, '0.0494', 1e-4, 'translate')

    body = Automaton(*chopard, 'bond', 'componentwise')  # of diagonal matrices: without friction
    first, last = bounce(body)
    expect('bounce-chopard: first wall step', first, '154', 0)
    expect('bounce-chopard: last wall step', last, '157', 0)
    expect('bounce-chopard: velocity', body.velocity()[0], '-0.0317024553', 1e-10, 'bounce-chopard')
    body = Automaton(*coupled, 'bond', 'stick')
    first, last = bounce(body)
    expect('bounce: first wall step', first, '151', 0)
    expect('bounce: last wall step', last, '169', 0)
    expect('bounce: velocity x', body.velocity()[0], '-0.0362765743', 1e-10, 'bounce')
    expect('bounce: velocity y', body.velocity()[1], '0.0185786962', 1e-10, 'bounce')
    body = Automaton(*paper, 'mirror', 'componentwise')
    rate = drift(body, 100)[0] / 100
    expect('bounce-as-printed: drift', rate, '0.05', 2e-3, 'bounce-as-printed')
    body = Automaton(*paper, 'mirror', 'componentwise')
    expect('bounce-as-printed: change of y', drift(body, 250)[1], '-1.6', 0.05, 'bounce-as-printed')
    bounce(body, 50)
    expect('bounce-as-printed: energy at 300 is above', min(body.energy(), 20), '20', 0)
    for speeds, rule, growth, within in ((paper, 'bond', '1.085', 5e-4), (coupled, 'bond', '1', 1e-5),
                                         (paper, 'trapezoid', '1.064', 5e-4), (paper, 'mirror', '1', 1e-5)):
        found = Automaton(*speeds, rule).growth()
        expect(f'{rule}, c2 = {speeds[1]}: growth', found, growth, within, 'stability-map')


class Sheets:
    """x of two sheets of 10 x 10 cells of Chopard's automaton, of which the left one flies at the right
    one, face to face. A step is solved as a whole: with d_b, d_w what black and white cells move in it,
    d_w follows d_b, and where the free path of a pair of opposite cells would cross, it has a force
    lambda >= 0 on either, with lambda (d_right - d_left) = 0."""

    def __init__(self, velocity, gap):
        grid = np.indices((10, 10))
        self.white = np.array([grid.sum(axis=0) % 2 == 1] * 2)  # body, i, j
        self.u = np.where(self.white, np.array([velocity, 0])[:, None, None] / 2, 0)
        self.gap = gap
        self.mass = self.pull(np.zeros_like(self.u), 1) / 2

    @staticmethod
    def pull(u, beside=None):
        """sum B (neighbour - self) with B = 1/2; or, of 0 beside 1, the sum of B."""
        other = u if beside is None else np.ones_like(u)
        out = np.zeros_like(u)
        out[:, 1:] += (other[:, :-1] - u[:, 1:]) / 2
        out[:, :-1] += (other[:, 1:] - u[:, :-1]) / 2
        out[:, :, 1:] += (other[:, :, :-1] - u[:, :, 1:]) / 2
        out[:, :, :-1] += (other[:, :, 1:] - u[:, :, :-1]) / 2
        return out

    def moved(self, force):
        u = self.u.copy()
        for cells in ~self.white, self.white:
            u += np.where(cells, (self.pull(u) + force) / self.mass, 0)
        return u

    def step(self):
        """Forces of the pairs one by one, until each does what it must."""
        force, rows = np.zeros_like(self.u), set()
        while True:
            u = self.moved(force)
            gap = self.gap + u[1, 0] - u[0, 9]
            missed = {j for j in range(10) if gap[j] < -1e-13} - rows
            if not missed:
                break
            rows |= missed
            for _ in range(2000):
                most = 0
                for j in rows:
                    d = self.moved(force) - self.u
                    more = -(d[1, 0, j] - d[0, 9, j]) / (1 / self.mass[1, 0, j] + 1 / self.mass[0, 9, j])
                    more = max(more, -force[1, 0, j])
                    force[1, 0, j] += more
                    force[0, 9, j] -= more
                    most = max(most, abs(more))
                if most < 1e-14:
                    break
        self.u = u

    def velocities(self):
        """V = 2 p over the mass of one colour, p = sum m w - sum m b."""
        signed = np.where(self.white, 1, -1) * self.mass * self.u
        return [2 * signed[n].sum() / self.mass[n][self.white[n]].sum() for n in (0, 1)]


def collision():
    sheets = Sheets(0.1, 0.551)
    for _ in range(40):
        sheets.step()
    left, right = sheets.velocities()
    expect('automaton-collision: velocity of the right one', right, '0.095956', 1e-6, 'automaton-collision')
    expect('automaton-collision: momentum', left + right, '0.1', 1e-12)


def sheet_along(axis, origin, velocity):
    """One component of Chopard & Marconi's solid with M0 = 0, 20 x 20, in the box [0, 60]: w = M^-1 Psi
    with M = K/2, and w = 0 where that would pass a wall. `field` is by the link that it came along:
    f_i(l + c_i) <- w_l - f_{i+2}(l). Yields momentum, mass and energy of each step."""
    linked = {s: np.ones((20, 20)) for s in STEPS}
    linked[EAST][-1, :] = linked[WEST][0, :] = linked[NORTH][:, -1] = linked[SOUTH][:, 0] = 0
    mass = sum(linked.values()) / 2
    place = origin + np.indices((20, 20))[axis]
    field = {s: velocity / 2 * linked[s] for s in STEPS}
    while True:
        w = sum(field.values()) / mass
        w[(place + w < 0) | (place + w > 60)] = 0
        place = place + w
        sent = {s: (w - field[s]) * linked[s] for s in STEPS}
        field = {(-s[0], -s[1]): np.roll(sent[s], s, (0, 1)) for s in STEPS}
        momentum = sum(f.sum() for f in field.values())
        yield momentum, mass.sum(), sum((f**2).sum() for f in field.values())


def sheet():
    steps = zip(sheet_along(0, 7.313, 0.05), sheet_along(1, 11.747, 0.031))
    for step, ((px, mass, ex), (py, _, ey)) in zip(range(1, 4001), steps):
        fraction = (px**2 + py**2) / (2 * mass) / (ex + ey)
        if step == 2000:
            expect('wall-bounce: kinetic fraction at 2000', fraction, '0.81', 0.01, 'wall-bounce')
        if step == 4000:
            expect('wall-bounce: kinetic fraction at 4000', fraction, '0.63', 0.05, 'wall-bounce')


automata()
collision()
sheet()
sys.exit(failed > 0)
