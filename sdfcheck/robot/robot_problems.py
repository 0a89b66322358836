"""What refers to parts of a URDF robot and does not reach them."""

from __future__ import annotations

from sdfcheck.source.element import Value
from sdfcheck.source.record import Record


class UnreferencedExtension(Record):
    """A ``<gazebo>`` whose ``reference`` is no link or joint; ``kind`` says what else has that name."""

    value: Value
    suggestion: str | None
    kind: str | None
