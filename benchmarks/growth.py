"""How the work of the commands grows with the size of a document: ``python -m benchmarks.growth [NAME…]``.

Each dimension makes a document in which one thing occurs n times. Linear work grows with n to the
power of 1; the exponent is that from n to 4n. The measured time is that of the processor, in s;
``work`` counts instead, which does not depend on the machine.
"""

from __future__ import annotations

import argparse
import gc
import io
import math
import os
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterable
from contextlib import redirect_stderr, redirect_stdout, suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from types import FrameType
from typing import Any, NamedTuple

from sdfcheck.cli.main import main as run_command
from sdfcheck.lint.call import lint

TABLE = Path(__file__).parents[1] / "docs/testing.md"
MOST = 1.1
"""The largest exponent that still counts as linear."""


class Dimension(NamedTuple):
    """A kind of document, by the name of its file, and its text with something in it n times."""

    file: str
    text: Callable[[int], str]
    target: tuple[str, ...] | None = None


def _sdf(inside: str) -> str:
    return f'<sdf version="1.9"><model name="m"><link name="l"/>{inside}</model></sdf>'


def _urdf(inside: str) -> str:
    return f'<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a"/>{inside}</robot>'


def _xacro(inside: str) -> str:
    return f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{inside}</robot>'


def _each(part: str, n: int) -> str:
    """The part n times, with its number for ``#``."""
    return "".join(part.replace("#", str(number)) for number in range(n))


def _sdf_of(part: str) -> Dimension:
    return Dimension("a.sdf", lambda n: _sdf(_each(part, n)))


def _world_of(part: str) -> Dimension:
    return Dimension("a.sdf", lambda n: f'<sdf version="1.9"><world name="w">{_each(part, n)}</world></sdf>')


def _urdf_of(part: str) -> Dimension:
    return Dimension("a.urdf", lambda n: _urdf(_each(part, n)))


def _drake_of(part: str) -> Dimension:
    return Dimension("a.urdf", lambda n: _urdf(_each(part, n)), ("drake",))


def _xacro_of(part: str) -> Dimension:
    return Dimension("a.xacro", lambda n: _xacro(_each(part, n)))


def _nested(start: str, end: str) -> Dimension:
    return Dimension("a.sdf", lambda n: _sdf(_each(start, n // 20) + end * (n // 20)))


_GROUP = '<drake:collision_filter_group name="g{}">{}</drake:collision_filter_group>'
_INERTIAL = (
    "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz>"
    "<ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial>"
)
_COLLISION = '<collision name="c#"><geometry><sphere><radius>1</radius></sphere></geometry></collision>'
_REVOLUTE = '<limit lower="0" upper="1" effort="1" velocity="1"/>'

DIMENSIONS: dict[str, Dimension] = {
    # Elements.
    "links": _sdf_of('<link name="l#"/>'),
    "links with inertia": _sdf_of(f'<link name="l#">{_INERTIAL}</link>'),
    "links of one name": _sdf_of('<link name="x"/>'),
    "frames": _sdf_of('<frame name="f#"/>'),
    "frames in a chain": _sdf_of('<frame name="f#" attached_to="l"/>'),
    "joints": _sdf_of(
        '<link name="k#"/><joint name="j#" type="fixed"><parent>l</parent><child>k#</child></joint>'
    ),
    "joints without links": _sdf_of(
        '<joint name="j#" type="fixed"><parent>p#</parent><child>c#</child></joint>'
    ),
    "joints of one name": _sdf_of(
        '<link name="k#"/><joint name="j" type="fixed"><parent>l</parent><child>k#</child></joint>'
    ),
    "joints of one child": _sdf_of(
        '<link name="k#"/><joint name="j#" type="fixed"><parent>k#</parent><child>l</child></joint>'
    ),
    "frames attached to nothing": _sdf_of('<frame name="f#" attached_to="nothing#"/>'),
    "collisions": Dimension(
        "a.sdf",
        lambda n: _sdf(f'<link name="k">{_each(_COLLISION, n)}</link>'),
    ),
    "models": _world_of('<model name="m#"><link name="l"/></model>'),
    "models of one name": _world_of('<model name="m"><link name="l"/></model>'),
    "includes that lead nowhere": _world_of("<include><uri>model://m#</uri></include>"),
    "plugins": _world_of('<plugin name="p#" filename="libp#.so"/>'),
    "lights": _world_of('<light name="s#" type="point"/>'),
    "nested models": _nested('<model name="n#"><link name="l"/>', "</model>"),
    "unknown elements": _sdf_of("<unknown#/>"),
    "children of an unknown element": Dimension("a.sdf", lambda n: _sdf("<own>" + "<a/>" * n + "</own>")),
    "repeated elements": _sdf_of("<static>1</static>"),
    "attributes": Dimension("a.sdf", lambda n: _sdf('<link name="k"' + _each(' a#="1"', n) + "/>")),
    "custom elements": _sdf_of('<a:own xmlns:a="https://example.org/a">1</a:own>'),
    "undeclared prefixes": _sdf_of("<a#:own/>"),
    # Text.
    "numbers in a pose": Dimension("a.sdf", lambda n: _sdf("<pose>" + "0 " * n + "</pose>")),
    "numbers that are malformed": Dimension("a.sdf", lambda n: _sdf("<pose>" + "x " * n + "</pose>")),
    "lines": Dimension("a.sdf", lambda n: _sdf("\n" * n)),
    "comments": _sdf_of("<!-- # -->"),
    "comments with hyphens": _sdf_of("<!-- -- # -->"),
    "ampersands": _sdf_of("<a>& #</a>"),
    "mismatched tags": _sdf_of('<link name="l#"></lnik>'),
    "tags that are not closed": _sdf_of('<link name="l#">'),
    "tags that are not opened": _sdf_of("</link>"),
    # Comments that address the linter.
    "ignore comments": _sdf_of('<!-- sdfcheck: ignore[NAM001] --><link name="x"/>'),
    "ignore comments of no use": _sdf_of('<!-- sdfcheck: ignore[NAM001] --><link name="l#"/>'),
    "disable and enable comments": _sdf_of(
        '<!-- sdfcheck: disable[NAM001] --><link name="x"/><!-- sdfcheck: enable[NAM001] -->'
    ),
    "comments that enable everything": _sdf_of("<!-- sdfcheck: disable[NAM001] --><!-- sdfcheck: enable -->"),
    # URDF.
    "links of URDF": _urdf_of(
        '<link name="l#"/><joint name="j#" type="fixed"><parent link="a"/><child link="l#"/></joint>'
    ),
    "joints of URDF of one name": _urdf_of(
        '<link name="l#"/><joint name="j" type="fixed"><parent link="a"/><child link="l#"/></joint>'
    ),
    "joints of URDF of one child": _urdf_of(
        '<link name="l#"/><joint name="j#" type="fixed"><parent link="l#"/><child link="a"/></joint>'
    ),
    "links of URDF in a chain": Dimension(
        "a.urdf",
        lambda n: _urdf(
            '<link name="l0"/>'
            + "".join(
                f'<link name="l{i + 1}"/><joint name="j{i}" type="revolute"><parent link="l{i}"/>'
                f'<child link="l{i + 1}"/>{_REVOLUTE}</joint>'
                for i in range(n)
            )
        ),
    ),
    "materials without use": _urdf_of('<material name="m#"><color rgba="0 0 0 1"/></material>'),
    "materials that are nowhere": _urdf_of(
        '<link name="l#"><visual><geometry><sphere radius="1"/></geometry><material name="m#"/></visual></link>'
        '<material name="n#"><color rgba="1 1 1 1"/></material>'
    ),
    "gazebo blocks": _urdf_of('<gazebo reference="a"><selfCollide>1</selfCollide></gazebo>'),
    "gazebo blocks that lead nowhere": _urdf_of('<gazebo reference="b#"/>'),
    "mimicking joints without inertia": _urdf_of(
        '<link name="l#"/><joint name="j#" type="revolute"><parent link="a"/><child link="l#"/>'
        f'{_REVOLUTE}<mimic joint="j0"/></joint>'
    ),
    # Drake.
    "collision filter groups": _drake_of(_GROUP.format("#", '<drake:member link="a"/>')),
    "collision filter groups of one name": _drake_of(_GROUP.format("", '<drake:member link="a"/>')),
    "members of a collision filter group": Dimension(
        "a.urdf", lambda n: _urdf(_GROUP.format("", _each('<drake:member link="a"/>', n))), ("drake",)
    ),
    "members of unknown links": Dimension(
        "a.urdf", lambda n: _urdf(_GROUP.format("", _each('<drake:member link="b#"/>', n))), ("drake",)
    ),
    "ignored collision filter groups": Dimension(
        "a.urdf",
        lambda n: _urdf(
            _each(_GROUP.format("#", '<drake:member link="a"/>'), n)
            + _GROUP.format(
                "", _each('<drake:ignored_collision_filter_group name="g#"/>', n) + '<drake:member link="a"/>'
            )
        ),
        ("drake",),
    ),
    "members in SDFormat": Dimension(
        "a.sdf",
        lambda n: (
            '<sdf version="1.9" xmlns:drake="drake.mit.edu"><model name="m"><link name="l"/>'
            + _GROUP.format("", "<drake:member>l</drake:member>" * n)
            + "</model></sdf>"
        ),
        ("drake",),
    ),
    # xacro.
    "properties with a use": _xacro_of('<xacro:property name="p#" value="1"/><link name="l${p#}"/>'),
    "macros": _xacro_of('<xacro:macro name="m#" params="a"><link name="l#"/></xacro:macro><xacro:m# a="1"/>'),
    "calls of a small macro": Dimension(
        "a.xacro",
        lambda n: _xacro(
            '<xacro:macro name="m" params="a"><link name="${a}"/></xacro:macro>'
            + _each('<xacro:m a="l#"/>', n)
        ),
    ),
}
"""Everything that may occur often in a document, wanted or not."""


_NEXT = '<joint name="j#" type="fixed"><parent link="a"/><child link="k#"/></joint>'
_MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
_BOX = '<geometry><box size="1 1 1"/></geometry>'
_HELD = (
    f'<link name="k#">{_MASS}</link><joint name="j#" type="revolute"><parent link="a"/><child link="k#"/>'
    f'<axis xyz="0 0 1"/>{_REVOLUTE}</joint>'
)


def _chain_of(kind: str) -> Dimension:
    part = (
        f'<link name="l@">{_MASS}</link><joint name="j#" type="{kind}"><parent link="l#"/><child link="l@"/>'
        f'<axis xyz="0 0 1"/>{_REVOLUTE}</joint>'
    )
    return Dimension("a.urdf", lambda n: _urdf(_base() + _steps(part, n)))


def _base() -> str:
    return f'<link name="l0">{_MASS}</link><joint name="j" type="fixed"><parent link="a"/><child link="l0"/></joint>'


def _steps(part: str, n: int) -> str:
    """The part n times, with its number for ``#`` and the next number for ``@``."""
    return "".join(part.replace("#", str(number)).replace("@", str(number + 1)) for number in range(n))


def _on_a_link(start: str, part: str, end: str) -> Dimension:
    return Dimension("a.urdf", lambda n: _urdf(_base().replace(_MASS, _MASS + start + _each(part, n) + end)))


class Series(NamedTuple):
    """Documents with something n times, the commands that look at it, and what ``diff`` replaces for its second."""

    dimension: Dimension
    commands: tuple[str, ...]
    change: tuple[str, str] = ("", "")


_TO_SDF, _TO_URDF = "convert urdf-to-sdf", "convert sdf-to-urdf"
_MERGED, _LIKE = "convert urdf-to-sdf --fixed-joints merge", "convert urdf-to-sdf --like gazebo"
_UPGRADE = "convert sdf-to-sdf --sdf-version 1.11"

SERIES: dict[str, Series] = {
    "chain of revolute joints": Series(
        _chain_of("revolute"),
        ("lint", _TO_SDF, "diff", "targets", "print", "inertia", "view"),
        ('="l', '="x'),
    ),
    "chain of fixed joints": Series(
        _chain_of("fixed"), ("lint", _TO_SDF, _MERGED, _LIKE, "diff", "targets"), ('="j', '="x')
    ),
    "links on one link": Series(
        _urdf_of(_HELD), ("lint", _TO_SDF, "diff", "targets", "print", "inertia", "view"), ('="k', '="x')
    ),
    "fixed links on one link": Series(
        _urdf_of(_HELD.replace("revolute", "fixed")),
        (_TO_SDF, _MERGED, "diff"),
        ('xyz="0 0 1"', 'xyz="0 1 0"'),
    ),
    "collisions of a link": Series(
        _on_a_link("", f"<collision>{_BOX}</collision>", ""),
        ("lint", _TO_SDF, _MERGED, "diff", "print", "targets"),
        ("1 1 1", "1 1 2"),
    ),
    "named collisions of a link": Series(
        _on_a_link("", f'<collision name="c#"><origin xyz="# 0 0"/>{_BOX}</collision>', ""),
        ("lint", _TO_SDF, "diff"),
        ('="c', '="d'),
    ),
    "visuals of a link": Series(
        Dimension(
            "a.sdf",
            lambda n: _sdf(
                '<joint name="j" type="fixed"><parent>l</parent><child>q</child></joint><link name="q">'
                + _each('<visual name="v#"><geometry><box><size>1 1 1</size></box></geometry></visual>', n)
                + "</link>"
            ),
        ),
        ("lint", _TO_URDF, _UPGRADE, "diff", "print", "view"),
        ('"v', '"w'),
    ),
    "textures that are lost": Series(
        _on_a_link(
            "", f'<visual>{_BOX}<material name="m#"><texture filename="t#.png"/></material></visual>', ""
        ),
        ("lint", _TO_SDF, "diff", "print"),
        ('="t', '="u'),
    ),
    "attributes that are lost": Series(_on_a_link("", '<texture name="s"/>', ""), ("lint", _TO_SDF)),
    "frames attached in a chain": Series(
        Dimension(
            "a.sdf",
            lambda n: _sdf('<frame name="f0"/>' + _steps('<frame name="f@" attached_to="f#"/>', n)),
        ),
        ("lint", _TO_URDF, f"{_TO_URDF} --frames", _UPGRADE, "print", "diff", "targets"),
        ('"f', '"g'),
    ),
    "models in a model": Series(
        _sdf_of('<model name="n#"><link name="l"/></model>'),
        (
            "lint",
            _UPGRADE,
            _TO_URDF + " --forest fixed",
            "print",
            "diff",
            "graph frames",
            "inertia",
            "targets",
        ),
        ('"n', '"o'),
    ),
    "models nested in each other": Series(
        _sdf_of(
            '<model name="n#"><link name="l"/>' + '<model name="n"><link name="l"/>' * 9 + "</model>" * 10
        ),
        ("lint", _UPGRADE, "print", "diff"),
        ('"n', '"o'),
    ),
    "models of a world": Series(
        _world_of('<model name="m#"><pose># 0 0 0 0 0</pose><link name="l"/></model>'),
        ("lint", _UPGRADE, "print", "diff", "graph frames", "inertia", "view", "targets"),
        ('"m', '"o'),
    ),
    "transmissions": Series(
        _urdf_of(
            _HELD + '<transmission name="t#"><type>transmission_interface/SimpleTransmission</type>'
            '<joint name="j#"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>'
            '<actuator name="m#"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>'
        ),
        ("lint", _TO_SDF, "diff", "print", "targets"),
        ('"t', '"u'),
    ),
    "ros2_control blocks": Series(
        _urdf_of(
            _HELD
            + '<ros2_control name="c#" type="system"><hardware><plugin>mock_components/GenericSystem</plugin>'
            '</hardware><joint name="j#"><command_interface name="effort"/><state_interface name="position"/>'
            "</joint></ros2_control>"
        ),
        ("lint", _TO_SDF, "diff", "print", "targets"),
        ('"c', '"d'),
    ),
    "gazebo blocks of links": Series(
        _urdf_of(_HELD + '<gazebo reference="k#"><mu1>0.5</mu1><selfCollide>1</selfCollide></gazebo>'),
        ("lint", _TO_SDF, "diff", "print"),
        ("0.5", "0.6"),
    ),
    "gazebo blocks of merged links": Series(
        _urdf_of(
            _HELD.replace("revolute", "fixed")
            + '<gazebo reference="k#"><mu1>0.5</mu1><selfCollide>1</selfCollide></gazebo>'
        ),
        ("lint", _MERGED, _LIKE),
    ),
    "mimicking joints": Series(
        _urdf_of(_HELD.replace("<axis", '<mimic joint="j0"/><axis')), ("lint", _TO_SDF, "diff"), ('"k', '"x')
    ),
    "materials": Series(
        _urdf_of(
            f'<material name="m#"><color rgba="0 0 0 1"/></material><link name="k#">{_MASS}'
            f'<visual>{_BOX}<material name="m#"/></visual></link>' + _NEXT
        ),
        ("lint", _TO_SDF, "view", "diff", "print"),
        ("0 0 0 1", "0 0 1 1"),
    ),
    "missing meshes": Series(
        _urdf_of(
            f'<link name="k#">{_MASS}<visual><geometry><mesh filename="m#.stl"/></geometry></visual></link>'
            + _NEXT
        ),
        ("lint", "view", _TO_SDF, "diff", "inertia"),
        ('"m', '"o'),
    ),
    "unknown names with a common prefix": Series(
        _sdf_of(
            '<link name="robot_left_upper_section_actuator_#"/>'
            '<frame name="f#" attached_to="robot_left_upper_section_actuator_x#"/>'
        ),
        ("lint",),
    ),
    "letters of a name": Series(
        Dimension(
            "a.sdf",
            lambda n: _sdf(
                f'<link name="{"a" * 8 * n}"/><frame name="f" attached_to="{"a" * (8 * n - 1)}b"/>'
            ),
        ),
        ("lint",),
    ),
    "comments to fix": Series(_sdf_of("<!-- a -- # -->"), ("lint", "lint --diff", "lint --fix")),
    "bare ampersands": Series(_sdf_of('<link name="l# & b"/>'), ("lint", "lint --diff", "lint --fix")),
    "numbers to fix": Series(
        _sdf_of('<link name="l#"><pose>1,2 0 0 0 0 0</pose></link>'), ("lint", "lint --diff")
    ),
    "findings to silence": Series(
        _sdf_of('<link name="l#"><inertial><mass>0</mass></inertial></link>'), ("lint --add-ignore",)
    ),
    "findings in formats": Series(
        _sdf_of("<frame name='f#' attached_to='nothing'/>"),
        (
            "lint --output-format json",
            "lint --output-format html",
            "lint --output-format sarif",
            "lint --no-fold",
        ),
    ),
    "properties": Series(
        Dimension(
            "a.urdf.xacro",
            lambda n: _xacro('<link name="a"/>' + _each('<xacro:property name="p#" value="1"/>', n)),
        ),
        ("lint", "expand"),
    ),
    "properties of each other": Series(
        Dimension(
            "a.urdf.xacro",
            lambda n: _xacro(
                '<link name="a"/><xacro:property name="p0" value="1"/>'
                + _steps('<xacro:property name="p@" value="${p#}"/>', n)
            ),
        ),
        ("lint", "expand"),
    ),
    "calls of a macro": Series(
        Dimension(
            "a.urdf.xacro",
            lambda n: _xacro(
                '<xacro:macro name="m" params="a"><link name="${a}"/></xacro:macro>'
                + _each('<xacro:m a="l#"/>', n)
            ),
        ),
        ("lint", "expand", "expand --annotate"),
    ),
    "truths that are compared with texts": Series(
        _xacro_of(
            '<xacro:property name="p#" value="true"/><xacro:if value="${p# == \'true\'}"><link name="l#"/></xacro:if>'
        ),
        ("lint", "expand"),
    ),
    "arguments": Series(
        _xacro_of('<xacro:arg name="a#" default="l#"/><link name="$(arg a#)"/>'), ("lint", "expand")
    ),
    "unknown names in expressions": Series(_xacro_of('<link name="${nothing_#}"/>'), ("lint",)),
    "properties given twice in a macro": Series(
        Dimension(
            "a.urdf.xacro",
            lambda n: _xacro(
                f'<xacro:macro name="m" params="{_each("p# ", n)}">'
                + _each('<xacro:property name="p#" value="1"/>', n)
                + '<link name="a${p0}"/></xacro:macro>'
            ),
        ),
        ("lint",),
    ),
    "parameters of a macro": Series(
        Dimension(
            "a.urdf.xacro",
            lambda n: _xacro(
                f'<xacro:macro name="m" params="{_each("p# ", n)}"><link name="a${{p0}}"/></xacro:macro>'
                f"<xacro:m {_each('p#=' + chr(34) + '1' + chr(34) + ' ', n)}/>"
            ),
        ),
        ("lint", "expand"),
    ),
}
"""The commands and what may occur often in a document that concerns them."""
SHOWING = ("convert", "view", "print", "expand", "inertia", "targets", "graph", "diff")
"""Commands that write something about every document here."""
ENOUGH = 0.3
"""Seconds above the floor from which a size is measured: the times of the system are in steps of 0.01 s."""
QUICK = 0.1
"""With fewer seconds for the largest document an exponent says nothing but how coarse the clock is."""
LARGEST = 60_000
SURE = 1.05
"""An exponent above this is measured again with larger documents: what is steep gets steeper, noise does not."""
AGAIN, TOO_LONG = 3, 15.0


class DidNotRun(Exception):
    """A command that refused its document: its time says nothing."""


def seconds_of(command: str, series: Series, n: int) -> float:
    """Processor time that a command takes, in this process and its children; raises DidNotRun."""
    name = command.split(maxsplit=1)[0]
    with TemporaryDirectory() as project:
        folder = Path(project, "robot")
        folder.mkdir()
        Path(project, ".git").mkdir()  # otherwise all that lies beside the folder could be the project
        text = series.dimension.text(n)
        file, other = folder / series.dimension.file, folder / f"b-{series.dimension.file}"
        file.write_text(text)
        files = [str(file)]
        if name == "diff":
            other.write_text(text.replace(*series.change))
            files.append(str(other))
        shown, said, result = _captured(), _captured(), folder / "result"
        begin = _processor_time()
        with redirect_stdout(shown), redirect_stderr(said):
            code = run_command([*command.split(), "--isolated", *_to_a_file(name, result), *files])
        took = _processor_time() - begin
        written = result.stat().st_size if result.exists() else 0
        if code not in (0, 1) or (name in SHOWING and not written + len(_text_of(shown))):
            raise DidNotRun(f"exit code {code}: {_text_of(said)[:300] or _text_of(shown)[:300]}")
        return took


def _to_a_file(name: str, result: Path) -> list[str]:
    return ["-o", str(result)] if name in ("convert", "view") else []


def _captured() -> io.TextIOWrapper:
    return io.TextIOWrapper(io.BytesIO(), "utf-8", errors="replace")


def _text_of(stream: io.TextIOWrapper) -> str:
    stream.flush()
    written = stream.buffer
    assert isinstance(written, io.BytesIO)
    return " ".join(written.getvalue().decode("utf-8", "replace").split())


def _processor_time() -> float:
    used = os.times()
    return time.process_time() + used.children_user + used.children_system


class Grown(NamedTuple):
    """The time of a command for n, 2n and 4n parts, s above the floor, and the exponent from the first to the last."""

    n: int
    seconds: list[float]
    exponent: float


def growth_of(command: str, series: Series, enough: float = ENOUGH) -> Grown:
    """How a command grows with a series; raises DidNotRun.

    The smallest document is one that takes ``enough`` s above the floor, the time for a document of 5 parts.
    Each time is the better of two: a busy machine makes times longer, never shorter.
    """
    seconds_of(command, series, 10)
    floor = min(seconds_of(command, series, 5) for _ in range(3))
    n = 250
    while seconds_of(command, series, n) - floor < enough and n < LARGEST:
        n *= 2
    found = _measured(command, series, n, floor)
    for _ in range(AGAIN):
        if found.exponent <= SURE or found.seconds[-1] > TOO_LONG or found.n > LARGEST:
            break
        with suppress(DidNotRun):  # some limit
            found = _measured(command, series, 2 * found.n, floor)
    return found


def _measured(command: str, series: Series, n: int, floor: float) -> Grown:
    took = []
    for factor in (1, 2, 4):
        gc.collect()
        took.append(min(seconds_of(command, series, n * factor) for _ in range(2)) - floor)
    return Grown(n, took, exponent(max(took[0], 1e-3), max(took[2], 1e-3), 4))


def all_series() -> dict[str, Series]:
    """The documents with the commands to measure: ``lint`` for every dimension, and what is in SERIES."""
    of_lint = {
        name: Series(each, (" ".join(("lint", *(f"--target {one}" for one in each.target or ()))),))
        for name, each in DIMENSIONS.items()
    }
    return {**of_lint, **SERIES}


def measure(names: Iterable[str]) -> tuple[dict[str, dict[str, Grown]], bool]:
    """Print a line for each document and command; returns what was measured, and whether all is linear."""
    found: dict[str, dict[str, Grown]] = defaultdict(dict)
    are_linear = True
    series = all_series()
    for name, command in [(each, command) for each in names for command in series[each].commands]:
        try:
            grown = found[name][command] = growth_of(command, series[name])
        except DidNotRun as problem:
            are_linear = False
            print(f"{name}: {command} did not run: {problem}", file=sys.stderr, flush=True)
            continue
        is_steep = grown.exponent > MOST and grown.seconds[-1] > QUICK
        are_linear = are_linear and not is_steep
        times = "  ".join(f"{each:6.2f}" for each in grown.seconds)
        steep = "  steep" if is_steep else ""
        print(f"{name:40} {command:42} {grown.n:7,} {times}  n^{grown.exponent:.2f}{steep}", flush=True)
    return found, are_linear


def write_table(found: dict[str, dict[str, Grown]]) -> None:
    """Put the exponents where the documentation shows them."""
    lines = ["| document | exponents |", "|---|---|"]
    for name, commands in found.items():
        lines.append(
            f"| {name} | {', '.join(f'`{each}` {commands[each].exponent:.2f}' for each in commands)} |"
        )
    before, _, rest = TABLE.read_text("utf-8").partition("<!-- growth -->\n")
    after = rest.partition("<!-- /growth -->")[2]
    text = "\n".join(lines)
    TABLE.write_text(f"{before}<!-- growth -->\n{text}\n<!-- /growth -->{after}", "utf-8")


def work(dimension: Dimension, n: int) -> int:
    """How many lines of code run to lint a document; a loop in one line counts each time around."""
    text = dimension.text(n)
    count = 0

    def trace(frame: FrameType, event: str, argument: Any) -> Any:
        nonlocal count
        count += 1
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        lint(text, name=dimension.file, isolated=True, target=dimension.target)
    finally:
        sys.settrace(before)
    return count


def exponent(small: float, large: float, factor: float) -> float:
    """The power of the size with which something grows."""
    return math.log(large / small) / math.log(factor)


def main() -> int:
    """Measure, print a line for each document and command; 1 if one is not linear or did not run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", help="the documents to measure (default: all)")
    parser.add_argument("--write", action="store_true", help="write the table of docs/testing.md")
    given = parser.parse_args()
    # As in the program: trees are acyclic, and the collector would look at all of them again and again.
    gc.disable()
    found, are_linear = measure(given.names or all_series())
    if given.write:
        write_table(found)
    return int(not are_linear)


if __name__ == "__main__":
    sys.exit(main())
