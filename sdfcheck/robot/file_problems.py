"""What can be wrong with the files that a description refers to, and with how it names them."""

from __future__ import annotations

from enum import Enum
from pathlib import Path

from sdfcheck.files.uris import Location
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record


class MissingFile(Record):
    """A file that is not where its URI leads. ``what`` says what it would be: a mesh, a texture.

    ``suggestion`` is a file beside it that may be meant. ``has_kin``: its folder holds
    others of its suffix; without any, such files may be kept elsewhere. ``count`` is how
    often the document names it.
    """

    value: Value
    what: str
    location: Location
    suggestion: str | None
    has_kin: bool
    count: int = 1


class MissingFolder(Record):
    """A folder that is not there, with what should be in it, as when such files are kept elsewhere.

    ``uses`` are all URIs into it, in document order.
    """

    value: Value
    folder: Path
    location: Location
    uses: tuple[Value, ...]


class MissingOwner(Record):
    """A model or package that is nowhere to be found; ``uses`` are all URIs into it, in document order."""

    value: Value
    location: Location
    uses: tuple[Value, ...]


class WrongCase(Record):
    """A URI that would be right if case did not matter; ``meant`` is the right one, if that is clear."""

    value: Value
    near: Path
    meant: str | None


class UriFault(Enum):
    """The ways in which a URI is no URI, or not the one that is meant."""

    BACKSLASH = "backslash"
    SLASHES = "number of slashes"
    SCHEME_CASE = "capital letters"
    UNKNOWN_SCHEME = "unknown scheme"
    NO_NAME = "no name"
    BLANK = "blank"


class MalformedUri(Record):
    """A URI with a slip in it; ``meant`` is what it was probably to be."""

    value: Value
    fault: UriFault
    meant: str | None


class AbsolutePath(Record):
    """A path from the root of this computer's file system."""

    value: Value


class UnportableUri(Record):
    """A URI in a URDF that not all readers of URDF resolve; ``uses`` are all of that kind."""

    value: Value
    scheme: str
    uses: tuple[Value, ...]


class UnknownReference(Record):
    """A name of a collision or link, used by a sensor, gripper or sound, that nothing there has.

    ``kind`` is what is to be named, ``scope`` where it would have to be.
    """

    value: Value
    kind: str
    scope: Element
    suggestion: str | None
