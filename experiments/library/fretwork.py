# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs scenarios of Fretwork inside Python, and hands out their numbers as NumPy arrays.

    import fretwork
    with fretwork.Simulation("wall-bounce") as simulation:
        simulation.run(lambda now: print(now.step, now.measure("energy")), every=500)

The numbers are those of the program `fretwork`, to the last bit. Needs NumPy and libfretwork
(through ctypes; no compiler).

Arrays that are handed out are windows on the memory of the simulation: nothing is copied, and
nothing can be written into them. They show the present, and change when the simulation advances
(velocities, forces and fields when they are asked for again); `array.copy()` keeps numbers. They
stay good as long as anybody has them, also after the simulation was closed.

A simulation may be used by one thread at a time; others run in other threads meanwhile.
"""

import ctypes
import json
import os
import sys
import threading
from collections import namedtuple
from ctypes import POINTER, Structure, byref, c_bool, c_char, c_char_p, c_double, c_int, c_int64, c_void_p

import numpy

__all__ = ["BadInput", "Body", "Diverged", "FretworkError", "Series", "Simulation", "version"]

_NAME = "libfretwork.so.0.1"


class FretworkError(Exception):
    """What the program says in one sentence; `status` is its exit code."""

    def __init__(self, sentence, status):
        super().__init__(sentence)
        self.status = status


class BadInput(FretworkError, ValueError):
    """The scenario, or what was asked of it, cannot be run."""


class Diverged(FretworkError, ArithmeticError):
    """The numbers are no longer finite, or a particle has escaped."""


# --- the library ---


class _Error(Structure):
    _fields_ = [("status", c_int), ("sentence", c_char * 10240)]  # FW_SENTENCE_SIZE


class _Def(Structure):
    _fields_ = [
        ("scenario", c_char_p),
        ("text", c_char_p),
        ("settings", POINTER(c_char_p)),
        ("setting_count", c_int),
        ("sweep_case", c_char_p),
        ("directory", c_char_p),
        ("overwrite", c_bool),
        ("threads", c_int),
    ]


class _BodyView(Structure):
    _fields_ = [
        ("name", c_char_p),
        ("model", c_char_p),
        ("count", c_int),
        ("x", c_void_p),
        ("y", c_void_p),
    ]


class _SeriesView(Structure):
    _fields_ = [
        ("name", c_char_p),
        ("components", c_int),
        ("count", c_int64),
        ("stride", c_int64),
        ("values", c_void_p),
        ("steps", c_void_p),
        ("times", c_void_p),
    ]


_NUMBERS = 8  # FW_SIMULATION_NUMBERS

# Result and arguments of each function.
_FUNCTIONS = {
    "fw_version": (c_char_p,),
    "fw_simulation_def_default": (_Def,),
    "fw_simulation_create": (c_int, POINTER(c_void_p), POINTER(_Def), POINTER(_Error)),
    "fw_simulation_destroy": (None, c_void_p),
    "fw_simulation_advance": (c_int, c_void_p, c_int64, POINTER(_Error)),
    "fw_simulation_stop": (c_int, c_void_p, POINTER(_Error)),
    "fw_simulation_step": (c_int64, c_void_p),
    "fw_simulation_step_count": (c_int64, c_void_p),
    "fw_simulation_time": (c_double, c_void_p),
    "fw_simulation_is_at_end": (c_bool, c_void_p),
    "fw_simulation_name": (c_char_p, c_void_p),
    "fw_simulation_title": (c_char_p, c_void_p),
    "fw_simulation_warnings": (c_char_p, c_void_p),
    "fw_simulation_body_count": (c_int, c_void_p),
    "fw_simulation_body": (_BodyView, c_void_p, c_int),
    "fw_simulation_velocities": (
        c_int, c_void_p, c_int, POINTER(c_void_p), POINTER(c_void_p), POINTER(_Error)),
    "fw_simulation_forces": (
        c_int, c_void_p, c_int, POINTER(c_void_p), POINTER(c_void_p), POINTER(_Error)),
    "fw_simulation_field": (
        c_int, c_void_p, c_int, c_char_p, POINTER(c_void_p), POINTER(_Error)),
    "fw_simulation_field_name": (c_char_p, c_void_p, c_int, c_int),
    "fw_simulation_measure": (
        c_int, c_void_p, c_char_p, POINTER(c_double), POINTER(c_int), POINTER(_Error)),
    "fw_simulation_series_count": (c_int, c_void_p),
    "fw_simulation_series": (_SeriesView, c_void_p, c_int),
    "fw_simulation_judge": (c_int, c_void_p, POINTER(c_int), POINTER(c_int), POINTER(_Error)),
}


def _load():
    """From $FRETWORK_LIBRARY; beside this file, as in a build folder; below the folder in which this
    module is installed; or where the system looks."""
    here = os.path.dirname(os.path.realpath(__file__))
    stands = os.path.dirname(os.path.abspath(__file__))
    folders = [stands, os.path.join(here, "..", "..")]
    multiarch = getattr(sys.implementation, "_multiarch", None)
    if multiarch:
        folders.append(os.path.join(here, "..", "..", multiarch))
    found = [path for path in (os.path.join(f, _NAME) for f in folders) if os.path.exists(path)]
    library = ctypes.CDLL(os.environ.get("FRETWORK_LIBRARY") or (found + [_NAME])[0])
    for name, (result, *arguments) in _FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


_library = _load()


def version():
    """Of the library: "0.1.0"."""
    return _library.fw_version().decode()


def _check(status, error):
    if status == 0:
        return
    kind = {2: BadInput, 3: Diverged}.get(status, FretworkError)
    raise kind(error.sentence.decode("utf-8", "replace"), status)


def _written(value):
    """As a scenario has it: words as they are, lists and numbers also of NumPy."""
    return value if isinstance(value, str) else json.dumps(value, default=lambda other: other.tolist())


def _bytes(text):
    return None if text is None else os.fsencode(text)


# --- memory ---


class _Owner:
    """The simulation in the library. Whoever sees its memory has a reference to this object, and
    with the last one it goes."""

    def __init__(self, handle):
        self.handle = handle
        self.lock = threading.Lock()
        self.destroy = _library.fw_simulation_destroy  # still there when the interpreter ends

    def __del__(self):
        self.destroy(self.handle)


class _Window:
    """What an array is based on."""

    def __init__(self, owner, address, shape, strides, kind):
        self.owner = owner
        self.__array_interface__ = {
            "version": 3,
            "data": (address, True),
            "shape": shape,
            "strides": strides,
            "typestr": numpy.dtype(kind).str,
        }


def _window(owner, address, shape, strides, kind="=f8"):
    return numpy.asarray(_Window(owner, address, shape, strides, kind))


def _vectors(owner, count, x, y):
    """[count, 2] out of every x and every y."""
    return _window(owner, x, (count, 2), (8, y - x))


# --- what is handed out ---

Series = namedtuple("Series", "steps times values")
Series.__doc__ = "What was measured: steps [rows], times [rows], values [rows] or [rows, components]."


class Body:
    """A body of the scenario. Every array has one row per particle, in the order of the results."""

    def __init__(self, owner, number):
        self._owner, self._number = owner, number
        view = _library.fw_simulation_body(owner.handle, number)
        self.name, self.model, self.count = view.name.decode(), view.model.decode(), view.count

    def __repr__(self):
        return f"<body {self.name}: {self.count} particles, {self.model}>"

    def __len__(self):
        return self.count

    @property
    def positions(self):
        """[count, 2], of the present, whenever it is."""
        view = _library.fw_simulation_body(self._owner.handle, self._number)
        return _vectors(self._owner, self.count, view.x, view.y)

    def _ask(self, function):
        x, y, error = c_void_p(), c_void_p(), _Error()
        with self._owner.lock:
            _check(function(self._owner.handle, self._number, byref(x), byref(y), byref(error)), error)
        return _vectors(self._owner, self.count, x.value, y.value)

    @property
    def velocities(self):
        """[count, 2], as they are when asked for."""
        return self._ask(_library.fw_simulation_velocities)

    @property
    def forces(self):
        """[count, 2]: outside forces and reactions of contacts, as they are when asked for."""
        return self._ask(_library.fw_simulation_forces)

    @property
    def field_names(self):
        names, owner = [], self._owner
        while True:
            name = _library.fw_simulation_field_name(owner.handle, self._number, len(names))
            if name is None:
                return names
            names.append(name.decode())

    def field(self, name):
        """[count]: a field that results may record, as it is when asked for."""
        values, error, owner = c_void_p(), _Error(), self._owner
        with owner.lock:
            _check(_library.fw_simulation_field(
                owner.handle, self._number, name.encode(), byref(values), byref(error)), error)
        return _window(owner, values.value, (self.count,), (8,))


class Simulation:
    """A scenario, ready to run: the name of an experiment, or a file (with a slash or .yaml), as
    `fretwork run` takes it, or its text.

    settings   {"run.steps": 200}, or ["run.steps=200"]: as --set
    case       of a sweep: "A=2.5"
    directory  where results are written; None: nowhere
    overwrite  an earlier result there is replaced, else refused
    threads    results do not depend on it
    """

    _SLICE = 256  # steps, between which Python looks whether somebody has pressed ^C

    def __init__(self, scenario=None, *, text=None, settings=(), case=None, directory=None,
                 overwrite=False, threads=1):
        if hasattr(settings, "items"):
            settings = [f"{key}={_written(value)}" for key, value in settings.items()]
        items = [os.fsencode(setting) for setting in settings]
        given = _library.fw_simulation_def_default()
        given.scenario, given.text = _bytes(scenario), _bytes(text)
        given.settings, given.setting_count = (c_char_p * len(items))(*items), len(items)
        given.sweep_case, given.directory = _bytes(case), _bytes(directory)
        given.overwrite, given.threads = overwrite, threads
        handle, error = c_void_p(), _Error()
        _check(_library.fw_simulation_create(byref(handle), byref(given), byref(error)), error)
        self._owner = owner = _Owner(handle)
        self.name = _library.fw_simulation_name(handle).decode()
        self.title = _library.fw_simulation_title(handle).decode()
        self.step_count = _library.fw_simulation_step_count(handle)
        bodies = [Body(owner, b) for b in range(_library.fw_simulation_body_count(handle))]
        self.bodies = {body.name: body for body in bodies}

    def __repr__(self):
        return f"<simulation {self.name}: step {self.step} of {self.step_count}>"

    # --- running ---

    def advance(self, steps=1):
        """So many steps, or fewer to the end."""
        if steps < 0:
            raise ValueError(f"steps are {steps}, expected 0 or more")
        error, owner = _Error(), self._owner
        while steps > 0 and not self.at_end:
            part = min(steps, self._SLICE)
            with owner.lock:
                _check(_library.fw_simulation_advance(owner.handle, part, byref(error)), error)
            steps -= part

    def frames(self, every=1):
        """For a loop: yields the simulation at once, whenever its steps are a multiple of `every`,
        and at the end."""
        if every < 1:
            raise ValueError(f"every is {every}, expected 1 or more")
        yield self
        while not self.at_end:
            self.advance(every - self.step % every)
            yield self

    def run(self, look=None, every=1):
        """To the end. look(simulation) is called as in frames(); False from it is enough, and run()
        may go on later."""
        if look is None:
            self.advance(self.step_count)
            return
        for now in self.frames(every):
            answer = look(now)
            if isinstance(answer, (bool, numpy.bool_)) and not answer:
                return

    def close(self):
        """Leaves off. Results that are not at their end can be resumed by the program."""
        error = _Error()
        with self._owner.lock:
            _check(_library.fw_simulation_stop(self._owner.handle, byref(error)), error)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # --- looking ---

    @property
    def step(self):
        """Steps done."""
        return _library.fw_simulation_step(self._owner.handle)

    @property
    def time(self):
        return _library.fw_simulation_time(self._owner.handle)

    @property
    def at_end(self):
        return _library.fw_simulation_is_at_end(self._owner.handle)

    @property
    def warnings(self):
        """What the program would have warned of so far: a list of lines."""
        with self._owner.lock:
            return _library.fw_simulation_warnings(self._owner.handle).decode().splitlines()

    def measure(self, name):
        """A quantity at present, "energy", "energy.sheet" or "momentum.sheet.x": a number, or an
        array of its components."""
        values, count, error = (c_double * _NUMBERS)(), c_int(), _Error()
        with self._owner.lock:
            _check(_library.fw_simulation_measure(
                self._owner.handle, name.encode(), values, byref(count), byref(error)), error)
        return values[0] if count.value == 1 else numpy.array(values[:count.value])

    def _all_series(self):
        handle = self._owner.handle
        for n in range(_library.fw_simulation_series_count(handle)):
            yield _library.fw_simulation_series(handle, n)

    @property
    def series_names(self):
        return [view.name.decode() for view in self._all_series()]

    def series(self, name):
        """What the scenario has measured under that name so far, see Series."""
        for view in self._all_series():
            if view.name.decode() != name:
                continue
            rows, parts, owner = view.count, view.components, self._owner
            shape, strides = ((rows,), (8 * view.stride,)) if parts == 1 else (
                (rows, parts), (8 * view.stride, 8))
            return Series(_window(owner, view.steps, (rows,), (8,), "=i8"),
                          _window(owner, view.times, (rows,), (8,)),
                          _window(owner, view.values, shape, strides))
        raise BadInput(f"{name} is not measured, expected one of {', '.join(self.series_names)}", 2)

    def judge(self):
        """At the end: (how many numbers the scenario expects, how many of them did not come out)."""
        expected, failed, error = c_int(), c_int(), _Error()
        with self._owner.lock:
            _check(_library.fw_simulation_judge(
                self._owner.handle, byref(expected), byref(failed), byref(error)), error)
        return expected.value, failed.value
