# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks a results file made by recorded_run.h through h5py.

trajectory.py h5md FILE FRAMES SAMPLES    every item of H5MD 1.1, extents cut to what counts
trajectory.py rows FILE...                every committed frame and sample against its formula
trajectory.py guarded FILE...             the same, of those that HDF5 does not refuse to open
trajectory.py structure BEFORE AFTER      two states of one file differ in raw data only
trajectory.py reader FILE                 MDAnalysis reads the same numbers, where it is installed
trajectory.py same REFERENCE FILE...      all datasets are equal, but for provenance and seal
"""
import sys

import h5py
import numpy as np

COUNT = 8
PARTICLES = "particles/trajectory"


def value(kind, rows, components):
    """run_value of recorded_run.h for all particles: [row][particle][component]."""
    row, particle, component = np.ix_(rows, np.arange(COUNT), np.arange(components))
    return row * 64.0 + particle + 0.25 * component + 4096.0 * kind


def equal(path, name, found, expected):
    """All rows, or what the first wrong one holds: the evidence goes with the file."""
    found, expected = np.asarray(found), np.asarray(expected)
    wrong = [k for k in range(len(expected)) if not np.array_equal(found[k], expected[k])]
    assert not wrong, (path, name, "rows", wrong, "of", len(expected), "first holds",
                       found[wrong[0]].tolist())


def rows(path):
    with h5py.File(path, "r") as file:
        frames = int(file["parameters/frames_committed"][()])
        samples = int(file["parameters/samples_committed"][()])
        k = np.arange(frames)
        for kind, name in enumerate(["position", "velocity", "force"]):
            group = file[f"{PARTICLES}/{name}"]
            expected = np.zeros((frames, COUNT, 3))
            expected[:, :, :2] = value(kind, k, 2)
            equal(path, name, group["value"][:frames], expected)
            equal(path, name + "/step", group["step"][:frames], 10 * k)
            equal(path, name + "/time", group["time"][:frames], 5.0 * k)
        strain = file[f"{PARTICLES}/strain/value"][:frames]
        equal(path, "strain", strain, value(3, k, 1)[:, :, 0])
        pull = file[f"{PARTICLES}/return-force/value"][:frames]
        equal(path, "return-force", pull[:, :5], value(4, k, 1)[:, :5, 0])
        equal(path, "no return-force", np.isnan(pull[:, 5:]), np.ones((frames, 3), bool))
        k = np.arange(samples)
        energy = file["parameters/series/energy/value"][:samples]
        equal(path, "energy", energy, value(5, k, 1)[:, 0, 0])
        momentum = file["parameters/series/momentum"]
        equal(path, "momentum", momentum["value"][:samples], value(6, k, 2)[:, 0, :])
        equal(path, "momentum/step", momentum["step"][:samples], k)
        equal(path, "momentum/time", momentum["time"][:samples], 0.5 * k)
        return frames, samples


def guarded(path):
    try:
        h5py.File(path, "r").close()
    except OSError:
        return
    rows(path)


def seal(path):
    """Gives a changed file the seal that fits: FNV-1a from the superblock to the seal."""
    with h5py.File(path, "r") as file:
        place = file["parameters/seal"].id.get_offset()
    with open(path, "r+b") as file:
        checksum = 14695981039346656037
        for byte in file.read(place)[48:]:
            checksum = (checksum ^ byte) * 1099511628211 % 2**64
        file.seek(place)
        file.write(checksum.to_bytes(8, "little"))


def fixed_text(holder, name, expected=None):
    """The specification wants strings of fixed length in scalar spaces."""
    attribute = holder.attrs.get_id(name)
    info = h5py.check_string_dtype(attribute.dtype)
    assert info is not None and info.length is not None, name
    assert attribute.shape == (), name
    text = holder.attrs[name]
    text = text.decode() if isinstance(text, bytes) else str(text)
    assert text and (expected is None or text == expected), (name, text)


def element(group, frames, tail):
    assert set(group) == {"value", "step", "time"}, group.name
    assert group["value"].shape == (frames, *tail), (group.name, group["value"].shape)
    assert group["value"].dtype == np.float64
    for name, kind in (("step", "i"), ("time", "f")):
        assert group[name].shape == (frames,) and group[name].dtype.kind == kind
        assert (np.diff(group[name][:]) > 0).all(), "monotonically increasing"


def h5md(path, frames, samples):
    with h5py.File(path, "r") as file:
        assert set(file) == {"h5md", "particles", "connectivity", "observables", "parameters"}
        version = file["h5md"].attrs["version"]
        assert version.dtype.kind == "i" and version.tolist() == [1, 1]
        fixed_text(file["h5md/author"], "name", "A. Person")
        fixed_text(file["h5md/creator"], "name", "fretwork")
        fixed_text(file["h5md/creator"], "version")

        group = file[PARTICLES]
        box = group["box"]
        dimension = box.attrs.get_id("dimension")
        assert dimension.shape == () and dimension.dtype.kind == "i"
        assert box.attrs["dimension"] == 3
        boundary = box.attrs.get_id("boundary")
        assert boundary.shape == (3,)
        assert h5py.check_string_dtype(boundary.dtype).length is not None
        assert [text.decode() for text in box.attrs["boundary"]] == ["none"] * 3
        assert "edges" not in box, "needless without periodic boundaries"
        for name in ("position", "velocity", "force"):
            element(group[name], frames, (COUNT, 3))
        for name in ("strain", "return-force"):
            element(group[name], frames, (COUNT,))
            fixed_text(group[name], "meaning")
        for name in ("velocity", "force", "strain", "return-force"):
            for moment in ("step", "time"):
                assert group[name][moment] == group["position"][moment], "hard links"
        assert "image" not in group
        assert group["species"].dtype.kind == "i"
        assert group["species"][:].tolist() == [0] * 5 + [1] * 3
        assert group["body"] == group["species"]
        names = group["species"].attrs["bodies"]
        assert [name.decode() for name in names] == ["sheet", "Körper"]
        assert group["id"].dtype.kind == "i" and group["id"][:].tolist() == list(range(COUNT))
        assert group["mass"][:].tolist() == [1, 1, 2, 1, 1, 0.5, 0.5, 0.25]

        links = file["connectivity/links"]
        assert links.dtype.kind == "i"
        assert links[:].tolist() == [[0, 1], [1, 2], [2, 3], [5, 6], [6, 7]]
        assert file[links.attrs["particles_group"]] == group, "object reference"

        assert set(file["observables"]) == {"energy", "momentum"}
        series = file["parameters/series"]
        assert set(series) == {"energy", "momentum"}
        for elements, count in ((file["observables"], frames), (series, samples)):
            element(elements["energy"], count, ())
            element(elements["momentum"], count, (2,))
            for observable in elements.values():
                fixed_text(observable, "meaning")
                fixed_text(observable["value"], "unit")
        for observable in file["observables"].values():
            for moment in ("step", "time"):
                assert observable[moment] == group["position"][moment], "a row per frame"
        # Of the frames' steps only the first was measured at.
        momentum = file["observables/momentum/value"][:]
        assert np.array_equal(momentum[0], series["momentum/value"][0])
        assert np.isnan(momentum[1:]).all()

        parameters = file["parameters"]
        assert "reduced" in parameters.attrs["units"].decode()
        assert "reduced" in group.attrs["units"].decode()
        assert parameters["scenario"][()].decode() == "title: a run\n"
        assert parameters["seed"][()] == 77
        assert parameters["frames_committed"][()] == frames
        assert parameters["samples_committed"][()] == samples
        provenance = parameters["provenance"]
        assert provenance["threads"][()] == 2
        assert provenance["resumed"][()] == 0
        assert parameters["warnings"][()] == b""
        texts = {name: item[()] for name, item in provenance.items() if item.dtype.kind == "S"}
        assert set(texts) == {"program", "version", "revision", "compiler", "flags", "instructions", "libraries",
                              "host", "start", "end", "exit_reason"}
        assert all(texts.values()), texts
        for library in (b"HDF5 ", b"GSL ", b"Box2D "):
            assert library in texts["libraries"], texts
    assert rows(path) == (frames, samples)


def structure(before, after):
    """Bytes outside the datasets' raw data are the file's structure."""
    with open(before, "rb") as file:
        old = np.frombuffer(file.read(), np.uint8)
    with open(after, "rb") as file:
        new = np.frombuffer(file.read(), np.uint8)
    assert len(old) == len(new), (len(old), len(new))
    changed = old != new
    assert changed.any()
    with h5py.File(after, "r") as file:
        def forgive(name, item):
            if not isinstance(item, h5py.Dataset):
                return
            if item.chunks is None:
                first = item.id.get_offset()
                if first is not None:
                    changed[first:first + item.id.get_storage_size()] = False
                return
            for number in range(item.id.get_num_chunks()):
                chunk = item.id.get_chunk_info(number)
                changed[chunk.byte_offset:chunk.byte_offset + chunk.size] = False
        file.visititems(forgive)
    assert not changed.any(), np.flatnonzero(changed)


def datasets(path):
    found = {}
    with h5py.File(path, "r") as file:
        def keep(name, item):
            own = name.startswith("parameters/provenance") or name == "parameters/seal"
            if isinstance(item, h5py.Dataset) and not own:
                found[name] = (item.dtype, item.shape, item[()].tobytes())
        file.visititems(keep)
    assert len(found) >= 16, found.keys()
    return found


def same(reference, paths):
    wanted = datasets(reference)
    for path in paths:
        found = datasets(path)
        assert found.keys() == wanted.keys(), (path, found.keys() ^ wanted.keys())
        for name, content in wanted.items():
            assert found[name] == content, (path, name)


def reader(path):
    try:
        import MDAnalysis
    except ImportError:
        print("no MDAnalysis here: file not read with it")
        return
    # Units are reduced, so MDAnalysis must not convert any.
    universe = MDAnalysis.Universe.empty(COUNT, trajectory=True)
    universe.load_new(path, format="H5MD", convert_units=False)
    assert len(universe.trajectory) == 40
    for k, moment in enumerate(universe.trajectory):
        assert moment.time == 5.0 * k and moment.data["step"] == 10 * k
        for kind, found in enumerate([moment.positions, moment.velocities, moment.forces]):
            assert np.array_equal(found[:, :2], value(kind, [k], 2)[0]), (k, kind)
            assert not found[:, 2].any()
    assert universe.trajectory.n_frames == 40


if __name__ == "__main__":
    job, *arguments = sys.argv[1:]
    if job == "h5md":
        h5md(arguments[0], int(arguments[1]), int(arguments[2]))
    elif job == "rows":
        for path in arguments:
            rows(path)
    elif job == "guarded":
        for path in arguments:
            if "*" not in path:
                guarded(path)
    elif job == "structure":
        structure(*arguments)
    elif job == "reader":
        reader(arguments[0])
    elif job == "same":
        same(arguments[0], arguments[1:])
