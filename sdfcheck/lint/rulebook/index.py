"""Writes a pack's index: ``python -m sdfcheck.lint.rulebook.index [PACK]``; with ``--check`` only compares."""

from __future__ import annotations

import sys

from sdfcheck.lint.rulebook.pack import INDEX, Pack, PackError, describe, to_record
from sdfcheck.lint.rulebook.plugins.find import find_pack
from sdfcheck.lint.rulebook.plugins.load import load_rules
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


def main(arguments: list[str]) -> int:
    names = [argument for argument in arguments if not argument.startswith("-")] or [BUILT_IN]
    stale = 0
    for pack in map(find_pack, names):
        path = pack.folder / f"{INDEX}.py"
        text = render(pack)
        if "--check" in arguments:
            if not path.is_file() or path.read_text(encoding="utf-8") != text:
                print(f"{path} is stale: run `make generate`")
                stale = 1
        else:
            path.write_text(text, encoding="utf-8")
    return stale


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except PackError as error:
        sys.exit(f"error: {error}")
