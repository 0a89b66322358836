"""Problems of the parameters of an include."""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record


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
    """An entry of an include's parameters, or a part of one, that fails or does not do what it
    says.

    ``other`` is the second party: the kind of element that the id names, the element in which a
    child is absent, the name that is assumed.
    """

    place: Element | Value
    fault: ParameterFault
    entry: Element
    other: str = ""
    suggestion: str | None = None
