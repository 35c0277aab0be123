#!/usr/bin/env python3
"""Prints the types of the package velum, for editors and type checkers: python/velum/__init__.pyi. Methods that are commands are those
of the table; all others say their types where they are written. PYTHONPATH leads to the package that was built."""
import inspect
import re
import typing

import velum
from velum._table import Namespace

SPECIAL = ["__init__", "__array__", "__getitem__", "__setitem__", "__call__", "__enter__", "__exit__"]
HEAD = '''# Made by python/tests/make_stub.py.
import os
from typing import Any, Callable, Iterator, Literal, Mapping, Optional, Sequence, Union

import numpy

__version__: str
'''


def type_text(annotation):
    if annotation is inspect.Parameter.empty:
        return "Any"
    if isinstance(annotation, str):
        return annotation
    if annotation is None or annotation is type(None):
        return "None"
    if isinstance(annotation, type) and not typing.get_args(annotation):
        return annotation.__name__
    return str(annotation).replace("typing.", "").replace("NoneType", "None")


def first_sentence(doc):
    return re.match(r".*?\.(?= |$)|.*", " ".join(inspect.cleandoc(doc).split()))[0]


def function_lines(name, function, indent=""):
    signature = inspect.signature(function)
    words, has_star = [], False
    for parameter in signature.parameters.values():
        if parameter.kind is parameter.KEYWORD_ONLY and not has_star:
            words.append("*")
            has_star = True
        stars = {parameter.VAR_POSITIONAL: "*", parameter.VAR_KEYWORD: "**"}.get(parameter.kind, "")
        has_star = has_star or stars == "*"
        kind = "" if parameter.name == "self" else f": {type_text(parameter.annotation)}"
        default = "" if parameter.default is parameter.empty else f" = {parameter.default!r}"
        words.append(f"{stars}{parameter.name}{kind}{default}")
    doc = function.__doc__ or ""
    yield f"{indent}def {name}({', '.join(words)}) -> {type_text(signature.return_annotation)}:" + ("" if doc else " ...")
    if doc:
        yield f'{indent}    """{first_sentence(doc)}"""'


def property_lines(name, member):
    yield "    @property"
    if inspect.isclass(member.fget):
        yield f"    def {name}(self) -> {member.fget.__name__}: ..."
        return
    yield from function_lines(name, member.fget, "    ")
    if member.fset:
        value = list(inspect.signature(member.fset).parameters.values())[1]
        yield f"    @{name}.setter"
        yield f"    def {name}(self, {value.name}: {type_text(value.annotation)}) -> None: ..."


def class_lines(cls):
    bases = {velum.Image: "(numpy.ndarray)", velum.Note: "(UserWarning)", velum.Error: "(RuntimeError)", velum.ArgumentError: "(Error, ValueError)"}
    base = bases.get(cls, "(Error)" if issubclass(cls, velum.Error) else "")
    yield f"\nclass {cls.__name__}{base}:"
    yield f'    """{first_sentence(cls.__doc__)}"""'
    members = {}
    for owner in reversed(cls.__mro__):
        if owner.__module__.startswith("velum") and owner is not Namespace:
            members.update(vars(owner))
    for name, member in members.items():
        if name.startswith("_") and name not in SPECIAL or (name == "__init__" and cls.__init__ is Namespace.__init__):
            continue
        if isinstance(member, property):
            yield from property_lines(name, member)
        elif inspect.isfunction(member):
            yield from function_lines(name, member, "    ")


def stub():
    lines = [HEAD]
    groups = [member.fget for member in vars(velum.Session).values() if isinstance(member, property) and inspect.isclass(member.fget)]
    for cls in [*groups, *(getattr(velum, name) for name in velum.__all__)]:
        lines += class_lines(cls) if inspect.isclass(cls) else ["", *function_lines(cls.__name__, cls)]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(stub(), end="")
