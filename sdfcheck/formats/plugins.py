"""The plugins of Gazebo: their classes, their parameters, and the things that parameters name."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from sdfcheck.source.record import NamedTuple

_FILE = Path(__file__).parent / "data" / "plugins.txt"
_PREFIX = re.compile(r"^(?:ignition-gazebo\d*-|gz-sim\d*-)")
_VERSIONED = re.compile(r"^(gz::sim|ignition::gazebo)::v\d+::")
GZ_SIM = "gz-sim"


class Naming(NamedTuple):
    """A parameter that names a part of the model: ``wheel@link_name`` is an attribute of a child."""

    path: str
    kind: str
    """``joint`` or ``link``."""
    is_scoped: bool
    is_list: bool


class PluginFacts(NamedTuple):
    """One plugin in one generation of Gazebo."""

    file: str
    generation: str
    classes: tuple[str, ...]
    """Those of which ``name`` has to be one; empty where it is free."""
    once: str
    """The scope in which it may be once: ``world``, ``model`` or ``process``; empty where it may be repeated."""
    serves: tuple[str, ...]
    """The types of sensors that do nothing without it."""
    namings: tuple[Naming, ...]
    parameters: frozenset[str]
    """The names of its parameters; empty where not all are known."""

    def is_class(self, name: str) -> bool:
        """Is it the name of a class in it? Full names with the version are accepted as well."""
        plain = _VERSIONED.sub(r"\1::", name)
        return not self.classes or plain in self.classes


def stem(filename: str) -> str:
    """The name by which a file is known: without folder, ``lib``, ``.so`` and old prefixes."""
    base = filename.rpartition("/")[2].removeprefix("lib").removesuffix(".so")
    return _PREFIX.sub("gz-sim-", base)


@cache
def known(filename: str) -> tuple[PluginFacts, ...]:
    """The entries of a file, by generations."""
    return tuple(map(_facts, _entries().get(stem(filename), ())))


@cache
def known_files() -> tuple[str, ...]:
    """The files of gz-sim's own systems, without ``lib`` and ``.so``."""
    return tuple(name for name, entries in _entries().items() if f"\t{GZ_SIM}\t" in entries[0])


@cache
def served() -> dict[str, tuple[str, ...]]:
    """Type of sensor → the systems of gz-sim of which it needs one."""
    found: dict[str, tuple[str, ...]] = {}
    for name in known_files():
        for kind in _facts(_entries()[name][0]).serves:
            found[kind] = (*found.get(kind, ()), name)
    return found


@cache
def _entries() -> dict[str, tuple[str, ...]]:
    """File → its lines, by generations."""
    found: dict[str, tuple[str, ...]] = {}
    text = _FILE.read_text("utf-8").rpartition("\n# ")[2].partition("\n")[2]
    for entry in text.rstrip("\n").replace("\n ", "\r ").split("\n"):
        key = stem(entry[: entry.index("\t")])
        found[key] = (*found.get(key, ()), entry)
    return found


def _facts(entry: str) -> PluginFacts:
    lines = entry.split("\r")
    file, generation, classes, once, serves = lines[0].split("\t")
    namings = tuple(_naming(line[1:]) for line in lines[1:] if line[1] != "=")
    listed = next((line[2:] for line in lines[1:] if line[1] == "="), "")
    return PluginFacts(
        file,
        generation,
        tuple(filter(None, classes.split(","))),
        once,
        tuple(filter(None, serves.split(","))),
        namings,
        frozenset(filter(None, listed.split(","))),
    )


def _naming(line: str) -> Naming:
    path, kind, *flags = line.split("\t")
    return Naming(path, kind, "scoped" in flags, "comma" in flags)
