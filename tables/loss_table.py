"""Writes the tables of losses and findings into the guides: ``python -m tables.loss_table [--check]``."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from sdfcheck.convert.loss import LossKind
from sdfcheck.lint.kinds import SimKind

GUIDES: tuple[tuple[Path, str, type[LossKind] | type[SimKind]], ...] = (
    (Path("docs", "converting.md"), "losses", LossKind),
    (Path("docs", "simulating.md"), "findings", SimKind),
)
"""Page, the word of the marks around its table, and what the table lists."""


def table(kinds: type[LossKind] | type[SimKind]) -> str:
    """The kinds of loss or finding, in Markdown."""
    rows = [f"| {kind.code} | {kind.title} | {kind.facts.summary} |" for kind in kinds]
    return "\n".join(["| code | name | what happens, and why |", "|---|---|---|", *rows]) + "\n"


def with_table(guide: str, mark: str, kinds: type[LossKind] | type[SimKind]) -> str:
    """The guide with the table between its marks."""
    before, start, rest = guide.partition(f"<!-- {mark} -->\n")
    _, end, after = rest.partition(f"<!-- /{mark} -->")
    return f"{before}{start}{table(kinds)}{end}{after}"


def main(arguments: Sequence[str]) -> int:
    stale = 0
    for path, mark, kinds in GUIDES:
        guide = path.read_text(encoding="utf-8")
        wanted = with_table(guide, mark, kinds)
        if "--check" not in arguments:
            path.write_text(wanted, encoding="utf-8")
        elif wanted != guide:
            sys.stdout.write(f"{path} is stale: run `make generate`\n")
            stale = 1
    return stale


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
