# SPDX-License-Identifier: GPL-3.0-or-later
"""test_python.py PROGRAM: the module fretwork gives the numbers of the program's results, bit by
bit; its arrays are the memory of the simulation, and are good as long as they are held."""

import gc
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import fretwork
import h5py
import numpy

PROGRAM = sys.argv.pop(1)
GAS = """\
title: a gas
materials: {gas: {movable-particles: {strength: 0.1}}}
bodies:
  left: {material: gas, lattice: hexagonal, shape: {rectangle: [5, 5]}, temperature: 1}
  right: {material: gas, lattice: hexagonal, shape: {rectangle: [4, 4]}, origin: [9, 0]}
walls: {box: {box: [-3, -3, 20, 9]}}
dynamics: {time-step: 0.01, damping: 1, temperature: 0.5}
run: {steps: 50, record-every: 4, measure-every: 3, seed: 7}
"""


def same(a, b):
    """Every bit."""
    return numpy.array_equal(numpy.ascontiguousarray(a).view("u8"), numpy.ascontiguousarray(b).view("u8"))


class Numbers(unittest.TestCase):
    def compare(self, name, settings=()):
        """A frame of the results at a time."""
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "out")
            given = [word for setting in settings for word in ("--set", setting)]
            # What is expected does not matter here.
            subprocess.run([PROGRAM, "run", name, "-o", out, "--no-plot", "--quiet", *given],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
            with h5py.File(os.path.join(out, "trajectory.h5")) as file:
                self.compare_with(file, fretwork.Simulation(name, settings=settings), settings)

    def compare_with(self, file, simulation, settings):
        group = file["particles/trajectory"]
        steps = group["position/step"][:]
        every = int(steps[1] - steps[0])
        fields = [key for key in simulation_fields(simulation) if key in group]
        count = 0
        for frame, now in enumerate(simulation.frames(every)):
            self.assertEqual(now.step, steps[frame])
            first = 0
            for body in now.bodies.values():
                part = slice(first, first + len(body))
                first += len(body)
                self.assertTrue(same(group["position/value"][frame, part, :2], body.positions))
                self.assertTrue(same(group["velocity/value"][frame, part, :2], body.velocities))
                if "force" in group:
                    self.assertTrue(same(group["force/value"][frame, part, :2], body.forces))
                for name in fields:
                    if name in body.field_names:
                        self.assertTrue(same(group[name]["value"][frame, part], body.field(name)), name)
            count += 1
        self.assertEqual(count, len(steps))
        # All samples stand side by side; those of a frame again as observables.
        samples = file["parameters/series"]
        for name in simulation.series_names:
            series = simulation.series(name)
            self.assertTrue(same(samples[name]["value"][:], series.values), name)
            self.assertTrue(numpy.array_equal(samples[name]["step"][:], series.steps))
            self.assertTrue(same(samples[name]["time"][:], series.times))

    def test_boltzmann(self):
        self.compare("sheet-collision")

    def test_automaton(self):
        self.compare("automaton-tension", ["run.record-every=500"])

    def test_particles_that_share_a_solid(self):
        self.compare("particle-collision", ["run.record-every=500"])

    def test_linear_lattice_with_settings(self):
        self.compare("translate", ["run.record-every=100"])


def simulation_fields(simulation):
    return sorted({name for body in simulation.bodies.values() for name in body.field_names})


class Memory(unittest.TestCase):
    def test_arrays_are_windows(self):
        simulation = fretwork.Simulation(text=GAS)
        body = simulation.bodies["left"]
        positions = body.positions
        before = positions.copy()
        self.assertEqual(positions.shape, (25, 2))
        self.assertEqual(positions.__array_interface__["data"], body.positions.__array_interface__["data"])
        simulation.advance(5)
        self.assertFalse(numpy.array_equal(positions, before))
        with self.assertRaises(ValueError):
            simulation.advance(-1)
        with self.assertRaises(ValueError):
            positions[0, 0] = 1
        with self.assertRaises(ValueError):
            positions.flags.writeable = True

    def test_arrays_keep_what_they_show(self):
        simulation = fretwork.Simulation(text=GAS)
        simulation.run()
        body = simulation.bodies["right"]
        held = [body.positions, body.velocities, body.forces, body.field("local-order"),
                simulation.series("energy").values, body.positions[::2, 0]]
        kept = [array.copy() for array in held]
        simulation.close()
        del simulation, body
        gc.collect()
        # What was freed would be used again.
        others = [fretwork.Simulation(text=GAS, settings={"run.seed": n}) for n in range(20)]
        for other in others:
            other.run()
        for array, copy in zip(held, kept):
            self.assertTrue(same(array, copy))

    def test_memory_goes_with_the_last_array(self):
        gone = []
        destroy = fretwork._library.fw_simulation_destroy

        class Watched:
            def __call__(self, handle):
                gone.append(handle)
                destroy(handle)

        fretwork._library.fw_simulation_destroy = Watched()
        try:
            simulation = fretwork.Simulation(text=GAS)
            part = simulation.bodies["left"].positions[3:5]
            del simulation
            gc.collect()
            self.assertEqual(gone, [])
            del part
            gc.collect()
            self.assertEqual(len(gone), 1)
        finally:
            fretwork._library.fw_simulation_destroy = destroy


class Running(unittest.TestCase):
    def test_whoever_looks_is_called_and_may_say_enough(self):
        seen = []
        simulation = fretwork.Simulation(text=GAS)
        simulation.run(lambda now: seen.append(now.step), every=20)
        self.assertEqual(seen, [0, 20, 40, 50])
        simulation = fretwork.Simulation(text=GAS)
        simulation.run(lambda now: numpy.less(now.step, 20), every=10)
        self.assertEqual((simulation.step, simulation.at_end), (20, False))
        simulation.run()
        self.assertTrue(simulation.at_end)

    def test_settings_are_values_of_python(self):
        simulation = fretwork.Simulation(text=GAS, settings={
            "run.steps": numpy.int64(8), "bodies.left.velocity": [numpy.float64(0.5), 0],
            "title": "another", "bodies.left.temperature": 0})
        self.assertEqual((simulation.step_count, simulation.title), (8, "another"))
        self.assertEqual(simulation.bodies["left"].velocities[3].tolist(), [0.5, 0])

    def test_exceptions_of_the_caller_come_through(self):
        simulation = fretwork.Simulation(text=GAS)
        with self.assertRaises(KeyError):
            simulation.run(lambda now: {}["nothing"])
        self.assertEqual(simulation.step, 0)
        with self.assertRaises(ValueError):
            list(simulation.frames(0))

    def test_refusals_are_the_sentences_of_the_program(self):
        for given, kind, sentence in [
            ({"scenario": "wall-bonce"}, fretwork.BadInput, "did you mean 'wall-bounce'?"),
            ({"text": "title: x\nbodis: {}\n"}, ValueError, "scenario:2:1: unknown key 'bodis'"),
            ({"text": GAS, "settings": {"run.stepz": 3}}, fretwork.BadInput, "--set run.stepz=3"),
            ({"scenario": "friction-sweep"}, fretwork.BadInput, "such as A=0"),
            ({}, fretwork.BadInput, "without a scenario"),
        ]:
            with self.assertRaises(kind) as caught:
                fretwork.Simulation(**given)
            self.assertIn(sentence, str(caught.exception))
            self.assertEqual(caught.exception.status, 2)
        simulation = fretwork.Simulation(text=GAS)
        for attempt in (lambda: simulation.measure("enrgy"), lambda: simulation.series("enrgy"),
                        lambda: simulation.bodies["left"].field("enrgy")):
            with self.assertRaises(fretwork.BadInput) as caught:
                attempt()
            self.assertIn("enrgy", str(caught.exception))
        simulation.close()
        with self.assertRaises(fretwork.FretworkError) as caught:
            simulation.advance()
        self.assertIn("interrupted after 0 of 50 steps", str(caught.exception))

    def test_a_run_that_diverges_says_so(self):
        simulation = fretwork.Simulation(text="""\
title: torn
materials: {dust: {lattice-boltzmann: {rest-mass: 1}}}
bodies: {one: {material: dust, shape: {rectangle: [1, 1]}}}
forces: {pull: {body: one, force: [1e6, 0]}}
run: {steps: 1000, record-every: 10}
""")
        with self.assertRaises(fretwork.Diverged):
            simulation.run()
        self.assertGreater(simulation.bodies["one"].positions[0, 0], 1e6)

    def test_results_are_written_and_resumed(self):
        with tempfile.TemporaryDirectory() as folder:
            file, out, whole = (os.path.join(folder, name) for name in ("gas.yaml", "out", "whole"))
            with open(file, "w", encoding="utf-8") as text:
                text.write(GAS)
            with fretwork.Simulation(file, directory=out, threads=2) as simulation:
                simulation.advance(30)
            for words in (["resume", out], ["run", file, "-o", whole]):
                subprocess.run([PROGRAM, *words, "--no-plot", "--quiet"], check=True,
                               stdout=subprocess.DEVNULL)
            with h5py.File(os.path.join(out, "trajectory.h5")) as one, \
                    h5py.File(os.path.join(whole, "trajectory.h5")) as other:
                path = "particles/trajectory/position/value"
                self.assertTrue(same(one[path][:], other[path][:]))

    def test_threads_run_side_by_side(self):
        alone = fretwork.Simulation(text=GAS)
        alone.run()
        made = [fretwork.Simulation(text=GAS) for _ in range(4)]
        threads = [threading.Thread(target=simulation.run) for simulation in made]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for simulation in made:
            self.assertTrue(same(alone.bodies["left"].positions, simulation.bodies["left"].positions))


if __name__ == "__main__":
    unittest.main()
