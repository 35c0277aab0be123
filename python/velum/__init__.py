"""Volumes and cell models, cut open the way illustrators do: what the programs velum and velum-batch do, for Python.

    import velum
    s = velum.open("head.nii.gz")
    s.cut("plane", axis=(0, -1, 0))
    s["cuts[0].face"] = "section"
    image = s.render(1280, 960)

A session's methods are the commands of scripts, by the same names and with the same arguments: help(velum.Session) lists them.
Not a medical device.
"""
import numpy

from . import _velum
from ._data import Image, Labels, Volume
from ._session import Note, Session, open
from ._velum import ArgumentError, Cancelled, Error, GpuError, InputError

__version__ = _velum.version
__all__ = ["open", "Session", "Volume", "Labels", "Image", "Note", "Error", "ArgumentError", "InputError", "GpuError", "Cancelled"]

for _class in (Session, Volume, Labels, Image, Note, Error, ArgumentError, InputError, GpuError, Cancelled):
    _class.__module__ = __name__
Error.__doc__ = "What the library refuses, in one line: what, which value, what to do."
ArgumentError.__doc__ = "An argument, a name or a field's value that cannot be used."
InputError.__doc__ = "A file that cannot be read or written, or data that is not there."
GpuError.__doc__ = "There is no graphics driver that will do."
Cancelled.__doc__ = "Session.cancel() has stopped the work. Nothing has changed."
