"""Each element and attribute of SDFormat with odd values: does Gazebo refuse what it is said to refuse, and no more?"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import pytest

import sdfcheck
from sdfcheck import Consumer
from sdfcheck.consumers.engines import RUN_BY, is_installed
from sdfcheck.formats.schema import NOT_GIVEN, Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.version import NEWEST, Version
from tests.peers.consumers import loads
from tests.peers.differences import refusal

VALUES = ("", "abc", "inf", "-5 1 1")
LINKS = '<link name="base"/><link name="arm"/>'
ENDS = {"parent": "base", "child": "arm"}
TYPES = {
    ("joint", None): "revolute",
    ("joint", "axis2"): "universal",
    ("joint", "gearbox_ratio"): "gearbox",
    ("joint", "gearbox_reference_body"): "gearbox",
    ("joint", "screw_thread_pitch"): "screw",
    ("joint", "thread_pitch"): "screw",
    ("light", None): "point",
    ("light", "spot"): "spot",
    ("sensor", None): "imu",
    ("sensor", "rfidtag"): "rfidtag",
    ("sensor", "transceiver"): "wireless_receiver",
}
"""Element and the child in it that is tried → the type that has it; a sensor's is mostly the child's name."""
_NOISE = "model/link/sensor/air_pressure/pressure/noise/@type"
KNOWN = frozenset(
    (
        "world/actor/script/trajectory/waypoint/pose = ''",
        "model/link/inertial/inertia/ixx = 'inf'",
        *(f"{_NOISE} = {value!r}" for value in VALUES[1:]),
    )
)
"""Verdicts that are not as predicted."""
OLD = Version(1, 6)
STATE = "world/state/"
"""Up to 1.11 its models are called otherwise, and nobody reads them."""

GAZEBO = RUN_BY[Consumer.GAZEBO]
pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not is_installed(GAZEBO), reason="libsdformat is not installed"),
]


class Place(NamedTuple):
    """An element, below those that it is in, from the root on."""

    above: tuple[Definition, ...]
    element: Definition

    @property
    def path(self) -> str:
        return "/".join(each.name for each in (*self.above[1:], self.element))

    def document(self, attributes: str, content: str) -> str:
        """A document with the element, and with all that is required around it."""
        inner, child = f"<{self.element.name}{attributes}>{content}</{self.element.name}>", self.element.name
        for around in reversed(self.above):
            beside = LINKS if around.name == "model" else required(around, child)
            inner = f"<{around.name}{written(around, child)}>{beside}{inner}</{around.name}>"
            child = around.name
        return inner


def written(element: Definition, child: str | None = None, **given: str) -> str:
    """The required attributes of an element that is to hold a child, and those ``given``."""
    found = {name: _usual(element, name, child) for name in element.required_attributes}
    return "".join(f' {name}="{value}"' for name, value in {**found, **given}.items())


def _usual(element: Definition, name: str, child: str | None) -> str:
    known = element.attributes[name]
    if name == "version":
        return str(element.version)
    if name == "type" and element.name in {"joint", "light", "sensor"}:
        listed = child if element.name == "sensor" and child in known.listed else None
        return TYPES.get((element.name, child)) or listed or TYPES[element.name, None]
    default = known.default if known.default not in {None, "", NOT_GIVEN} else "x"
    return (known.listed or (default,))[0]


def required(element: Definition, without: str = "") -> str:
    """The children that an element needs, with their defaults."""
    children = (element.children[name] for name in element.required_children if name != without)
    return "".join(f"<{each.name}{written(each)}>{usual(each)}</{each.name}>" for each in children)


def usual(element: Definition) -> str:
    """The content of an element with which nothing is wrong."""
    if element.name == "model":
        return LINKS
    if element.name in ENDS and element.path.startswith("joint/"):
        return ENDS[element.name]
    if element.type is None:
        return required(element)
    return element.default if element.default not in {None, "", NOT_GIVEN} else "x"


def places(element: Definition, above: tuple[Definition, ...], seen: set[str]) -> Iterator[Place]:
    """The element and all below it, each definition once."""
    if element.place not in seen:
        seen.add(element.place)
        yield Place(above, element)
        for child in element.children.values():
            yield from places(child, (*above, element), seen)


def trials(place: Place) -> Iterator[tuple[str, str]]:
    """The changes to a place, each with its document; the first changes nothing."""
    plain = written(place.element)
    yield "", place.document(plain, usual(place.element))
    for value in VALUES if place.element.type is not None else ():
        yield f" = {value!r}", place.document(plain, value)
    for name in place.element.attributes:
        for value in VALUES:
            yield (
                f"/@{name} = {value!r}",
                place.document(written(place.element, **{name: value}), usual(place.element)),
            )


def written_out(found: Sequence[Place], folder: Path) -> dict[Path, tuple[Place, str]]:
    """The documents of some places, as files."""
    files = {}
    for number, place in enumerate(found):
        for each, (change, text) in enumerate(trials(place)):
            path = folder / f"{number}-{each}.sdf"
            path.write_text(text)
            files[path] = place, change
    return files


@pytest.mark.parametrize("version", [NEWEST, OLD], ids=str)
def test_each_place(version: Version, tmp_path: Path) -> None:
    root = schema(version).root
    seen: set[str] = set()
    # Models first: where a part of one is elsewhere, not all of it is read.
    children = sorted(root.children.values(), key=lambda each: each.name != "model")
    files = written_out([place for child in children for place in places(child, (root,), seen)], tmp_path)
    taken = loads(GAZEBO, list(files))
    sound = {place for path, (place, change) in files.items() if not change and taken[path]}
    assert len(sound) > 300
    differing = {
        place.path + change
        for path, (place, change) in files.items()
        if place in sound
        and taken[path]
        is not (
            refusal(sdfcheck.lint(path, isolated=True, target=("gazebo",)).diagnostics, Consumer.GAZEBO)
            is None
        )
    }
    found = {each for each in differing - KNOWN if version is NEWEST or not each.startswith(STATE)}
    assert not found, "\n".join(sorted(found))
