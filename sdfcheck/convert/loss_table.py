"""Writes the table of losses into the guide: ``python -m sdfcheck.convert.loss_table [--check]``."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from sdfcheck.convert.loss import LossKind

GUIDE = Path("docs", "converting.md")
_START, _END = "<!-- losses -->\n", "<!-- /losses -->"


def table() -> str:
    """The kinds of loss, in Markdown."""
    rows = [f"| {kind.code} | {kind.title} | {kind.facts.summary} |" for kind in LossKind]
    return "\n".join(["| code | name | what happens, and why |", "|---|---|---|", *rows]) + "\n"


def with_table(guide: str) -> str:
    """The guide with the table between its marks."""
    before, start, rest = guide.partition(_START)
    _, end, after = rest.partition(_END)
    return f"{before}{start}{table()}{end}{after}"


def main(arguments: Sequence[str]) -> int:
    guide = GUIDE.read_text(encoding="utf-8")
    wanted = with_table(guide)
    if "--check" not in arguments:
        GUIDE.write_text(wanted, encoding="utf-8")
        return 0
    if wanted != guide:
        sys.stdout.write(f"{GUIDE} is stale: run `make generate`\n")
    return int(wanted != guide)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
