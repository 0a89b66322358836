"""What can be wrong with an include, what it brings, and how it changes that."""

from __future__ import annotations

from enum import Enum
from pathlib import Path

from sdfcheck.files.uris import Location
from sdfcheck.robot.includes import Obstacle
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record


class UnresolvedInclude(Record):
    """A uri that leads to no file.

    ``uses`` are all of that text in the document, where the reason lies outside of it:
    what is on the network or nowhere on the search path is told once.
    """

    uri: Value
    location: Location
    uses: tuple[Value, ...]

    @property
    def is_searched_for(self) -> bool:
        """Does it name a model or package, to be found on a search path, which nothing near by is?

        To libsdformat a bare word is the name of a model, too.
        """
        location, text = self.location, self.uri.text.strip()
        is_word = not location.scheme and not {*text} & {"/", "\\", "."}
        return is_word or (location.is_searched_for and location.owner is None)


class FolderWithoutConfig(Record):
    """A uri that leads to a folder without ``model.config``; ``descriptions`` are files that may be meant."""

    uri: Value
    folder: Path
    descriptions: tuple[str, ...]


class OldManifest(Record):
    """A model folder that still has a ``manifest.xml`` instead of a ``model.config``."""

    uri: Value
    manifest: Path


class IncludeCycle(Record):
    """A file that includes itself; ``steps`` are the uris that lead back to it, the first in this file."""

    steps: tuple[Value, ...]


class UnusableInclude(Record):
    """An included file that was found and brings nothing.

    ``file`` is that file, ``root`` the name of its root element, ``worlds`` whether it holds a world.
    """

    uri: Value
    obstacle: Obstacle
    file: Path
    root: str = ""
    holds_world: bool = False


class EmptyIncludeSetting(Record):
    """An empty ``name``, ``static`` or ``placement_frame``, which libsdformat does not survive."""

    element: Element


class InvalidMerge(Record):
    """Something that cannot be merged into where the include stands.

    ``kind`` is what is included: a light or an actor never merges; a model does, but not
    into ``parent`` where that is neither model nor world, nor into a world with the
    ``parts`` that a world cannot have.
    """

    merge: Value
    kind: str
    parent: Element
    parts: tuple[str, ...] = ()


class ParameterFault(Enum):
    """The ways in which an entry of ``experimental:params`` fails."""

    NO_ID = "no element_id"
    OPEN_END = "element_id ends in ::"
    UNKNOWN_ACTION = "unknown action"
    NO_NAME = "no name"
    EMPTY_NAME = "empty name"
    TAKEN = "taken"
    NOTHING = "names nothing"
    OTHER_KIND = "names another kind"
    NO_PARENT = "no parent"
    UNKNOWN_ENTRY = "unknown element"
    NO_CHILD_ACTION = "child without action"
    ABSENT_CHILD = "absent child"
    UNKNOWN_CHILD = "unknown child"
    UNKNOWN_ATTRIBUTE = "unknown attribute"
    NAME_ASSUMED = "name assumed"
    NO_CHANGE = "no change"


class InvalidParameter(Record):
    """An entry of an include's parameters, or a part of one, that fails or does not do what it says.

    ``other`` is the party that is told with it: the kind of element that the id names,
    the element in which a child is absent, the name that is assumed.
    """

    place: Element | Value
    fault: ParameterFault
    entry: Element
    other: str = ""
    suggestion: str | None = None
