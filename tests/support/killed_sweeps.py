# SPDX-License-Identifier: GPL-3.0-or-later
"""killed_sweeps.py PROGRAM FOLDER ENGINE KILLS SEED

Runs a sweep of 40 short cases by an engine and kills it at random moments, so many times: the
master, a worker, or all of them at once; then it starts it again. In the end tables and datasets
are, byte for byte, those of a sweep that nobody disturbed. Engines: jobs-1, jobs-2 (`fretwork run
-j`), parallel (GNU parallel), slurm (an array of a cluster that is there: see
tests/manual/slurm-cluster).
"""
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import h5py

SCENARIO = """
title: a gas of few particles
parameters: {T: 1, mu: 1}
materials: {grain: {movable-particles: {return-force: {amplitude: 0}}}}
dynamics: {time-step: 0.005, damping: mu, temperature: T}
bodies: {gas: {material: grain, lattice: square, spacing: 3, shape: {rectangle: [4, 4]}}}
run: {steps: 4000, record-every: 500, checkpoint-every: 250}
study:
  seeds: 2
  sweep:
    parameters:
      T: {from: 0.1, to: 1, count: 10, unit: energy}
      mu: {values: [0.5, 1, 2, 4]}
expect:
  - {quantity: temperature, statistic: mean, above: 0}
  - {quantity: temperature, statistic: mean, trend: rises, along: T}
"""
CASES = 40
OWN = ("parameters/provenance", "parameters/seal")  # of each run
TABLES = ("sweep.csv", "sweep-seeds.csv", "sweep.h5", "sweep-as-run.yaml")


def contents(path):
    """Bytes of all datasets but those that tell of the run itself."""
    found = {}
    with h5py.File(path, "r") as file:
        def keep(name, item):
            if isinstance(item, h5py.Dataset) and not name.startswith(OWN):
                value = item[()]
                found[name] = value if isinstance(value, bytes) else value.tobytes()
        file.visititems(keep)
    return found


class Engine:
    """Starts all cases; `living` are the processes that it has now, its own master first."""

    def __init__(self, program, folder):
        self.program, self.folder = program, Path(folder)
        self.part = self.folder / "part"

    def prepare(self):
        self.listed = subprocess.run(
            [self.program, "sweep", self.folder / "gas.yaml", "-o", self.part, "--list"],
            check=True, capture_output=True, text=True).stdout
        lines = self.listed.replace("fretwork ", f"{self.program} ", 1 << 20).splitlines()
        self.cases = self.folder / "cases"
        self.cases.write_text("".join(f"{line} -q\n" for line in lines))
        assert len(lines) == CASES

    def spawn(self, *command, **more):
        return subprocess.Popen([str(word) for word in command], start_new_session=True,
                                stdout=subprocess.DEVNULL,
                                stderr=open(self.folder / "said", "a"), **more)

    def workers(self):
        """Processes of this sweep, whoever is their parent now."""
        found = []
        for entry in Path("/proc").iterdir():
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0") if entry.name.isdigit() else []
            except OSError:
                continue
            if words and words[0] == self.program.encode() and str(self.part).encode() in words:
                found.append(int(entry.name))
        return found

    def finish(self, process):
        process.wait()


class Jobs(Engine):
    def __init__(self, count, *rest):
        super().__init__(*rest)
        self.count = count

    def start(self):
        verb = "resume" if (self.part / "sweep-as-run.yaml").exists() else "run"
        words = [self.part] if verb == "resume" else [self.folder / "gas.yaml", "-o", self.part]
        return self.spawn(self.program, verb, *words, "-q", "--no-plot", "-j", self.count)

    def prepare(self):
        pass


class Parallel(Engine):
    def start(self):
        return self.spawn("parallel", "-j", "2", stdin=open(self.cases))


class Slurm(Engine):
    """The master is `sbatch --wait`; its array is cancelled, hard, when the master is killed."""
    SCRIPT = '#!/bin/sh\nsed -n "${SLURM_ARRAY_TASK_ID}p" cases | sh\n'

    def start(self):
        (self.folder / "cases.sh").write_text(self.SCRIPT)
        return self.spawn("sbatch", "--wait", "--parsable", "--job-name", "killed-sweep",
                          "--output", "/dev/null", f"--array=1-{CASES}", "cases.sh",
                          cwd=self.folder)

    def cancel(self):
        subprocess.run(["scancel", "--signal=KILL", "--full", "--name", "killed-sweep"])
        subprocess.run(["scancel", "--name", "killed-sweep"])


def kill(number):
    try:
        os.kill(number, signal.SIGKILL)
        return True
    except ProcessLookupError:
        return False


class Killer:
    def __init__(self, engine, seed):
        self.engine, self.random = engine, random.Random(seed)
        self.count = dict.fromkeys(("master", "worker", "all"), 0)
        self.kills = 0

    def finished(self):
        return sum(1 for _ in self.engine.part.glob("*/summary.csv"))

    def strike(self, process, longest):
        """One kill, of what is alive then; the others go on or are left alone."""
        time.sleep(self.random.uniform(0.01, longest))
        kinds = ("master",) if isinstance(self.engine, Jobs) else ("worker", "master", "worker", "all")
        what = self.random.choice(kinds)
        if process.poll() is not None:
            return
        workers = self.engine.workers()
        if what == "worker" and process.pid not in workers and workers:
            self.kills += kill(self.random.choice(workers))
        elif what == "master":
            self.kills += kill(process.pid)
        else:
            os.killpg(process.pid, signal.SIGKILL)
            for number in self.engine.workers():
                kill(number)
            self.kills += 1
        self.count[what] += 1
        # One whose master lives goes on to the next case; a second strike may follow.
        if what != "worker":
            if isinstance(self.engine, Slurm):
                self.engine.cancel()
            process.wait()

    def run(self, kills, duration):
        process = None
        before = []
        while self.kills < kills:
            # Too late for the kills that are left: from the beginning.
            if self.finished() == CASES:
                if process.poll() is None:
                    process.wait()
                shutil.rmtree(self.engine.part)
                self.engine.prepare()
            if process is None or process.poll() is not None:
                process = self.engine.start()
            self.strike(process, duration / 6)
            before.append(self.finished())
        if process.poll() is None:
            process.wait()
        # Workers that were left behind have their cases until they are done.
        for _ in range(20):
            self.engine.start().wait()
            while self.engine.workers():
                time.sleep(0.05)
            if self.finished() == CASES:
                break
        self.engine.start().wait()
        return before


def check(whole, part):
    for name in TABLES:
        assert (whole / name).read_bytes() == (part / name).read_bytes(), name
    folders = sorted(path.name for path in whole.iterdir() if path.is_dir())
    assert folders == sorted(path.name for path in part.iterdir() if path.is_dir())
    assert len(folders) == CASES
    for name in folders:
        one, other = whole / name, part / name
        assert (one / "summary.csv").read_bytes() == (other / "summary.csv").read_bytes(), name
        assert contents(one / "trajectory.h5") == contents(other / "trajectory.h5"), name
    assert not list(part.rglob("taken"))


def main(program, folder, engine, kills, seed):
    folder = Path(folder)
    (folder / "gas.yaml").write_text(SCENARIO)
    begin = time.monotonic()
    subprocess.run([program, "run", folder / "gas.yaml", "-o", folder / "whole", "-q", "--no-plot"],
                   check=True, stdout=subprocess.DEVNULL)
    duration = time.monotonic() - begin
    made = {"jobs-1": lambda: Jobs(1, program, folder), "jobs-2": lambda: Jobs(2, program, folder),
            "parallel": lambda: Parallel(program, folder),
            "slurm": lambda: Slurm(program, folder)}[engine]()
    made.prepare()
    killer = Killer(made, int(seed))
    before = killer.run(int(kills), duration)
    if not isinstance(made, Jobs):
        subprocess.run([program, "collect", folder / "part", "--no-plot"], check=True,
                       stdout=subprocess.DEVNULL)
    check(folder / "whole", folder / "part")
    kinds = ", ".join(f"{count} of {what}" for what, count in killer.count.items())
    print(f"{engine}: {killer.kills} kills ({kinds}); cases finished at each: "
          f"{' '.join(str(number) for number in before)}; the same bytes")
    # They came while there was work to do.
    assert sum(1 for number in before if number < CASES) * 2 >= int(kills), before


if __name__ == "__main__":
    main(*sys.argv[1:])
