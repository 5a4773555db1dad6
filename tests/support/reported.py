# SPDX-License-Identifier: GPL-3.0-or-later
"""reported.py PAGE FOLDER [BREAK-AT] - the page asks nothing of anybody, its markup is its own, and its player shows the
places, fields, forces and curves of FOLDER/trajectory.h5 as closely as its grid and its shades are. BREAK-AT: its links
break in the first frame in which they are stretched by more, against the first of all."""

import base64
import html.parser
import json
import re
import sys

import h5py
import numpy

GRID, SHADES = 65535, 254
page, folder = open(sys.argv[1], encoding="utf-8").read(), sys.argv[2]


class Elements(html.parser.HTMLParser):
    found, links = [], []

    def handle_starttag(self, tag, attributes):
        self.found.append(tag)
        self.links += [value for name, value in attributes if name in ("src", "href")]


def fail(sentence):
    sys.exit(f"{sys.argv[1]}: {sentence}")


def numbers(kind, text):
    return numpy.frombuffer(base64.b64decode(text), kind)


def near(what, found, wanted, within):
    error = numpy.nanmax(numpy.abs(numpy.asarray(found) - wanted))
    if not error <= within:
        fail(f"{what} differs by {error:g}, expected at most {within:g}")


elements = Elements()
elements.feed(page)
if sorted(set(elements.found)) != sorted(["html", "head", "meta", "title", "style", "body", "noscript", "main", "script"]):
    fail(f"has the elements {sorted(set(elements.found))}")
if elements.found.count("script") != 2 or elements.links:
    fail("has scripts or links of somebody else")
if "default-src 'none'" not in page or re.search(r"https?://(?!www\.w3\.org)", page.split('id="facts"')[0]):
    fail("may ask others")
facts = json.loads(re.search(r'id="facts">(.*?)</script>', page, re.S).group(1))
run = facts["runs"][0]
motion, results = run["motion"], h5py.File(f"{folder}/trajectory.h5", "r")
group = results["particles/trajectory"]
every, frames, stride = motion["every"], len(motion["steps"]), motion["stride"]
shown = numpy.concatenate([numpy.flatnonzero(group["body"][()] == b)[::stride]
                           for b in range(len(motion["bodies"]))])
if [body["count"] for body in motion["bodies"]] != [
        len(numpy.flatnonzero(group["body"][()] == b)[::stride]) for b in range(len(motion["bodies"]))]:
    fail("has other bodies")
if motion["steps"] != group["position/step"][::every].tolist():
    fail("has other frames")
low, high = numpy.array(motion["box"][::2]), numpy.array(motion["box"][1::2])
places = numbers("<u2", motion["places"]).reshape(frames, -1, 2) * (high - low) / GRID + low
near("places", places, group["position/value"][::every][:, shown, :2], (high - low).max() / GRID)
for field in motion["fields"]:
    key = field["name"].replace(" ", "-")
    values = numpy.clip(group[key]["value"][::every][:, shown], field["low"], field["high"])
    shades = numbers("u1", field["shades"]).reshape(frames, -1).astype(float)
    shades[shades > SHADES] = numpy.nan
    if not numpy.array_equal(numpy.isnan(shades), numpy.isnan(values)):
        fail(f"shows {key} where there is none, or none where it is")
    near(key, field["low"] + shades * (field["high"] - field["low"]) / SHADES, values,
         (field["high"] - field["low"]) / SHADES)
if "force" in group:
    near("forces", numbers("<f4", motion["forces"]).reshape(frames, -1, 2),
         group["force/value"][::every][:, shown, :2], 1e-6)
if stride == 1 and "connectivity/links" in results:
    found = numbers("<i4", motion["links"]).reshape(-1, 3)[:, :2]
    if sorted(map(tuple, found)) != sorted(map(tuple, results["connectivity/links"][()])):
        fail("has links between others")
if len(sys.argv) > 3:
    where, links = group["position/value"][::every, :, :2], results["connectivity/links"][()]
    across = where[:, links[:, 1]] - where[:, links[:, 0]]
    broken = numpy.linalg.norm(across - across[0], axis=2) > float(sys.argv[3])
    first = numpy.where(broken.any(axis=0), broken.argmax(axis=0), 2**31 - 1)
    wanted = numpy.column_stack([links, first])
    found = numbers("<i4", motion["links"]).reshape(-1, 3)
    if sorted(map(tuple, found)) != sorted(map(tuple, wanted)) or not 0 < broken[-1].sum() < len(links):
        fail("breaks other links")
by = int(numpy.ceil(len(results["parameters/series/energy/value"]) / len(run["sampled"])))
curve = next(curve for curve in run["curves"] if curve["name"] == "energy")
energy = results["parameters/series/energy/value"]
said = energy.attrs.get("physical", b"1 energy").decode().split()  # "0.2 eV"
if curve["unit"] != said[1]:
    fail(f"has an energy in {curve['unit']}")
wanted = energy[::by] * float(said[0])
near("energy", numbers("<f4", curve["values"]), wanted, 1e-6 * abs(wanted).max())
