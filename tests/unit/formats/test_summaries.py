"""Each element and attribute that the tables know is described in words of our own."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.formats.describe import summary
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.urdf.schema import urdf
from sdfcheck.formats.vendor import BUILT_IN
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.formats.version import NEWEST, Version

FILE = Path(__file__).parents[3] / "sdfcheck" / "formats" / "data" / "descriptions.txt"


def places_of_sdf(version: Version) -> Iterator[tuple[str, ...]]:
    seen: set[tuple[str, str]] = set()
    waiting: list[tuple[tuple[str, ...], Definition]] = [(("sdf",), schema(version).root)]
    while waiting:
        names, element = waiting.pop()
        yield names
        yield from ((*names, f"@{name}") for name in element.attributes)
        for child in element.children.values():
            if (element.name, child.place) not in seen:
                seen.add((element.name, child.place))
                waiting.append(((*names, child.name), child))


def places_of_urdf() -> Iterator[tuple[str, ...]]:
    waiting: list[tuple[tuple[str, ...], Definition]] = [(("robot",), urdf())]
    while waiting:
        names, element = waiting.pop()
        yield names
        yield from ((*names, f"@{name}") for name in element.attributes)
        if not element.open:
            waiting += (((*names, child.name), child) for child in element.children.values())


@pytest.mark.parametrize("minor", [5, 7, NEWEST.minor])
def test_all_of_sdf_is_described(minor: int) -> None:
    lacking = {
        "/".join(names[-2:]) for names in places_of_sdf(Version(1, minor)) if not summary("sdf", names)
    }
    assert not lacking


def test_all_of_urdf_is_described() -> None:
    assert not {"/".join(names[-2:]) for names in places_of_urdf() if not summary("urdf", names)}


def test_all_tags_of_vendors_are_described() -> None:
    for prefix, path in BUILT_IN.items():
        tags = {name for dialect in ("sdf", "urdf") for name in vendor(path, dialect).tags}
        assert not {name for name in tags if not summary(prefix, (name,))}


def test_the_descriptions_are_sentences() -> None:
    for number, line in enumerate(FILE.read_text("utf-8").splitlines(), 1):
        if line and line[0] not in "#[":
            places, tab, text = line.partition("\t")
            assert tab, f"line {number}"
            assert places.strip() == places, f"line {number}"
            assert text[0].isupper() or text[0] in "(`", f"line {number}"
            assert text.endswith("."), f"line {number}"
            assert len(text) < 200, f"line {number}"


def test_the_longest_place_counts() -> None:
    assert summary("sdf", ("sdf", "model", "joint", "axis", "dynamics", "friction")) != summary(
        "sdf", ("sdf", "model", "link", "collision", "surface", "friction")
    )
    assert summary("sdf", ("nothing",)) == ""
