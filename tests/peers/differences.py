"""Where sdfcheck and a consumer differ on files with one change.

``python -m tests.peers.differences FOLDER --consumer gazebo`` takes the files below a folder that
both find sound, changes one element or attribute of a file at a time, and asks both again. It prints
the changes that the consumer refuses and sdfcheck says nothing about, and those that it takes although
sdfcheck says that it refuses them. Each of them is a mistake of one of the two.
"""

from __future__ import annotations

import argparse
import copy
import random
import shutil
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from lxml import etree

import sdfcheck
from sdfcheck import Consumer, Diagnostic, Severity
from tests.peers.consumers import installed

FOLDER = Path("build/differences")
LARGEST = 60_000
"""bytes: larger files take too long."""
SDF, URDF = (".sdf", ".world"), (".urdf",)

VALUES = (
    "", "abc", "-1", "0", "nan", "inf", "1e400", "1 2 3", "true", "0 0 0 0 0 0", "x::y", "__model__", "world",
    "1.5", "99999999999", "0x10", "1,5", " 1 ", ".5", "1e-3", "+1", "1 2", "1 2 3 4", "link", "base",
)  # fmt: skip
NAMES = (
    "mass", "pose", "link", "joint", "static", "axis", "geometry", "size", "name", "frame", "inertial", "material",
    "plugin", "sensor", "limit", "origin",
)  # fmt: skip

Change = Callable[[random.Random, list[etree._Element]], str | None]
"""Changes the tree, and says how; None where it cannot."""


def text(chance: random.Random, elements: list[etree._Element]) -> str | None:
    element, value = chance.choice(elements), chance.choice(VALUES)
    if len(element):
        return None
    element.text = value
    return f"{_title(element)} = {value!r}"


def attribute(chance: random.Random, elements: list[etree._Element]) -> str | None:
    element, value = chance.choice(elements), chance.choice(VALUES)
    if not element.attrib:
        return None
    name = chance.choice(_names(element))
    element.set(name, value)
    return f"{_title(element)}/@{name} = {value!r}"


def lost_attribute(chance: random.Random, elements: list[etree._Element]) -> str | None:
    element = chance.choice(elements)
    if not element.attrib:
        return None
    name = chance.choice(_names(element))
    del element.attrib[name]
    return f"{_title(element)} without @{name}"


def lost_element(chance: random.Random, elements: list[etree._Element]) -> str | None:
    element = chance.choice(elements)
    if (parent := element.getparent()) is None:
        return None
    parent.remove(element)
    return f"{parent.tag} without {element.tag}"


def doubled_element(chance: random.Random, elements: list[etree._Element]) -> str | None:
    element = chance.choice(elements)
    if element.getparent() is None:
        return None
    element.addnext(copy.deepcopy(element))
    return f"{_title(element)} twice"


def moved_element(chance: random.Random, elements: list[etree._Element]) -> str | None:
    element, place = chance.choice(elements), chance.choice(elements)
    if element.getparent() is None or place is element or element in place.iterancestors():
        return None
    title = _title(element)
    place.append(element)
    return f"{title} moved into {place.tag}"


def new_element(chance: random.Random, elements: list[etree._Element]) -> str | None:
    place, name = chance.choice(elements), chance.choice(NAMES)
    etree.SubElement(place, name).text = chance.choice(VALUES)
    return f"{name} in {place.tag}"


def other_tag(chance: random.Random, elements: list[etree._Element]) -> str | None:
    element, other = chance.choice(elements), chance.choice(elements)
    if element.getparent() is None:
        return None
    title = _title(element)
    element.tag = other.tag
    return f"{title} called {other.tag}"


def shared_name(chance: random.Random, elements: list[etree._Element]) -> str | None:
    named = [element for element in elements if element.get("name")]
    if len(named) < 2:
        return None
    first, second = chance.sample(named, 2)
    first.set("name", second.get("name", ""))
    return f"{_title(first)} with the name of a {second.tag}"


CHANGES: tuple[Change, ...] = (
    text, attribute, lost_attribute, lost_element, doubled_element, moved_element, new_element, other_tag, shared_name,
)  # fmt: skip


def _names(element: etree._Element) -> list[str]:
    return [str(name) for name in element.attrib]


def _title(element: etree._Element) -> str:
    parent = element.getparent()
    return str(element.tag) if parent is None else f"{parent.tag}/{element.tag}"


def concerns(diagnostic: Diagnostic, consumer: Consumer) -> bool:
    """Is a warning or an error about this consumer, or about all?"""
    if diagnostic.severity is Severity.INFO:
        return False
    return not diagnostic.affects or consumer.value in diagnostic.concerned


def refusal(found: Sequence[Diagnostic], consumer: Consumer) -> Diagnostic | None:
    """The first diagnostic that says that a consumer refuses the file."""
    for diagnostic in found:
        if any(who == consumer.value and reaction.is_refusal for who, reaction in diagnostic.affects):
            return diagnostic
    return None


def lint(path: Path, consumer: Consumer) -> Sequence[Diagnostic]:
    return sdfcheck.lint(path, isolated=True, target=(consumer.value,)).diagnostics


def mutants(origins: Sequence[Path], number: int, chance: random.Random) -> Iterator[tuple[Path, str]]:
    """Files with one change each, and the changes."""
    while number:
        origin = chance.choice(origins)
        root = etree.fromstring(origin.read_bytes().strip(), etree.XMLParser(recover=True))
        change = chance.choice(CHANGES)(chance, list(root.iter(etree.Element)))
        if change is not None:
            path = FOLDER / f"{number}{origin.suffix}"
            path.write_bytes(etree.tostring(root))
            yield path, change
            number -= 1


def is_apart(path: Path) -> bool:
    """Is a file small, and does it refer to no other?"""
    return path.stat().st_size <= LARGEST and b"://" not in path.read_bytes().replace(b"http://", b"")


def main() -> int:
    peers = installed()
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--consumer", type=Consumer, choices=peers, default=next(iter(peers), None))
    parser.add_argument("--dialect", choices=("sdf", "urdf"), default="sdf")
    parser.add_argument("--number", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if options.consumer is None:
        parser.error("no consumer is installed")
    consumer: Consumer = options.consumer
    ask_peer = peers[consumer]
    suffixes = SDF if options.dialect == "sdf" else URDF
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    files = [path for path in sorted(options.folder.rglob("*")) if path.suffix in suffixes and is_apart(path)]
    origins = [path for path, loads in ask_peer(files).items() if loads and not lint(path, consumer)]
    if not origins:
        parser.error(f"no file below {options.folder} is found sound by both")
    changes = dict(mutants(origins, options.number, random.Random(options.seed)))
    differences = 0
    for path, loads in ask_peer(list(changes)).items():
        found = lint(path, consumer)
        alarm = refusal(found, consumer) if loads else None
        is_silent = not loads and not any(concerns(each, consumer) for each in found)
        if is_silent or alarm is not None:
            differences += 1
            what = "not reported" if alarm is None else f"taken, but {alarm.message} [{alarm.code}]"
            print(f"{path}: {changes[path]}: {what}")
    print(f"changes: {len(changes)}, sound files: {len(origins)}, differences: {differences}")
    return 1 if differences else 0


if __name__ == "__main__":
    raise SystemExit(main())
