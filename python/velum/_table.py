"""The table of commands as methods: names, arguments, defaults, meanings and examples are the table's."""
from __future__ import annotations

import ast
import inspect
import json
import math
import os
import re
from typing import Any, Callable, Iterator, Literal, Mapping, Optional, Sequence, Union

from . import _velum

_PLAIN = {"true or false": bool, "number": float, "whole number": int, "text": str, "any value": Any}


def _annotation(kind: str) -> Any:
    """Of an argument, by the words that the table has for its type."""
    if kind in _PLAIN:
        return _PLAIN[kind]
    if kind.startswith("list of "):
        item = _annotation(kind[len("list of "):])
        return Union[item, Sequence[item]]  # one stands for a list of one
    if kind.endswith(" numbers"):
        return Sequence[float]
    return Literal[tuple(re.findall("`([^`]+)`", kind))]


def plain(value: Any) -> Any:
    """A value as JSON has it: numbers and arrays of numpy as numbers and lists, paths as texts, infinity as null."""
    if isinstance(value, (bytes, os.PathLike)):
        return os.fsdecode(value)
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    return None if isinstance(value, float) and math.isinf(value) else value


def _text(value: Any) -> str:
    try:
        return json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    except (TypeError, ValueError) as error:
        raise _velum.ArgumentError(f"{value!r} is no value: {error}") from None


def field_text(value: Any) -> str:
    """The value of a field as the command set takes it. A text that is no JSON goes as it is, as in scripts: 'mip', '1,2,3'."""
    if not isinstance(value, str):
        value = plain(value)
        are_numbers = isinstance(value, list) and len(value) > 1 and all(type(item) in (int, float) for item in value)
        return ",".join(map(_text, value)) if are_numbers else _text(value)
    try:
        json.loads(value)
    except ValueError:
        if value and value == value.strip() and "\n" not in value and "\r" not in value:
            return value
    return _text(value)


def field_paths(value: Any, path: str = "") -> Iterator[str]:
    """The paths of all fields in a part of a scene: for completion."""
    if path:
        yield path
    if isinstance(value, dict):
        for name, item in value.items():
            yield from field_paths(item, f"{path}.{name}" if path else name)
    elif isinstance(value, list):
        for place, item in enumerate(value):
            if isinstance(item, dict):
                yield from field_paths(item, f"{path}.{place}")


def _argument(name: str, kind: str, value: Any) -> str:
    """ NAME=VALUE of a line. The line takes the quotes off, and what is in them is JSON, or a word of scripts ("a,b" is a list)."""
    value = plain(value)
    # Paths that are no UTF-8 are no JSON either.
    is_word = isinstance(value, str) and (kind not in ("text", "any value") or any("\udc80" <= letter <= "\udcff" for letter in value))
    return f" {name}={_text(value if is_word else _text(value))}"


def line(command: Mapping[str, Any], arguments: Mapping[str, Any]) -> str:
    """A line of a script that does a command."""
    kinds = {row["path"]: row["type"] for row in command["arguments"]}
    return command["name"] + "".join(_argument(name, kinds.get(name, ""), value) for name, value in arguments.items())


def _parameters(rows: Sequence[Mapping[str, str]]) -> list[inspect.Parameter]:
    """Of a command. Arguments with parts (raw.dims, raw.type) are one, a dictionary."""
    parameters: dict[str, inspect.Parameter] = {}
    for row in rows:
        name, _, part = row["path"].partition(".")
        default = ast.literal_eval(row["default"])
        kind = _annotation(row["type"])
        if part:
            kind, default = Optional[Mapping[str, Any]], None
        elif default is None:
            kind = Optional[kind]
        elif name == "path" and kind is str:
            kind = Union[str, bytes, os.PathLike[Any]]
        parameters.setdefault(name, inspect.Parameter(name, inspect.Parameter.POSITIONAL_OR_KEYWORD, default=default, annotation=kind))
    return list(parameters.values())


def _doc(command: Mapping[str, Any]) -> str:
    lines = [command["doc"], ""]
    for row in command["arguments"]:
        facts = ", ".join(filter(None, [row["unit"], row["range"]]))
        kind = row["type"] if "`" in row["type"] else ""
        lines.append(f"{row['path']}: {row['doc']}" + (f" [{facts}]" if facts else "") + (f" One of {kind.replace('`', '')}." if kind else ""))
    return "\n".join([*lines, *([""] if command["arguments"] else []), f"    {command['example']}"])


def method(command: Mapping[str, Any], session_of: Callable[[Any], Any]) -> Callable[..., Any]:
    """A method that does a command. session_of: gives the session of the object whose method it is."""
    parameters = _parameters(command["arguments"])
    names = [parameter.name for parameter in parameters]
    self = inspect.Parameter("self", inspect.Parameter.POSITIONAL_ONLY)
    before, now = command["renamed"]
    signature = inspect.Signature([self, *parameters], return_annotation=list[str] if command["answers"] else None)

    def bound_line(*arguments: Any, **named: Any) -> tuple[Any, str]:
        if before in named and now not in named:
            named[now] = named.pop(before)
        try:
            bound = signature.bind(*arguments, **named).arguments
        except TypeError as error:
            raise TypeError(f"{command['pythonName']}: {error}; it takes ({', '.join(names)})") from None
        return bound.pop("self"), line(command, bound)

    def call(*arguments: Any, **named: Any) -> Any:
        owner, text = bound_line(*arguments, **named)
        return session_of(owner)._do(text)

    call.line = lambda *arguments, **named: bound_line(*arguments, **named)[1]  # type: ignore[attr-defined]
    call.__name__ = command["pythonName"].rpartition(".")[2]
    call.__doc__ = _doc(command)
    call.__signature__ = signature  # type: ignore[attr-defined]
    return call


class Namespace:
    """Commands whose names begin alike, as s.cut.add and s.cut.flip."""

    def __init__(self, session: Any) -> None:
        self._session = session

    def __repr__(self) -> str:
        return f"<velum.{type(self).__name__}: {', '.join(name for name in dir(self) if not name.startswith('_'))}>"


def namespaces() -> dict[str, type[Namespace]]:
    """A class for each group of commands."""
    found: dict[str, type[Namespace]] = {}
    for command in _velum.commands():
        group, _, name = command["pythonName"].rpartition(".")
        if not group:
            continue
        if group not in found:
            found[group] = type(group.capitalize() + "Commands", (Namespace,), {"__doc__": f"The commands {group}.*", "__module__": "velum"})
        call = method(command, lambda namespace: namespace._session)
        call.__qualname__ = f"{found[group].__name__}.{name}"
        setattr(found[group], name, call)
    return found
