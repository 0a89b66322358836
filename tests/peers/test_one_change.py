"""A robot with one change at a time: do consumers refuse what they are said to refuse, and nothing else?"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck import Consumer
from sdfcheck.consumers.engines import RUN_BY, Engine, is_installed
from tests.peers.consumers import loads
from tests.peers.differences import refusal

INERTIAL = (
    '<inertial><origin xyz="0 0 0.1"/><mass value="1"/>'
    '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
)
LINKS = (
    f'<link name="a">{INERTIAL}<visual><geometry><cylinder radius="0.1" length="0.2"/></geometry>'
    '<material name="m"><color rgba="1 0 0 1"/></material></visual></link>'
    f'<link name="b">{INERTIAL}<collision><geometry><box size="1 1 1"/></geometry></collision></link>'
)
JOINT = (
    '<joint name="j" type="revolute"><origin xyz="0 0 1"/><parent link="a"/><child link="b"/>'
    '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/><dynamics damping="0.1"/></joint>'
)
ROBOT = f'<robot name="r">{LINKS}{JOINT}</robot>'
ALONE = f'<robot name="r"><link name="a">{INERTIAL}</link></robot>'

CHAIN = (
    f'<robot name="r"><link name="world"/><link name="base">{INERTIAL}</link><link name="arm">{INERTIAL}</link>'
    f'<link name="hand">{INERTIAL}</link><link name="tool"/>'
    '<joint name="w" type="fixed"><parent link="world"/><child link="base"/></joint>'
    '<joint name="j1" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>'
    '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
    '<joint name="j2" type="prismatic"><parent link="arm"/><child link="hand"/><axis xyz="1 0 0"/>'
    '<limit lower="0" upper="0.1" effort="1" velocity="1"/><mimic joint="j1" multiplier="0.5"/>'
    '<safety_controller k_velocity="1" soft_lower_limit="0" soft_upper_limit="0.1"/></joint>'
    '<joint name="j3" type="fixed"><parent link="hand"/><child link="tool"/></joint></robot>'
)

VALUES = ("", "abc", "inf", "nan", "1e400", "0x10", "1 ", "1kg")
TAG = re.compile(r"<(\w+)([^<>]*?)(/?)>")
ATTRIBUTE = re.compile(r' (\w+)="([^"]*)"')

EXEMPT = (Consumer.DRAKE, "linxk for link world")
"""It has a world anyway."""

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not any(map(is_installed, Engine)), reason="no consumer is installed"),
]


def changed(text: str, values: Sequence[str] = VALUES) -> Iterator[tuple[str, str]]:
    """The changes, each with its robot: a part left out or misspelled, an attribute with another value."""
    for tag in TAG.finditer(text):
        name, at = tag[1], tag.start()
        if name == "robot":
            continue
        inner = tag.end() if tag[3] else text.index(f"</{name}>", tag.end())
        end = tag.end() if tag[3] else inner + len(f"</{name}>")
        wrong = f"{name[:-1]}x{name[-1]}"
        closing = "" if tag[3] else f"{text[tag.end() : inner]}</{wrong}>"
        yield f"no {name}", text[:at] + text[end:]
        whose = " world" if tag[2] == ' name="world"' else ""
        yield f"{wrong} for {name}{whose}", f"{text[:at]}<{wrong}{tag[2]}{tag[3]}>{closing}{text[end:]}"
        for given in ATTRIBUTE.finditer(tag[2]):
            start = at + 1 + len(name)
            before, after = text[: start + given.start()], text[start + given.end() :]
            yield f"{name} without {given[1]}", before + after
            yield f"{given[1]}x of {name}", f'{before} {given[1]}x="{given[2]}"{after}'
            for value in values:
                yield f"{name}/@{given[1]} = {value!r}", f'{before} {given[1]}="{value}"{after}'


@pytest.mark.parametrize(
    ("text", "values"),
    [(ROBOT, VALUES), (ALONE, VALUES), (CHAIN, ("", "nan", "1 "))],
    ids=["two-links", "one-link", "chain"],
)
def test_one_change(text: str, values: Sequence[str], tmp_path: Path) -> None:
    changes: dict[Path, str] = {}
    for number, (change, robot) in enumerate(changed(text, values)):
        path = tmp_path / f"{number}.urdf"
        path.write_text(robot)
        changes[path] = change
    present = [consumer for consumer, engine in RUN_BY.items() if is_installed(engine)]
    target = tuple(consumer.value for consumer in present)
    found = {path: sdfcheck.lint(path, isolated=True, target=target).diagnostics for path in changes}
    taken = {engine: loads(engine, list(changes)) for engine in {RUN_BY[consumer] for consumer in present}}
    differing = [
        f"{consumer.value}: {change}: {'taken' if taken[RUN_BY[consumer]][path] else 'refused'}"
        for consumer in present
        for path, change in changes.items()
        if taken[RUN_BY[consumer]][path] is not (refusal(found[path], consumer) is None)
        and (consumer, change) != EXEMPT
    ]
    assert not differing, "\n".join(differing)
