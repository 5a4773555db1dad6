# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks what the program itself has written.

results.py h5md FILE REVISION      every item of H5MD 1.1 in the results of test_h5md.c
results.py reader FILE             MDAnalysis reads that file's numbers, where it is installed
results.py verdicts FILE...        JSON of test_commands.c
"""
import json
import sys

sys.dont_write_bytecode = True  # of the module beside this one

import h5py
import numpy as np

from trajectory import PARTICLES, element, fixed_text

# The scenario of test_h5md.c: a sheet of 4 x 3 and a chain of 5, 10 steps, every fourth recorded.
SHEET, CHAIN = 12, 5
COUNT = SHEET + CHAIN
STEPS = [0, 4, 8, 10]


def metadata(file):
    """Root level: the group h5md, and nothing that the specification does not name."""
    assert set(file) == {"h5md", "particles", "connectivity", "observables", "parameters"}
    version = file["h5md"].attrs["version"]
    assert version.dtype.kind == "i" and version.tolist() == [1, 1]
    fixed_text(file["h5md/author"], "name")
    fixed_text(file["h5md/creator"], "name", "fretwork")
    fixed_text(file["h5md/creator"], "version")


def box(group):
    dimension = group.attrs.get_id("dimension")
    assert dimension.shape == () and dimension.dtype.kind == "i"
    assert group.attrs["dimension"] == 3, "readers insist on three"
    boundary = group.attrs.get_id("boundary")
    assert boundary.shape == (3,)
    assert h5py.check_string_dtype(boundary.dtype).length is not None
    assert [text.decode() for text in group.attrs["boundary"]] == ["none"] * 3
    assert "edges" not in group, "needless without periodic boundaries"


def start():
    """Where the particles of both bodies lie at first: row by row, as the scenario says."""
    sheet = [(2 + i, 3 + j) for j in range(3) for i in range(4)]
    chain = [(10 + 0.5 * i, 4) for i in range(5)]
    return np.array(sheet + chain, float)


def particles(file):
    group = file[PARTICLES]
    box(group["box"])
    for name in ("position", "velocity", "force"):
        element(group[name], len(STEPS), (COUNT, 3))
        assert not group[f"{name}/value"][:, :, 2].any(), "two dimensions"
    element(group["energy"], len(STEPS), (COUNT,))
    fixed_text(group["energy"], "meaning")
    assert group["position/step"][:].tolist() == STEPS
    assert group["position/time"][:].tolist() == STEPS, "one unit of time is one step"
    assert np.array_equal(group["position/value"][0, :, :2], start())
    velocity = group["velocity/value"][0, :, :2]
    assert np.allclose(velocity[:SHEET], (0.1, -0.05), rtol=0, atol=1e-15)
    assert np.allclose(velocity[SHEET:], 0, rtol=0, atol=1e-15)
    assert group["species"].shape == (COUNT,) and group["species"].dtype.kind == "i"
    assert group["species"][:].tolist() == [0] * SHEET + [1] * CHAIN
    names = group["species"].attrs["bodies"]
    assert [name.decode() for name in names] == ["sheet", "chain"]
    assert group["id"].dtype.kind == "i" and group["id"][:].tolist() == list(range(COUNT))
    # M = (M0^2 + K)/2 with K links; the chain has M0 = 1.
    chain = [(1 + links) / 2 for links in (1, 2, 2, 2, 1)]
    sheet = [(2 + (0 < i < 3) + (j == 1)) / 2 for j in range(3) for i in range(4)]
    assert np.allclose(group["mass"][:], sheet + chain, rtol=1e-15)
    assert "image" not in group and "charge" not in group


def connectivity(file):
    links = file["connectivity/links"]
    assert links.dtype.kind == "i" and links.shape == (17 + 4, 2)
    assert file[links.attrs["particles_group"]] == file[PARTICLES], "object reference"
    pairs = links[:]
    place = start()
    length = np.hypot(*(place[pairs[:, 1]] - place[pairs[:, 0]]).T)
    spacing = np.where(pairs[:, 0] < SHEET, 1, 0.5)
    assert np.array_equal(length, spacing), "neighbours in the lattice"
    assert len({tuple(sorted(pair)) for pair in pairs.tolist()}) == len(pairs), "each once"


def observables(file):
    rows = 11
    group = file["parameters/series"]
    assert set(group) >= {"energy", "momentum", "centre-of-mass.sheet", "centre-of-mass.chain"}
    assert set(file["observables"]) == set(group)
    for name, observable in file["observables"].items():
        element(observable, len(STEPS), group[f"{name}/value"].shape[1:])
        assert observable["step"] == file[f"{PARTICLES}/position/step"], "a row per frame"
        assert np.array_equal(observable["value"][:], group[f"{name}/value"][:][STEPS])
        fixed_text(observable, "meaning")
        fixed_text(observable["value"], "unit")
    element(group["energy"], rows, ())
    for name in ("momentum", "centre-of-mass.sheet"):
        element(group[name], rows, (2,))
    for observable in group.values():
        assert observable["step"][:].tolist() == list(range(rows))
        assert observable["time"][:].tolist() == list(range(rows))
        fixed_text(observable, "meaning")
        fixed_text(observable["value"], "unit")
    mass = file[f"{PARTICLES}/mass"][:SHEET]
    place = file[f"{PARTICLES}/position/value"][:, :SHEET, :2]
    middle = (mass[:, None] * place).sum(axis=1) / mass.sum()
    found = group["centre-of-mass.sheet/value"][:][STEPS]
    assert np.allclose(found, middle, rtol=0, atol=1e-13), "of the positions in the same file"


def parameters(file, revision):
    group = file["parameters"]
    assert "reduced" in group.attrs["units"].decode()
    assert "reduced" in file[PARTICLES].attrs["units"].decode()
    scenario = group["scenario"][()].decode()
    assert "steps: 10" in scenario and "seed: 42" in scenario, "as it was run, after --seed"
    assert group["title"][()].decode() == "a sheet beside a chain"
    assert group["seed"][()] == 42
    assert group["frames_committed"][()] == len(STEPS) and group["samples_committed"][()] == 11
    provenance = group["provenance"]
    assert provenance["threads"][()] == 2 and provenance["resumed"][()] == 0
    texts = {name: item[()].decode() for name, item in provenance.items() if item.dtype.kind == "S"}
    assert texts.pop("forms") == "sheet: displacements\nchain: displacements\n"
    assert set(texts) == {"program", "version", "revision", "compiler", "flags", "instructions", "libraries",
                          "host", "start", "end", "exit_reason"}
    assert texts["revision"] == revision and texts["exit_reason"] == "finished"
    assert texts["start"] <= texts["end"] and texts["start"].endswith("Z")
    for library in ("HDF5 ", "GSL ", "Box2D ", "libyaml ", "cairo "):
        assert library in texts["libraries"], texts


def h5md(path, revision):
    with h5py.File(path, "r") as file:
        metadata(file)
        particles(file)
        connectivity(file)
        observables(file)
        parameters(file, revision)


def reader(path):
    try:
        import MDAnalysis
    except ImportError:
        print("no MDAnalysis here: file not read with it")
        return
    # Units are reduced, so MDAnalysis must not convert any. It keeps single precision.
    universe = MDAnalysis.Universe.empty(COUNT, trajectory=True)
    universe.load_new(path, format="H5MD", convert_units=False)
    assert len(universe.trajectory) == len(STEPS)
    with h5py.File(path, "r") as file:
        group = file[PARTICLES]
        for k, moment in enumerate(universe.trajectory):
            assert moment.time == STEPS[k] and moment.data["step"] == STEPS[k]
            for name, found in (("position", moment.positions), ("velocity", moment.velocities),
                                ("force", moment.forces)):
                wanted = group[f"{name}/value"][k].astype(np.float32)
                assert np.array_equal(found, wanted), (k, name)
            for name, observable in file["observables"].items():
                assert np.array_equal(moment.data[name], observable["value"][k]), (k, name)
            assert moment.dimensions is None, "no box"


def verdicts(paths):
    for path in paths:
        with open(path, encoding="utf-8") as file:
            found = json.load(file)
        assert found["program"] == "fretwork" and found["version"] and found["revision"]
        assert found["expectations"] == 9 and found["failed"] == 2
        judged, damping = found["experiments"]
        assert judged["experiment"] == "judged" and damping["experiment"] == "damping"
        assert judged["title"] == 'a "falling" particle' and judged["source"] == "K\u00f6rper"
        assert judged["seconds"] >= 0 and len(damping["expectations"]) == 5
        assert all(verdict["holds"] for verdict in damping["expectations"])
        place, relative, bounds, ratio = judged["expectations"]
        assert place == {
            "quantity": "position.speck[0,0] x, at the end", "expected": "2.5 +- 0.25",
            "value": 2.5, "tolerance": 0.25, "above": None, "below": None, "measured": 2.0,
            "holds": False, "source": None, "note": None}
        assert relative["tolerance"] == 0.01 * 0.0625 and relative["holds"]
        assert (relative["source"], relative["note"]) == ("half", "so")
        assert bounds["value"] is None and bounds["tolerance"] is None
        assert (bounds["above"], bounds["below"]) == (0.01, 1) and bounds["holds"]
        assert ratio["measured"] is None and ratio["holds"] is False, "not a number"


if __name__ == "__main__":
    job, *arguments = sys.argv[1:]
    if job == "h5md":
        h5md(*arguments)
    elif job == "reader":
        reader(*arguments)
    elif job == "verdicts":
        verdicts(arguments)
    else:
        sys.exit(f"no job {job}")
