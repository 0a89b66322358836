"""Writes a pack's index: ``python -m sdfcheck.lint.index [PACK]``; with ``--check`` only compares."""

from __future__ import annotations

import json
import sys

from sdfcheck.lint.packs import BUILT_IN, Pack, describe, find_pack, import_pack, rule_classes, to_record


def render(pack: Pack) -> str:
    """The index of a pack, made from its rules."""
    facts = sorted(describe(rule) for module in import_pack(pack) for rule in rule_classes(module))
    return json.dumps([to_record(fact) for fact in facts], indent=1, ensure_ascii=False) + "\n"


def main(arguments: list[str]) -> int:
    names = [argument for argument in arguments if not argument.startswith("-")] or [BUILT_IN]
    stale = 0
    for pack in map(find_pack, names):
        path = pack.folder / "index.json"
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
