"""One file: its text, its tree, and what other layers have worked out about it."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from lxml import etree

from sdfcheck.source.decode import decode
from sdfcheck.source.element import Element, Value
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Step

if TYPE_CHECKING:
    from sdfcheck.source.library import Library
    from sdfcheck.source.problems import Problem, SyntaxDefect
    from sdfcheck.source.scan import Scan
    from sdfcheck.source.spans import Spans

T = TypeVar("T")

# What a strict parser reads well but not as the simulators do.
_NEEDS_REWRITING = re.compile(r"<!DOCTYPE|\sxmlns\s*=")

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
        self.library: Library | None = None
        """Where files that this one refers to come from; None: nothing is looked up."""
        self.included_by: tuple[Value, ...] = ()
        """The uris through which the file was reached, from the outside in; empty for one that was asked for."""
        self.root: Element | None = self._parse()
        name = self.root.name if self.root is not None else ""
        self.kind = kind or _KINDS.get(name, Kind.OTHER_XML)
        """The dialect; worked out from the root element where the caller does not say."""

    def __repr__(self) -> str:
        return f"Document({str(self.path)!r}, {self.kind.value})"

    @property
    def path(self) -> Path:
        return self.source.path

    @property
    def version(self) -> str | None:
        """The text of the root element's ``version``."""
        return None if self.root is None else self.root.attributes.get("version")

    @property
    def scan(self) -> Scan:
        """The places of everything; made when first asked for."""
        if self._scan is None:
            from sdfcheck.source.quick_scan import quick_scan

            self._scan = quick_scan(self.source)
        return self._scan

    @property
    def spans(self) -> Spans:
        if self._spans is None:
            from sdfcheck.source.spans import Spans

            assert self.root is not None, "spans belong to elements, and there is none"
            self._spans = Spans(self.source, self.scan, self.root)
        return self._spans

    def origins(self, element: Element) -> tuple[Step, ...]:
        """The macro calls and includes that led to an element, the nearest first."""
        return ()

    def view(self, compute: Callable[[Document], T]) -> T:
        """The result of ``compute(self)``, computed once."""
        if compute not in self._views:
            self._views[compute] = compute(self)
        return self._views[compute]  # type: ignore[no-any-return]

    def _parse(self) -> Element | None:
        parser = self._parser(recover=False)
        text = self.source.text
        error: etree.XMLSyntaxError | None = None
        if not _NEEDS_REWRITING.search(text):
            try:
                return etree.fromstring(_encoded(text), parser)  # type: ignore[return-value]
            except etree.XMLSyntaxError as failure:
                error = failure
        from sdfcheck.source.scan import scan

        self._scan = scan(self.source, rewrite=True)
        found = self._scan.problems
        self.problems = [*self.problems, *found]
        if error is not None and not found and not _is_about_namespaces(error):
            self.problems.append(self._unexplained(error))
        if not self._scan.starts:
            return None
        tree = etree.fromstring(_encoded(self._scan.wellformed), self._parser(recover=True))
        return tree  # type: ignore[return-value]

    def _parser(self, *, recover: bool) -> etree.XMLParser:
        """A parser whose elements know this document; it loads nothing from anywhere."""
        own_class = type("Element", (Element,), {"document": self, "__slots__": ()})
        parser = etree.XMLParser(
            encoding="utf-8", resolve_entities=False, no_network=True, load_dtd=False, recover=recover
        )
        parser.set_element_class_lookup(etree.ElementDefaultClassLookup(element=own_class))
        return parser

    def _unexplained(self, error: etree.XMLSyntaxError) -> SyntaxDefect:
        """The parser's own words, for a fault that the scan does not know."""
        from sdfcheck.source.problems import SyntaxDefect, SyntaxKind

        line, column = error.position
        at = self.source.offset(line, max(column, 1))
        return SyntaxDefect(self.source.span(at, at), SyntaxKind.OTHER, None, error.msg or "not well formed")


def read(data: bytes, path: Path, kind: Kind | None = None) -> Document:
    """Read a file's bytes. Never fails: what is wrong is in the document's ``problems``."""
    source, problems = decode(data, path)
    return Document(source, kind, list(problems))


def problems(document: Document) -> list[Problem]:
    """What reading found wrong with the text."""
    return document.problems


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", "surrogatepass")


def _is_about_namespaces(error: etree.XMLSyntaxError) -> bool:
    """Namespaces are judged by an analysis of their own (libxml2's error codes 200 to 205)."""
    return etree.ErrorTypes.NS_ERR_XML_NAMESPACE <= error.code <= etree.ErrorTypes.NS_ERR_COLON
