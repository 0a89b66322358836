"""Files that are only a part of a robot: another file includes them and has the rest."""

from __future__ import annotations

from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind

_ENDS = frozenset({"parent", "child"})


def is_fragment(document: Document) -> bool:
    """Whether a robot has no links, or not those of its joints, and another file includes it."""
    root = document.root
    if root is None or document.kind is not Kind.URDF or (root.has("link") and not lacks_links(document)):
        return False
    from sdfcheck.xacro.static.project import is_included

    return is_included(document)


def lacks_links(document: Document) -> bool:
    """Whether the joints of a robot connect links that it does not have itself."""
    root = document.root
    if root is None or document.kind is not Kind.URDF:
        return False
    own = {link.text_of("name") for link in root.children("link")}
    ends = (end for joint in root.children("joint") for end in joint.children() if end.name in _ENDS)
    return any(end.text_of("link") not in own for end in ends)
