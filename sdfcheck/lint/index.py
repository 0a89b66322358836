"""Writes a pack's index: ``python -m sdfcheck.lint.index [PACK]``; with ``--check`` only compares."""

from __future__ import annotations

import sys

from sdfcheck.lint.packs import (
    BUILT_IN,
    INDEX,
    Pack,
    describe,
    find_pack,
    import_pack,
    rule_classes,
    to_record,
)

_HEAD = '''"""What can be known of the rules without importing them; written by ``make generate``."""

# ruff: noqa: E501
# fmt: off
RULES: tuple[dict[str, object], ...] = (
'''


def render(pack: Pack) -> str:
    """The index of a pack, made from its rules: a Python module, which loads fastest."""
    facts = sorted(describe(rule) for module in import_pack(pack) for rule in rule_classes(module))
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
    sys.exit(main(sys.argv[1:]))
