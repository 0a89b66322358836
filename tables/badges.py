"""The badges: those of the README, and the one that users show in theirs.

``make picture`` writes them again: ``python -m tables.badges``. They load nothing from elsewhere.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).parents[1]
FOLDER = ROOT / "docs" / "assets"
_PROJECT = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
_NARROW = frozenset("fijlrt.- ")
_INDIGO, _GREEN = "#3f51b5", "#2e7d32"


def badges() -> Mapping[str, str]:
    """File → picture."""
    versions = re.findall(r"Python :: (3\.\d+)", _PROJECT)
    (license_,) = re.findall(r'^license = "(\S+)', _PROJECT, re.MULTILINE)
    return {
        "badge.svg": svg("robots", "checked with sdfcheck", _GREEN),
        "badge-python.svg": svg("python", f"{versions[0]} – {versions[-1]}", _INDIGO),
        "badge-license.svg": svg("license", license_, _INDIGO),
    }


def svg(label: str, words: str, color: str) -> str:
    """A label and words beside it; ``textLength`` keeps them in their boxes whatever fonts there are."""
    first, second = (sum(4.6 if letter in _NARROW else 7 for letter in text) + 12 for text in (label, words))
    first, second = round(first), round(second)
    return f"""\
<svg xmlns="http://www.w3.org/2000/svg" width="{first + second}" height="20" role="img" aria-label="{label}: {words}">
  <title>{label}: {words}</title>
  <clipPath id="c"><rect width="{first + second}" height="20" rx="3"/></clipPath>
  <g clip-path="url(#c)">
    <rect width="{first}" height="20" fill="#444"/>
    <rect x="{first}" width="{second}" height="20" fill="{color}"/>
  </g>
  <g fill="#fff" font-family="Verdana, DejaVu Sans, sans-serif" font-size="11">
    <text x="6" y="14" textLength="{first - 12}">{label}</text>
    <text x="{first + 6}" y="14" textLength="{second - 12}">{words}</text>
  </g>
</svg>
"""


if __name__ == "__main__":
    for name, picture in badges().items():
        (FOLDER / name).write_text(picture, encoding="utf-8")
