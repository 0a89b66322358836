"""A rule in preview, and a document that it reports."""

from __future__ import annotations

from sdfcheck.lint.example import fill, unmark
from sdfcheck.lint.rulebook.packs import load_index


def preview_example() -> tuple[str, str]:
    """The code of a built-in rule in preview, and SDFormat in which it has a finding of its own."""
    index = load_index()
    for facts in index.facts:
        rule = index.rule(facts)
        text = unmark(fill(rule.scaffold, rule.bad[0]))[0]
        if facts.preview and text.lstrip().startswith("<sdf") and not rule.bad[0].files:
            return facts.code, text
    raise LookupError("no rule is in preview")
