"""Mistakes of people, planted inside of macros, properties, loops, blocks and includes: reported where they are."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
LIBRARY = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
MASS = (
    '<inertial><mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>'
)
BASE = f'<link name="base">{MASS}</link>'
WHEEL = """
<xacro:macro name="wheel" params="side radius:=0.1 *origin">
<link name="${side}_wheel">MASS<visual><geometry><sphere radius="${radius}"/></geometry></visual></link>
<joint name="${side}_j" type="fixed"><xacro:insert_block name="origin"/>
<parent link="base"/><child link="${side}_wheel"/></joint>
</xacro:macro>"""
CALL = '<xacro:wheel side="l"><origin xyz="0 0 0"/></xacro:wheel>'
LOOP = """
<xacro:macro name="loop" params="n">
<xacro:if value="${n > 0}">
<link name="l${n}">MASS<visual><geometry><sphere radius="${n * 0.1}"/></geometry></visual></link>
<joint name="j${n}" type="fixed"><parent link="base"/><child link="l${n}"/></joint>
<xacro:loop n="${n - 1}"/>
</xacro:if>
</xacro:macro>
<xacro:loop n="3"/>"""

PLANTED: dict[str, tuple[str, ...]] = {
    # in macros
    "misspelled parameter in a body": (
        WHEEL.replace("${radius}", "${raduis}").replace("<link", "!<link"),
        CALL,
    ),
    "misspelled call in a macro": (
        '<xacro:macro name="both" params="">',
        '!<xacro:wheal side="l"/>',
        "</xacro:macro>",
        WHEEL,
        "<xacro:both/>",
    ),
    "negative radius from a call": (
        WHEEL,
        '!<xacro:wheel side="l" radius="-1"><origin xyz="0 0 0"/></xacro:wheel>',
    ),
    "text for a radius": (WHEEL, '!<xacro:wheel side="l" radius="1o"><origin xyz="0 0 0"/></xacro:wheel>'),
    "empty side": (WHEEL, CALL, '!<xacro:wheel side="l"><origin xyz="1 0 0"/></xacro:wheel>'),
    "comma between parameters": (
        WHEEL.replace("side radius", "side, radius").replace("<xacro:macro", "!<xacro:macro"),
        CALL,
    ),
    "doubled parameter": (
        WHEEL.replace("side radius", "side side radius").replace("<xacro:macro", "!<xacro:macro"),
        CALL,
    ),
    "missing parameter": (WHEEL, '!<xacro:wheel><origin xyz="0 0 0"/></xacro:wheel>'),
    "unknown parameter": (WHEEL, '!<xacro:wheel side="l" color="red"><origin xyz="0 0 0"/></xacro:wheel>'),
    "unknown parameter in a macro": (
        WHEEL,
        '<xacro:macro name="both" params="">',
        '!<xacro:wheel sid="l"><origin/></xacro:wheel>',
        "</xacro:macro>",
        "<xacro:both/>",
    ),
    "parameter replaced by a property": (
        '<xacro:macro name="m" params="k">',
        '!<xacro:property name="k" value="2"/>',
        f'<link name="a${{k}}">{MASS}</link>',
        '<joint name="ja" type="fixed"><parent link="base"/><child link="a${k}"/></joint>',
        "</xacro:macro>",
        '<xacro:m k="1"/>',
    ),
    "macro defined twice": (WHEEL, WHEEL.replace("<xacro:macro", "!<xacro:macro"), CALL),
    "macro after its call": ("!" + CALL, WHEEL),
    "macro of a robot without call": (
        BASE,
        WHEEL.replace("<xacro:macro", "!<xacro:macro").replace('wheel"', 'whale"'),
    ),
    "prefix in the name of a macro": (
        WHEEL.replace('name="wheel"', 'name="xacro:wheel"').replace("<xacro:macro", "!<xacro:macro"),
        CALL,
    ),
    "macro without its prefix": (
        WHEEL.replace("<xacro:macro", "!<macro").replace("</xacro:macro", "</macro"),
        CALL,
    ),
    "literal instead of a parameter": (
        WHEEL.replace("${radius}", "0.2").replace("<xacro:macro", "!<xacro:macro"),
        CALL,
    ),
    "local property used outside": (
        '<xacro:macro name="m" params="">',
        '!<xacro:property name="k" value="1"/>',
        "</xacro:macro>",
        "<xacro:m/>",
        f'<link name="a${{k}}">{MASS}</link>',
    ),
    "misspelled scope": (
        '<xacro:macro name="m" params="">',
        '!<xacro:property name="k" value="1" scope="parnet"/>',
        "</xacro:macro>",
        "<xacro:m/>",
        f'<link name="a${{k}}">{MASS}</link>',
    ),
    "recursion": (
        '<xacro:macro name="m" params="n">',
        '!<xacro:m n="${n}"/>',
        "</xacro:macro>",
        '<xacro:m n="1"/>',
    ),
    # in properties
    "property used by another one": (
        '<xacro:property name="d" value="0.2"/>',
        '!<xacro:property name="r" value="${dd / 2}"/>',
        WHEEL,
        '<xacro:wheel side="l" radius="${r}"><origin/></xacro:wheel>',
    ),
    "property with a hyphen": (
        '!<xacro:property name="wheel-radius" value="0.2"/>',
        WHEEL,
        '<xacro:wheel side="l" radius="${wheel-radius}"><origin/></xacro:wheel>',
    ),
    "property that divides by zero": (
        '<xacro:property name="d" value="0"/>',
        '!<xacro:property name="r" value="${1 / d}"/>',
        WHEEL,
        '<xacro:wheel side="l" radius="${r}"><origin/></xacro:wheel>',
    ),
    "property that is zero": (
        '!<xacro:property name="r" value="0"/>',
        WHEEL,
        '<xacro:wheel side="l" radius="${r}"><origin/></xacro:wheel>',
    ),
    "property of a property that is zero": (
        '!<xacro:property name="r" value="0"/>',
        '<xacro:property name="s" value="${2 * r}"/>',
        WHEEL,
        '<xacro:wheel side="l" radius="${s}"><origin/></xacro:wheel>',
    ),
    "text in a product": (
        '!<xacro:property name="r" value="0,2"/>',
        WHEEL,
        '<xacro:wheel side="l" radius="${r / 2}"><origin/></xacro:wheel>',
    ),
    "property set twice": (
        '!<xacro:property name="r" value="0.1"/>',
        '<xacro:property name="r" value="0.2"/>',
        WHEEL,
        '<xacro:wheel side="l" radius="${r}"><origin/></xacro:wheel>',
    ),
    "property after its use": (
        WHEEL,
        '<xacro:wheel side="l" radius="${r}"><origin/></xacro:wheel>',
        '!<xacro:property name="r" value="0.2"/>',
    ),
    "pi of its own": (
        '!<xacro:property name="pi" value="3.14"/>',
        f'<link name="a${{pi}}">{MASS}</link>',
        '<joint name="j" type="fixed"><parent link="base"/><child link="a3.14"/></joint>',
    ),
    "property that nothing reads": ('!<xacro:property name="hieght" value="1"/>', WHEEL, CALL),
    "property without value": (
        '!<xacro:property name="r"/>',
        WHEEL,
        '<xacro:wheel side="l" radius="${r}"><origin/></xacro:wheel>',
    ),
    "misspelled value": (
        '!<xacro:property name="r" vaule="1"/>',
        WHEEL,
        '<xacro:wheel side="l" radius="${r}"><origin/></xacro:wheel>',
    ),
    "argument in braces": (
        '<xacro:arg name="r" default="1"/>',
        WHEEL,
        '!<xacro:wheel side="l" radius="${r}"><origin/></xacro:wheel>',
    ),
    "property in parentheses": (
        '<xacro:property name="r" value="1"/>',
        WHEEL,
        '!<xacro:wheel side="l" radius="$(r)"><origin/></xacro:wheel>',
    ),
    "argument after its use": (
        WHEEL,
        '<xacro:wheel side="$(arg side)"><origin/></xacro:wheel>',
        '!<xacro:arg name="side" default="l"/>',
    ),
    "argument misspelled": (
        '<xacro:arg name="side" default="l"/>',
        WHEEL,
        '!<xacro:wheel side="$(arg sied)"><origin/></xacro:wheel>',
    ),
    "argument that nothing asks for": ('!<xacro:arg name="speed" default="1"/>', WHEEL, CALL),
    "argument compared in capitals": (
        '<xacro:arg name="sim" default="true"/>',
        """!<xacro:if value="${'$(arg sim)' == 'True'}">""",
        WHEEL,
        "</xacro:if>",
        BASE.replace("base", "other"),
    ),
    # in loops and conditions
    "C in a condition": (LOOP.replace("${n > 0}", "${n > 0 || n == 7}").replace("<xacro:if", "!<xacro:if"),),
    "loop without end": (
        LOOP.replace("${n - 1}", "${n}")
        .replace('<xacro:loop n="$', '!<xacro:loop n="$')
        .replace("${n > 0}", "1"),
    ),
    "else": (
        '<xacro:if value="0">',
        BASE.replace("base", "q"),
        "</xacro:if>",
        "!<xacro:else>",
        BASE.replace("base", "p"),
        "</xacro:else>",
    ),
    "text for a condition": (LOOP.replace("${n > 0}", "${n} times").replace("<xacro:if", "!<xacro:if"),),
    "negative size in a loop": (LOOP.replace("${n * 0.1}", "${(n - 2) * 0.1}").replace("<link", "!<link"),),
    "no dollar in a loop": (LOOP.replace('name="l${n}"', 'name="l{n}"').replace("<link", "!<link"),),
    "brace left open in a loop": (LOOP.replace("${n * 0.1}", "${n * 0.1").replace("<link", "!<link"),),
    "bad Python in a loop": (LOOP.replace("${n * 0.1}", "${n ** * 0.1}").replace("<link", "!<link"),),
    "if without prefix": (LOOP.replace("<xacro:if", "!<if").replace("</xacro:if", "</if"),),
    "same name in each turn": (
        LOOP.replace('name="l${n}"', 'name="l"')
        .replace("<link", "!<link")
        .replace('link="l${n}"', 'link="l"'),
    ),
    "missing link in a loop": (
        LOOP.replace('<child link="l${n}"', '<child link="ll${n}"').replace("<joint", "!<joint"),
    ),
    # in blocks
    "block that is not taken": (WHEEL, '!<xacro:wheel side="l"><origin xyz="0 0 0"/><extra/></xacro:wheel>'),
    "block that is missing": (WHEEL, '!<xacro:wheel side="l"/>'),
    "unknown block": (WHEEL.replace('name="origin"/>', 'name="orgin"/>').replace("<joint", "!<joint"), CALL),
    "insert_block without prefix": (
        WHEEL.replace("<xacro:insert_block", "<insert_block").replace("<joint", "!<joint"),
        CALL,
    ),
    "wrong numbers in a block": (WHEEL, '!<xacro:wheel side="l"><origin xyz="0 0"/></xacro:wheel>'),
    "misspelled attribute in a block": (WHEEL, '!<xacro:wheel side="l"><origin xzy="0 0 0"/></xacro:wheel>'),
    "two stars": (WHEEL.replace("*origin", "**origin").replace("<xacro:macro", "!<xacro:macro"), CALL),
    "expression in a block": (WHEEL, '!<xacro:wheel side="l"><origin xyz="0 ${hieght} 0"/></xacro:wheel>'),
    # in includes
    "missing file": ('!<xacro:include filename="libb.xacro"/>', WHEEL, CALL),
    "file in capitals": ('!<xacro:include filename="Lib.xacro"/>', WHEEL, CALL),
    "package by its URI": ('!<xacro:include filename="package://p/lib.xacro"/>', WHEEL, CALL),
    "include without prefix": ('!<include filename="lib.xacro"/>', WHEEL, CALL),
    "misspelled macro of an include": ('<xacro:include filename="lib.xacro"/>', "!<xacro:lag/>"),
    "misspelled filename": ('!<xacro:include file="lib.xacro"/>', "<xacro:leg/>"),
    "content in an include": (
        '<xacro:include filename="lib.xacro">',
        '!<xacro:property name="k" value="1"/>',
        "</xacro:include>",
        "<xacro:leg/>",
    ),
    "old function": (
        '!<xacro:property name="k" value="${range(3)[1]}"/>',
        WHEEL,
        '<xacro:wheel side="${k}"><origin/></xacro:wheel>',
    ),
}
"""Mistake → the lines of a robot; that with an exclamation mark is the one to edit."""


def planted(lines: tuple[str, ...]) -> tuple[str, int]:
    """The text of a robot, and the number of the line to edit."""
    inside = "\n".join(lines).replace("MASS", MASS)
    text = "\n".join((HEAD, BASE if BASE not in inside else "", inside, "</robot>"))
    (number,) = (number for number, line in enumerate(text.splitlines(), 1) if line.startswith("!"))
    return text.replace("\n!", "\n"), number


@pytest.mark.parametrize("name", PLANTED)
def test_a_planted_mistake_is_reported_at_its_line_or_labels_it(tmp_path: Path, name: str) -> None:
    text, line = planted(PLANTED[name])
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "lib.xacro").write_text(
        f'{LIBRARY}<xacro:macro name="leg" params=""><link name="leg"/></xacro:macro></robot>'
    )
    path = tmp_path / "robot.urdf.xacro"
    path.write_text(text)
    found = sdfcheck.lint(path, isolated=True, ignore=["URD008", "URD013"]).diagnostics
    places = [
        (each.span, *(label.span for label in each.labels), *(o.span for o in each.origins)) for each in found
    ]
    lines = {span.begin.line for spans in places for span in spans if span.source.path.name == path.name}
    assert line in lines, "\n".join(str((each.code, each.span.begin.line, each.message)) for each in found)


def test_there_are_enough() -> None:
    assert len(PLANTED) >= 60
