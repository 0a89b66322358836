"""The lowest versions that pyproject.toml promises, as constraints for pip: ``python -m tables.lowest``."""

from __future__ import annotations

import re
import sys
from pathlib import Path

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[1]


def lowest() -> list[str]:
    """A line for each of the dependencies that have a floor, with its condition."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    floors = (re.match(r"([\w.-]+)>=([\w.]+)[^;]*(;.*)?", each) for each in project["dependencies"])
    return [f"{floor[1]}=={floor[2]}{floor[3] or ''}" for floor in floors if floor]


if __name__ == "__main__":
    print("\n".join(lowest()))
