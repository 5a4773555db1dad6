# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes files that are not results, or no longer, out of a right one.

foreign_files.py RIGHT FOLDER    one .h5 file for each kind of damage
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


DAMAGES = {
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

if __name__ == "__main__":
    right, folder = sys.argv[1:]
    for name, damage in DAMAGES.items():
        path = f"{folder}/{name}.h5"
        shutil.copy(right, path)
        with h5py.File(path, "r+") as file:
            damage(file)
            sealed = "parameters/seal" in file
        if sealed:
            seal(path)
