"""Prefixes: where they are declared, and where they are used.

Read from the text, as libsdformat and Drake read it; scope is that of "Namespaces in XML 1.0",
which the custom-elements proposal of SDFormat 1.7 asks users to comply with.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from sdfcheck.source.document import Document
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.source.scanner.start_tag import AttributePlace, StartTag

_RESERVED = frozenset(("xml", "xmlns"))
_RESERVED_NAMES = frozenset(("http://www.w3.org/XML/1998/namespace", "http://www.w3.org/2000/xmlns/"))


class PrefixDeclaration:
    """An attribute that declares a prefix, ``xmlns:p="…"``, or a default namespace, ``xmlns="…"``."""

    def __init__(self, namespaces: Namespaces, name: str, namespace: str, number: int = 0) -> None:
        self.document = namespaces.document
        self.name = name
        self.prefix = name.partition(":")[2]
        """The name after ``xmlns:``; empty for a default namespace."""
        self.namespace = namespace
        self.is_on_root = number == 0
        self.is_used = False
        """Does a name use the prefix, in or out of the scope?"""
        self.beside: list[PrefixDeclaration] = []
        """All declarations of its element, itself among them."""
        self.first: PrefixDeclaration | None = None
        """The one that declares the same prefix before it on the same element."""
        self.outer: PrefixDeclaration | None = None
        """The one of the same prefix in whose scope it is."""
        self.twin: PrefixDeclaration | None = None
        """One of another prefix and the same namespace in whose scope it is."""
        self._namespaces = namespaces
        self._number = number

    @property
    def is_qualified(self) -> bool:
        """Is its name a prefix, one colon and a local part?"""
        return _is_qualified(self.name)

    @property
    def is_repeated(self) -> bool:
        """Does its element declare the prefix once more?"""
        return any(other.first is self for other in self.beside)

    def use(self) -> None:
        """Note that a name uses it; those around it that say the same could take its place."""
        same: PrefixDeclaration | None = self
        while same is not None and same.namespace == self.namespace:
            same.is_used, same = True, same.outer

    @property
    def span(self) -> Span:
        """The place of its name."""
        return self.document.source.span(self._place.name_start, self._place.name_end)

    @property
    def whole(self) -> Span:
        """The attribute with the spaces before it: what deleting it takes."""
        source = self.document.source
        text, start, end = source.text, self._place.name_start, self._place.value_end
        while text[start - 1].isspace():
            start -= 1
        return source.span(start, end + (text[end : end + 1] in {'"', "'"}))

    @property
    def scope_end(self) -> Span:
        """The end tag of its element."""
        place = self.document.scan.place(self._number)
        return self.document.source.span(place.close, place.close_end)

    @property
    def _place(self) -> AttributePlace:
        """The attribute, the first or a further one of its name."""
        places = [a for a in self._namespaces.tag(self._number).attributes if a.name == self.name]
        return places[[other for other in self.beside if other.name == self.name].index(self)]


class PrefixedName:
    """A name with a colon, of an element or attribute."""

    def __init__(self, name: str, span: Span, *, is_in_plugin: bool) -> None:
        self.name = name
        self.prefix, _, self.local = name.partition(":")
        self.span = span
        self.is_in_plugin = is_in_plugin
        self.namespace: str | None = None
        """The URI of its prefix; None where it is not bound."""
        self.first: PrefixedName | None = None
        """The attribute before it in the same tag that has the same namespace and local part, by another prefix."""

    @property
    def is_qualified(self) -> bool:
        """Is its name a prefix, one colon and a local part?"""
        return _is_qualified(self.name)

    @property
    def prefix_span(self) -> Span:
        return self.span.source.span(self.span.start, self.span.start + len(self.prefix))


class Prefix:
    """A prefix of a file: its declarations that are in effect, and the names that use it."""

    def __init__(self, name: str, namespaces: Namespaces) -> None:
        self.name = name
        self.document = namespaces.document
        self.declarations: list[PrefixDeclaration] = []
        self.undeclared: list[Span] = []
        """Where it is used out of the scope of any declaration."""
        self._namespaces = namespaces

    @property
    def insertion(self) -> Span:
        """Where a declaration goes: after the last attribute of the root's start tag."""
        return self._namespaces.insertion


class Namespaces:
    """The prefixes of a document, their declarations, and the names with a colon.

    Where all prefixes are declared on the root, and all different, the names are left out:
    nothing is wrong with them.
    """

    def __init__(self, document: Document) -> None:
        self.document = document
        self.declarations: list[PrefixDeclaration] = []
        self.names: list[PrefixedName] = []
        self.prefixes: dict[str, Prefix] = {}
        self._scope: list[PrefixDeclaration] = []
        self._ends: list[int] = []
        if document.root is None or not document.is_recognized or document.is_expanded:
            return
        if _is_plain(document):
            self._take_root(document.root.declared, document.names)
        else:
            self._read()
        for prefix in self.prefixes.values():
            for declaration in prefix.declarations if prefix.undeclared else ():
                declaration.is_used = True

    @property
    def insertion(self) -> Span:
        """Where a declaration goes: after the last attribute of the root's start tag."""
        tag = self.tag(0)
        text, at = self.document.source.text, tag.name_end
        if tag.attributes:
            at = tag.attributes[-1].value_end
            at += text[at : at + 1] in {'"', "'"}
        return self.document.source.span(at, at)

    def _read(self) -> None:
        """Go over the start tags in document order, with the declarations in scope."""
        text, scan = self.document.source.text, self.document.scan
        plugin_end = 0
        for number, start in enumerate(scan.starts):
            end = scan.ends[number]
            while self._ends and self._ends[-1] <= start:
                self._scope.pop()
                self._ends.pop()
            if text.startswith("<plugin", start):
                plugin_end = max(plugin_end, scan.close_ends[number])
            if text.find(":", start, end) >= 0 or text.find("xmlns", start, end) >= 0:
                tag = self.tag(number)
                self._declare(number, tag)
                self._use(tag.name, tag.name_start, plugin_end)
                self._use_attributes(tag, plugin_end)

    def _take_root(self, declared: Mapping[str, str], names: Iterable[str]) -> None:
        """The declarations of a root that declares all prefixes, those of the names of the document."""
        used = {name.partition(":")[0] for name in names if ":" in name}
        for prefix, space in declared.items():
            new = PrefixDeclaration(self, f"xmlns:{prefix}", space)
            new.is_used = prefix in used
            new.beside = self.declarations
            self.declarations.append(new)
            self._prefix(prefix).declarations.append(new)

    def tag(self, number: int) -> StartTag:
        """The start tag of an element by its number."""
        # Only texts with prefixes pay for it.
        from sdfcheck.source.scanner.scan import parse_start_tag

        scan = self.document.scan
        return scan.odd.get(number) or parse_start_tag(self.document.source, scan.starts[number])[0]

    def _prefix(self, name: str) -> Prefix:
        return self.prefixes.setdefault(name, Prefix(name, self))

    def _declare(self, number: int, tag: StartTag) -> None:
        own: list[PrefixDeclaration] = []
        firsts: dict[str, PrefixDeclaration] = {}
        for place in tag.attributes:
            if place.name.partition(":")[0] != "xmlns":
                continue
            namespace = self.document.source.text[place.value_start : place.value_end]
            new = PrefixDeclaration(self, place.name, namespace, number)
            own.append(new)
            new.beside = own
            if not _is_qualified(new.name):
                continue
            if new.prefix in firsts:
                new.first = firsts[new.prefix]
                continue
            firsts[new.prefix] = new
            self._compare(new)
            self._scope.append(new)
            self._ends.append(self._end(number))
            self._prefix(new.prefix).declarations.append(new)
        self.declarations += own

    def _end(self, number: int) -> int:
        """Where the scope of an element's declarations ends."""
        # A declaration on the root of a well-formed text holds to the end.
        is_whole = number == 0 and self.document.is_wellformed
        return len(self.document.source.text) if is_whole else self.document.scan.close_ends[number]

    def _compare(self, new: PrefixDeclaration) -> None:
        """Find what a declaration has to do with those whose scope it is in."""
        new.outer = next((other for other in reversed(self._scope) if other.prefix == new.prefix), None)
        if new.outer is None:
            new.twin = next((other for other in self._scope if other.namespace == new.namespace), None)

    def _use_attributes(self, tag: StartTag, plugin_end: int) -> None:
        firsts: dict[tuple[str, str], PrefixedName] = {}
        for attribute in tag.attributes:
            if ":" not in attribute.name or attribute.name.startswith("xmlns:"):
                continue
            used = self._use(attribute.name, attribute.name_start, plugin_end)
            if used is not None and used.namespace is not None:
                first = firsts.setdefault((used.namespace, used.local), used)
                used.first = first if first.prefix != used.prefix else None

    def _use(self, name: str, start: int, plugin_end: int) -> PrefixedName | None:
        if ":" not in name:
            return None
        used = PrefixedName(
            name, self.document.source.span(start, start + len(name)), is_in_plugin=start < plugin_end
        )
        self.names.append(used)
        for declaration in reversed(self._scope):
            if declaration.prefix == used.prefix:
                declaration.use()
                used.namespace = declaration.namespace
                return used
        if _is_qualified(name) and used.prefix not in _RESERVED:
            self._prefix(used.prefix).undeclared.append(used.prefix_span)
        return used


def declarations(document: Document) -> list[PrefixDeclaration]:
    """The declarations of prefixes in a text, in its order."""
    return document.view(Namespaces).declarations


def names(document: Document) -> list[PrefixedName]:
    """The names with a colon in a text, in its order; none where nothing can be wrong with them."""
    return document.view(Namespaces).names


def prefixes(document: Document) -> list[Prefix]:
    """The prefixes that a text declares or uses."""
    return list(document.view(Namespaces).prefixes.values())


def _is_qualified(name: str) -> bool:
    """Is a name a prefix, one colon and a local part?"""
    prefix, _, local = name.partition(":")
    return bool(prefix and local) and ":" not in local and (local[0].isalpha() or local[0] == "_")


def _is_plain(document: Document) -> bool:
    """Are all prefixes declared on the root, and unlike? Then there is nothing to know but which are used."""
    root = document.root
    if root is None or not document.is_wellformed or document.declared.keys() - {root}:
        return False
    if "<xmlns:" in document.source.text:
        return False
    declared = root.declared
    spaces = {space for space in declared.values() if space.strip()}
    if len(spaces) < len(declared) or "" in declared:
        return False
    if not _RESERVED.isdisjoint(declared) or not _RESERVED_NAMES.isdisjoint(spaces):
        return False
    names = [name for name in document.names if ":" in name]
    return all(
        _is_qualified(name) and name.partition(":")[0] in _RESERVED | declared.keys() for name in names
    )
