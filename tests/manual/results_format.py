# SPDX-License-Identifier: GPL-3.0-or-later
"""results_format.py PROGRAM PAGE: the manual's tables of datasets and columns against real results.

Every dataset of some runs is named in the page, and everything that the page names is found in one
of them. Exit code 77, skipped, where there is no h5py.
"""
import csv
import re
import subprocess
import sys
import tempfile

try:
    import h5py
except ImportError:
    print("python3 cannot import h5py: not run")
    sys.exit(77)

CRYSTALS = """
title: crystals
materials: {m: {movable-particles: {return-force: {amplitude: 1, axes: lab}}}}
bodies:
  left: {material: m, lattice: hexagonal, shape: {rectangle: [6, 6]}, origin: [-6.5, 0]}
  right: {material: m, lattice: hexagonal, shape: {rectangle: [6, 6]}, origin: [0.5, 0]}
dynamics: {damping: 0.3, temperature: 0.01}
grips:
  left: {body: left, side: left, layer: 1.1, force: [2, 0], tether: [0, 1]}
  right: {body: right, side: right, layer: 1.1, force: [-2, 0], tether: [0, 1]}
run: {steps: 400, record-every: 100, measure-every: 20}
record: {force: true, fields: [return-force]}
profile: {axis: x, every: 100, far: [2, 4]}
study: {seeds: 2, control: ['grips.left.force=[1, 0]']}
expect: [{quantity: layer-contact, above: 0}]
"""
NAMED = {"FIELD", "ITEM", "NAME", "OF", "COLUMN", "MEASURE", "ARRAY"}


def rows_after(page, heading):
    """The rows of the first table behind a line of the page, as lists of cells."""
    lines = page[page.index(heading):].split("\n")
    first = next(n for n, line in enumerate(lines) if line.startswith("|"))
    rows = []
    for line in lines[first + 2:]:
        if not line.startswith("|"):
            break
        rows.append([cell.strip() for cell in line.strip("|").split("|")])
    return rows


def names_of(cell):
    """Full names in a cell: `a/b/c`, `d` names a/b/d as well."""
    names = []
    for name in re.findall(r"`([^`]*)`", cell):
        if names and "/" not in name:
            name = names[-1].rsplit("/", 1)[0] + "/" + name
        elif name.startswith(".../"):
            name = names[0].rsplit("/", 1)[0] + name[3:]
        names.append(name)
    return names


def pattern_of(name):
    parts = re.split("(" + "|".join(sorted(NAMED, key=len, reverse=True)) + ")", name)
    return re.compile("".join("[^/]+" if part in NAMED else re.escape(part) for part in parts))


def datasets_of(path):
    found = set()

    def visit(group, name):
        for key, item in group.items():
            if isinstance(item, h5py.Dataset):
                found.add(name + key)
            else:
                visit(item, name + key + "/")

    with h5py.File(path) as file:
        visit(file, "")
    return found


program, page_path = sys.argv[1:]
with open(page_path, encoding="utf-8") as file:
    page = file.read()
with tempfile.TemporaryDirectory() as folder:

    def run(*words):
        subprocess.run([program, "run", *words, "--no-plot"], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    with open(f"{folder}/crystals.yaml", "w", encoding="utf-8") as file:
        file.write(CRYSTALS)
    run("crystals.yaml", "-o", "crystals")
    run("chain", "-o", "chain")
    run("stability-map", "-o", "map", "--set", "analysis.map.stability-map.points=[5,5]")
    found = set().union(*(datasets_of(f"{folder}/{name}/trajectory.h5")
                          for name in ("crystals", "chain", "map")))
    with open(f"{folder}/crystals/profile.csv", encoding="utf-8") as file:
        columns = next(csv.reader(file))[2::4]
    with open(f"{folder}/crystals/layer.csv", encoding="utf-8") as file:
        measures = next(csv.reader(file))
    with open(f"{folder}/crystals/summary.csv", encoding="utf-8") as file:
        summary = next(csv.reader(file))

names = []
for row in rows_after(page, "## trajectory.h5"):
    if "attribute" in row[0]:
        continue
    if row[0].startswith("`.../"):  # steps and times, of what the row above names
        base = names[-1].rsplit("/", 1)[0]
        names += [f"{base}/{name[4:]}" for name in re.findall(r"`([^`]*)`", row[0])]
    else:
        names += names_of(row[0])
faults = [f"the page does not name {dataset}" for dataset in sorted(found)
          if not any(pattern_of(name).fullmatch(dataset) for name in names)
          and not re.fullmatch(r"(particles/trajectory|observables|parameters/series)/[^/]+/(step|time)", dataset)]
faults += [f"no result has {name}" for name in names
           if not any(pattern_of(name).fullmatch(dataset) for dataset in found)]
told = [names_of(row[0])[0] for row in rows_after(page, "Quantities of `profile.csv`")]
if told != columns:
    faults.append(f"profile.csv has {columns}, the page {told}")
if measures[:2] != ["seed", "run"]:
    faults.append(f"layer.csv begins with {measures[:2]}")
if summary[:5] != ["quantity", "expected", "mean", "standard error", "verdict"]:
    faults.append(f"summary.csv begins with {summary[:5]}")
for fault in faults:
    print(fault)
print(f"{len(found)} datasets, {len(names)} names, {len(faults)} faults")
sys.exit(bool(faults))
