# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes files that are not results, or no longer, out of a right one.

foreign_files.py RIGHT FOLDER [KIND]    one .h5 file for each kind of damage:
  damages   that is seen when the file is opened (the default)
  parts     of one part: the file is opened, and that part refused
  rows      where a run that was killed would go on
  oddities  that are none: all else is read
"""
import shutil
import sys

import h5py
import numpy as np

from trajectory import seal

PARTICLES = "particles/trajectory"


def replace(file, path, data):
    attributes = dict(file[path].attrs) if path in file else {}
    del file[path]
    file[path] = data
    for name, content in attributes.items():
        file[path].attrs[name] = content


def set_value(path, data):
    return lambda file: file[path].__setitem__((), data)


def new_data(path, data):
    return lambda file: replace(file, path, data)


def without(path):
    return lambda file: file.__delitem__(path)


def other_creator(file):
    del file["h5md/creator"].attrs["name"]
    file["h5md/creator"].attrs["name"] = np.bytes_("somebody")


def variable_creator(file):
    del file["h5md/creator"].attrs["name"]
    file["h5md/creator"].attrs["name"] = "fretwork"


def other_bodies(file):
    del file[f"{PARTICLES}/species"].attrs["bodies"]
    file[f"{PARTICLES}/species"].attrs["bodies"] = np.array([b"one"])


def huge_species(file):
    """Claims a billion particles without storing them."""
    del file[f"{PARTICLES}/species"]
    file.create_dataset(f"{PARTICLES}/species", (1_000_000_000,), np.int32, chunks=(1_000_000,))


def huge_links(file):
    del file["connectivity/links"]
    file.create_dataset("connectivity/links", (500_000_000, 2), np.int32, chunks=(1_000_000, 2))


def escape_in_body(file):
    del file[f"{PARTICLES}/species"].attrs["bodies"]
    file[f"{PARTICLES}/species"].attrs["bodies"] = np.array([b"one", b"t\x1b[31mwo"])


def escape_in_meaning(file):
    del file[f"{PARTICLES}/strain"].attrs["meaning"]
    file[f"{PARTICLES}/strain"].attrs["meaning"] = np.bytes_("elongation\x1b[31m of the links")


def attribute(path, name, data):
    return lambda file: file[path].attrs.__setitem__(name, data)


def hollow(path, shape, chunks):
    """Claims many numbers without storing them."""
    def damage(file):
        del file[path]
        file.create_dataset(path, shape, np.float64, chunks=chunks)
    return damage


def crowd(file):
    """More members of a group than anybody looks at."""
    for n in range(1100):
        file.create_group(f"{PARTICLES}/member{n}")


ENERGY = "parameters/series/energy"
DAMAGES = {
    "escape-in-unit": attribute(f"{PARTICLES}/strain", "unit", np.bytes_("\x7f")),
    "escape-in-physical": attribute(f"{PARTICLES}/strain", "physical",
                                    np.bytes_("\x9b31m".encode())),
    "escape-in-unit-of-energy": attribute(f"{ENERGY}/value", "unit", np.bytes_("\x1b")),
    "escape-in-physical-energy": attribute(f"{ENERGY}/value", "physical", np.bytes_("\x1b")),
    "escape-in-meaning-of-energy": attribute(ENERGY, "meaning", np.bytes_("\x1b")),
    "escape-in-time": attribute("observables", "time", np.bytes_("\x1b")),
    "row-of-frames": new_data("parameters/frames_committed", np.full(1, 40)),
    "row-of-seals": new_data("parameters/seal", np.zeros(1, np.int64)),
    "seal-of-halves": new_data("parameters/seal", np.zeros((), np.float64)),
    "seal-in-words": new_data("parameters/seal", np.bytes_("none")),
    "species-in-words": new_data(f"{PARTICLES}/species", np.bytes_("one")),
    "plane-species": new_data(f"{PARTICLES}/species", np.zeros((8, 1), np.int32)),
    "species-of-halves": new_data(f"{PARTICLES}/species", np.zeros(8)),
    "negative-species": set_value(f"{PARTICLES}/species", np.full(8, -1)),
    "links-in-words": new_data("connectivity/links", np.bytes_("none")),
    "links-of-halves": new_data("connectivity/links", np.zeros((5, 2))),
    "flat-links": new_data("connectivity/links", np.zeros(10, np.int32)),
    "position-in-words": new_data(f"{PARTICLES}/position/value", np.bytes_("none")),
    "title-of-variable-length": new_data("parameters/title", "a run"),
    "row-of-titles": new_data("parameters/title", np.array([b"one", b"two"])),
    "short-species": new_data(f"{PARTICLES}/species", np.zeros(8, np.int16)),
    "species-of-bytes": new_data(f"{PARTICLES}/species", np.zeros(8, np.uint8)),
    "species-of-pairs": new_data(f"{PARTICLES}/species", np.zeros(8, "i4,i4")),
    "position-of-five-ranks": new_data(f"{PARTICLES}/position/value", np.zeros((40, 8, 3, 1, 1))),
    "bodies-in-numbers": attribute(f"{PARTICLES}/species", "bodies", np.zeros(2)),
    "no-series": without("parameters/series"),
    "integral-observable": new_data(f"{ENERGY}/value", np.zeros(300, np.int32)),
    "cubic-observable": new_data(f"{ENERGY}/value", np.zeros((300, 2, 2))),
    "observable-without-components": new_data(f"{ENERGY}/value", np.zeros((300, 0))),
    "escape-in-body": escape_in_body,
    "escape-in-meaning": escape_in_meaning,
    "escape-in-observable": lambda file: file.move("parameters/series/energy",
                                                   "parameters/series/e\x1b[2J"),
    "no-metadata": without("h5md"),
    "other-creator": other_creator,
    "creator-of-variable-length": variable_creator,
    "no-particles": without("particles"),
    "no-position": without(f"{PARTICLES}/position"),
    "no-position-value": without(f"{PARTICLES}/position/value"),
    "flat-position": new_data(f"{PARTICLES}/position/value", np.zeros((40, 24))),
    "plane-position": new_data(f"{PARTICLES}/position/value", np.zeros((40, 8, 2))),
    "short-position": new_data(f"{PARTICLES}/position/value", np.zeros((39, 8, 3))),
    "single-precision": new_data(f"{PARTICLES}/position/value", np.zeros((40, 8, 3), np.float32)),
    "other-count": new_data(f"{PARTICLES}/position/value", np.zeros((40, 9, 3))),
    "too-many-frames": set_value("parameters/frames_committed", 41),
    "negative-frames": set_value("parameters/frames_committed", -1),
    "endless-frames": set_value("parameters/frames_committed", 2**62),
    "too-many-samples": set_value("parameters/samples_committed", 301),
    "negative-samples": set_value("parameters/samples_committed", -2**63),
    "frames-in-words": new_data("parameters/frames_committed", np.bytes_("forty")),
    "no-frames": without("parameters/frames_committed"),
    "no-scenario": without("parameters/scenario"),
    "scenario-of-numbers": new_data("parameters/scenario", np.zeros(3)),
    "no-provenance": without("parameters/provenance"),
    "no-species": without(f"{PARTICLES}/species"),
    "empty-species": new_data(f"{PARTICLES}/species", np.zeros(0, np.int32)),
    "species-from-one": set_value(f"{PARTICLES}/species", np.arange(1, 9)),
    "species-mixed": set_value(f"{PARTICLES}/species", [0, 1, 0, 1, 0, 1, 0, 1]),
    "species-too-large": set_value(f"{PARTICLES}/species", [0] * 7 + [2**31 - 1]),
    "species-without-names": lambda file: file[f"{PARTICLES}/species"].attrs.__delitem__("bodies"),
    "other-bodies": other_bodies,
    "huge-species": huge_species,
    "huge-links": huge_links,
    "links-beyond": set_value("connectivity/links", np.full((5, 2), 8)),
    "negative-links": set_value("connectivity/links", np.full((5, 2), -1)),
    "triple-links": new_data("connectivity/links", np.zeros((5, 3), np.int32)),
    "empty-observable": lambda file: file["parameters/series"].create_group("temperature"),
    "short-observable": new_data("parameters/series/energy/value", np.zeros(299)),
    "no-seal": without("parameters/seal"),
    "observable-in-words": new_data("parameters/series/energy/value", np.bytes_("none")),
}

TABLE = "parameters/analysis/map/growth"
LIST = "parameters/profile/edges"
PARTS = {
    "table-of-integers": new_data(TABLE, np.zeros(3, np.int32)),
    "table-in-words": new_data(TABLE, np.bytes_("none")),
    "cubic-table": new_data(TABLE, np.zeros((2, 2, 2))),
    "single-table": new_data(TABLE, np.float64(1)),
    "hollow-table": hollow(TABLE, (100_000_000,), (1_000_000,)),
    "long-table": hollow(TABLE, (2**31,), (1_000_000,)),
    "wide-table": hollow(TABLE, (1, 2**31), (1, 1_000_000)),
    "list-of-integers": new_data(LIST, np.zeros(4, np.int32)),
    "list-in-words": new_data(LIST, np.bytes_("none")),
    "cubic-list": new_data(LIST, np.zeros((4, 1, 1))),
    "single-list": new_data(LIST, np.float64(1)),
    "wide-list": new_data(LIST, np.zeros((4, 2))),
    "short-list": new_data(LIST, np.zeros(3)),
    "hollow-list": hollow(LIST, (100_000_000,), (1_000_000,)),
    "long-list": hollow(LIST, (2**31,), (1_000_000,)),
    "no-list": without(LIST),
    "no-sample-steps": without(f"{ENERGY}/step"),
    "sample-times-in-words": new_data(f"{ENERGY}/time", np.bytes_("none")),
    "few-frame-times": new_data(f"{PARTICLES}/position/time", np.zeros(39)),
    "integral-mass": new_data(f"{PARTICLES}/mass", np.zeros(8, np.int32)),
}
ROWS = {
    "no-position": without(f"{PARTICLES}/position"),
    "position-in-words": new_data(f"{PARTICLES}/position/value", np.bytes_("none")),
    "flat-position": new_data(f"{PARTICLES}/position/value", np.zeros((40, 24))),
    "plane-position": new_data(f"{PARTICLES}/position/value", np.zeros((40, 8, 2))),
    "position-of-integers": new_data(f"{PARTICLES}/position/value", np.zeros((40, 8, 3), np.int64)),
    "short-velocity": new_data(f"{PARTICLES}/velocity/value", np.zeros((39, 8, 3))),
    "no-steps": without(f"{PARTICLES}/position/step"),
    "steps-in-words": new_data(f"{PARTICLES}/position/step", np.bytes_("none")),
    "steps-of-halves": new_data(f"{PARTICLES}/position/step", np.zeros(40)),
    "few-steps": new_data(f"{PARTICLES}/position/step", np.zeros(39, np.int64)),
    "plane-of-steps": new_data(f"{PARTICLES}/position/step", np.zeros((40, 1), np.int64)),
    "few-times": new_data(f"{PARTICLES}/position/time", np.zeros(39)),
    "integral-times": new_data(f"{PARTICLES}/position/time", np.zeros(40, np.int64)),
    "species-of-halves": new_data(f"{PARTICLES}/species", np.zeros(8)),
    "plane-species": new_data(f"{PARTICLES}/species", np.zeros((8, 1), np.int32)),
    "no-reason": without("parameters/provenance/exit_reason"),
}
ODDITIES = {
    "name-of-hundreds": lambda file: file[PARTICLES].create_group("x" * 300),
    "escape-in-field": lambda file: file.move(f"{PARTICLES}/strain", f"{PARTICLES}/str\x1bain"),
    "other-letters": attribute(f"{PARTICLES}/strain", "unit",
                               np.bytes_("\u00b5m \u00a0\u00c0".encode())),
    "crowd": crowd,
}

if __name__ == "__main__":
    right, folder = sys.argv[1:3]
    kinds = {"damages": DAMAGES, "parts": PARTS, "rows": ROWS, "oddities": ODDITIES}
    for name, damage in kinds[sys.argv[3] if len(sys.argv) > 3 else "damages"].items():
        path = f"{folder}/{name}.h5"
        shutil.copy(right, path)
        with h5py.File(path, "r+") as file:
            damage(file)
            sealed = "seal" not in name
        if sealed:
            seal(path)
