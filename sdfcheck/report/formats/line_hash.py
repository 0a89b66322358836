"""The fingerprints by which GitHub follows a finding when its line moves.

The hash of a line covers the 100 UTF-16 units from its beginning on, spaces left out and line ends
made equal; a number distinguishes lines that hash alike. GitHub computes the same from the file
(github/codeql-action, `fingerprints.ts`) where it finds none.
"""

from __future__ import annotations

import struct
from collections import Counter
from collections.abc import Iterable

_UNITS = 100
_FACTOR = 37
_MASK = (1 << 64) - 1
_WINDOW = struct.Struct(f"<{_UNITS}H")


def line_hashes(text: str, lines: Iterable[int]) -> dict[int, str]:
    """The fingerprints of the given lines (from 1) of a text."""
    wanted = frozenset(lines)
    dense = text.replace("\r\n", "\n").replace("\r", "\n").replace(" ", "").replace("\t", "")
    units = f"{dense}\uffff".encode("utf-16-le", "surrogatepass") + bytes(_WINDOW.size)
    seen: Counter[bytes] = Counter()
    hashes: dict[int, str] = {}
    start = 0
    for number, line in enumerate(dense.split("\n"), 1):
        window = units[start : start + _WINDOW.size]
        seen[window] += 1
        if number in wanted:
            hashes[number] = f"{_hash(window):x}:{seen[window]}"
        start += len(f"{line}\n".encode("utf-16-le", "surrogatepass"))
    return hashes


def _hash(window: bytes) -> int:
    value = 0
    for unit in _WINDOW.unpack(window):
        value = (value * _FACTOR + unit) & _MASK
    return value
