"""Data as arrays of numpy: volumes, labels, pictures."""
from __future__ import annotations

import os
import struct
import zlib
from typing import Any, Mapping, Optional, Sequence

import numpy

from . import _checks, _velum


def _affine(affine: Any, spacing: Any, origin: Any) -> numpy.ndarray:
    """The matrix from voxels (x, y, z) to the world, of what is said of it."""
    if affine is not None:
        if spacing is not None or origin is not None:
            raise _velum.ArgumentError("an affine says spacing and origin, too: give one or the other")
        return _checks.numbers("affine", affine, (4, 4), "a matrix of 4 x 4")
    matrix = numpy.eye(4)
    if spacing is not None:
        wanted = "three numbers above 0, along x, y and z"
        spacing = _checks.numbers("spacing", spacing, (3,), wanted)
        if not (spacing > 0).all():
            raise _checks.refusal("spacing", spacing.tolist(), wanted)
        matrix[:3, :3] = numpy.diag(spacing)
    if origin is not None:
        matrix[:3, 3] = _checks.numbers("origin", origin, (3,), "three numbers, where the first voxel is")
    return matrix


class _Data:
    """What volumes and labels have in common."""

    _held: Any
    _array_is_copy = False

    @classmethod
    def _of(cls, held: Any):
        made = cls.__new__(cls)
        made._held = held
        return made

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> numpy.ndarray:
        array = self.array
        if copy is False and (self._array_is_copy or (dtype is not None and numpy.dtype(dtype) != array.dtype)):
            raise ValueError("there is no such array without a copy")
        return numpy.array(array, dtype=dtype) if copy else numpy.asarray(array, dtype=dtype)

    @property
    def array(self) -> numpy.ndarray:
        """The voxels, [z, y, x]."""
        return self._held.array()

    @property
    def affine(self) -> numpy.ndarray:
        """4 x 4, from voxels (x, y, z) to the world: DICOM's axes (x to the left, y to the back, z to the head), in `lengthUnit`."""
        return self._held.affine()

    @property
    def spacing(self) -> tuple[float, float, float]:
        """Of the voxels along x, y and z, in `lengthUnit`."""
        return tuple(float(length) for length in numpy.linalg.norm(self.affine[:3, :3], axis=0))

    @property
    def origin(self) -> tuple[float, float, float]:
        """Where the first voxel's middle is: x, y, z."""
        return tuple(float(place) for place in self.affine[:3, 3])

    @property
    def lengthUnit(self) -> str:
        """Of the world: angstrom where that was said, else mm."""
        return self._held.facts()["lengthUnit"]

    @property
    def name(self) -> str:
        """For people."""
        return self._held.facts()["name"]

    def save(self, path: str | bytes | os.PathLike[Any]) -> list[str]:
        """Writes the voxels and where they are, in the format that the path's extension says. Gives what the format cannot hold, a line
        each."""
        return self._held.save(_checks.path(path))


class Volume(_Data):
    """Voxels, and where they are in the world. It never changes.

    array: [z, y, x], or [z, y, x, channel], or [time, z, y, x, channel]; any strides and byte order; bool, float16, and whole and
    floating numbers of up to 32 and 64 bits.
    copy: None: the volume lies over the array's memory where it can, and the array cannot be written to any more; what lies otherwise
    (other strides, byte orders and types, a part of a larger array that can be written to) is copied. True: it is copied, and stays
    yours. False: ArgumentError where it would have to be copied.
    spacing, origin: along x, y, z. affine: 4 x 4 in their place. lengthUnit: of these, as mm, um, nm, angstrom or m; angstrom stay
    angstrom, all else becomes mm, as of files. unit: of the values, as HU. modality: CT, MR, PET, angiography, ultrasound, microscopy,
    seismic, or unknown: the first look is chosen by it. color: the channels are red, green, blue (and alpha), of uint8.
    """

    def __init__(self, array: Any, *, spacing: Optional[Sequence[float]] = None, origin: Optional[Sequence[float]] = None,
                 affine: Any = None, lengthUnit: str = "mm", unit: str = "", modality: str = "unknown", color: bool = False,
                 name: str = "array", timeStepSeconds: float = 0.0, copy: Optional[bool] = None) -> None:
        text = _checks.text
        self._held = _velum.Volume(numpy.asanyarray(array), None if copy is None else bool(copy), _affine(affine, spacing, origin),
                                   text("lengthUnit", lengthUnit), text("unit", unit), text("modality", modality), bool(color),
                                   text("name", name), _checks.number("timeStepSeconds", timeStepSeconds))

    @property
    def array(self) -> numpy.ndarray:
        """The samples as they are, [z, y, x] and more where there are channels or time steps: no copy, not to be written to. A value is
        array * scale + offset. Of a volume that is streamed it is the coarse level that is in memory."""
        return self._held.array()

    @property
    def unit(self) -> str:
        """Of the values, as HU."""
        return self._held.facts()["unit"]

    @property
    def modality(self) -> str:
        """CT, MR, ..., or unknown."""
        return self._held.facts()["modality"]

    @property
    def color(self) -> bool:
        """The channels are red, green, blue (and alpha)."""
        return self._held.facts()["color"]

    @property
    def scale(self) -> float:
        """See array."""
        return self._held.facts()["scale"]

    @property
    def offset(self) -> float:
        """See array."""
        return self._held.facts()["offset"]

    @property
    def range(self) -> tuple[float, float]:
        """Least and most of the values."""
        return self._held.facts()["range"]

    @property
    def timeStepSeconds(self) -> float:
        """From a time step to the next; 0 where it is not known."""
        return self._held.facts()["timeStepSeconds"]

    def __repr__(self) -> str:
        return f"<velum.Volume {self.name} {self.array.shape} {self.array.dtype}>"


class Labels(_Data):
    """Whole numbers that say to which structure each voxel belongs; 0: to none. It never changes.

    array: [z, y, x], numbers from 0 to 65535 of any type of whole numbers; they are held compressed, and the array stays yours. names, colors: by number; colours are sRGB, 0 to 1.
    The rest as of Volume.
    """

    _array_is_copy = True

    def __init__(self, array: Any, *, names: Optional[Mapping[int, str]] = None, colors: Optional[Mapping[int, Sequence[float]]] = None,
                 spacing: Optional[Sequence[float]] = None, origin: Optional[Sequence[float]] = None, affine: Any = None,
                 lengthUnit: str = "mm", name: str = "labels") -> None:
        text = _checks.text
        named = {_checks.whole("names", id): text(f"names[{id}]", name) for id, name in dict(names or {}).items()}
        colored = {_checks.whole("colors", id): tuple(_checks.numbers(f"colors[{id}]", color, (3,), "red, green and blue, 0 to 1"))
                   for id, color in dict(colors or {}).items()}
        self._held = _velum.Labels(numpy.asarray(array), _affine(affine, spacing, origin), text("lengthUnit", lengthUnit), named, colored,
                                   text("name", name))

    @property
    def array(self) -> numpy.ndarray:
        """A copy of the numbers, uint16, [z, y, x]."""
        return self._held.array()

    @property
    def names(self) -> dict[int, str]:
        """Of the structures, by number."""
        return self._held.facts()["names"]

    @property
    def colors(self) -> dict[int, tuple[float, float, float]]:
        """Of the structures, by number; sRGB, 0 to 1."""
        return self._held.facts()["colors"]

    def __repr__(self) -> str:
        return f"<velum.Labels {self.name} {self.array.shape} {len(self.names)} structures>"


class Image(numpy.ndarray):
    """A picture: an array [row, column, channel] of red, green, blue (and alpha): whole numbers from 0 to 255, or floating ones from 0
    to 1. Notebooks show it. What is computed of it and is no picture is a number, or a plain array."""

    def _is_picture(self) -> bool:
        return self.ndim == 3 and self.shape[2] in (3, 4) and self.dtype.kind in "iuf"

    def _plain(self) -> Any:
        """What this is where it is no picture."""
        return self if self._is_picture() else self.view(numpy.ndarray)[()]

    def __array_wrap__(self, array: numpy.ndarray, context: Any = None, return_scalar: bool = False) -> Any:
        return (array if isinstance(array, Image) else array.view(Image))._plain()

    def __getitem__(self, key: Any) -> Any:
        part = super().__getitem__(key)
        return part._plain() if isinstance(part, Image) else part

    def _repr_png_(self) -> Optional[bytes]:
        if not self._is_picture():
            return None
        pixels = numpy.asarray(self)
        if pixels.dtype.kind == "f":
            pixels = numpy.clip(numpy.nan_to_num(pixels), 0, 1) * 255 + 0.5
        pixels = numpy.clip(pixels, 0, 255).astype(numpy.uint8)
        height, width, channels = pixels.shape
        rows = numpy.zeros((height, 1 + width * channels), numpy.uint8)  # each row says first that it is not filtered
        rows[:, 1:] = pixels.reshape(height, -1)

        def chunk(name: bytes, data: bytes) -> bytes:
            return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

        head = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 6, 0, 0, 0)
        return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows.tobytes(), 1)) + chunk(b"IEND", b"")
