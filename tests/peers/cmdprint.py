"""Files as libsdformat prints them: converted to its own version, with defaults written out."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from tests.peers import libsdformat


class Job(NamedTuple):
    """Print a file; includes are looked for from ``folder``."""

    path: Path
    folder: Path | None = None


def version_of(name: str) -> str:
    """The version that a library (``libsdformat12.so.12``) prints: that of libsdformat12 is 1.9."""
    return f"1.{int(name.removeprefix('libsdformat').partition('.')[0]) - 3}"


def printed(jobs: Sequence[Job]) -> list[str]:
    """The SDFormat that libsdformat prints for each file, empty for nothing.

    Raises:
        FileNotFoundError: no libsdformat is installed.
    """
    texts = (libsdformat.ask("cmdPrint", job.path, job.folder).output for job in jobs)
    return [start + rest for _, start, rest in (text.partition("<sdf") for text in texts)]
