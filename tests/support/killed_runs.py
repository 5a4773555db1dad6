# SPDX-License-Identifier: GPL-3.0-or-later
"""killed_runs.py PROGRAM FOLDER KILLS SEED

Kills `fretwork run` and `fretwork resume` at random moments, so many times in all. Whenever it
does, h5py must find every committed frame and sample as the run that was let be has them; and in
the end a resumed run must leave datasets of the same bytes.
"""
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import h5py

# Some tenths of a second: noise, friction, breaking links, frames and checkpoints at odds.
SCENARIO = """
title: a bar is shaken to pieces on a rough floor
materials: {glass: {lattice-boltzmann: {rest-mass: 0.6, damping: 0.01, break-at: 0.6}}}
bodies: {bar: {material: glass, shape: {rectangle: [40, 5]}, origin: [0, 0.2], velocity: [0.1, -0.02]}}
walls: {floor: {chain: [[-500, 0], [500, 0]], surface: {coulomb: 0.4}}}
forces:
  shaking: {body: bar, random: 0.1}
  weight: {body: bar, acceleration: [0, -0.002]}
measure: [energy, momentum, reaction, friction-heat, broken-links]
record: {velocity: true, force: true, fields: [energy]}
run: {steps: 2500, record-every: 17, measure-every: 3, checkpoint-every: 11, seed: 3}
"""
PROVENANCE = "parameters/provenance"
OWN = (PROVENANCE, "parameters/seal")  # of each run


def datasets(path):
    found = {}
    with h5py.File(path, "r") as file:
        def keep(name, item):
            if isinstance(item, h5py.Dataset) and not name.startswith(OWN):
                found[name] = item[()]
        file.visititems(keep)
    return found


class Killer:
    def __init__(self, program, folder, seed):
        self.program, self.folder = program, Path(folder)
        self.random = random.Random(seed)
        self.scenario = self.folder / "bar.yaml"
        self.scenario.write_text(SCENARIO)
        self.part = self.folder / "part"
        self.count = dict.fromkeys(("unborn", "begun", "running", "torn", "finished"), 0)
        self.kills = self.frames = 0
        begin = time.monotonic()
        assert self.start("run", self.scenario, "-o", self.folder / "whole").wait() == 0
        self.duration = time.monotonic() - begin
        self.whole = datasets(self.folder / "whole/trajectory.h5")
        assert self.whole["parameters/series/broken-links.bar/value"][-1] > 10
        assert self.whole["parameters/series/friction-heat/value"][-1] > 0

    def start(self, command, *words):
        threads = self.random.choice("12")
        return subprocess.Popen(
            [self.program, command, *words, "--quiet", "--no-plot", "--threads", threads],
            stdout=subprocess.DEVNULL, stderr=open(self.folder / "said", "w"))

    def said(self):
        return (self.folder / "said").read_text()

    def strike(self, process):
        """Kills it at a random moment; now and then while it is busy with an orderly end."""
        time.sleep(self.random.uniform(0, self.duration))
        if self.random.random() < 0.2:
            process.send_signal(signal.SIGTERM)
            time.sleep(self.random.uniform(0, 0.02))
        process.kill()
        code = process.wait()
        self.kills += code < 0
        return code

    def ended(self, code):
        """Did the run reach its end, now or before? Everything but its death needs a reason."""
        assert code < 0 or code in (0, 143) or "is finished" in self.said(), (code, self.said())
        return code in (0, 2)

    def check(self):
        """Whatever counts is right; returns whether there is anything to resume."""
        path = self.part / "trajectory.h5"
        if not path.exists():
            self.count["unborn"] += 1
            return False
        if (self.part / "trajectory.h5.cutting").exists():
            self.count["torn"] += 1
            return True
        with h5py.File(path, "r") as file:
            frames = int(file["parameters/frames_committed"][()])
            samples = int(file["parameters/samples_committed"][()])
            reason = file[f"{PROVENANCE}/exit_reason"][()].decode()
            def compare(name, item):
                if not isinstance(item, h5py.Dataset) or not item.chunks:
                    return
                rows = frames if name.startswith(("particles", "observables")) else samples
                wanted = self.whole[name][:rows]
                assert item[:rows].tobytes() == wanted.tobytes(), (name, rows)
                self.compared += 1
            self.compared = 0
            file.visititems(compare)
            assert self.compared >= 10
        self.frames += frames
        state = "finished" if reason == "finished" else "running" if frames > 1 else "begun"
        self.count[state] += 1
        return True

    def resume(self):
        """To the end, unless it is killed again."""
        process = self.start("resume", self.part)
        return self.ended(self.strike(process) if self.random.random() < 0.5 else process.wait())

    def run_once(self):
        shutil.rmtree(self.part, ignore_errors=True)
        self.ended(self.strike(self.start("run", self.scenario, "-o", self.part)))
        while self.check():
            if self.resume():
                break
        else:
            code = self.start("resume", self.part).wait()
            assert code == 2, (code, self.said())
            assert "holds no results" in self.said() or "cannot open" in self.said(), self.said()
            assert self.start("run", self.scenario, "-o", self.part).wait() == 0, self.said()
        found = datasets(self.part / "trajectory.h5")
        assert found.keys() == self.whole.keys()
        for name, wanted in self.whole.items():
            same = found[name] == wanted if isinstance(wanted, bytes) else (
                found[name].dtype == wanted.dtype and found[name].tobytes() == wanted.tobytes())
            assert same, name


if __name__ == "__main__":
    program, folder, kills, seed = sys.argv[1:]
    killer = Killer(program, folder, int(seed))
    while killer.kills < int(kills):
        killer.run_once()
    states = ", ".join(f"{count} {state}" for state, count in killer.count.items())
    print(f"{killer.kills} kills (run of {killer.duration:.2f} s): {states}; "
          f"{killer.frames} frames read back")
    assert killer.count["running"] > int(kills) // 4 and killer.frames > 10 * int(kills)
