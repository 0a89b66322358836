"""Writes a pack's index: ``python -m sdfcheck.lint.rulebook.index [PACK]``; with ``--check`` only compares."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path

from sdfcheck.lint.rulebook.pack import INDEX, Pack, PackError, describe, to_record
from sdfcheck.lint.rulebook.plugins import find_pack, load_rules
from sdfcheck.lint.run import BUILT_IN

_HEAD = '''"""What can be known of the rules without importing them; written by ``make generate``."""

# ruff: noqa: E501
# fmt: off
RULES: tuple[tuple[object, ...], ...] = (
'''


def render(pack: Pack) -> str:
    """The index of a pack, made from its rules: a Python module, which loads fastest.

    Raises:
        PackError: one of its rules is faulty.
    """
    rules, faults = load_rules(pack)
    if faults:
        raise PackError(str(faults[0]), pack.name)
    facts = sorted(map(describe, rules))
    return "".join((_HEAD, *(f"    {to_record(fact)!r},\n" for fact in facts), ")\n"))


def keep(
    arguments: list[str], name: str, render: Callable[[Pack], str], is_current: Callable[[Path, str], bool]
) -> int:
    """Write a module of each pack that ``arguments`` name, or with ``--check`` say which of them are stale."""
    names = [argument for argument in arguments if not argument.startswith("-")] or [BUILT_IN]
    stale = 0
    for pack in map(find_pack, names):
        path, text = pack.folder / f"{name}.py", render(pack)
        if is_current(path, text):
            continue
        if "--check" in arguments:
            print(f"{path} is stale: run `make generate`")
            stale = 1
        else:
            path.write_text(text, encoding="utf-8")
    return stale


def is_current(path: Path, text: str) -> bool:
    return os.path.isfile(path) and path.read_text(encoding="utf-8") == text


def main(arguments: list[str]) -> int:
    return keep(arguments, INDEX, render, is_current)


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except PackError as error:
        sys.exit(f"error: {error}")
