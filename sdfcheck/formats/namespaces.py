"""Prefixes: where they are declared, where they are used, and whether the two agree.

Judged on the text, as libsdformat and Drake read it; scope and uniqueness are those of
"Namespaces in XML 1.0", which the custom-elements proposal of SDFormat 1.7 asks users
to comply with.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from sdfcheck.formats.namespace_problems import (
    DeclaredBelowRoot,
    DefaultNamespace,
    EmptyNamespaceName,
    MalformedQualifiedName,
    RedeclaredPrefix,
    ReservedPrefix,
    ShadowedPrefix,
    SynonymousPrefix,
    UndeclaredPrefix,
    UnusedPrefix,
)
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.source.scanner.start_tag import AttributePlace, StartTag

XML_NAMESPACE = "http://www.w3.org/XML/1998/namespace"
XMLNS_NAMESPACE = "http://www.w3.org/2000/xmlns/"

_COLON = re.compile(r":[\w.\-:]*([\s=/>])?")
_NAME_BEFORE = re.compile(r"[<\s/][\w.\-]*\Z")


Problem = (
    UndeclaredPrefix
    | RedeclaredPrefix
    | DefaultNamespace
    | DeclaredBelowRoot
    | UnusedPrefix
    | MalformedQualifiedName
    | ShadowedPrefix
    | SynonymousPrefix
    | EmptyNamespaceName
    | ReservedPrefix
)


class _Declaration:
    """A declaration in effect: its attribute, its scope's end, and whether anything used it."""

    __slots__ = ("end", "namespace", "number", "place", "prefix", "span", "used")

    def __init__(
        self, prefix: str, namespace: str, place: AttributePlace, span: Span, number: int, end: int
    ) -> None:
        self.prefix = prefix
        self.namespace = namespace
        self.place = place
        self.span = span
        self.number = number
        self.end = end
        self.used = False


def problems(document: Document) -> list[Problem]:
    """Everything about prefixes that is wrong in a document, in no particular order."""
    if document.root is None or not document.is_recognized:
        return []
    used = _plain_uses(document)
    if used is None:
        return _Analysis(document).run() if _has_prefixes(document.source.text) else []
    return _Analysis(document).of_root(used) if len(used) < len(document.root.nsmap) else []


def _plain_uses(document: Document) -> set[str] | None:
    """The namespaces in use, where that is all there is to know: prefixes are declared on the root only, and unlike.

    None, to be safe, for everything else.
    """
    root = document.root
    if root is None or not document.is_wellformed or document.source.text.count("xmlns") != len(root.nsmap):
        return None
    spaces = {space for space in root.nsmap.values() if space.strip()}
    if len(spaces) < len(root.nsmap) or any(p is None or _is_reserved(p, n) for p, n in root.nsmap.items()):
        return None
    return {space for prefix, space in root.nsmap.items() if _is_used(root, f"{prefix}:", space)}


def _is_used(root: Element, head: str, space: str) -> bool:
    if head not in root.document.source.text:
        return False
    if next(root.iter(f"{{{space}}}*"), None) is not None:
        return True
    return bool(root.xpath("boolean(//@*[namespace-uri() = $space])", space=space))


def _has_prefixes(text: str) -> bool:
    """A quick look, wrong only to the safe side: is there a colon in what may be a name?"""
    if "xmlns" in text:
        return True
    ends = (match.start() for match in _COLON.finditer(text) if match[1])
    return any(_NAME_BEFORE.search(text, max(0, end - 80), end) for end in ends)


class _Analysis:
    """One pass over the start tags, in document order, with the declarations in scope."""

    def __init__(self, document: Document) -> None:
        # Only texts with prefixes pay for it.
        from sdfcheck.source.scanner.parse_tag import parse_start_tag

        self.parse = parse_start_tag
        self.document = document
        self.source = document.source
        self.scan = document.scan
        self.found: list[Problem] = []
        self.scope: list[_Declaration] = []
        self.declarations: list[_Declaration] = []
        self.unresolved: dict[str, list[Span]] = {}
        self.plugin_end = 0

    def run(self) -> list[Problem]:
        text, scan = self.source.text, self.scan
        for number, start in enumerate(scan.starts):
            end = scan.ends[number]
            while self.scope and self.scope[-1].end <= start:
                self.scope.pop()
            if text.startswith("<plugin", start):
                self.plugin_end = max(self.plugin_end, scan.close_ends[number])
            if text.find(":", start, end) >= 0 or text.find("xmlns", start, end) >= 0:
                self.take(number)
        self.conclude()
        return self.found

    def of_root(self, used: set[str]) -> list[Problem]:
        """The same where the root declares all prefixes, and these namespaces are used."""
        self.take(0)
        for declaration in self.declarations:
            declaration.used = declaration.namespace in used
        self.conclude()
        return self.found

    def take(self, number: int) -> None:
        tag = self.scan.odd.get(number) or self.parse(self.source, self.scan.starts[number])[0]
        own: dict[str, _Declaration] = {}
        for attribute in tag.attributes:
            head, colon, prefix = attribute.name.partition(":")
            if head == "xmlns":
                self.declare(number, tag, attribute, prefix if colon else None, own)
        self.use(tag.name, tag.name_start, tag.name_end)
        for attribute in tag.attributes:
            if ":" in attribute.name and not attribute.name.startswith("xmlns:"):
                self.use(attribute.name, attribute.name_start, attribute.name_end)

    def declare(
        self,
        number: int,
        tag: StartTag,
        attribute: AttributePlace,
        prefix: str | None,
        own: dict[str, _Declaration],
    ) -> None:
        span = self.source.span(attribute.name_start, attribute.name_end)
        namespace = self.source.text[attribute.value_start : attribute.value_end]
        if prefix is None:
            if self.document.kind is Kind.SDF:  # others take no notice
                self.found.append(DefaultNamespace(span, self.whole(attribute), namespace))
            return
        if not prefix or ":" in prefix:
            self.found.append(MalformedQualifiedName(span, attribute.name))
            return
        if prefix in own:
            self.found.append(RedeclaredPrefix(span, own[prefix].span, prefix))
            return
        # What is declared on the root of a well-formed text holds to the end.
        whole = number == 0 and self.document.is_wellformed
        end = len(self.source.text) if whole else self.scan.close_ends[number]
        declaration = _Declaration(prefix, namespace, attribute, span, number, end)
        declaration.used = True  # what is wrong need not be superfluous as well
        if _is_reserved(prefix, namespace):
            self.found.append(ReservedPrefix(span, prefix))
        elif not namespace.strip():
            self.found.append(EmptyNamespaceName(span, prefix))
        else:
            declaration.used = False
            self.compare(declaration)
        own[prefix] = declaration
        self.scope.append(declaration)
        self.declarations.append(declaration)

    def compare(self, new: _Declaration) -> None:
        """Set a declaration against those whose scope it is in."""
        for other in reversed(self.scope):
            if other.prefix == new.prefix:
                if other.namespace != new.namespace:
                    self.found.append(ShadowedPrefix(new.span, new.prefix, other.span))
                return
        for other in self.scope:
            if other.namespace == new.namespace and new.namespace.strip():
                self.found.append(SynonymousPrefix(new.span, new.prefix, other.span, other.prefix))
                return

    def use(self, name: str, start: int, end: int) -> None:
        if ":" not in name:
            return
        prefix, _, local = name.partition(":")
        if not prefix or not local or ":" in local:
            # gz-sim reads settings such as <gz::system_priority> in its plugins by just that name.
            if start >= self.plugin_end:
                self.found.append(MalformedQualifiedName(self.source.span(start, end), name))
            self.mark_used(prefix)
            return
        place = self.source.span(start, start + len(prefix))
        if prefix == "xmlns":
            self.found.append(ReservedPrefix(place, prefix))
        elif not self.mark_used(prefix) and prefix != "xml":
            self.unresolved.setdefault(prefix, []).append(place)

    def mark_used(self, prefix: str) -> bool:
        for declaration in reversed(self.scope):
            if declaration.prefix == prefix:
                declaration.used = True
                return True
        return False

    def conclude(self) -> None:
        root = self.root_insertion()
        for prefix, uses in self.unresolved.items():
            if prefix == "xacro" and self.document.kind is Kind.XACRO:
                continue  # xacro itself stops there, which is another matter
            other = next((d for d in self.declarations if d.prefix == prefix), None)
            end = self.scope_end(other) if other else None
            namespace = other.namespace if other else ""
            elsewhere = other.span if other else None
            self.found.append(UndeclaredPrefix(uses[0], prefix, tuple(uses), elsewhere, end, namespace, root))
        by_prefix: dict[str, list[_Declaration]] = {}
        for declaration in self.declarations:
            by_prefix.setdefault(declaration.prefix, []).append(declaration)
        for prefix, declarations in by_prefix.items():
            # A declaration that does not reach the uses is reported above: that is one mistake.
            if prefix not in self.unresolved:
                self.weigh(prefix, declarations, root)
        # The files that an xacro file includes may use what it declares.
        if self.document.kind is not Kind.XACRO:
            self.look_for_unused()

    def look_for_unused(self) -> None:
        by_element: dict[int, list[_Declaration]] = {}
        for declaration in self.declarations:
            if not declaration.used and declaration.prefix not in self.unresolved:
                by_element.setdefault(declaration.number, []).append(declaration)
        for unused in by_element.values():
            wholes = tuple(self.whole(declaration.place) for declaration in unused)
            prefixes = tuple(declaration.prefix for declaration in unused)
            self.found.append(UnusedPrefix(unused[0].span, prefixes, wholes))

    def weigh(self, prefix: str, declarations: list[_Declaration], root: Span) -> None:
        """Say what is better moved of the declarations of one prefix."""
        below = [declaration for declaration in declarations if declaration.used and declaration.number > 0]
        if len({declaration.namespace for declaration in declarations}) > 1:
            self.found += (DeclaredBelowRoot(d.span, prefix, (), "", root) for d in below)
        elif below:
            wholes = tuple(self.whole(declaration.place) for declaration in below)
            on_root = declarations[0].number == 0
            text = "" if on_root else wholes[0].text.strip()
            self.found.append(DeclaredBelowRoot(below[0].span, prefix, wholes, text, root))

    def scope_end(self, declaration: _Declaration) -> Span:
        place = self.scan.place(declaration.number)
        return self.source.span(place.close, place.close_end)

    def root_insertion(self) -> Span:
        tag = self.scan.odd.get(0) or self.parse(self.source, self.scan.starts[0])[0]
        at = tag.name_end
        if tag.attributes:
            at = tag.attributes[-1].value_end
            at += self.source.text[at : at + 1] in {'"', "'"}
        return self.source.span(at, at)

    def whole(self, attribute: AttributePlace) -> Span:
        """The attribute with the blanks before it: what deleting it takes."""
        text, start, end = self.source.text, attribute.name_start, attribute.value_end
        while text[start - 1].isspace():
            start -= 1
        return self.source.span(start, end + (text[end : end + 1] in {'"', "'"}))


def _is_reserved(prefix: str, namespace: str) -> bool:
    if prefix == "xml":
        return namespace != XML_NAMESPACE
    return prefix == "xmlns" or namespace in {XML_NAMESPACE, XMLNS_NAMESPACE}
