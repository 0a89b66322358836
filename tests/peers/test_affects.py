"""What the rules say of readers against the readers themselves, on the rules' own examples."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sdfcheck.cli.descriptions import Around
from sdfcheck.cli.targets import verdicts
from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.example import Bad, Good, fill, unmark
from tests.peers import readers
from tests.test_rules import RULES

pytestmark = pytest.mark.peers

READERS = dict(readers.installed())
READERS.pop(Consumer.GAZEBO, None)
"""libsdformat, a process for each file, is compared on small cases and real files instead."""

MISSING = "what an example refers to is not there, and may be elsewhere"
REMOTE = "the reader refuses what is on the network; it is not looked at here"
OLD = "releases differ"
URDFDOM_3 = "urdfdom 3 knows one version of URDF, and its parser no document type"
NOT_ONE = "a file without exactly one model or world is refused by Drake"

ARGUED: dict[Consumer, dict[str, str]] = {
    Consumer.DRAKE: {
        "DRK009 DRK018 MUJ001 MUJ002 RES001 RES004 RES006 RES013 URD006 URD007": f"{MISSING}; or: {REMOTE}",
        "RES002": "models are on its search path only if it is told",
        "RES005": MISSING,
        "RES012": "an empty setting of an include crashes libsdformat, and Drake with some of them",
        "SCH005": "the installed Drake reads what older versions wrote in `state` less leniently",
        "SCH006 XML002": NOT_ONE,
        "SCH012": "what a comment leaves of the value is too short besides",
        "NS012": OLD,
    },
    Consumer.URDFDOM: {
        "JNT008": "a ring of links beside one root is passed over",
        "URD009": "two expressions in visuals: the link is dropped, the file read",
        "URD019 XML007": URDFDOM_3,
    },
    Consumer.MUJOCO: {
        "MUJ001 MUJ002": MISSING,
        "URD009": "expressions in visuals, which it does not read",
    },
}
"""Rules on the examples of which a reader differs from what is told of it, and why."""

ALLOWED = {Consumer.DRAKE: 10}
"""How many examples may differ without an argument."""


def examples(folder: Path) -> dict[Path, str]:
    """The examples that are whole documents of SDFormat or URDF, written out: file → code of the rule."""
    written = {}
    for rule in RULES:
        for kind in ("bad", "good"):
            for number, example in enumerate(getattr(rule, kind)):
                text = unmark(fill(rule.scaffold, example))[0]
                suffix = dialect(text)
                if suffix and not example.file.endswith((".xacro", ".config")):
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


@pytest.mark.parametrize("reader", READERS, ids=lambda reader: reader.value)
def test_examples(reader: Consumer, tmp_path: Path) -> None:
    told = {}
    codes = examples(tmp_path)
    for file in codes:
        (row,) = verdicts(file, (reader,), Around(Configuration(isolated=True)))
        if row.verdict is not Verdict.UNREAD:
            told[file] = row.verdict is not Verdict.REJECT
    taken = READERS[reader](list(told))
    argued = {code for some in ARGUED[reader] for code in some.split()}
    found = [
        f"{file.parent.name}: told to be {'taken' if told[file] else 'refused'}, and is not"
        for file, takes in taken.items()
        if takes is not told[file] and codes[file] not in argued
    ]
    assert len(told) > 50
    assert len(found) <= ALLOWED.get(reader, 0), found
