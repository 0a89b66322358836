"""What can be wrong with prefixes: small values that rules put into words."""

from __future__ import annotations

from sdfcheck.source.record import Record
from sdfcheck.source.text import Span


class UndeclaredPrefix(Record):
    """A prefix used out of the scope of any declaration.

    ``uses`` are all such uses in the document, the first one first; ``elsewhere`` is a
    declaration whose scope (up to ``scope_end``) does not reach them.
    """

    span: Span
    prefix: str
    uses: tuple[Span, ...]
    elsewhere: Span | None
    scope_end: Span | None
    namespace: str
    root: Span
    """Where a declaration can be inserted: after the last attribute of the root's start tag."""


class RedeclaredPrefix(Record):
    """One prefix declared twice on one element."""

    span: Span
    first: Span
    prefix: str


class DefaultNamespace(Record):
    """``xmlns="…"``; ``whole`` is the attribute with the blanks before it."""

    span: Span
    whole: Span
    namespace: str


class DeclaredBelowRoot(Record):
    """A declaration on an element that is not the root.

    ``wholes`` are all declarations of the prefix below the root, with the blanks before
    them, if they agree on the name and so can be replaced by one on the root; else empty.
    ``declaration`` is what to insert at ``root`` then; empty if the root has it already.
    """

    span: Span
    prefix: str
    wholes: tuple[Span, ...]
    declaration: str
    root: Span


class UnusedPrefix(Record):
    """What one element declares and nothing uses: the first, and all with the blanks before them."""

    span: Span
    prefixes: tuple[str, ...]
    wholes: tuple[Span, ...]


class MalformedQualifiedName(Record):
    """A name with more than one colon, or with nothing before or after it."""

    span: Span
    name: str


class ShadowedPrefix(Record):
    """A prefix bound anew, to another name, inside its own scope."""

    span: Span
    prefix: str
    outer: Span


class SynonymousPrefix(Record):
    """A second prefix for a namespace name that has one in scope."""

    span: Span
    prefix: str
    first: Span
    first_prefix: str


class EmptyNamespaceName(Record):
    span: Span
    prefix: str


class ReservedPrefix(Record):
    """``xml`` or ``xmlns`` declared or used for an element, or their names given to another prefix."""

    span: Span
    prefix: str
