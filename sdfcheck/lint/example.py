"""Examples of a rule: documentation that runs as tests."""

from __future__ import annotations

from collections.abc import Mapping

from sdfcheck.source.record import NamedTuple

MARK_START, MARK_END = "«", "»"

SDF = '<sdf version="1.12">{}</sdf>'
IN_WORLD = '<sdf version="1.12"><world name="w">{}</world></sdf>'
IN_MODEL = '<sdf version="1.12"><model name="m"><link name="base"/>{}</model></sdf>'
IN_LINK = '<sdf version="1.12"><model name="m"><link name="base">{}</link></model></sdf>'
IN_COLLISION = (
    '<sdf version="1.12"><model name="m"><link name="base">'
    '<collision name="c">{}</collision></link></model></sdf>'
)
IN_VISUAL = (
    '<sdf version="1.12"><model name="m"><link name="base"><visual name="v">{}</visual></link></model></sdf>'
)
IN_JOINT = (
    '<sdf version="1.12"><model name="m"><link name="base"/><link name="arm"/>'
    '<joint name="j" type="revolute"><parent>base</parent><child>arm</child>{}</joint></model></sdf>'
)
IN_ROBOT = '<robot name="r"><link name="base"/>{}</robot>'
IN_URDF_LINK = '<robot name="r"><link name="base">{}</link></robot>'
IN_URDF_JOINT = (
    '<robot name="r"><link name="base"/><link name="arm"/>'
    '<joint name="j" type="revolute"><parent link="base"/><child link="arm"/>{}</joint></robot>'
)


class Bad(NamedTuple):
    """A snippet that the rule reports, with ``«»`` around the exact place.

    ``fixed`` is the snippet after the fix; ``unsafe`` marks a fix that a person should
    look at. ``also`` names other rules that rightly speak up in the same snippet.
    ``says`` is a part of the message.
    """

    text: str
    fixed: str | None = None
    unsafe: bool = False
    says: str = ""
    also: tuple[str, ...] = ()
    file: str = ""
    """File name, where the root element does not show the snippet's kind."""
    scaffold: str | None = None
    files: Mapping[str, str] | None = None
    """Files beside the snippet's own: path beside it → text. None: nothing is looked up."""


class Good(NamedTuple):
    """A snippet that looks bad to a hasty eye and is not; ``why`` says so."""

    text: str
    why: str = ""
    file: str = ""
    scaffold: str | None = None
    files: Mapping[str, str] | None = None


def fill(scaffold: str, example: Bad | Good) -> str:
    """The whole document around a snippet; ``scaffold`` is the rule's, unless the example has its own."""
    chosen = scaffold if example.scaffold is None else example.scaffold
    return chosen.replace("{}", example.text, 1) if "{}" in chosen else example.text


def unmark(text: str) -> tuple[str, int, int]:
    """The text without its marks, and the range that they enclosed (-1, -1 without marks)."""
    start = text.find(MARK_START)
    end = text.find(MARK_END)
    if start < 0 or end < 0:
        return text, -1, -1
    plain = text.replace(MARK_START, "", 1).replace(MARK_END, "", 1)
    return plain, start, end - 1
