"""A table of TOML to checked settings; faults are reported with their place."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from sdfcheck.lint.config.settings import (
    FIELDS,
    GIVEN,
    UNSET,
    ArgumentSet,
    ConfigFile,
    Field,
    Pattern,
    Settings,
    Shape,
)
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.text import shown

_MOST_MEGABYTES = 1e9


def parse_toml(path: Path, text: str) -> dict[str, Any]:
    """The whole file as Python values."""
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    try:
        table: dict[str, Any] = tomllib.loads(text)
    except RecursionError:
        raise WrongUsage(f"{shown(path)}: tables and lists are nested too deeply") from None
    except tomllib.TOMLDecodeError as error:
        message, line = str(error), text.count("\n") + 1
        place = re.search(r" \(at line (\d+), column \d+\)$", message)
        if place:
            message, line = message[: place.start()], int(place[1])
        message = message.removesuffix(" (at end of document)")
        raise WrongUsage(f"{shown(path)}:{line}: {message[:1].lower()}{message[1:]}") from None
    return table


def read_table(file: ConfigFile, table: Mapping[str, Any]) -> dict[str, Any]:
    """The values of the keys that are set, by their names in ``Settings``."""
    fields = {field.key: field for field in FIELDS}
    values = {}
    for key, value in table.items():
        field = fields.get(key)
        if field is None:
            from sdfcheck.formats.near_names import did_you_mean

            raise file.error(f"unknown key `{key}`{did_you_mean(key, fields)}", key)
        if _has_nul(value):
            raise file.error(f"`{key}` has the character NUL, which no path can have", key)
        values[field.attribute] = _READERS[field.shape](file, field, value)
    return values


class _Caller(ConfigFile):
    """The place of what a program or an editor gives instead of a file: none."""

    def error(self, message: str, *keys: str) -> WrongUsage:
        return WrongUsage(message)


def read_value(field: Field, value: object, root: Path | None = None) -> Any:
    """A setting that a program or an editor gives, checked; relative paths start from ``root``.

    Raises:
        WrongUsage: it is not of the setting's form.
    """
    return _READERS[field.shape](_Caller(Path(), "", root or Path()), field, _plain(value))


def read_given(values: Mapping[str, object]) -> Settings:
    """The settings that a program gives by name; None leaves one to the configuration.

    Raises:
        TypeError: a caller cannot set that.
        WrongUsage: a value is not of its setting's form.
    """
    for name in values:
        if name not in GIVEN:
            from sdfcheck.formats.near_names import did_you_mean

            raise TypeError(f"there is no setting `{name}`{did_you_mean(name, GIVEN)}")
    read = {name: read_value(GIVEN[name], value) for name, value in values.items() if value is not None}
    return UNSET._replace(**read)


def _plain(value: object) -> object:
    """A value as TOML would have it."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return {key: _plain(each) for key, each in value.items()}
    is_many = isinstance(value, Iterable) and not isinstance(value, str | bytes)
    return [_plain(each) for each in value] if is_many else value  # type: ignore[attr-defined]


def _has_nul(value: object) -> bool:
    if isinstance(value, dict):
        return any(_has_nul(each) for pair in value.items() for each in pair)
    return any(map(_has_nul, value)) if isinstance(value, list) else isinstance(value, str) and "\0" in value


def _mismatch(file: ConfigFile, field: Field, *keys: str, rest: str = "") -> WrongUsage:
    where = "`" + "` of `".join(reversed((field.key, *keys))) + "`"
    expected = _EXPECTED[len(keys)].get(field.shape, field.shape)
    return file.error(f"{where} should be {expected}{rest}", field.key, *keys)


def _strings(file: ConfigFile, field: Field, value: object, *keys: str) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        rest = f": write `[{json.dumps(value)}]`" if isinstance(value, str) else ""
        raise _mismatch(file, field, *keys, rest=rest)
    return tuple(value)


def _table(file: ConfigFile, field: Field, value: object) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise _mismatch(file, field)
    return value


def _targets(file: ConfigFile, field: Field, value: object) -> tuple[str, ...]:
    from sdfcheck.lint.select import check_targets

    targets = _strings(file, field, value)
    try:
        check_targets(targets)
    except WrongUsage as error:
        raise file.error(str(error), field.key) from None
    return targets


def _patterns(file: ConfigFile, field: Field, value: object) -> tuple[Pattern, ...]:
    return tuple(_pattern(file, field, glob) for glob in _strings(file, field, value))


def _pattern(file: ConfigFile, field: Field, glob: str) -> Pattern:
    try:
        return Pattern(file.root, glob)
    except ValueError:
        raise file.error(f"`{glob}` is not a pattern", field.key, glob) from None


def _path(file: ConfigFile, field: Field, value: object, *keys: str) -> Path:
    if not isinstance(value, str):
        raise _mismatch(file, field, *keys)
    return Path(os.path.normpath(file.root / os.path.expanduser(value)))


def _paths(file: ConfigFile, field: Field, value: object) -> tuple[Path, ...]:
    return tuple(_path(file, field, item) for item in _strings(file, field, value))


def _plugins_or_strings(file: ConfigFile, field: Field, value: object) -> tuple[str, ...]:
    strings = _strings(file, field, value)
    if field.key != "plugins":
        return strings
    return tuple(str(file.root / name) if os.path.isdir(file.root / name) else name for name in strings)


def _flag(file: ConfigFile, field: Field, value: object) -> bool:
    if not isinstance(value, bool):
        raise _mismatch(file, field)
    return value


def _megabytes(file: ConfigFile, field: Field, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value < _MOST_MEGABYTES:
        raise _mismatch(file, field)
    return value


def _severity(file: ConfigFile, field: Field, value: object, *keys: str) -> Severity:
    try:
        return Severity(value)
    except ValueError:
        raise _mismatch(file, field, *keys) from None


def _severities(file: ConfigFile, field: Field, value: object) -> tuple[tuple[str, Severity | None], ...]:
    return tuple(
        (selector, None if level == "off" else _severity(file, field, level, selector))
        for selector, level in _table(file, field, value).items()
    )


def _ignores(file: ConfigFile, field: Field, value: object) -> tuple[tuple[Pattern, tuple[str, ...]], ...]:
    return tuple(
        (_pattern(file, field, glob), _strings(file, field, selectors, glob))
        for glob, selectors in _table(file, field, value).items()
    )


def _places(file: ConfigFile, field: Field, value: object) -> tuple[tuple[str, Path], ...]:
    places = _table(file, field, value)
    return tuple((name, _path(file, field, place, name)) for name, place in places.items())


def _arguments(
    file: ConfigFile, field: Field, value: object
) -> tuple[tuple[Pattern, tuple[ArgumentSet, ...]], ...]:
    read = []
    for glob, given in _table(file, field, value).items():
        tables = given if isinstance(given, list) else [given]
        sets = tuple(_argument_set(file, field, table, glob) for table in tables)
        read.append((_pattern(file, field, glob), sets))
    return tuple(read)


def _argument_set(file: ConfigFile, field: Field, table: object, glob: str) -> ArgumentSet:
    if not isinstance(table, dict) or not all(isinstance(item, str | int | float) for item in table.values()):
        raise _mismatch(file, field, glob)
    return tuple(
        (name, str(item).lower() if isinstance(item, bool) else str(item)) for name, item in table.items()
    )


_READERS: Mapping[str, Callable[[ConfigFile, Field, object], Any]] = {
    Shape.SELECTORS: _strings,
    Shape.PATTERNS: _patterns,
    Shape.TARGETS: _targets,
    Shape.STRINGS: _plugins_or_strings,
    Shape.PATHS: _paths,
    Shape.PATH: _path,
    Shape.FLAG: _flag,
    Shape.MEGABYTES: _megabytes,
    Shape.SEVERITY: _severity,
    Shape.SEVERITIES: _severities,
    Shape.IGNORES: _ignores,
    Shape.PLACES: _places,
    Shape.ARGUMENTS: _arguments,
}
_EXPECTED: tuple[Mapping[str, str], ...] = (
    {Shape.SEVERITY: "`error`, `warning` or `info`"},
    {
        Shape.SEVERITIES: "`error`, `warning`, `info` or `off`",
        Shape.IGNORES: "a list of rule codes, names or families",
        Shape.PLACES: "a path",
        Shape.ARGUMENTS: "a table of texts, numbers or true and false (or a list of such tables)",
    },
)
"""The type that a value should have, and that of a value inside a table."""
