"""In long texts that are broken in one place the local scan finds what the scan of the whole text finds."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lxml import etree

from sdfcheck.source import document as documents
from sdfcheck.source.document import Document
from sdfcheck.source.scanner import full_scan, tokenizer
from sdfcheck.source.scanner.full_scan import scan
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.scanner.tokens import Tokens
from sdfcheck.source.text import Source

MODEL = """\
    <model name="m{n}">
      <!-- a <box> -->
      <pose>0 0 {n} 0 0 0</pose>
      <link name="a"><visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual></link>
      <plugin
        filename="x" name="gz::sim::X"/>
    </model>
"""
TEXT = '<?xml version="1.0"?>\n<sdf version="1.12">\n  <world name="w">\n'
TEXT += "".join(MODEL.format(n=n) for n in range(60)) + "  </world>\n</sdf>\n"
PIECES = [
    "<",
    ">",
    "/",
    '"',
    "</link>",
    "<link name='x'>",
    "</",
    "&",
    "-->",
    "<!--",
    "<model name='a'>",
    "",
    "",
]


def what(scan: Scan) -> tuple[object, ...]:
    """All that a scan says; blanks in tags that are written anew do not count."""
    parser = etree.XMLParser(recover=True)  # which refuses the name `gz::sim::X`
    tree = etree.tostring(etree.fromstring(scan.wellformed.encode(), parser), method="c14n")
    places = scan.starts, scan.ends, scan.closes, scan.close_ends
    return scan.problems, places, scan.comments, scan.odd, sorted(scan.doubtful), tree


@settings(max_examples=60, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.integers(0, len(TEXT)), st.sampled_from([0, 0, 1, 5, 30]), st.sampled_from(PIECES))
def test_both_scans_agree(at: int, removed: int, piece: str) -> None:
    source = Source(Path("w.sdf"), TEXT[:at] + piece + TEXT[at + removed :])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(full_scan, "WINDOW", 1500)
        patch.setattr(documents, "LONG", 0)
        document = Document(source, None, [])
    if document.scan.wellformed:
        assert what(document.scan) == what(scan(source))


def test_only_the_place_of_the_fault_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    at = TEXT.index("<model", len(TEXT) // 2)
    source = Source(Path("w.sdf"), TEXT[:at] + "<" + TEXT[at:])
    monkeypatch.setattr(full_scan, "WINDOW", 1500)
    looked_at: list[str] = []

    def tokenize(given: Source, text: str) -> Tokens:
        looked_at.append(text.replace(" ", ""))
        return tokenizer.tokenize(given, text)

    monkeypatch.setattr(full_scan, "tokenize", tokenize)
    found = full_scan.local_scan(source, at)
    assert found is not None
    assert len(looked_at[0]) < 6000 < len(TEXT)
    assert len(found.starts) == TEXT.count("<model") * 8 + 2


def test_a_second_fault_far_away_is_not_hidden() -> None:
    at, other = TEXT.index("<model", 2000), TEXT.rindex("<model")
    text = TEXT[:at] + "<" + TEXT[at:other] + "<" + TEXT[other:]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(full_scan, "WINDOW", 1500)
        patch.setattr(documents, "LONG", 0)
        document = Document(Source(Path("w.sdf"), text), None, [])
    assert [problem.span.start for problem in document.problems] == [at, other + 1]
