"""libsdformat's own checker: ``python -m tests.peers.cmdcheck FILE…``."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from tests.peers import libsdformat

_COLOR = re.compile(r"\x1b\[[0-9;]*m")


class Opinion(NamedTuple):
    """The verdict of libsdformat on a file. ``accepted`` is None if it crashed or took too long."""

    accepted: bool | None
    messages: tuple[str, ...]


def check(path: Path) -> Opinion:
    """Ask libsdformat about a file.

    Raises:
        FileNotFoundError: no libsdformat is installed.
    """
    answer = libsdformat.ask("cmdCheck", path)
    messages = tuple(_messages(answer.errors + answer.output))
    return Opinion(None if answer.status is None else answer.status == 0, messages)


def _messages(text: str) -> Iterator[str]:
    for line in _COLOR.sub("", text).splitlines():
        if line.strip() and line.strip() != "Valid.":
            yield line.strip()


def main(arguments: list[str]) -> int:
    rejected = 0
    for argument in arguments:
        opinion = check(Path(argument))
        rejected += opinion.accepted is not True
        verdict = {True: "accepted", False: "rejected", None: "crashed"}[opinion.accepted]
        print("\n  ".join((f"{argument}: {verdict}", *opinion.messages)))
    return min(rejected, 1)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
