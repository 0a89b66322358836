"""Comments of a URDF document that a reader trips over.

ROS 2 launch files hand the description over as a parameter, and unless they say that it
is text, it is read as YAML first: there a colon with a blank after it begins a mapping.
"""

from __future__ import annotations

import re

from sdfcheck.formats.urdf.problems import ColonInComment
from sdfcheck.source.document import Document

_QUICK = re.compile(r"<!--(?:(?!-->)[^:])*(?::|\Z)")
_COLON = re.compile(r":(?=\s)")


def problems(document: Document) -> list[ColonInComment]:
    """At most one problem: what fixes one colon has to fix all."""
    text = document.source.text
    if _QUICK.search(text) is None or document.root is None:
        return []
    colons = [
        document.source.span(*match.span())
        for start, end in document.scan.comments
        for match in _COLON.finditer(text, start + 4, end - 3)
    ]
    return [ColonInComment(colons[0], tuple(colons))] if colons else []
