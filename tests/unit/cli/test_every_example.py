"""Every rule's examples go through every command that takes such a file, and none of them meets a bug."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.lint.example import fill, unmark
from sdfcheck.lint.rulebook.example_run import file_name
from sdfcheck.lint.rulebook.packs import load_index

OF_ROBOTS = (
    "graph frames",
    "graph poses",
    "graph joints",
    "inertia",
    "print --expand-includes",
    "convert urdf-to-sdf --no-lint",
    "convert sdf-to-urdf --no-lint",
    "convert sdf-to-sdf --no-lint --sdf-version 1.4",
    "convert sdf-to-sdf --no-lint --sdf-version 1.12",
)


def examples() -> Iterator[tuple[str, str, dict[str, str]]]:
    """The file, the text and the other files of each example, each text once."""
    index = load_index()
    seen = set()
    for facts in index.facts:
        rule = index.rule(facts)
        for example in (*rule.bad, *rule.good):
            text = unmark(fill(rule.scaffold, example))[0]
            if text not in seen:
                seen.add(text)
                yield file_name(text, example), text, dict(example.files or {})
