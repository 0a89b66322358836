"""One file: its text, its tree, and what other layers have worked out about it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from lxml import etree

from sdfcheck.source.decode import decode
from sdfcheck.source.element import Element, Value
from sdfcheck.source.rewritten import ATTRIBUTE_LIMIT, COLON
from sdfcheck.source.sniff import HEAD, Kind, sniff
from sdfcheck.source.text import Source, Span, Step

if TYPE_CHECKING:
    from sdfcheck.source.problems import Problem, SyntaxDefect
    from sdfcheck.source.scanner.scan import Scan
    from sdfcheck.source.spans import Spans

T = TypeVar("T")

_TAIL = re.compile(r"\s*>(?:\s|<!--(?:(?!-->)[\s\S])*-->)*")
_LONG_TAG = re.compile(rf"<[^<]{{{5 * ATTRIBUTE_LIMIT}}}")
"""A tag in which there is room for so many attributes."""
_DEFAULT_NAMESPACE = re.compile(r"xmlns\s*=")

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
        "included_by",
        "is_referred_to",
        "is_wellformed",
        "kind",
        "library",
        "problems",
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
        """Did a strict parser, aware of namespaces, take the text as it is?"""
        self.root: Element | None = self._parse()
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

            assert self.root is not None, "a document without elements has no spans"
            self._spans = Spans(self.source, self.scan, self.root)
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
        if self.root is not None and not self.is_referred_to:
            del type(self.root).document
        self.root = self._spans = self._scan = self.library = None
        self.problems, self.included_by = [], ()

    def _parse(self) -> Element | None:
        text = self.source.text
        fault: etree._LogEntry | None = None
        # A text that a strict parser accepts but reads otherwise than simulators is rewritten.
        if "<!DOCTYPE" not in text and COLON not in text and not _DEFAULT_NAMESPACE.search(text):
            root, fault = self._parse_strictly(text)
            if root is not None:
                return root
            if fault is not None and fault.type == etree.ErrorTypes.ERR_HYPHEN_IN_COMMENT:
                root = self._parse_without_hyphens()
                if root is not None:
                    return root
        if (
            fault is not None
            and LONG <= len(text) <= LONGEST
            and (root := self._parse_locally(fault)) is not None
        ):
            return root
        from sdfcheck.source.scanner.full_scan import scan

        self._scan = scan(self.source)
        found = self._scan.problems
        self.problems = [*self.problems, *found]
        if fault is not None and not found:
            self.problems.append(self._unexplained(fault))
        if not self._scan.starts:
            return None
        return etree.fromstring(_encoded(self._scan.wellformed), self._parser(recover=True))  # type: ignore[return-value]

    def _parse_strictly(self, text: str) -> tuple[Element | None, etree._LogEntry | None]:
        """The root of a text that is well formed, perhaps but for undeclared prefixes; or the error."""
        parser = self._parser(recover=False)
        try:
            root: Element = etree.fromstring(_encoded(text), parser)  # type: ignore[assignment]
        except etree.XMLSyntaxError:
            if _lacks_only_prefixes(parser):
                # Then names are kept as they are written, colon and all.
                found: Element = etree.fromstring(_encoded(text), self._parser(recover=True))  # type: ignore[assignment]
                return (found if _is_all(found, text) and not _is_overloaded(found, text) else None), None
            return None, _first_fault(parser)
        if _is_overloaded(root, text):
            return None, None
        self.is_wellformed = text is self.source.text
        return root, None

    def _parse_locally(self, fault: etree._LogEntry) -> Element | None:
        """The root of a long text that is broken in one place."""
        from sdfcheck.source.scanner.local_scan import local_scan

        found = local_scan(self.source, self.source.offset(fault.line, max(fault.column, 1)))
        if found is None:
            return None
        try:
            root: Element = etree.fromstring(_encoded(found.wellformed), self._parser(recover=False))  # type: ignore[assignment]
        except etree.XMLSyntaxError:
            return None
        if root.xpath("count(//*)") != len(found.starts) or _is_overloaded(root, found.wellformed):
            return None
        self._scan = found
        self.problems = [*self.problems, *found.problems]
        return root

    def _parse_without_hyphens(self) -> Element | None:
        """Try it with the hyphens of comments spaced out, of which there are too many."""
        from sdfcheck.source.scanner.hyphens import without_hyphens

        spaced = without_hyphens(self.source)
        if spaced is None:
            return None
        text, found = spaced
        root, _ = self._parse_strictly(text)
        if root is not None:
            self.problems = [*self.problems, *found]
        return root

    def _parser(self, *, recover: bool) -> etree.XMLParser:
        """A parser whose elements know this document; it loads nothing from anywhere."""
        own_class = type("Element", (Element,), {"document": self, "__slots__": ()})
        parser = etree.XMLParser(
            encoding="utf-8", resolve_entities=False, no_network=True, load_dtd=False, recover=recover
        )
        parser.set_element_class_lookup(etree.ElementDefaultClassLookup(element=own_class))
        return parser

    def _unexplained(self, fault: etree._LogEntry) -> SyntaxDefect:
        """The message of the parser, for a fault that the scan does not know."""
        from sdfcheck.source.problems import SyntaxDefect, SyntaxKind

        at = self.source.offset(fault.line, max(fault.column, 1))
        words = fault.message.rstrip(". ")
        return SyntaxDefect(self.source.span(at, at), SyntaxKind.OTHER, None, words[:1].lower() + words[1:])


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


def around(element: Element) -> Iterator[Element]:
    """The elements around one, the innermost first."""
    return element.iterancestors()  # type: ignore[return-value]


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", "surrogatepass")


def _lacks_only_prefixes(parser: etree.XMLParser) -> bool:
    return all(entry.type == etree.ErrorTypes.NS_ERR_UNDEFINED_NAMESPACE for entry in parser.error_log)


def _is_all(root: Element, text: str) -> bool:
    """Does nothing but comments follow the root? Past a prefix that lacks, the parser does not look."""
    end = f"</{root.name}"
    return text.count(end) == 1 and _TAIL.fullmatch(text, text.index(end) + len(end)) is not None


def _is_overloaded(root: Element, text: str) -> bool:
    """Has an element more attributes than are looked at?"""
    if text.count("=") <= ATTRIBUTE_LIMIT or _LONG_TAG.search(text) is None:
        return False
    overloaded = root.xpath(f"boolean(descendant-or-self::*[count(@*) > {ATTRIBUTE_LIMIT}])")
    return bool(overloaded) or text.count("xmlns:") > ATTRIBUTE_LIMIT


def _first_fault(parser: etree.XMLParser) -> etree._LogEntry | None:
    """The cause of the parser's error, unless another analysis reports it: prefixes, repeated attributes."""
    fatal = (entry for entry in parser.error_log if entry.level == etree.ErrorLevels.FATAL)
    return next((entry for entry in fatal if entry.type != etree.ErrorTypes.ERR_ATTRIBUTE_REDEFINED), None)
