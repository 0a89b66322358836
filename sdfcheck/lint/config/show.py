"""Settings as TOML, for ``--show-settings``."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from pathlib import Path
from typing import Any

from sdfcheck.lint.config.settings import FIELDS, ArgumentSet, Pattern, Settings
from sdfcheck.source.text import shown


def render(settings: Settings) -> str:
    """Every key that is set or has a default, as it would are in ``sdfcheck.toml``."""
    lines = [f"# from {shown(file.path)}" for file in settings.files] or ["# no configuration file"]
    tables: list[str] = []
    for field in FIELDS:
        value = getattr(settings, field.attribute, None)
        if value is None:
            continue
        if field.default == "{}":
            tables += _table(field.key, value)
        else:
            lines.append(f"{field.key} = {_toml(value)}")
    return "\n".join((*lines, *tables)) + "\n"


def _table(key: str, pairs: tuple[tuple[Any, Any], ...]) -> Iterator[str]:
    if pairs:
        yield ""
        yield f"[{key}]"
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
