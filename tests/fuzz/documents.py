"""Texts to run commands on: fixtures that are changed, documents that the formats allow, and raw bytes."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path

from hypothesis import strategies as st

from sdfcheck.formats.schema import AttributeDefinition, Definition, RowInVersion
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.urdf.schema import urdf
from sdfcheck.formats.version import NEWEST, OLDEST, Version
from sdfcheck.source.record import NamedTuple

FIXTURES = Path(__file__).parents[2] / "fixtures"
SUFFIXES = (".sdf", ".urdf", ".xacro", ".world", ".config")

NUMBERS = (
    "0",
    "1",
    "-1",
    "1e308",
    "1e-320",
    "nan",
    "inf",
    "-inf",
    "1e999",
    "0x1p3",
    "1,5",
    "1.",
    "+.5",
    "٣",
    "",
)
POSES = (
    "0 0 0 0 0 0",
    "1 2 3 0.1 0.2 0.3",
    "0 0 0 90 0 0",
    "1 2",
    "nan 0 0 0 0 0",
    "1e308 1e308 1e308 0 0 0",
)
NAMES = (
    "a",
    "b",
    "base_link",
    "world",
    "__model__",
    "a::b",
    "__root__",
    "",
    " ",
    "a b",
    "ä",
    "x" * 300,
    "${n}",
)
PIECES = (
    *("<", ">", "/", '"', "'", "&", "&amp;", "&#0;", "&x;", "<!--", "-->", "--", "<![CDATA[", "]]>", "<?", "?>"),
    *("</link>", "</model>", "<link name='x'/>", "<model name='m'>", "<frame name='f' attached_to='f'/>"),
    *("<pose relative_to='x'>1 2 3 4 5 6</pose>", "<include><uri>model://a</uri></include>"),
    *("<joint name='j' type='fixed'><parent>a</parent><child>a</child></joint>", "<static>1</static>"),
    *("<!-- sdfcheck: ignore[ALL] -->", "<!-- sdfcheck: disable -->", "<!-- sdfcheck: ignore[", "xmlns:p='q'"),
    *("<p:q/>", "<drake:q/>", "xmlns:drake='drake.mit.edu'", "${", "$(", "${1/0}", "$(find a)", "$(arg a)"),
    *("<xacro:if value='1'>", "<xacro:include filename='a'/>", "<xacro:macro name='m' params='a:=1 *b'/>"),
    *("\0", "\r", "\r\n", "\t", "\x1b[31m", "\u202e", "\ufeff", "\U0001f600", "\ud800", "\xa0", "²"),
    *("<<<<<<< a\n", "=======\n", ">>>>>>> b\n", "<!DOCTYPE a [<!ENTITY x 'y'>]>", "<a>" * 300, "1e309 "),
)  # fmt: skip

_VECTORS = ("1 2 3", "0 0 1", "1 0 0", "1 1")
_FLAGS = ("true", "false")

_ELEMENT = re.compile(r"<([\w:]+)[^<>]*?(?:/>|>[^<>]*</\1>)")
_VALUE = re.compile(r"(?<==)([\"'])[^\"'<>]*\1|(?<=>)[^<>]+(?=</)")
_NAME = re.compile(r"[\w:]{2,}")


class Text(NamedTuple):
    """A document: the end of its file's name, and its bytes."""

    suffix: str
    data: bytes


@cache
def fixtures() -> tuple[Text, ...]:
    """The documents among the fixtures, without the largest."""
    files = sorted(path for path in FIXTURES.rglob("*") if path.is_file() and path.suffix in SUFFIXES)
    return tuple(Text(path.suffix, path.read_bytes()) for path in files if path.stat().st_size < 20_000)


def texts() -> st.SearchStrategy[Text]:
    """Every kind of document; most are nearly right, as what is wholly wrong ends early."""
    allowed = st.one_of(sdf_documents(), urdf_documents())
    return st.one_of(changed(st.sampled_from(fixtures())), allowed, changed(allowed), raw())


@st.composite
def raw(draw: st.DrawFn) -> Text:
    """Bytes of any kind, or pieces of markup, in some encoding."""
    suffix = draw(st.sampled_from(SUFFIXES))
    if draw(st.booleans()):
        return Text(suffix, draw(st.binary(max_size=300)))
    pieces = st.lists(st.sampled_from(PIECES) | st.text(max_size=5), max_size=30).map("".join)
    root = draw(
        st.sampled_from(("{}", "<sdf version='1.9'>{}</sdf>", "<robot name='r'>{}</robot>", "<model>{}"))
    )
    encoding = draw(st.sampled_from(("utf-8", "utf-8", "utf-16", "utf-8-sig", "latin-1")))
    return Text(suffix, root.replace("{}", draw(pieces)).encode(encoding, "replace"))


@st.composite
def changed(draw: st.DrawFn, origins: st.SearchStrategy[Text]) -> Text:
    """A document after a few changes."""
    suffix, data = draw(origins)
    text = data.decode("utf-8", "replace")
    for _ in range(draw(st.integers(1, 6))):
        text = draw(st.sampled_from(_CHANGES))(draw, text)[:60_000]
    if draw(st.integers(0, 9)) == 0:
        suffix = draw(st.sampled_from(SUFFIXES))
    return Text(suffix, text.encode("utf-8", "replace"))


def _place(draw: st.DrawFn, text: str) -> int:
    return draw(st.integers(0, len(text)))


def _insert(draw: st.DrawFn, text: str) -> str:
    at = _place(draw, text)
    return text[:at] + draw(st.sampled_from(PIECES)) + text[at:]


def _delete(draw: st.DrawFn, text: str) -> str:
    at = _place(draw, text)
    return text[:at] + text[at + draw(st.integers(1, 60)) :]


def _cut(draw: st.DrawFn, text: str) -> str:
    return text[: _place(draw, text)]


def _repeat(draw: st.DrawFn, text: str) -> str:
    at = _place(draw, text)
    end = at + draw(st.integers(1, 400))
    return text[:end] + text[at:end] * draw(st.sampled_from((1, 1, 2, 30))) + text[end:]


def _one_of(draw: st.DrawFn, pattern: re.Pattern[str], text: str) -> re.Match[str] | None:
    found = list(pattern.finditer(text))
    return draw(st.sampled_from(found)) if found else None


def _drop_element(draw: st.DrawFn, text: str) -> str:
    found = _one_of(draw, _ELEMENT, text)
    return text if found is None else text[: found.start()] + text[found.end() :]


def _double_element(draw: st.DrawFn, text: str) -> str:
    found = _one_of(draw, _ELEMENT, text)
    return text if found is None else text[: found.end()] + found[0] + text[found.end() :]


def _move_element(draw: st.DrawFn, text: str) -> str:
    found, there = _one_of(draw, _ELEMENT, text), _one_of(draw, _ELEMENT, text)
    return text if found is None or there is None else text[: there.end()] + found[0] + text[there.end() :]


def _change_value(draw: st.DrawFn, text: str) -> str:
    found = _one_of(draw, _VALUE, text)
    if found is None:
        return text
    value, quote = draw(st.sampled_from(NUMBERS + POSES + NAMES)), found[1] or ""
    return f"{text[: found.start()]}{quote}{value}{quote}{text[found.end() :]}"


def _change_name(draw: st.DrawFn, text: str) -> str:
    found, other = _one_of(draw, _NAME, text), _one_of(draw, _NAME, text)
    return text if found is None or other is None else text[: found.start()] + other[0] + text[found.end() :]


def _splice(draw: st.DrawFn, text: str) -> str:
    other = draw(st.sampled_from(fixtures())).data.decode("utf-8", "replace")
    return text[: _place(draw, text)] + other[_place(draw, other) :]


_CHANGES: tuple[Callable[[st.DrawFn, str], str], ...] = (
    *(_insert, _delete, _cut, _repeat, _splice),
    *(
        _drop_element,
        _double_element,
        _move_element,
        _change_value,
        _change_value,
        _change_name,
        _change_name,
    ),
)


@st.composite
def sdf_documents(draw: st.DrawFn) -> Text:
    """SDFormat of some version, by its table."""
    version = Version(1, draw(st.integers(OLDEST.minor, NEWEST.minor)))
    left = [draw(st.integers(5, 60))]
    text = _sdf_element(draw, schema(version).root, left)
    return Text(".sdf", text.replace("<sdf", f'<sdf version="{version}"', 1).encode("utf-8", "replace"))


def _sdf_element(draw: st.DrawFn, element: Definition, left: list[int]) -> str:
    left[0] -= 1
    names = [name for name in sorted(element.attributes) if name != "version" and draw(st.integers(0, 3)) > 0]
    attributes = "".join(f' {name}="{_sdf_value(draw, element.attributes[name])}"' for name in names)
    inside = _sdf_value(draw, element) if element.type else ""
    names = sorted(element.children)
    while names and left[0] > 0 and draw(st.integers(0, 3)) > 0:
        inside += _sdf_element(draw, element.children[draw(st.sampled_from(names))], left)
    return f"<{element.name}{attributes}>{inside}</{element.name}>"


def _sdf_value(draw: st.DrawFn, value: Definition | AttributeDefinition) -> str:
    return _value(draw, value.type or "", value.default or "")


def _value(draw: st.DrawFn, kind: str, default: str) -> str:
    if default and not default.startswith("__") and draw(st.booleans()):
        return default
    choices: tuple[str, ...] = NUMBERS[:3] + NUMBERS[:3] + NUMBERS + _FLAGS
    if kind == "string":
        choices = NAMES[:4] + NAMES[:4] + NAMES
    elif "pose" in kind or "vector" in kind:
        choices = POSES + _VECTORS
    return _pick(draw, choices)


def _pick(draw: st.DrawFn, choices: tuple[str, ...]) -> str:
    choice: str = draw(st.sampled_from(choices))
    return choice


@st.composite
def urdf_documents(draw: st.DrawFn) -> Text:
    """URDF, by its table."""
    text = _urdf_element(draw, urdf(), [draw(st.integers(5, 60))])
    return Text(".urdf", text.encode("utf-8", "replace"))


def _urdf_element(draw: st.DrawFn, element: Definition, left: list[int]) -> str:
    left[0] -= 1
    names = [name for name in sorted(element.attributes) if draw(st.integers(0, 3)) > 0]
    attributes = "".join(f' {name}="{_urdf_value(draw, element.attributes[name])}"' for name in names)
    inside = _urdf_value(draw, element) if element.type else ""
    names = sorted(element.children)
    while names and left[0] > 0 and draw(st.integers(0, 3)) > 0:
        inside += _urdf_element(draw, element.children[draw(st.sampled_from(names))], left)
    return f"<{element.name}{attributes}>{inside}</{element.name}>"


def _urdf_value(draw: st.DrawFn, value: RowInVersion) -> str:
    if value.listed and draw(st.integers(0, 1)) == 0:
        return _pick(draw, value.listed)
    return _value(draw, value.type or "", value.given_default)
