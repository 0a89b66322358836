"""Findings that are known and wait: how many of each rule in each file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from pathlib import Path

from sdfcheck.files.regular import MEGABYTE, read_named
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.run import Run
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import relative_path

VERSION = 1
LARGEST = 64 * MEGABYTE
"""So many bytes a baseline may have."""

Key = tuple[str, str]
"""File (relative to the folder of the baseline) and code of the rule."""


class Held(NamedTuple):
    """A run without what the baseline knows; ``gone`` known findings are no more."""

    run: Run
    gone: int


def read(path: Path) -> Mapping[Key, int]:
    """The numbers of a baseline.

    Raises: WrongUsage: the file does not exist, or is not a baseline.
    """
    import json

    try:
        record = json.loads(read_named(path, LARGEST))
        if record["version"] != VERSION:
            raise WrongUsage(f"{path}: a baseline of version {record['version']}, not {VERSION}")
        return {
            (file, code): _count(number)
            for file, rules in record["findings"].items()
            for code, number in rules.items()
        }
    except OSError as error:
        raise WrongUsage(f"cannot read {path}: {error.strerror}; --write-baseline makes one") from None
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        raise WrongUsage(f"{path} is not a baseline") from None


def _count(number: object) -> int:
    if not isinstance(number, int) or isinstance(number, bool) or number < 0:
        raise ValueError("not a count")
    return number


def render(run: Run, path: Path) -> str:
    """The baseline that holds all findings of a run."""
    import json

    findings: dict[str, dict[str, int]] = {}
    for (file, code), number in sorted(_counts(run, path).items()):
        findings.setdefault(file, {})[code] = number
    return json.dumps({"version": VERSION, "findings": findings}, indent=1, ensure_ascii=False) + "\n"


def hold(run: Run, known: Mapping[Key, int], path: Path) -> Held:
    """Leave out what is known; where a file has more findings of a rule than that, nobody knows which are new."""
    counts = _counts(run, path)
    left = tuple(d for d in run.diagnostics if counts[_key(d, path)] > known.get(_key(d, path), 0))
    linted = {_name(file, path) for file in run.files}
    gone = sum(max(0, number - counts[key]) for key, number in known.items() if key[0] in linted)
    silenced = run.suppressed + len(run.diagnostics) - len(left)
    return Held(run._replace(diagnostics=left, suppressed=silenced), gone)


def _counts(run: Run, path: Path) -> Counter[Key]:
    return Counter(_key(diagnostic, path) for diagnostic in run.diagnostics)


def _key(diagnostic: Diagnostic, path: Path) -> Key:
    return _name(diagnostic.span.source.path, path), diagnostic.code


def _name(file: Path, path: Path) -> str:
    return Path(relative_path(file, path.parent)).as_posix()
