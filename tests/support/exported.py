# SPDX-License-Identifier: GPL-3.0-or-later
"""exported.py FOLDER NAME EVERY[,EVERY...] [AGAIN...] - FOLDER/NAME-EVERY.csv, .extxyz, .pvd and .xdmf, read by
standard means, hold every number of each EVERY-th frame of FOLDER/NAME/trajectory.h5, to the last bit, NAME-EVERY.data
those of its last frame; MDAnalysis reads the .extxyz, where it is installed. AGAIN: these results begin where those
end."""

import base64
import csv
import pathlib
import sys
import warnings
import xml.etree.ElementTree as xml

import h5py
import numpy

folder, name = pathlib.Path(sys.argv[1]), sys.argv[2]
every, stem, steps, times = 1, name, None, None  # of the files that are looked at
results = h5py.File(folder / name / "trajectory.h5", "r")
group = results["particles/trajectory"]
fields = [key for key, of in group.items() if "value" in of and of["value"].ndim == 2]
vectors = [key for key in ("position", "velocity", "force") if key in group]
bodies = list(group["body"].attrs["bodies"])
bodies = [body.decode() if isinstance(body, bytes) else body for body in bodies]


def value(key):
    return group[key]["value"][::every]


def same(what, found, wanted):
    found, wanted = numpy.asarray(found), numpy.asarray(wanted)
    if found.shape != wanted.shape or not numpy.array_equal(found, wanted, equal_nan=found.dtype.kind == "f"):
        sys.exit(f"{what} differs from the results file")


def check_csv():
    with open(folder / f"{stem}.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    count = len(group["id"])
    column = {key: numpy.array([float(row[key] or "nan") for row in rows]) for key in rows[0] if key != "body"}
    same("csv steps", column["step"], numpy.repeat(steps, count))
    same("csv times", column["time"], numpy.repeat(times, count))
    same("csv ids", column["id"], numpy.tile(group["id"][()], len(steps)))
    same("csv masses", column["mass"], numpy.tile(group["mass"][()], len(steps)))
    same("csv bodies", [row["body"] for row in rows],
         numpy.tile([bodies[b] for b in group["body"][()]], len(steps)))
    for key in vectors:
        prefix = "" if key == "position" else key + "-"
        for c, axis in enumerate("xy"):
            same(f"csv {key}", column[prefix + axis], value(key)[:, :, c].ravel())
    for key in fields:
        same(f"csv {key}", column[key], value(key).ravel())


def check_extxyz():
    path, columns = folder / f"{stem}.extxyz", {"position": "pos", "velocity": "velo", "force": "forces"}
    lines, at = path.read_text().splitlines(), 0
    for frame, (step, time) in enumerate(zip(steps, times)):
        count, head = int(lines[at]), lines[at + 1]
        part = head.split()[0].split("=")[1].split(":")
        widths = list(zip(part[::3], map(int, part[2::3])))
        table = numpy.array([line.split() for line in lines[at + 2:at + 2 + count]])
        at += 2 + count
        if f" step={step} " not in head or float(head.split(" time=")[1].split()[0]) != time:
            sys.exit(f"extxyz: frame {frame} is of another time: {head}")
        first, column = 0, {}
        for key, width in widths:
            column[key] = table[:, first:first + width]
            first += width
        for key in vectors:
            same(f"extxyz {key}", column[columns[key]].astype(float), value(key)[frame])
        for key in fields:
            same(f"extxyz {key}", column[key][:, 0].astype(float), value(key)[frame])
        same("extxyz masses", column["masses"][:, 0].astype(float), group["mass"][()])
        same("extxyz bodies", column["body"][:, 0].astype(int), group["body"][()])
    if at != len(lines):
        sys.exit("extxyz: lines are left")
    try:
        warnings.simplefilter("ignore")  # it guesses masses of elements that are none
        import MDAnalysis
    except ImportError:
        return
    universe = MDAnalysis.Universe(str(path), format="XYZ", topology_format="XYZ")
    found = numpy.array([frame.positions.copy() for frame in universe.trajectory])
    same("extxyz read by MDAnalysis", found, value("position").astype("f4"))


def check_data():
    sections, found, head = ("Masses", "Atoms", "Velocities"), {}, None
    for line in (folder / f"{stem}.data").read_text().splitlines()[1:]:
        words = line.split("#")[0].split()
        if words and words[0] in sections:
            head = words[0]
        elif words and head:
            found.setdefault(head, []).append([float(word) for word in words])
    atoms, count = numpy.array(found["Atoms"]), len(group["id"])
    same("data ids", atoms[:, 0], numpy.arange(1, count + 1))
    same("data types", atoms[:, 1], group["body"][()] + 1)
    same("data places", atoms[:, 2:], group["position/value"][-1])
    for mass_type, mass in found["Masses"]:
        same("data masses", group["mass"][()][group["body"][()] == mass_type - 1][0], mass)
    if "velocity" in group:
        same("data velocities", numpy.array(found["Velocities"])[:, 1:], group["velocity/value"][-1])


def check_again(again):
    again = h5py.File(folder / again / "trajectory.h5", "r")
    same("the start of the next run", again["particles/trajectory/position/value"][0], group["position/value"][-1])


def numbers(element):
    """Of an array of VTK: the number of bytes as one of 64 bits, then the bytes."""
    kind = {"Float64": "<f8", "Int64": "<i8"}[element.get("type")]
    data = base64.b64decode(element.text)
    if int.from_bytes(data[:8], "little") != len(data) - 8:
        sys.exit(f"vtp: {element.get('Name')} has {len(data) - 8} bytes")
    found = numpy.frombuffer(data[8:], kind)
    width = int(element.get("NumberOfComponents", "1"))
    return found.reshape(-1, width) if width > 1 else found


def check_vtp():
    sets = xml.parse(folder / f"{stem}.pvd").getroot().findall("./Collection/DataSet")
    same("pvd times", [float(of.get("timestep")) for of in sets], times)
    links = results["connectivity/links"][()] if "connectivity/links" in results else numpy.zeros((0, 2))
    for frame, of in enumerate(sets):
        piece = xml.parse(folder / of.get("file")).getroot().find("./PolyData/Piece")
        same("vtp points", numbers(piece.find("./Points/DataArray")), value("position")[frame])
        found = {array.get("Name"): numbers(array) for array in piece.findall("./PointData/DataArray")}
        for key in vectors[1:] + fields:
            same(f"vtp {key}", found[key], value(key)[frame])
        for key in ("mass", "id", "body"):
            same(f"vtp {key}", found[key], group[key][()])
        lines = {array.get("Name"): numbers(array) for array in piece.findall("./Lines/DataArray")}
        same("vtp lines", lines["connectivity"], links.ravel())
        same("vtp ends of lines", lines["offsets"], 2 * numpy.arange(1, len(links) + 1))


def slab(item):
    """What a data item of XDMF means."""
    inner = item.findall("DataItem")
    where = (inner[1] if inner else item).text
    file, path = where.rsplit(":", 1)
    with h5py.File(folder / file, "r") as told:
        data = told[path][()]
    extent = tuple(map(int, (inner[1] if inner else item).get("Dimensions").split()))
    if data.shape != extent:
        sys.exit(f"xdmf: {path} is said to be {extent}, and is {data.shape}")
    if inner:
        start, stride, count = numpy.array(inner[0].text.split(), int).reshape(3, -1)
        data = data[tuple(slice(s, s + n * by, by) for s, by, n in zip(start, stride, count))]
    return data.reshape(tuple(map(int, item.get("Dimensions").split())))


def check_xdmf():
    grids = xml.parse(folder / f"{stem}.xdmf").getroot().findall("./Domain/Grid/Grid")
    same("xdmf times", [float(grid.find("Time").get("Value")) for grid in grids], times)
    for frame, grid in enumerate(grids):
        same("xdmf positions", slab(grid.find("./Geometry/DataItem")), value("position")[frame])
        for attribute in grid.findall("Attribute"):
            key = attribute.get("Name")
            wanted = group[key][()] if isinstance(group[key], h5py.Dataset) else value(key)[frame]
            same(f"xdmf {key}", slab(attribute.find("DataItem")), wanted)
        links = grid.find("./Topology/DataItem")
        if links is not None:
            same("xdmf links", slab(links), results["connectivity/links"][()])


for every in map(int, sys.argv[3].split(",")):
    stem = f"{name}-{every}"
    steps, times = group["position/step"][::every], group["position/time"][::every]
    check_csv()
    check_extxyz()
    check_vtp()
    check_xdmf()
    check_data()
for further in sys.argv[4:]:
    check_again(further)
