"""XML declarations and other instructions: whether they are well formed."""

from __future__ import annotations

import re

from sdfcheck.source.problems import SyntaxKind
from sdfcheck.source.scanner.start_tag import BLANK, NAME

_INSTRUCTION = re.compile(
    rf"<\?xml{BLANK}+version{BLANK}*={BLANK}*([\"'])1\.[0-9]+\1"
    rf"(?:{BLANK}+encoding{BLANK}*={BLANK}*([\"'])[A-Za-z][\w.\-]*\2)?(?:{BLANK}+standalone{BLANK}*={BLANK}*([\"'])(?:yes|no)\3)?{BLANK}*\?>"
    rf"|<\?(?![xX][mM][lL]){NAME}(?:{BLANK}[\s\S]*)?\?>|<\?xml-{NAME}(?:{BLANK}[\s\S]*)?\?>"
)
_VERSION = re.compile(rf"<\?xml{BLANK}+version{BLANK}*={BLANK}*([\"'])(\w[\w.\-]*)\1")


def instruction_fault(text: str, start: int, end: int) -> tuple[SyntaxKind, int, int] | None:
    """The fault of an instruction and its place; None if it is sound."""
    if _INSTRUCTION.fullmatch(text, start, end):
        return None
    version = _VERSION.match(text, start, end)
    if version and _INSTRUCTION.fullmatch(f'<?xml version="1.0"{text[version.end() : end]}'):
        return SyntaxKind.ODD_VERSION, version.start(2), version.end(2)
    return SyntaxKind.MALFORMED_INSTRUCTION, start, end
