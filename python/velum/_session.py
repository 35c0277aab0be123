"""Sessions: what is open, and all that can be done to it."""
from __future__ import annotations

import atexit
import json
import os
import warnings
import weakref
from typing import Any, Callable, Iterator, Literal, Optional, Sequence

import numpy

from . import _checks, _table, _velum
from ._data import Image, Labels, Volume

_SHORT = {"protect": "membrane.hang", "grow": "growth.grow"}  # methods of a session by a name of their own
_LISTS = {"cut": "cuts", "mark": "lettering.marks"}  # s.cut(...) adds an item to the list, and sets its fields
_CALLED = {"film": "save"}  # s.film(...) is s.film.save(...)
_FILM, _SET = (next(command for command in _velum.commands() if command["name"] == name) for name in ("film.save", "set"))
_open_sessions: weakref.WeakSet[Session] = weakref.WeakSet()


class Note(UserWarning):
    """What somebody should know about a command that was done, in one line."""


class Session(_velum.Session):
    """What is open, and all that can be done to it: a method for each command of scripts, s[FIELD] for each field of the scene.

    Sessions are independent of each other. Each has a thread, and a graphics context from the moment when something is drawn or a
    membrane hangs. Calls may come from any thread; those of one session are done one after the other. While a session works, other
    threads of Python run. Ctrl+C stops the work (KeyboardInterrupt), as does an exception of `progress`; then nothing has changed.

    context: how to draw, auto, egl or osmesa.
    progress: called with how far the work is (0 to 1) and what is being done, some twenty times a second, by the thread that waits.
    """

    def __init__(self, context: Literal["auto", "egl", "osmesa"] = "auto", *, progress: Optional[Callable[[float, str], Any]] = None) -> None:
        super().__init__(_checks.text("context", context))
        self.progress = progress
        _open_sessions.add(self)

    @property
    def progress(self) -> Optional[Callable[[float, str], Any]]:
        """What is called while the session works."""
        return self._listener

    @progress.setter
    def progress(self, progress: Optional[Callable[[float, str], Any]]) -> None:
        if progress is not None and not callable(progress):
            raise _checks.refusal("progress", progress, "a function of two arguments")
        self._listener = progress

    def _do(self, *lines: str) -> Optional[list[str]]:
        answers, lines = self._run([_checks.text("command", line) for line in lines])
        if answers:
            return lines
        for note in lines:
            warnings.warn(note, Note, stacklevel=3)
        return None

    def run(self, script: str) -> list[str]:
        """Does the lines of a script, and gives what they answer. Lines that are empty or begin with # are passed over."""
        # As scripts are read: a caption may have other characters at which Python would part lines.
        lines = [line for line in (line.strip(" \t\r") for line in script.split("\n")) if line and not line.startswith("#")]
        return [answer for line in lines for answer in self._do(line) or []]

    def __getitem__(self, path: str) -> Any:
        """The value of a field, or of a part with all of its fields: s["camera.eye"], s["cuts[0]"]."""
        return json.loads(self._field(_checks.text("field", path)))

    def __setitem__(self, path: str, value: Any) -> None:
        """Sets a field, with all that follows from it: s["rayCast.mode"] = "mip". A text that is no JSON may be what scripts have: "1,2,3"."""
        self._do(_set_line(path, value))

    @property
    def voxels(self) -> Optional[Volume]:
        """The volume that is open."""
        held = self._volume()
        return None if held is None else Volume._of(held)

    @property
    def labels(self) -> Optional[Labels]:
        """The labels that are open, with what was grown. Set, they take the place of those that are there; an array lies on the volume's
        voxels."""
        held = self._labels()
        return None if held is None else Labels._of(held)

    @labels.setter
    def labels(self, labels: Any) -> None:
        if not isinstance(labels, Labels):
            array, volume = numpy.asarray(labels), self.voxels
            on_volume = {}
            if volume is not None:
                if volume.array.shape[:3] != array.shape and volume.array.shape[-4:-1] != array.shape:
                    raise _velum.ArgumentError(f"labels of shape {array.shape} do not fit a volume of shape {volume.array.shape}; say where they "
                                               "are: velum.Labels(array, affine=...)")
                on_volume = {"affine": volume.affine, "lengthUnit": volume.lengthUnit}
            labels = Labels(array, **on_volume)
        self._putLabels(labels._held)

    def _drawn(self, width: Any, height: Any, samples: Any, transparent: bool, layers: bool, fine: bool, section: Any,
               as_bytes: bool) -> tuple[list[str], numpy.ndarray]:
        whole = _checks.whole
        return self._picture(whole("width", width), whole("height", height), whole("samples", samples), transparent, layers, fine,
                             _checks.text("section", section), as_bytes)

    def render(self, width: int = 1280, height: int = 720, *, samples: int = 0, transparent: bool = False, section: str = "",
               dtype: Literal["uint8", "float32"] = "uint8") -> Image:
        """A picture with everything at rest, [row, column, channel]: as uint8 what files of 8 bits hold, to the byte.

        samples: pictures that are averaged, 0 as the scene says. transparent: no background, with alpha. section: axial, coronal or
        sagittal, in the place of the 3D picture.
        """
        as_bytes = _is_bytes(dtype)
        return _image(*self._drawn(width, height, samples, bool(transparent), False, not as_bytes, section, as_bytes), transparent)

    def frames(self, width: int = 1280, height: int = 720, *, animate: str | Sequence[str] = (), seconds: float = 0.0, samples: int = 0,
               transparent: bool = False, section: str = "", dtype: Literal["uint8", "float32"] = "uint8", blur: int = 1,
               shutter: float = 0.5) -> Iterator[Image]:
        """The frames of the film one after the other, each drawn when it is asked for, as render() gives it: what film(...) writes.

        The film is the one that the scene has when the first frame is drawn; what is changed between frames changes nothing of it.
        animate, seconds, blur, shutter: as of film.save. The rest as of render.
        """
        as_bytes = _is_bytes(dtype)
        size = f"{_checks.whole('width', width)}x{_checks.whole('height', height)}"
        frames = self._frames(_table.line(_FILM, {
            "path": "frames/", "size": size, "animate": animate, "seconds": seconds, "section": section, "samples": samples,
            "transparent": transparent, "bits": 8 if as_bytes else 16, "blur": blur, "shutter": shutter}))
        try:
            for frame in range(frames.count):
                yield _image(*self._frame(frames, frame, as_bytes), transparent)
        finally:
            self._endFrames(frames)

    def layers(self, width: int = 1280, height: int = 720, *, samples: int = 0) -> dict[str, numpy.ndarray]:
        """A picture and all that lies under it, by name, float32, [row, column] or [row, column, channel].

        color: red, green, blue and alpha, 0 to 1. Z: the distance from the eye along the ray, in the scene's unit (s["unit"]), infinite
        where nothing is. position: x, y, z in the world, in that unit. normal: x, y, z in the world, of length 1. id: the number of the
        structure, 0: none. instance, type: of a model, from 1. More as the layers of an .exr hold it (docs/USER-GUIDE.md).
        """
        channels, pixels = self._drawn(width, height, samples, False, True, True, "", False)
        groups: dict[str, list[int]] = {}
        for place, channel in enumerate(channels):
            name = "color" if channel in "RGBA" else channel.rpartition(".")[0] or channel
            groups.setdefault(name, []).append(place)
        return {name: pixels[:, :, places[0]] if len(places) == 1 else pixels[:, :, places] for name, places in groups.items()}

    def measure(self, *, marks: bool = True, structures: bool = False, faces: bool = False) -> dict[str, Any]:
        """What marks measure, what cuts leave of structures, and the faces of cuts: the lists marks, structures and faces, as
        `velum-batch measure --json` writes them."""
        return json.loads(self._measure(bool(marks), bool(structures), bool(faces)))

    def count(self, width: int = 1280, height: int = 720) -> list[dict[str, Any]]:
        """What became of the instances of each type of a model, or, without a model, of the pixels of each structure, in a picture of that
        size: how many are visible, hidden, clipped, and how many there are in total."""
        return json.loads(self._count(_checks.whole("width", width), _checks.whole("height", height)))

    def asPython(self) -> str:
        """All that was done since something was opened, as a program: run again it leads to the same scene, and the same bytes of a
        picture. What the window copies by Edit > Copy as Python."""
        return self._program()

    def cancel(self) -> None:
        """Stops the work that another thread waits for: there it raises Cancelled."""
        self._cancel()

    def close(self) -> None:
        """Stops all work and gives up what is open. Happens by itself when nobody has the session any more."""
        self._close()

    def __repr__(self) -> str:
        try:
            voxels, cuts = self.voxels, len(self["cuts"])
        except _velum.ArgumentError:
            return "<velum.Session closed>"
        return f"<velum.Session {voxels!r}, {cuts} cut{'' if cuts == 1 else 's'}>"

    def _ipython_key_completions_(self) -> list[str]:
        return list(_table.field_paths(self[""]))

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *error: Any) -> None:
        self.close()


def _is_bytes(dtype: Any) -> bool:
    try:
        wanted = numpy.dtype(dtype)
    except TypeError:
        wanted = None
    if wanted not in (numpy.uint8, numpy.float32):
        raise _checks.refusal("dtype", dtype, "uint8 or float32")
    return wanted == numpy.uint8


def _image(channels: list[str], pixels: numpy.ndarray, transparent: bool) -> Image:
    wanted = [channels.index(name) for name in ("RGBA" if transparent else "RGB")]
    return numpy.ascontiguousarray(pixels[:, :, wanted]).view(Image)


def _add_commands() -> None:
    for group, commands in _table.namespaces().items():
        setattr(Session, group, property(commands, doc=commands.__doc__))
        if group in _CALLED:
            commands.__call__ = getattr(commands, _CALLED[group])  # type: ignore[attr-defined]
        if group in _LISTS:
            commands.__call__ = _adder(commands.add, _LISTS[group])  # type: ignore[attr-defined]
    names = {name: short for short, name in _SHORT.items()}
    for command in _velum.commands():
        name = names.get(command["name"], command["pythonName"])
        if "." not in name:
            call = _table.method(command, lambda session: session)
            call.__name__, call.__qualname__ = name, f"Session.{name}"
            setattr(Session, name, call)


def _set_line(path: Any, value: Any) -> str:
    return _table.line(_SET, {"path": path, "value": _table.field_text(value)})


def _adder(add: Callable[..., Any], items: str) -> Callable[..., None]:
    def call(self: Any, *arguments: Any, **fields: Any) -> None:
        session = self._session
        own = {name: fields.pop(name) for name in list(fields) if name in add.__signature__.parameters}  # type: ignore[attr-defined]
        place = len(session[items])
        session._do(add.line(self, *arguments, **own),  # type: ignore[attr-defined]
                    *(_set_line(f"{items}.{place}.{field}", value) for field, value in fields.items()))

    call.__doc__ = f"{add.__doc__}\n\nMore arguments are fields of what is added: axis=(0, -1, 0) sets {items}.N.axis."
    return call


def open(what: Any, *, context: Literal["auto", "egl", "osmesa"] = "auto", progress: Optional[Callable[[float, str], Any]] = None,
         **how: Any) -> Session:
    """A session in which something is open.

    what: a file or folder (a scene, a picture with a scene inside, a volume, labels, a model), with the arguments of the command open;
    a Volume; or an array, with the arguments of Volume.
    """
    session = Session(context, progress=progress)
    if isinstance(what, (str, bytes, os.PathLike)):
        session.open(what, **how)  # type: ignore[attr-defined]
    else:
        volume = Volume(what, **how) if not isinstance(what, Volume) else what
        session._openVolume(volume._held)
    return session


@atexit.register
def _close_all() -> None:
    for session in list(_open_sessions):
        session.close()


_add_commands()
