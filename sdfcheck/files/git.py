"""What git knows about a folder."""

from __future__ import annotations

import os
from pathlib import Path

from sdfcheck.source.record import NamedTuple

# Set while git runs a hook; they would point at that repository, whichever folder is asked about.
_HOOK_VARIABLES = ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX")


def work_tree(folder: Path) -> Path | None:
    """The root of the repository that holds ``folder``; told by its ``.git``, without running git."""
    absolute = Path(os.path.abspath(folder))
    return next((place for place in (absolute, *absolute.parents) if (place / ".git").exists()), None)


class Listed(NamedTuple):
    """One name that git lists: a file, or a repository inside the repository."""

    name: str
    is_repository: bool


def listed(folder: Path) -> list[Listed] | None:
    """Tracked and untracked files below ``folder`` that are not ignored, relative to it.

    None if git cannot tell: it is missing, this is no repository, or the folder is
    itself ignored.
    """
    if work_tree(folder) is None:
        return None
    output = _git(folder, "ls-files", "-z", "--stage", "--cached", "--others", "--exclude-standard")
    if output is None:
        return None
    names = {_parse(os.fsdecode(line)) for line in output.split(b"\0") if line}
    if not names and _git(folder, "check-ignore", "--quiet", ".") is not None:
        return None
    return sorted(names)


def _parse(line: str) -> Listed:
    """Tracked names stand behind their mode, hash and stage; untracked ones stand alone."""
    entry, tab, name = line.partition("\t")
    if tab and entry.count(" ") == 2 and len(entry) > 45:
        return Listed(name, entry.startswith("160000 "))
    return Listed(line.rstrip("/"), line.endswith("/"))


def _git(folder: Path, *arguments: str) -> bytes | None:
    """The output of a git command; None if it fails."""
    import subprocess

    environment = {name: value for name, value in os.environ.items() if name not in _HOOK_VARIABLES}
    try:
        done = subprocess.run(
            ["git", *arguments],
            cwd=folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            check=True,
        )
    except (OSError, subprocess.CalledProcessError):
        return None
    return done.stdout
