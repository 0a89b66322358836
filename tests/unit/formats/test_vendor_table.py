"""Drake's table, line by line: right uses are silent, and each wrong use is reported as what it is."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.formats.vendor.table import vendor
from sdfcheck.source.document import read
from tables.drake import TABLE, read_facts, render
from tests.each import each
from tests.vendor_documents import Case, cases
from tests.vendor_rules import REMARKS, reported

FACTS = Path(__file__).parents[4] / "shared" / "facts" / "drake"
CASES = cases()


def found(case: Case) -> list[str]:
    document = read(case.text.encode(), Path(f"model.{case.dialect}"))
    assert not document.problems, case.text
    return [d.code for d in reported(document) if d.code not in REMARKS]


@pytest.mark.skipif(not FACTS.is_dir(), reason="the facts that the table is made of are not here")
def test_the_committed_table_is_up_to_date() -> None:
    assert TABLE.read_text("utf-8") == render(read_facts(FACTS))


@pytest.mark.skipif(not FACTS.is_dir(), reason="the facts that the table is made of are not here")
def test_every_tag_of_the_facts_is_there() -> None:
    tags = set(read_facts(FACTS)["tags"])
    for dialect in ("sdf", "urdf"):
        assert tags <= set(vendor(TABLE, dialect).tags)


def test_every_tag_has_a_right_and_a_wrong_use() -> None:
    for dialect in ("sdf", "urdf"):
        tags = vendor(TABLE, dialect).tags.values()
        wanted = {
            t.name for t in tags if not t.keys.text("gone") and not (t.places and t.keys.text("mirror"))
        }
        assert wanted <= {case.name.split(" ")[1] for case in CASES if case.code and case.dialect == dialect}


@pytest.mark.parametrize("dialect", ["sdf", "urdf"])
def test_right_uses_are_silent_and_wrong_uses_are_reported(dialect: str) -> None:
    each([case for case in CASES if case.dialect == dialect], is_judged, lambda case: case.name)


def is_judged(case: Case) -> None:
    assert found(case) == ([case.code] if case.code else []), case.text
