"""The reactions in rules against the consumers themselves, on the rules' own examples."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from sdfcheck.cli.parts.descriptions import SearchContext
from sdfcheck.cli.targets import verdicts
from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.example import Bad, Good, fill, unmark
from sdfcheck.lint.rule import Rule
from tests.peers import consumers
from tests.test_rules import RULES

pytestmark = pytest.mark.peers

CONSUMERS = consumers.installed()

MISSING = "what an example refers to is not there, and may be elsewhere"
REMOTE = "the consumer refuses what is on the network; it is not looked at here"
OLD = "releases differ"
TWELVE = "about libsdformat 17: version 12 does not know it yet, or still asks for it"
URDFDOM_3 = "urdfdom 3 knows one version of URDF"
NOT_ONE = "a file without exactly one model or world is refused by Drake"

ARGUED: dict[Consumer, dict[str, str]] = {
    Consumer.GAZEBO: {
        "FRM008 INR008 JNT003 JNT009 JNT012 NAM006 NS012 RES007 RES008 RES009 SCH001 SCH002 SCH005 URD014": TWELVE,
        "NAM001 NAM002-bad-2": "two of one name, which its checker alone refuses",
        "JNT001-bad-3": "refused when ends are resolved, which the check does not do",
        "RES004-bad-3": "what follows the scheme is looked for, and is not there",
        "XML010": "the depth that tinyxml2 follows is the distribution's",
        "RES002 RES003 RES010 RES012": "models are on its search path only if it is expected",
        "JNT008": "a ring of links beside a root without mass",
        "FRM010 RES004-good-0": REMOTE,
    },
    Consumer.DRAKE: {
        "DRK009 DRK018 DRK022 MUJ001 MUJ002 RES001 RES004 RES006 RES013 URD006 URD007": f"{MISSING}; or: {REMOTE}",
        "RES002 RES009 RES010": "models are on its search path only if it is expected",
        "RES003 RES005 JNT020-good-0": MISSING,
        "FRM010 GAZ017": REMOTE,
        "RES012": "an empty setting of an include crashes libsdformat, and Drake with some of them",
        "SCH006 XML002": NOT_ONE,
        "NS012": OLD,
    },
    Consumer.URDFDOM: {
        "URD019": URDFDOM_3,
    },
    Consumer.MUJOCO: {
        "GEO005 MUJ001 MUJ002 MUJ006": MISSING,
    },
}
"""Rules on the examples of which, or examples on which, a consumer differs from what is reported, and why."""


def examples(
    folder: Path, rules: Iterable[type[Rule]] = RULES, *, most: int | None = None
) -> dict[Path, str]:
    """The examples that are whole documents of SDFormat or URDF, written out: file → code of the rule.

    ``most``: of those that are reported, and of those that are not, so many of each rule.
    """
    written = {}
    for rule in rules:
        for kind in ("bad", "good"):
            for number, example in enumerate(getattr(rule, kind)[:most]):
                text = unmark(fill(rule.scaffold, example))[0]
                suffix = dialect(text)
                if suffix and not example.file.endswith((".xacro", ".config", ".srdf")):
                    file = folder / f"{rule.code}-{kind}-{number}" / (example.file or f"example.{suffix}")
                    written[write(file, text, example)] = rule.code
    return written


def dialect(text: str) -> str:
    root = re.search(r"<(sdf|robot)\b", text)
    return {"sdf": "sdf", "robot": "urdf"}[root[1]] if root else ""


def write(file: Path, text: str, example: Bad | Good) -> Path:
    for name, content in (example.files or {}).items():
        (file.parent / name).parent.mkdir(parents=True, exist_ok=True)
        (file.parent / name).write_text(content, encoding="utf-8")
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
    return file


@pytest.mark.parametrize("consumer", CONSUMERS, ids=lambda consumer: consumer.value)
def test_examples(consumer: Consumer, tmp_path: Path, stride: Callable[[int], int]) -> None:
    expected = {}
    usual = 8 if consumer is Consumer.GAZEBO else 4  # its check is a process for each file
    rules = RULES[:: stride(usual)]
    codes = examples(tmp_path, rules, most=1 if len(rules) < len(RULES) else None)
    for file in codes:
        (row,) = verdicts(file, (consumer,), SearchContext(Configuration(isolated=True)))
        if row.verdict is not Verdict.UNREAD:
            expected[file] = row.verdict is not Verdict.REJECT
    taken = CONSUMERS[consumer](list(expected))
    argued = {code for some in ARGUED[consumer] for code in some.split()}
    found = [
        f"{file.parent.name}: expected to be {'taken' if expected[file] else 'refused'}, and is not"
        for file, takes in taken.items()
        if takes is not expected[file] and argued.isdisjoint((codes[file], file.parent.name))
    ]
    assert len(expected) > 50
    assert not found, "\n".join(found)
