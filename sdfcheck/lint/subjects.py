"""The subjects of rules in a document: objects of the robot that it describes, and its elements."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.source.document import Document, Element
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.robot.part import Part

OF_TEXT: dict[str, tuple[Kind | None, str]] = {
    "ModelConfig": (Kind.MODEL_CONFIG, "sdfcheck.robot.includes.model_config:model_configs"),
    "Prefix": (None, "sdfcheck.formats.namespaces:prefixes"),
    "PrefixDeclaration": (None, "sdfcheck.formats.namespaces:declarations"),
    "PrefixedName": (None, "sdfcheck.formats.namespaces:names"),
    "Semantics": (Kind.SRDF, "sdfcheck.robot.semantics:semantics_in"),
}
"""Class → the kind of documents that have its objects (None: all), and what finds them."""

OF_VENDORS = {
    "VendorTag": "sdfcheck.robot.vendor:tags",
    "VendorValue": "sdfcheck.robot.vendor:values",
}
"""Class → what finds its objects in a document, given the tables of the vendors."""

_OF_ROBOTS = frozenset((Kind.SDF, Kind.URDF))


class Subjects:
    """The objects of the named classes: all of them, or with selectors those that the selected elements make.

    Where :class:`Element` is named, or no class is, the selected elements themselves. None in a document
    without any of the texts in ``needs``. Made once for a run.
    """

    __slots__ = (
        "_elsewhere",
        "_is_narrowed",
        "_marks",
        "_parts",
        "_selectors",
        "_texts",
        "looks_at",
        "selects",
    )

    def __init__(self, looks_at: Sequence[str], selects: Sequence[str], needs: Sequence[str]) -> None:
        self.looks_at, self.selects = looks_at, selects
        classes = [name for name in looks_at if name != Element.__name__]
        self._is_narrowed = bool(selects) and len(classes) == len(looks_at) > 0
        self._parts = [name for name in classes if name not in OF_TEXT and name not in OF_VENDORS]
        self._elsewhere = [name for name in classes if name in OF_TEXT or name in OF_VENDORS]
        self._selectors: dict[str, list[tuple[str, tuple[str, ...]]]] = {}
        """Dialect → names of elements, each with those of the elements around it, from the inside out."""
        for selector in selects:
            dialect, _, path = selector.partition(":")
            *around, name = path.split("/")
            self._selectors.setdefault(dialect, []).append((name, tuple(reversed(around))))
        elements = [need for need in needs if need.startswith("<") and need[1:].isidentifier()]
        self._marks = [need[1:] for need in elements]
        """Names of elements, one of which a document has to have; or one of the texts."""
        self._texts = [need for need in needs if need not in elements]

    def occur_in(self, kind: Kind) -> bool:
        """Can documents of a kind have any?"""
        if kind.value in self._selectors:
            return True
        if self._is_narrowed:
            return False
        kinds = [OF_TEXT[name][0] if name in OF_TEXT else None for name in self._elsewhere]
        return bool(self._parts and kind in _OF_ROBOTS) or None in kinds or kind in kinds

    def names_in(self, kind: Kind) -> frozenset[str] | None:
        """Names of elements, one of which a document of a kind has to have; None where they do not decide."""
        names = {name for name, _ in self._selectors.get(kind.value, ())}
        if self._elsewhere:
            return None
        if self._parts and not self._is_narrowed:
            from sdfcheck.robot.root import ELEMENTS

            for name in self._parts:
                if name not in ELEMENTS:
                    return None
                names.update(ELEMENTS[name])
        return frozenset(names)

    def of(self, document: Document, tables: Sequence[Path] = ()) -> list[object]:
        """Those of a document; ``tables`` are those of the vendors whose prefix it seems to use."""
        if document.root is None or not self._are_needed(document):
            return []
        selected: list[Element] = []
        for name, around in self._selectors.get(document.kind.value, ()):
            selected += _in(document.view(_elements).get(name, ()), around)
        if self._is_narrowed and not selected and not self._elsewhere:
            return []
        found = self._found_elsewhere(document, tables) if self._elsewhere else []
        if self._parts and document.kind in _OF_ROBOTS and (selected or not self._is_narrowed):
            from sdfcheck.robot.root import root_of

            root = root_of(document)
            for name in self._parts:
                found += root.made_of(selected, name) if self._is_narrowed else root.each(name)
        return found if self._is_narrowed else [*found, *selected]

    def _are_needed(self, document: Document) -> bool:
        """Has a document one of the names or texts without which there is nothing to look at?"""
        if not self._marks and not self._texts:
            return True
        return not document.names.isdisjoint(self._marks) or any(map(document.source.contains, self._texts))

    def among(self, parts: Sequence[Part], elements: Sequence[Element]) -> list[object]:
        """Those among some parts and elements of a robot in URDF."""
        found: list[object] = [part for part in parts if type(part).__name__ in self.looks_at]
        if Element.__name__ in self.looks_at:
            for name, around in self._selectors.get(Kind.URDF.value, ()):
                found += _in((each for each in elements if each.name == name), around)
        return found

    def _found_elsewhere(self, document: Document, tables: Sequence[Path]) -> list[object]:
        found: list[object] = []
        for name in self._elsewhere:
            if name in OF_TEXT:
                kind, finder = OF_TEXT[name]
                found += _finder(finder)(document) if kind in (None, document.kind) else ()
            elif tables:
                found += _finder(OF_VENDORS[name])(document, tables)
        return found


@cache
def _finder(path: str) -> Callable[..., Iterable[object]]:
    module, _, function = path.partition(":")
    found: Callable[..., Iterable[object]] = getattr(import_module(module), function)
    return found


def is_extension(subject: object, document: Document) -> bool:
    """Is an object, element or problem of a URDF file in one of its ``<gazebo>`` blocks?"""
    if document.kind is not Kind.URDF or not document.source.contains("<gazebo"):
        return False
    known: bool | None = getattr(subject, "is_extension", None)
    if known is not None:
        return known
    at = subject
    if not isinstance(at, Element):
        at = getattr(subject, "value", None) or getattr(subject, "lower", None) or subject
        at = getattr(at, "element", at)
    if not isinstance(at, Element):
        return False
    return any(around.name == "gazebo" for around in at.around)


def _elements(document: Document) -> Mapping[str, Sequence[Element]]:
    """Name → elements; in SDF and URDF those that are where the format places them."""
    if document.kind is Kind.SDF:
        from sdfcheck.formats.sdf.survey import survey

        return survey(document).index
    if document.kind is Kind.URDF:
        from sdfcheck.formats.urdf import survey as urdf_survey

        return urdf_survey.survey(document).index
    found: dict[str, list[Element]] = {}
    for element in document.elements:
        found.setdefault(element.name, []).append(element)
    return found


def _in(elements: Iterable[Element], around: Sequence[str]) -> Iterable[Element]:
    """Those of some elements that are in elements of these names, from the inside out."""
    return (element for element in elements if _is_in(element, around)) if around else elements


def _is_in(element: Element, parents: Sequence[str]) -> bool:
    """Do the names of the enclosing elements, from the inside out, begin with ``parents``?"""
    for name in parents:
        parent = element.parent
        if parent is None or parent.name != name:
            return False
        element = parent
    return True
