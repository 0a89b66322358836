"""The verdicts that `targets` gives for consumers, against those that the consumers gave."""

from __future__ import annotations

import json
from collections import Counter

import pytest

from sdfcheck.cli.parts.descriptions import SearchContext
from sdfcheck.cli.targets import verdicts
from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.lint.config.configuration import Configuration
from tests.peers.findings import SHARED

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not SHARED.is_dir(), reason="the files to compare on are not here"),
]

CONSUMERS = {Consumer.GAZEBO: "libsdformat", Consumer.DRAKE: "drake"}
ALLOWED = {Consumer.GAZEBO: 0, Consumer.DRAKE: 1}
"""How many accepted files may be called rejected: Drake ignores the xacro elements of a `.urdf` file."""
UNASKED = {
    Consumer.GAZEBO: frozenset[str](),
    Consumer.DRAKE: frozenset({"DRK009", "RES001", "RES002", "SCH014", "URD006", "URD007"}),
}
"""Cases without a verdict: Drake read the files without shapes, and beside files that are not here."""


def test_real_files() -> None:
    counts: Counter[tuple[Consumer, bool, bool]] = Counter()
    corpus = SHARED / "corpus"
    for known in json.loads((corpus / "verdicts.json").read_text("utf-8")):
        rows = verdicts(corpus / known["file"], tuple(CONSUMERS), SearchContext(Configuration(isolated=True)))
        for row in rows:
            opinion = known.get(CONSUMERS[row.consumer])
            # Remote includes are fetched by nobody.
            if isinstance(opinion, dict) and opinion.get("first") not in {"URI_LOOKUP", "PARSING_ERROR"}:
                rejects = {
                    reason.diagnostic.code
                    for reason in row.reasons
                    if reason.reaction.verdict is Verdict.REJECT
                }
                if opinion["ok"]:
                    rejects -= UNASKED[row.consumer]
                counts[row.consumer, opinion["ok"], bool(rejects)] += 1
    for consumer, allowed in ALLOWED.items():
        assert counts[consumer, True, False] > 150
        assert counts[consumer, True, True] <= allowed
        assert counts[consumer, False, True] > 15
        assert counts[consumer, False, False] <= 1
