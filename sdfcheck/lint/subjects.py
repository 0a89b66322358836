"""The subjects of rules in a document: objects of the robot that it describes, and its elements."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache
from importlib import import_module
from pathlib import Path

from lxml import etree

from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.sniff import Kind

OF_TEXT: dict[str, tuple[Kind | None, str]] = {
    "ModelConfig": (Kind.MODEL_CONFIG, "sdfcheck.robot.includes.model_config:model_configs"),
    "Prefix": (None, "sdfcheck.formats.namespaces:prefixes"),
    "PrefixDeclaration": (None, "sdfcheck.formats.namespaces:declarations"),
    "PrefixedName": (None, "sdfcheck.formats.namespaces:names"),
    "Semantics": (Kind.SRDF, "sdfcheck.robot.semantics.find:semantics_in"),
}
"""Class → the kind of documents that have its objects (None: all), and what finds them."""

OF_VENDORS = {
    "VendorTag": "sdfcheck.robot.vendor.tags:tags",
    "VendorValue": "sdfcheck.robot.vendor.tags:values",
}
"""Class → what finds its objects in a document, given the tables of the vendors."""


def subjects(
    document: Document, looks_at: Sequence[str], selects: Sequence[str], tables: Sequence[Path] = ()
) -> list[object]:
    """The objects of the named classes: all of them, or with selectors those that the selected elements make.

    Where :class:`Element` is named, or no class is, the selected elements themselves. ``tables`` are those of
    the vendors whose prefix the document seems to use.
    """
    found: list[object] = []
    if document.root is None:
        return found
    selected = [element for selector in selects for element in _selected(document, selector)]
    classes = [name for name in looks_at if name != Element.__name__]
    is_narrowed = bool(selects) and len(classes) == len(looks_at) > 0
    parts = [name for name in classes if name not in OF_TEXT and name not in OF_VENDORS]
    if len(parts) < len(classes):
        for name in classes:
            if name in OF_TEXT:
                kind, finder = OF_TEXT[name]
                found += _finder(finder)(document) if kind in (None, document.kind) else ()
            elif name in OF_VENDORS and tables:
                found += _finder(OF_VENDORS[name])(document, tables)
    if parts and document.kind in (Kind.SDF, Kind.URDF) and (selected or not is_narrowed):
        from sdfcheck.robot.root import root_of

        root = root_of(document)
        for name in parts:
            found += root.made_of(selected, name) if is_narrowed else root.each(name)
    return found if is_narrowed else [*found, *selected]


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
    at = getattr(subject, "value", None) or getattr(subject, "lower", None) or subject
    at = getattr(at, "element", at)
    if not isinstance(at, Element):
        return False
    return any(around.tag == "gazebo" for around in at.iterancestors())


def _selected(document: Document, selector: str) -> Iterator[Element]:
    """The elements of a selector: ``sdf:axis/limit`` is each ``limit`` in an ``axis``."""
    dialect, _, path = selector.partition(":")
    if dialect != document.kind.value:
        return
    *parents, name = path.split("/")
    parents.reverse()
    for element in document.view(_elements).get(name, ()):
        if _is_in(element, parents):
            yield element


def _elements(document: Document) -> Mapping[str, Sequence[Element]]:
    """Name → elements; in SDF and URDF those that are where the format places them."""
    if document.kind is Kind.SDF:
        from sdfcheck.formats.sdf.survey import survey

        return survey(document).index
    if document.kind is Kind.URDF:
        from sdfcheck.formats.urdf import survey as urdf_survey

        return urdf_survey.survey(document).index
    found: dict[str, list[Element]] = {}
    assert document.root is not None
    for node in document.root.iter(etree.Element):
        if isinstance(node, Element):
            found.setdefault(node.name, []).append(node)
    return found


def _is_in(element: Element, parents: Sequence[str]) -> bool:
    """Do the names of the enclosing elements, from the inside out, begin with ``parents``?"""
    for name in parents:
        parent = element.parent
        if parent is None or parent.name != name:
            return False
        element = parent
    return True
