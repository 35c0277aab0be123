"""What is asked of arguments before the library sees them: errors are one line that says what is wanted."""
from __future__ import annotations

import operator
import os
from typing import Any

import numpy

from . import _velum


def refusal(name: str, value: Any, wanted: str) -> _velum.ArgumentError:
    """The error for an argument that is something else."""
    shown = " ".join(repr(value).split())
    return _velum.ArgumentError(f"{name} {shown if len(shown) <= 60 else shown[:57] + '...'}: expected {wanted}")


def whole(name: str, value: Any) -> int:
    """A whole number of 32 bits."""
    try:
        number = operator.index(value)
    except TypeError:
        raise refusal(name, value, "a whole number") from None
    if abs(number) >= 2 ** 31:
        raise refusal(name, value, "a smaller number")
    return number


def number(name: str, value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise refusal(name, value, "a number") from None


def numbers(name: str, value: Any, shape: tuple[int, ...], wanted: str) -> numpy.ndarray:
    """An array of numbers of a shape."""
    try:
        array = numpy.asarray(value, dtype=float)
    except (TypeError, ValueError, OverflowError):
        raise refusal(name, value, wanted) from None
    if array.shape != shape:
        raise refusal(name, value, wanted)
    return array


def text(name: str, value: Any) -> bytes:
    """A text in UTF-8. Paths that are none keep their bytes."""
    try:
        return value.encode("utf-8", "surrogateescape")
    except (AttributeError, UnicodeEncodeError):
        raise refusal(name, value, "a text") from None


def path(value: Any) -> bytes:
    """A whole path, as the system has it."""
    try:
        return os.fsencode(os.path.abspath(value))
    except (TypeError, UnicodeEncodeError):
        raise refusal("path", value, "a path") from None
