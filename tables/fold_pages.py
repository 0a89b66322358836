"""Folds the paragraphs of Markdown pages that have long lines: ``python -m tables.fold_pages``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from textwrap import wrap

LONGEST = 120
_ITEM = re.compile(r"\s*(?:[-*]|\d+\.)\s+")
_ALONE = ("#", "|", "<!--", "!!!", ">")
"""The beginnings of lines that are not part of a paragraph."""


def pages(root: Path) -> list[Path]:
    """The pages that people write."""
    tops = (root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md"))
    return [*tops, *sorted((root / "docs").glob("*.md"))]


def folded(text: str) -> str:
    """A page whose paragraphs have no line longer than it may be; tables and code stay."""
    lines: list[str] = []
    paragraph: list[str] = []
    in_code = False
    for line in text.split("\n"):
        is_fence = line.lstrip().startswith("```")
        stays = in_code or is_fence or not line.strip() or line.startswith(_ALONE)
        if stays or _ITEM.match(line):
            lines += _fold(paragraph)
            paragraph = []
        (lines if stays else paragraph).append(line)
        in_code ^= is_fence
    return "\n".join([*lines, *_fold(paragraph)])


def _fold(paragraph: Sequence[str]) -> Sequence[str]:
    if all(len(line) <= LONGEST for line in paragraph):
        return paragraph
    mark = _ITEM.match(paragraph[0])
    indent = mark[0] if mark else ""
    words = " ".join(line.strip() for line in paragraph).removeprefix(indent.strip()).lstrip()
    return wrap(
        words,
        LONGEST,
        initial_indent=indent,
        subsequent_indent=" " * len(indent),
        break_long_words=False,
        break_on_hyphens=False,
    )


if __name__ == "__main__":
    for page in pages(Path()):
        text = page.read_text(encoding="utf-8")
        if (new := folded(text)) != text:
            page.write_text(new, encoding="utf-8")
