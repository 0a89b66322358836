"""The rules about the elements of a vendor, by what they report."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.engine import Dispatch, lint_document
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.select import ActiveRules
from sdfcheck.source.document import Document

UNKNOWN, MISPLACED, MALFORMED, MISSING_CHILD = "DRK001", "DRK002", "DRK003", "DRK004"
SCOPED_DEFINITION, UNKNOWN_REFERENCE, UNKNOWN_TYPE_OF_JOINT = "DRK006", "DRK007", "DRK008"
REPEATED, OUT_OF_RANGE, MISSING_VALUE = "DRK016", "DRK019", "DRK020"
OTHERS = ("DRK005", "DRK014", "DRK021")
REMARKS = ("DRK017", "DRK018")
"""The rules that may report right uses."""
_WRONG_USES = (UNKNOWN, MISPLACED, MALFORMED, MISSING_CHILD, SCOPED_DEFINITION, UNKNOWN_REFERENCE)
CODES = {*_WRONG_USES, UNKNOWN_TYPE_OF_JOINT, REPEATED, OUT_OF_RANGE, MISSING_VALUE, *OTHERS, *REMARKS}
"""The rules about the vendor's own elements."""


def reported(document: Document) -> list[Diagnostic]:
    """The reports of the rules about the vendor's own elements."""
    index = load_index()
    facts = tuple(facts for facts in index.facts if facts.code in CODES)
    return lint_document(document, Dispatch(index, ActiveRules(facts, {})))
