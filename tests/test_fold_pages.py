"""Long lines of Markdown are folded, and nothing else changes."""

from __future__ import annotations

from tables.fold_pages import LONGEST, folded

LONG = "word " * 40


def test_items_keep_their_mark_and_indent() -> None:
    lines = folded(f"- {LONG}\n  1. {LONG}").splitlines()
    assert [line[:6] for line in lines] == ["- word", "  word", "  1. w", "     w"]
    assert all(len(line) <= LONGEST for line in lines)


def test_folding_twice_changes_nothing() -> None:
    once = folded(f"# Title\n\n{LONG}\n\n- {LONG}\n\n```\n{LONG}\n```\n| {LONG} |\n")
    assert folded(once) == once


def test_code_tables_and_short_lines_stay() -> None:
    text = f"short\nlines\n\n```\n{LONG}\n```\n\n| {LONG} |\n"
    assert folded(text) == text
