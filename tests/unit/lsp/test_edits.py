"""After any edits of real files, the server's state is that of a fresh reading, and nothing fails."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sdfcheck.lint.fix import TextEdit
from sdfcheck.lsp.actions import differences, extractions, offers
from sdfcheck.lsp.completion import complete
from sdfcheck.lsp.context import Checkpoints, context
from sdfcheck.lsp.edits import colors, counted, lenses, linked, selections
from sdfcheck.lsp.findings import Findings
from sdfcheck.lsp.hints import hints, tokens
from sdfcheck.lsp.hover import hover, signature
from sdfcheck.lsp.names import occurrences
from sdfcheck.lsp.outline import folds, links, outline
from sdfcheck.lsp.rename import Refused, Target, rename
from sdfcheck.lsp.speech import Change, Place, Units, changed, offset_of, place_of
from sdfcheck.lsp.workspace import Choices, Workspace
from sdfcheck.source.document import Document
from sdfcheck.source.splice import replaced
from sdfcheck.source.text import Source

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
FILES = sorted(
    path
    for path in ROBOTS.rglob("*")
    if path.suffix in {".sdf", ".urdf", ".xacro", ".world"} and path.is_file()
)
PIECES = [
    "",
    "<",
    ">",
    "/",
    '"',
    "<link name='x'/>",
    "</",
    "&",
    "\t",
    "\U0001d6fc",
    "é",
    "\r\n",
    "${",
    "-->",
    "<!--",
    "arm",
]


def ask_everything(workspace: Workspace, path: Path, offset: int) -> None:
    """Every question that an editor may have."""
    document = workspace.document(path)
    assert document is not None
    buffer = workspace.buffers[workspace.key(path)]
    whole = document.source.span(0, len(document.source.text))
    hover(document, offset)
    complete(workspace, buffer, offset)
    outline(document.source, lambda part, end: part[2])
    folds(document)
    list(links(document))
    list(hints(document, whole))
    tokens(document)
    list(colors(document))
    signature(workspace, buffer, offset)
    for lens in list(lenses(document))[:2]:
        counted(workspace, document, lens.span.start, is_file=lens.is_file)
    pair = linked(document, offset)
    assert pair is None or pair[0].text == pair[1].text
    assert all(inner.start >= outer.start for inner, outer in pairwise(selections(document, offset)))
    for chosen in (document.source.span(offset, offset), whole):
        for found in extractions(document, chosen):
            edits = [(edit.span.start, edit.span.end, edit.text) for edit in found.edits]
            assert edits == sorted(edits)
            assert len(replaced(document.source.text, edits)) > len(document.source.text)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
@settings(max_examples=2, deadline=None, suppress_health_check=list(HealthCheck))
@given(data=st.data())
def test_edits_leave_the_state_of_a_fresh_reading(
    path: Path, copied: Callable[[Path], Path], data: st.DataObject
) -> None:
    path = copied(path)
    workspace = Workspace()
    workspace.choose(Choices(expand=False))
    findings = Findings(workspace)
    buffer = workspace.open(path.as_uri(), path, path.read_bytes().decode(), 1)
    for number in range(data.draw(st.integers(1, 4))):
        size = len(buffer.source.text)
        first, last = sorted((data.draw(st.integers(0, size)), data.draw(st.integers(0, size))))
        last = min(last, first + 30)
        begin = place_of(buffer.source, first, Units.UTF16)
        end = place_of(buffer.source, last, Units.UTF16)
        piece = data.draw(st.sampled_from(PIECES))
        source, kept = changed(buffer.source, [Change(piece, begin, end)], Units.UTF16)
        workspace.write(buffer, source, number + 2, kept)
        ask_everything(workspace, path, min(first, len(source.text)))
    findings.lint(buffer)
    fresh = Workspace()
    fresh.choose(Choices(expand=False))
    other = fresh.open(path.as_uri(), path, buffer.source.text, 1)
    again = Findings(fresh)
    again.lint(other)
    assert shown(findings, path) == shown(again, path)
    offset = len(buffer.source.text) // 2
    assert context(buffer.source.text, offset, buffer.checkpoints) == context(buffer.source.text, offset)
    offers(workspace, buffer, findings.at(path), buffer.source.span(0, len(buffer.source.text)))


def shown(findings: Findings, path: Path) -> list[tuple[object, ...]]:
    return [(d.code, d.message, d.span.start, d.span.end) for d in findings.at(path)]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_renaming_and_back_gives_the_same_bytes(
    path: Path, copied: Callable[[Path], Path], stride: Callable[[int], int]
) -> None:
    path = copied(path)
    text = path.read_bytes().decode()
    workspace = Workspace()
    buffer = workspace.open(path.as_uri(), path, text, 1)
    document = workspace.document(path)
    assert document is not None
    symbols = {each.symbol.key: each.symbol for each in occurrences(document).all}
    for symbol in list(symbols.values())[:: stride(3)]:
        is_odd = (
            "&" in symbol.name or symbol.name.startswith("__") or text.count(f'name="{symbol.name}"') > 1
        )  # broken, or not the only one
        if symbol.span.source is not document.source or is_odd:
            continue
        new = f"{symbol.name}_anew"
        try:
            there = own(rename_at(workspace, path, symbol.span.start, new), path)
        except Refused:
            continue
        renamed = replaced(text, there)
        assert renamed != text
        workspace.write(buffer, Source(path, renamed), 2)
        start = symbol.span.start + sum(len(t) - (e - s) for s, e, t in there if s < symbol.span.start)
        back = own(rename_at(workspace, path, start, symbol.name), path)
        assert replaced(renamed, back) == text
        workspace.write(buffer, Source(path, text), 3)


def rename_at(workspace: Workspace, path: Path, offset: int, name: str) -> list[TextEdit]:
    document = workspace.document(path)
    assert document is not None
    occurrence = occurrences(document).at(offset)
    assert occurrence is not None
    return rename(workspace, document, Target(occurrence, occurrence.span), name)


def own(edits: list[TextEdit], path: Path) -> list[tuple[int, int, str]]:
    mine = (edit for edit in edits if edit.span.source.path == path)
    return sorted((edit.span.start, edit.span.end, edit.text) for edit in mine)


@given(st.text(alphabet="a\t\n\ré\U0001f600", max_size=40), st.data())
def test_places_come_back(text: str, data: st.DataObject) -> None:
    source = Source(Path("a"), text)
    offset = data.draw(st.integers(0, len(text)))
    for units in Units:
        place = place_of(source, offset, units)
        back = offset_of(source, place, units)
        assert place_of(source, back, units) == place or text[:offset].endswith("\r")


@given(st.text(alphabet="a\n\r\u2028", max_size=30), st.text(alphabet="b\n\r", max_size=5), st.data())
def test_edits_keep_count_of_lines(text: str, piece: str, data: st.DataObject) -> None:
    first, last = sorted((data.draw(st.integers(0, len(text))), data.draw(st.integers(0, len(text)))))
    source = Source(Path("a"), text)
    assert source.line_starts
    edited = source.edited(first, last, piece)
    assert edited.text == text[:first] + piece + text[last:]
    assert edited.line_starts == Source(Path("a"), edited.text).line_starts


def test_columns_after_tabs_and_astral_characters_count_in_utf16() -> None:
    source = Source(Path("a"), "\t\U0001f600 x")
    assert place_of(source, 3, Units.UTF16) == Place(0, 4)
    assert place_of(source, 3, Units.UTF8) == Place(0, 6)
    assert place_of(source, 3, Units.UTF32) == Place(0, 3)
    assert offset_of(source, Place(0, 4), Units.UTF16) == 3


@given(st.lists(st.sampled_from("abc"), max_size=12), st.lists(st.sampled_from("abc"), max_size=12))
def test_differences_lead_from_one_text_to_the_other(before: list[str], after: list[str]) -> None:
    old, new = "\n".join(before), "\n".join(after)
    edits = differences(Source(Path("a"), old), new)
    assert replaced(old, ((edit.span.start, edit.span.end, edit.text) for edit in edits)) == new


def test_checkpoints_forget_what_has_changed() -> None:
    text = "<sdf>" + "<model name='m'></model>" * 6000 + "<world>"
    known = Checkpoints()
    assert known.around(text, len(text))[0] == ("sdf", "world")
    changed_text = "<robot>" + text[5:]
    known.cut(0)
    assert known.around(changed_text, len(text) + 2)[0] == ("robot", "world")


def test_a_document_that_was_let_go_keeps_its_text() -> None:
    document = Document(Source(Path("a.sdf"), "<sdf version='1.12'/>"), None, [])
    document.release()
    assert document.root is None
    assert document.source.text == "<sdf version='1.12'/>"
