"""Misspelled versions of the format."""

from __future__ import annotations

import re

from sdfcheck.formats.sdf.version import Version

_VERSION = re.compile(r"\D*0*1[.,]0*(\d+)(?!\d)")


def meant_version(text: str) -> str | None:
    """The version that a misspelled one means: blanks around it, a leading zero, a third number, a comma."""
    found = _VERSION.match(text)
    version = Version.parse(f"1.{found[1]}") if found else None
    return str(version) if version else None
