"""Settings as TOML, for ``--show-settings``."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from enum import Enum
from pathlib import Path
from types import MappingProxyType
from typing import Any

from sdfcheck.lint.config.settings import FIELDS, UNSET, ArgumentSet, Field, Pattern, Settings, line_of
from sdfcheck.source.text import shown

_ADDED = frozenset({"extend_select", "ignore"})
"""Given on the command line, these are added to those of the configuration."""
_MERGED = frozenset({"model_paths", "package_paths", "packages", "env"})
"""These have been added already."""


def render(settings: Settings, asked: Mapping[str, object] = MappingProxyType({})) -> str:
    """Every key that is set or has a default, as it would be in ``sdfcheck.toml``, with where it is set.

    ``asked`` are the values of keys for which a command has options of its own.
    """
    lines = [f"# from {shown(file.path)}" for file in settings.files] or ["# no configuration file"]
    tables: list[str] = []
    for field in FIELDS:
        if field.key in asked:
            lines.append(f"{field.key} = {_toml(asked[field.key])}  # --{field.key}")
            continue
        value = _value(settings, field)
        if value is None:
            continue
        source = _source(settings, field)
        if field.default == "{}":
            tables += _table(field.key, value, source)
        else:
            lines.append(f"{field.key} = {_toml(value)}{source}")
    return "\n".join((*lines, *tables)) + "\n"


def missing_folders(settings: Settings) -> Iterator[str]:
    """The folders that a configuration names and that are not there, each after its place."""
    for field in FIELDS:
        if field.attribute in {"model_paths", "package_paths", "packages"}:
            for each in getattr(settings, field.attribute):
                path = each[1] if field.attribute == "packages" else each
                if not os.path.isdir(path):
                    place = _source(settings, field).removeprefix("  # ").partition(",")[0]
                    yield f"{place}: no such folder: {shown(path)}"


def _value(settings: Settings, field: Field) -> Any:
    own: Any = getattr(settings, field.attribute, None)
    if not _is_given(settings, field) or field.attribute in _MERGED:
        return own
    given: Any = getattr(settings.given, field.attribute)
    return own + given if field.attribute in _ADDED else given


def _is_given(settings: Settings, field: Field) -> bool:
    """Whether the command line sets it."""
    unset = getattr(UNSET, field.attribute, None)
    return settings.given is not None and getattr(settings.given, field.attribute, unset) != unset


def _source(settings: Settings, field: Field) -> str:
    """A comment: the places where it is set."""
    key = re.compile(rf"(?m)^[ \t]*(?:\[[\w.-]*\b)?{re.escape(field.key)}\b[ \t]*[]=.]")
    file = next((file for file in settings.files if key.search(file.text)), None)
    places = [f"{shown(file.path)}:{line_of(file.text, (field.key,))}"] if file is not None else []
    if _is_given(settings, field):
        places = [*(places if field.attribute in _ADDED | _MERGED else ()), field.option.split()[0]]
    return f"  # {', '.join(places)}" if places else ""


def _table(key: str, pairs: tuple[tuple[Any, Any], ...], source: str) -> Iterator[str]:
    if pairs:
        yield ""
        yield f"[{key}]{source}"
    for name, value in pairs:
        if key == "xacro":
            yield f"{_toml(name)} = [{', '.join(_inline_table(given) for given in value)}]"
        else:
            yield f"{_toml(name)} = {_toml('off' if value is None else value)}"


def _inline_table(pairs: ArgumentSet) -> str:
    return "{" + ", ".join(f"{_toml(name)} = {_toml(value)}" for name, value in pairs) + "}"


def _toml(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int | float):
        return f"{value:g}"
    if isinstance(value, tuple):
        return f"[{', '.join(_toml(item) for item in value)}]"
    if isinstance(value, Pattern):
        value = value.glob
    elif isinstance(value, Path):
        value = shown(value)
    elif isinstance(value, Enum):
        value = value.value
    return _quoted(str(value))


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c.isprintable() else f"\\U{ord(c):08x}" for c in escaped) + '"'
