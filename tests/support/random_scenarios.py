# SPDX-License-Identifier: GPL-3.0-or-later
"""random_scenarios.py PROGRAM FOLDER SECONDS SEED

Small scenarios of all solids with random keys of the schema and random values within their bounds
(`fretwork reference --json` says which). Of each:
- `check` accepts it if and only if `run` begins; else both say the same sentence with exit code 2,
  or 3 where the steps that `check` tries diverge;
- a run ends with 0 (all holds), 1 (an expectation failed) or 3 (the numbers diverged), never else;
- its books are closed: momentum, and energy where the solid keeps it to rounding;
- what `show` prints of it is read as the same, and is what the results hold.
"""
import json
import random
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

try:
    import h5py
except ImportError:
    h5py = None

SOLIDS = {
    "lattice-boltzmann": {"rest-mass": 0.5},
    "movable-particles": {"return-force": {"amplitude": 0.5}},
    "linear-lattice": {},
    "elastic-automaton": {"c1": 0.4, "c2": 0.2},
}
STEPS_MAX = 300
EXACT = ("lattice-boltzmann", "elastic-automaton")  # energy to rounding; the others to their order
NAMED = {"material": "materials", "body": "bodies", "grip": "grips", "wall": "walls",
         "phase": "phases", "time-from": "phases", "bodies": "bodies"}
DIVERGED, REFUSED = 3, 2


def base(random):
    solid = random.choice(list(SOLIDS))
    hot = solid in ("movable-particles", "linear-lattice")
    s = {"title": "random",
         "materials": {"m": {solid: json.loads(json.dumps(SOLIDS[solid]))}},
         "bodies": {"a": {"material": "m", "shape": {"rectangle": [5, 4]}, "origin": [3.3, 4.7],
                          "velocity": [0.02, -0.01]}},
         "run": {"steps": 60, "record-every": 20},
         "measure": ["energy-error", "momentum-error"]}
    if hot:
        s["bodies"]["a"]["lattice"] = "hexagonal"
    if random.random() < 0.5:
        s["walls"] = {"box": {"box": [0, 0, 30, 30]}}
    if random.random() < 0.3:
        s["forces"] = {"pull": {"body": "a", "sites": "right", "total": [0.01, 0]}}
    if random.random() < 0.3:
        s["grips"] = {"left": {"body": "a", "side": "left", "layer": 1, "force": [0.01, 0]}}
    if random.random() < 0.3 and not hot:
        s["bodies"]["b"] = {"material": "m", "shape": {"rectangle": [3, 3]}, "origin": [9.1, 4.2],
                            "velocity": [-0.05, 0]}
    if random.random() < 0.3:
        s["expect"] = [{"quantity": "energy", "below": random.choice((1e-9, 1e9))}]
    if random.random() < 0.3:
        s["phases"] = {"one": {"until": 30}, "two": {"until": 60}}
    return s


class Schema:
    def __init__(self, program):
        said = subprocess.run([program, "reference", "--json"], check=True, capture_output=True)
        self.keys = {key["path"]: key for key in json.loads(said.stdout)}
        said = subprocess.run([program, "quantities", "--json"], check=True, capture_output=True)
        self.quantities = [q["name"] for q in json.loads(said.stdout)["quantities"]]

    def below(self, path):
        """Keys of the mapping there."""
        depth = path.count(".") + 1 if path else 0
        start = path + "." if path else ""
        return [key for at, key in self.keys.items()
                if at.startswith(start) and at.count(".") == depth]


class Author:
    def __init__(self, schema, random):
        self.schema, self.random = schema, random

    def number(self, words, whole):
        bounds = dict(re.findall(r"(above|from|of at least|to below|to|at most) (-?[\d.e+-]+)",
                                 words))
        low = next((float(bounds[w]) for w in ("above", "from", "of at least") if w in bounds), None)
        high = next((float(bounds[w]) for w in ("to below", "to", "at most") if w in bounds), None)
        size = 10 ** self.random.uniform(-3, 1.5)
        if low is None:
            value = self.random.choice((-1, 0, 1, 1)) * size
        elif self.random.random() < 0.15 and "above" not in bounds:
            value = low
        else:
            value = low + size
        if high is not None and value > high:
            value = self.random.uniform(low or 0, high)
        if whole:
            return int(min(value, STEPS_MAX))
        value = float(f"{value:.4g}")
        # Now and then as a formula.
        return f"{value!r}*unit + 0" if self.formulas and self.random.random() < 0.2 else value

    def name(self, key, scenario):
        if key in ("quantity", "measure", "observables"):
            return self.random.choice(self.schema.quantities)
        there = list(scenario.get(NAMED.get(key, ""), {}))
        return self.random.choice(there) if there else "x"

    def value(self, path, key, words, scenario):
        choices = [c for c in re.split(r",? or (?=a |an |\[|one |names )", words)]
        form = self.random.choice(choices)
        if form.startswith("all, a side"):
            return self.random.choice(("all", "left", "top", [[0, 0]], [[1, 2], [2, 2]]))
        if form.startswith("one of "):
            return self.random.choice(form[len("one of "):].split(", "))
        if form.startswith("true or false") or words.startswith("true"):
            return self.random.random() < 0.5
        if form.startswith("a list of items, each "):
            inner = words[words.index("each ") + 5:]
            count = self.random.choice((1, 1, 2))
            return [self.value(path + ".N", key, inner, scenario) for _ in range(count)]
        if form.startswith("["):
            layout, _, bounds = form.partition("]")
            return [self.number(bounds, "whole" in bounds) for _ in layout.split(",")]
        if form.startswith("a mapping"):
            return self.mapping(path, scenario)
        if form.startswith("names of your own"):
            return {"new": self.mapping(path + ".NAME", scenario)}
        if form.startswith("names with a number each"):
            return {"unit": 1}
        if form.startswith(("a number", "an angle")):
            return self.number(form, False)
        if form.startswith("a whole number"):
            return self.number(form, True)
        if form.startswith("a name"):
            return self.name(key, scenario)
        return "words"

    def mapping(self, path, scenario):
        made = {}
        keys = self.schema.below(path)
        alternatives = [key for key in keys if key["alternative"]]
        chosen = self.random.choice(alternatives) if alternatives else None
        for key in keys:
            if not (key["required"] or key is chosen or
                    (not key["alternative"] and self.random.random() < 0.2)):
                continue
            made[key["key"]] = self.value(key["path"], key["key"], key["value"], scenario)
        return made

    def mappings(self, scenario):
        """Every mapping of the scenario whose keys the schema names, and the path of those."""
        def walk(path, node):
            if not isinstance(node, dict):
                return
            if self.schema.below(path):
                yield path, node
            for name, child in node.items():
                inner = f"{path}.{name}" if path else name
                if inner not in self.schema.keys:
                    inner = f"{path}.NAME"
                yield from walk(inner, child)
        return list(walk("", scenario))

    def write(self, scenario):
        self.formulas = self.random.random() < 0.3
        if self.formulas:
            scenario["parameters"] = {"unit": 1, "twice": "2*unit"}
        for _ in range(self.random.randint(1, 3)):
            path, node = self.random.choice(self.mappings(scenario))
            key = self.random.choice(self.schema.below(path))
            if key["path"] in ("study", "analysis", "parameters", "title", "measure", "materials",
                               "bodies"):
                continue
            if key["alternative"]:
                for other in self.schema.below(path):
                    if other["alternative"]:
                        node.pop(other["key"], None)
            node[key["key"]] = self.value(key["path"], key["key"], key["value"], scenario)
        # Small enough to be run: what is random here is how, not how long.
        run = scenario.get("run", {})
        if isinstance(run.get("steps"), (int, float)):
            run["steps"] = min(run["steps"], STEPS_MAX)
        return scenario


class Reader:
    def __init__(self, program, folder, seed):
        self.program, self.folder = program, Path(folder)
        self.random = random.Random(seed)
        self.schema = Schema(program)
        self.author = Author(self.schema, self.random)
        self.count = dict.fromkeys(("refused", "0", "1", "3", "too long"), 0)
        self.worst = {}

    def call(self, *words, seconds=20):
        return subprocess.run([self.program, *map(str, words)], cwd=self.folder,
                              capture_output=True, text=True, timeout=seconds)

    def sentence(self, done):
        lines = [line for line in done.stderr.splitlines() if line.startswith("fretwork: ")]
        return lines[-1] if lines else ""

    def books(self, solid):
        """Errors of the books over the whole run, as the program's own quantities have them."""
        if h5py is None:
            return
        with h5py.File(self.folder / "it/trajectory.h5", "r") as file:
            series = file["parameters/series"]
            for name in series:
                kind = name.split(".")[0]
                if kind not in ("energy-error", "momentum-error"):
                    continue
                if kind == "energy-error" and solid not in EXACT:
                    continue
                values = series[name]["value"][()]
                largest = float(abs(values).max()) if values.size else 0.0
                self.worst[solid, kind] = max(self.worst.get((solid, kind), 0), largest)
                assert largest < 1e-8, (name, largest)

    def kept(self, shown):
        if h5py is None:
            return
        with h5py.File(self.folder / "it/trajectory.h5", "r") as file:
            text = file["parameters/scenario"][()].decode()
        assert text == shown, (text, shown)

    def try_one(self):
        scenario = self.author.write(base(self.random))
        solid = next((s for s in SOLIDS if s in scenario["materials"]["m"]), "")
        (self.folder / "s.yaml").write_text(json.dumps(scenario, indent=1))
        setting = "title=shown"
        shutil.rmtree(self.folder / "it", ignore_errors=True)
        try:
            ran = self.call("run", "s.yaml", "-q", "--no-plot", "-o", "it", "--set", setting)
        except subprocess.TimeoutExpired:
            self.count["too long"] += 1
            return
        checked = self.call("check", "s.yaml", "--set", setting)
        assert checked.returncode in (0, REFUSED, DIVERGED), checked
        if ran.returncode == REFUSED:
            assert checked.returncode == REFUSED, ("check accepts, run refuses", ran.stderr)
            assert self.sentence(ran) == self.sentence(checked), (ran.stderr, checked.stderr)
            assert self.sentence(ran), ran
            assert not (self.folder / "it").exists()
            self.count["refused"] += 1
            return
        assert ran.returncode in (0, 1, DIVERGED), (ran.returncode, ran.stderr)
        assert checked.returncode != REFUSED, ("run begins, check refuses", checked.stderr)
        # It takes some of the steps: where these diverge, so does the run.
        assert checked.returncode == 0 or ran.returncode == DIVERGED, (checked, ran)
        self.count[str(ran.returncode)] += 1
        shown = self.call("show", "s.yaml", "--set", setting)
        assert shown.returncode == 0, shown.stderr
        (self.folder / "again.yaml").write_text(shown.stdout)
        again = self.call("show", "again.yaml", "--set", setting)
        assert again.stdout == shown.stdout, (shown.stdout, again.stdout, again.stderr)
        # What is outside of its limit from the beginning leaves no results.
        if ran.returncode != DIVERGED or (self.folder / "it/trajectory.h5").exists():
            self.kept(shown.stdout)
        if ran.returncode != DIVERGED:
            if scenario["materials"]["m"][solid].get("boundary") != "mirror":  # it keeps neither
                self.books(solid)
            table = self.call("table", "it")
            assert table.returncode == 0 and table.stdout.count("\n") > 3, table


def main(program, folder, seconds, seed):
    reader = Reader(program, folder, int(seed))
    end = time.monotonic() + float(seconds)
    tried = 0
    while time.monotonic() < end:
        tried += 1
        try:
            reader.try_one()
        except Exception:
            print(f"after {tried} scenarios from seed {seed}, this one:")
            print((reader.folder / "s.yaml").read_text())
            raise
    said = ", ".join(f"{count} {what}" for what, count in reader.count.items())
    worst = "; ".join(f"{s} {k} {v:.1e}" for (s, k), v in sorted(reader.worst.items()))
    print(f"{tried} scenarios: {said}; largest errors: {worst}")
    begun = reader.count["0"] + reader.count["1"] + reader.count["3"]
    assert begun * 8 > tried, "most are refused: nothing is tried"


if __name__ == "__main__":
    main(*sys.argv[1:])
