"""How the work grows with each dimension of a document: ``python -m benchmarks.growth [NAME…]``.

Each dimension makes a document in which one thing occurs n times. Linear work grows with n to the
power of 1; the exponent is that from the first size to the last. The measured time is that of the
processor, in s; ``work`` counts instead, which does not depend on the machine.
"""

from __future__ import annotations

import argparse
import gc
import io
import math
import os
import sys
import time
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory
from types import FrameType
from typing import Any, NamedTuple

from sdfcheck.cli.main import main as run_command
from sdfcheck.lint.call import lint

SIZE = 500
FACTORS = (1, 2, 4, 8, 16)
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
    "materials": _urdf_of('<material name="m#"><color rgba="0 0 0 1"/></material>'),
    "materials that are nowhere": _urdf_of(
        '<link name="l#"><visual><geometry><sphere radius="1"/></geometry><material name="m#"/></visual></link>'
        '<material name="n#"><color rgba="1 1 1 1"/></material>'
    ),
    "gazebo blocks": _urdf_of('<gazebo reference="a"><selfCollide>1</selfCollide></gazebo>'),
    "gazebo blocks that lead nowhere": _urdf_of('<gazebo reference="b#"/>'),
    "mimicking joints": _urdf_of(
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
    "properties": _xacro_of('<xacro:property name="p#" value="1"/><link name="l${p#}"/>'),
    "macros": _xacro_of('<xacro:macro name="m#" params="a"><link name="l#"/></xacro:macro><xacro:m# a="1"/>'),
    "calls of a macro": Dimension(
        "a.xacro",
        lambda n: _xacro(
            '<xacro:macro name="m" params="a"><link name="${a}"/></xacro:macro>'
            + _each('<xacro:m a="l#"/>', n)
        ),
    ),
}
"""Everything that may occur often in a document, wanted or not."""


def _chain_of(kind: str) -> Dimension:
    part = (
        f'<link name="l@">{_MASS}</link><joint name="j#" type="{kind}"><parent link="l#"/><child link="l@"/>'
        f'<axis xyz="0 0 1"/>{_REVOLUTE}</joint>'
    )
    return Dimension(
        "a.urdf",
        lambda n: _urdf(
            f'<link name="l0">{_MASS}</link>'
            '<joint name="j" type="fixed"><parent link="a"/><child link="l0"/></joint>'
            + "".join(part.replace("#", str(i)).replace("@", str(i + 1)) for i in range(n))
        ),
    )


_MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
_NEXT = '<joint name="j#" type="fixed"><parent link="a"/><child link="k#"/></joint>'

SERIES: dict[str, tuple[Dimension, tuple[str, ...]]] = {
    "chain of revolute joints": (
        _chain_of("revolute"),
        ("convert urdf-to-sdf", "diff", "targets", "inertia"),
    ),
    "chain of fixed joints": (_chain_of("fixed"), ("convert urdf-to-sdf", "diff")),
    "collisions of a link": (
        Dimension(
            "a.urdf",
            lambda n: _urdf(
                f'<link name="b">{_MASS}'
                + '<collision><geometry><box size="1 1 1"/></geometry></collision>' * n
                + '</link><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
            ),
        ),
        ("convert urdf-to-sdf", "diff"),
    ),
    "visuals of a link": (
        Dimension(
            "a.sdf",
            lambda n: _sdf(
                '<joint name="j" type="fixed"><parent>l</parent><child>q</child></joint><link name="q">'
                + _each('<visual name="v#"><geometry><box><size>1 1 1</size></box></geometry></visual>', n)
                + "</link>"
            ),
        ),
        ("convert sdf-to-urdf", "diff", "print"),
    ),
    "textures that are lost": (
        Dimension(
            "a.urdf",
            lambda n: _urdf("").replace(
                '<link name="a"/>', '<link name="a">' + '<texture name="s"/>' * n + "</link>"
            ),
        ),
        ("convert urdf-to-sdf",),
    ),
    "frames attached in a chain": (
        Dimension(
            "a.sdf",
            lambda n: _sdf(
                '<frame name="f0"/>'
                + "".join(f'<frame name="f{i + 1}" attached_to="f{i}"/>' for i in range(n))
            ),
        ),
        ("lint", "convert sdf-to-urdf", "print"),
    ),
    "unknown names with a common prefix": (
        _sdf_of(
            '<link name="robot_left_upper_section_actuator_#"/>'
            '<frame name="f#" attached_to="robot_left_upper_section_actuator_x#"/>'
        ),
        ("lint",),
    ),
    "letters of a name": (
        Dimension(
            "a.sdf",
            lambda n: _sdf(f'<link name="{"a" * n}"/><frame name="f" attached_to="{"a" * (n - 1)}b"/>'),
        ),
        ("lint",),
    ),
    "missing meshes": (
        _urdf_of(
            '<link name="k#"><visual><geometry><mesh filename="m#.stl"/></geometry></visual></link>' + _NEXT
        ),
        ("lint", "view"),
    ),
    "comments to fix": (_sdf_of("<!-- a -- # -->"), ("lint --diff",)),
    "parameters of a macro": (
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
"""Documents in which something occurs n times, and the other commands that look at it."""
TWO_FILES = ("diff",)
TO_A_FILE = ("convert urdf-to-sdf", "convert sdf-to-urdf", "view")


def seconds_of(command: str, dimension: Dimension, n: int) -> float:
    """Processor time that a command takes, in this process and its children."""
    with TemporaryDirectory() as folder:
        file = Path(folder, dimension.file)
        file.write_text(dimension.text(n))
        files = [str(file)] * (1 + (command in TWO_FILES))
        output = ["-o", str(Path(folder, "result"))] if command in TO_A_FILE else []
        begin = _processor_time()
        with redirect_stdout(_nowhere()), redirect_stderr(_nowhere()):
            run_command([*command.split(), "--isolated", *output, *files])
        return _processor_time() - begin


def _nowhere() -> io.TextIOWrapper:
    return io.TextIOWrapper(io.BytesIO(), "utf-8")


def _processor_time() -> float:
    used = os.times()
    return used.user + used.system + used.children_user + used.children_system


def measure_commands() -> int:
    """Print a line of a table for each series and command: the times above the floor, and the exponent.

    The floor is the time for a small document, the exponent that of the last two doublings. A series that
    seems steep is measured once more, and the smaller exponent counts.
    """
    steep = 0
    print("| document | command | s at n, 2n, 4n, 8n | exponent |\n|---|---|---|---|")
    for name, (dimension, commands) in SERIES.items():
        for command in commands:
            seconds_of(command, dimension, 10)
            floor = min(seconds_of(command, dimension, 5) for _ in range(2))
            power, times = 99.0, [0.0]
            for _ in range(2):
                took = [seconds_of(command, dimension, 300 * factor) - floor for factor in (1, 2, 4, 8)]
                again = exponent(max(took[1], 1e-3), max(took[3], 1e-3), 4)
                power, times = min((power, times), (again, took))
                gc.collect()
                if power <= MOST:
                    break
            steep += power > MOST
            shown = ", ".join(f"{each:.2f}" for each in times)
            print(f"| {name} | {command} | {shown} | {power:.2f} |", flush=True)
    return steep


def seconds(dimension: Dimension, n: int) -> float:
    """Processor time to lint a document."""
    text = dimension.text(n)
    begin = time.process_time()
    lint(text, name=dimension.file, isolated=True, target=dimension.target)
    return time.process_time() - begin


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
    """Measure, print a line for each dimension; 1 if one is not linear."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", default=list(DIMENSIONS), help="the dimensions to measure")
    parser.add_argument("--size", type=int, default=SIZE, help="the smallest n")
    parser.add_argument("--commands", action="store_true", help="measure the other commands instead")
    given = parser.parse_args()
    # As in the program: trees are acyclic, and the collector would look at all of them again and again.
    gc.disable()
    if given.commands:
        return int(measure_commands() > 0)
    steep = 0
    for name in given.names:
        dimension = DIMENSIONS[name]
        seconds(dimension, 10)
        took = [seconds(dimension, given.size * factor) for factor in FACTORS]
        power = exponent(took[0], took[-1], FACTORS[-1])
        steep += power > MOST
        times = "  ".join(f"{each:7.3f}" for each in took)
        gc.collect()
        print(f"{name:40} {times}  n^{power:.2f}{'  steep' if power > MOST else ''}", flush=True)
    return int(steep > 0)


if __name__ == "__main__":
    sys.exit(main())
