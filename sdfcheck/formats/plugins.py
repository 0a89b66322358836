"""The plugins of Gazebo: their classes, their parameters, and the things that parameters name."""

from __future__ import annotations

import re
from functools import cache, lru_cache
from itertools import product
from pathlib import Path

from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import pattern

_FILE = Path(__file__).parent / "data" / "plugins.txt"
_PREFIX = pattern(r"^(?:ignition-gazebo\d*-|gz-sim\d*-)")
_VERSIONED = pattern(r"^(gz::sim|ignition::gazebo)::v\d+::")
_LONGEST = 8
"""Letters of a name that is tried in all spellings."""
GZ_SIM = "gz-sim"
GUI = ("gz-gui", "gz-sim gui")


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
    required: frozenset[str]
    """Those without which it does not run."""
    repeatable: frozenset[str]
    """Those that it may read several times; of others it reads the first."""
    patterns: tuple[str, ...]
    """Regular expressions of the names of further parameters."""
    last: str
    """The last major release that has it; empty where it is still there."""
    places: tuple[str, ...]
    """The elements that it runs in; empty where it runs in any."""
    runs_elsewhere: bool
    """Does it run in others as well, under a wrong name?"""
    values: tuple[tuple[str, str], ...]
    """The values of parameters, by their paths, in the form that :func:`allows` reads."""

    def is_class(self, name: str) -> bool:
        """Is it the name of a class in it? Full names with the version are accepted as well."""
        plain = _VERSIONED.sub(r"\1::", name)
        return not self.classes or plain in self.classes

    def reads(self, name: str) -> bool:
        """Is it the name of a parameter?"""
        return name in self.parameters or any(re.fullmatch(pattern, name) for pattern in self.patterns)

    def has_naming(self, name: str) -> bool:
        """Is it the name of a parameter that names a joint or link?"""
        return any(each.path == name for each in self.namings)

    def in_other_case(self, name: str) -> str | None:
        """The parameter of a pattern that differs from a name in the case of letters only."""
        if not self.patterns or len(name) > _LONGEST:
            return None
        spellings = ("".join(letters) for letters in product(*((c.lower(), c.upper()) for c in name)))
        return next((each for each in spellings if each != name and self.reads(each)), None)


def stem(filename: str) -> str:
    """The name by which a file is known: without folder, ``lib``, ``.so`` and old prefixes."""
    base = filename.rpartition("/")[2].removeprefix("lib").removesuffix(".so")
    return _PREFIX.sub("gz-sim-", base)


@lru_cache(maxsize=1000)
def known(filename: str) -> tuple[PluginFacts, ...]:
    """The entries of a file, by generations."""
    return tuple(map(_facts, _entries().get(stem(filename), ())))


@lru_cache(maxsize=1000)
def counterparts(filename: str) -> tuple[PluginFacts, ...]:
    """The entries of files that do the same in other generations, such as the drives of Classic."""
    own = _purpose(stem(filename))
    return tuple(facts for key in _entries() if _purpose(key) == own for facts in known(key))


@lru_cache(maxsize=1000)
def other_drives(filename: str) -> tuple[PluginFacts, ...]:
    """The entries of the other drives in the generations of a drive."""
    drives = (facts for key in _entries() if key.endswith("_drive") for facts in known(key))
    own = known(filename)
    generations = {facts.generation for facts in own}
    return tuple(each for each in drives if each.generation in generations and each not in own)


def _purpose(stem: str) -> str:
    return stem.removeprefix("gz-sim-").removeprefix("gazebo_ros_").removesuffix("-system").replace("-", "_")


@cache
def known_files() -> tuple[str, ...]:
    """The files of gz-sim's own systems, without ``lib`` and ``.so``."""
    return tuple(name for name, entries in _entries().items() if f"\t{GZ_SIM}\t" in entries[0])


@cache
def systems() -> tuple[str, ...]:
    """The files of gz-sim's own systems that its newest release has, under the names that are written."""
    newest = {name: _facts(_entries()[name][0]) for name in known_files()}
    return tuple(sorted(name for name, facts in newest.items() if not facts.last))


def file_of_class(name: str) -> str | None:
    """The file of gz-sim's own system that has a class."""
    having = (file for file in known_files() if name in _facts(_entries()[file][0]).classes)
    return next(having, None)


@cache
def ros_files() -> tuple[str, ...]:
    """The files of the plugins of ROS for Gazebo Classic, without ``lib`` and ``.so``."""
    return tuple(name for name in _entries() if name.startswith("gazebo_ros_"))


@cache
def gui_files() -> tuple[str, ...]:
    """The files of the plugins of Gazebo's window."""
    return tuple(
        name for name, entries in _entries().items() if any(f"\t{kind}" in entries[0] for kind in GUI)
    )


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
    file, generation, classes, once, serves, last, places = (*lines[0].split("\t"), *[""] * 6)[:7]
    listed = next((line[2:].split(",") for line in lines[1:] if line[1] == "="), [])
    patterns = next((line[2:].split("\t") for line in lines[1:] if line[1] == "~"), [])
    return PluginFacts(
        file,
        generation,
        tuple(filter(None, classes.split(","))),
        once,
        tuple(filter(None, serves.split(","))),
        tuple(_naming(line[1:]) for line in lines[1:] if line[1] not in "=~:"),
        frozenset(name.rstrip("!+") for name in listed),
        frozenset(name.rstrip("!+") for name in listed if "!" in name),
        frozenset(name.rstrip("!+") for name in listed if "+" in name),
        tuple(patterns),
        last,
        tuple(filter(None, places.removeprefix("~").split(","))),
        places.startswith("~"),
        tuple(_pair(line[2:]) for line in lines[1:] if line[1] == ":"),
    )


def _pair(line: str) -> tuple[str, str]:
    path, _, allowed = line.partition("\t")
    return path, allowed


def allows(allowed: str, text: str) -> bool:
    """May a parameter have a value? ``cw|ccw``, ``> 0``, ``>= 0`` and ``0..1`` say so.

    A text where a number belongs is left open.
    """
    words = allowed.split("|")
    try:
        number = float(text)
        if allowed[0] == ">":
            return number >= 0 if "=" in allowed else number > 0
        if ".." in allowed:
            low, high = map(float, allowed.split(".."))
            return low <= number <= high
        return text in words or number in map(float, words)
    except ValueError:
        return text in words or words[0][-1].isdigit()


def _naming(line: str) -> Naming:
    path, kind, *flags = line.split("\t")
    return Naming(path, kind, "scoped" in flags, "comma" in flags)
