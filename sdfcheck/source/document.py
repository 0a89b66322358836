"""One file: its text, its tree, and what other layers have worked out about it."""

from __future__ import annotations

from collections.abc import Callable, Collection
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from sdfcheck.source.decode import decode
from sdfcheck.source.element import Aside, Element, Value
from sdfcheck.source.sniff import HEAD, Kind, sniff
from sdfcheck.source.text import Source, Span, Step
from sdfcheck.source.tree import fill

if TYPE_CHECKING:
    from sdfcheck.source.problems import Problem
    from sdfcheck.source.scanner.scan import Scan
    from sdfcheck.source.spans import Spans

T = TypeVar("T")


LONG, LONGEST = 200_000, 20_000_000
"""Of texts of such a length that are broken, only the place of the fault is scanned, if that is enough."""

_LINTED = frozenset((Kind.SDF, Kind.URDF, Kind.XACRO, Kind.MODEL_CONFIG, Kind.SRDF))
_KINDS = {"sdf": Kind.SDF, "robot": Kind.URDF, "model": Kind.MODEL_CONFIG}


class Document:
    """A robot description as it was read.

    ``root`` is None only if the text holds no element at all; ``problems`` are those of
    the text, in order of place. Views (frames, names, …) are computed once, by
    :meth:`view`.
    """

    __slots__ = (
        "__dict__",
        "_scan",
        "_spans",
        "_views",
        "declared",
        "elements",
        "epilog",
        "included_by",
        "is_referred_to",
        "is_wellformed",
        "kind",
        "library",
        "names",
        "problems",
        "prolog",
        "root",
        "source",
    )

    def __init__(self, source: Source, kind: Kind | None, problems: list[Problem]) -> None:
        self.source = source
        self.problems = problems
        self._scan: Scan | None = None
        self._spans: Spans | None = None
        self._views: dict[Callable[[Document], Any], Any] = {}
        self.library: object | None = None
        """Where files that this one refers to come from; None: nothing is looked up."""
        self.included_by: tuple[Value, ...] = ()
        """The uris through which the file was reached, from the outside in; empty for one that was asked for."""
        self.is_referred_to = False
        """Was another document reached through an include in it?"""
        self.is_wellformed = False
        """Did a strict parser take the text as it is?"""
        self.root: Element | None
        self.elements: list[Element] = []
        """All elements, in the order of their start tags."""
        self.names: Collection[str] = ()
        """The names of elements and attributes."""
        self.declared: dict[Element, dict[str, str]] = {}
        """Element → the prefixes that it declares, with their namespaces."""
        self.prolog: list[Aside] = []
        """The comments and instructions before the root."""
        self.epilog: list[Aside] = []
        """Those after it."""
        self._parse()
        name = self.root.name if self.root is not None else ""
        self.kind = kind or _KINDS.get(name) or sniff(_encoded(source.text[:HEAD]), source.path)
        """The dialect; worked out from the text where the caller does not say."""

    def __repr__(self) -> str:
        return f"Document({str(self.path)!r}, {self.kind.value})"

    @property
    def path(self) -> Path:
        return self.source.path

    @property
    def version(self) -> str | None:
        """The text of the root element's ``version``."""
        return None if self.root is None else self.root.text_of("version")

    @property
    def is_recognized(self) -> bool:
        """Is this something that is linted?"""
        return self.kind in _LINTED

    def is_doubtful(self, span: Span) -> bool:
        """Does a place lie where the text could only be read by a guess?

        There the problems of the text say what is wrong; whatever else seems to be
        follows from the guess.
        """
        if self._scan is None or span.source is not self.source:
            return False
        return any(start <= span.start < end for start, end in self._scan.doubtful)

    @property
    def scan(self) -> Scan:
        """The places of everything; made when first asked for."""
        if self._scan is None:
            from sdfcheck.source.scanner.quick_scan import quick_scan

            self._scan = quick_scan(self.source)
        return self._scan

    @property
    def spans(self) -> Spans:
        if self._spans is None:
            from sdfcheck.source.spans import Spans

            self._spans = Spans(self.source, self.scan)
        return self._spans

    @property
    def is_expanded(self) -> bool:
        """Whether the text was made from others, in which the places are."""
        return False

    def may_write(self, pattern: str) -> bool:
        """Whether the texts that it was made from have a place that fits, which may become a part of it."""
        return False

    def origins(self, element: Element) -> tuple[Step, ...]:
        """The macro calls and includes that led to an element, the nearest first."""
        return ()

    def view(self, compute: Callable[[Document], T]) -> T:
        """The result of ``compute(self)``, computed once."""
        if compute not in self._views:
            self._views[compute] = compute(self)
        return self._views[compute]  # type: ignore[no-any-return]

    def release(self) -> None:
        """Drop the tree and the views, which refer to one another; the text is kept."""
        for view in self._views.values():
            if (release := getattr(view, "release", None)) is not None:
                release()
        self._views.clear()
        if not self.is_referred_to:
            for element in self.elements:
                if element.nodes:
                    element.nodes.clear()
        self.root = self._spans = self._scan = self.library = None
        self.elements, self.declared = [], {}
        self.problems, self.included_by = [], ()

    def _parse(self) -> None:
        """Fill the tree from the text; from a repaired one where it is broken."""
        fault = fill(self, self.source.text)
        if fault is None:
            self.is_wellformed = True
            return
        if self._parse_without_hyphens(fault) or self._parse_locally(fault):
            return
        from sdfcheck.source.scanner.full_scan import scan

        self._scan = scan(self.source)
        found = self._scan.problems
        self.problems = [*self.problems, *found]
        if not found:
            self.problems += (unexplained := _unexplained(self.source))
            if not unexplained:
                self._scan.doubtful.clear()
        fill(self, self._scan.wellformed)

    def _parse_without_hyphens(self, fault: int) -> bool:
        """Try it with the hyphens of comments spaced out, of which there are too many."""
        text = self.source.text
        if text.rfind("<!--", 0, fault) <= text.rfind("-->", 0, fault):
            return False
        from sdfcheck.source.scanner.hyphens import without_hyphens

        spaced = without_hyphens(self.source)
        if spaced is None:
            return False
        text, found = spaced
        if fill(self, text) is not None:
            return False
        self.problems = [*self.problems, *found]
        return True

    def _parse_locally(self, fault: int) -> bool:
        """Try it with a repair of the one place in which a long text is broken."""
        if not LONG <= len(self.source.text) <= LONGEST:
            return False
        from sdfcheck.source.scanner.local_scan import local_scan

        found = local_scan(self.source, fault)
        if found is None or fill(self, found.wellformed) is not None:
            return False
        if len(self.elements) != len(found.starts):
            return False
        self._scan = found
        self.problems = [*self.problems, *found.problems]
        return True


def read(data: bytes, path: Path, kind: Kind | None = None) -> Document:
    """Read a file's bytes. Never fails: what is wrong is in the document's ``problems``."""
    source, problems = decode(data, path)
    return Document(source, kind, list(problems))


def problems(document: Document) -> list[Problem]:
    """The problems of the text; of a text that is not a robot description, only that one."""
    if document.is_recognized:
        return document.problems
    from sdfcheck.source.scanner.recognition import unrecognized

    root = document.root
    found = (root.name, root.span) if root is not None else (None, None)
    return [unrecognized(document.source, document.kind, *found)]


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", "surrogatepass")


def _unexplained(source: Source) -> list[Problem]:
    """The fault that another parser finds in a text where the scan knows none; it may take the text, too."""
    from lxml import etree

    from sdfcheck.source.problems import SyntaxDefect, SyntaxKind

    parser = etree.XMLParser(encoding="utf-8", resolve_entities=False, no_network=True, load_dtd=False)
    try:
        etree.fromstring(_encoded(source.text), parser)
    except etree.XMLSyntaxError:
        fatal = (entry for entry in parser.error_log if entry.level == etree.ErrorLevels.FATAL)
        for entry in fatal:
            if entry.type == etree.ErrorTypes.ERR_ATTRIBUTE_REDEFINED:
                continue  # reported as such
            at = source.offset(entry.line, max(entry.column, 1))
            words = entry.message.rstrip(". ")
            words = words[:1].lower() + words[1:]
            return [SyntaxDefect(source.span(at, at), SyntaxKind.OTHER, None, words)]
    return []
