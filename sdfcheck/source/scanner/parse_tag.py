"""A start tag, well formed or not."""

from __future__ import annotations

from sdfcheck.source.problems import Problem
from sdfcheck.source.scanner.start_tag import START, StartTag, has_names, repeated_attributes, tag_of
from sdfcheck.source.text import Source


def parse_start_tag(source: Source, at: int) -> tuple[StartTag, list[Problem]]:
    """Parse the start tag whose ``<`` is at ``at``; always returns one, and what is wrong with it."""
    match = START.match(source.text, at)
    if match is None or not has_names(match):
        from sdfcheck.source.scanner.broken_tag import parse_broken_tag

        return parse_broken_tag(source, source.text, at)
    tag = tag_of(match)
    return tag, repeated_attributes(source, tag)
