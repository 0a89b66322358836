"""What rules look at in a document: objects of the robot that it describes, and its elements."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from lxml import etree

from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.sniff import Kind


def subjects(document: Document, looks_at: Sequence[str], selects: Sequence[str]) -> list[object]:
    """The objects of the named classes: all of them, or with selectors those that the selected elements make.

    Where :class:`Element` is named, or no class is, the selected elements themselves.
    """
    found: list[object] = []
    if document.root is None:
        return found
    selected = [element for selector in selects for element in _selected(document, selector)]
    classes = [name for name in looks_at if name != Element.__name__]
    is_narrowed = bool(selects) and len(classes) == len(looks_at) > 0
    if classes and document.kind in (Kind.SDF, Kind.URDF) and (selected or not is_narrowed):
        from sdfcheck.robot.root import root_of

        root = root_of(document)
        for name in classes:
            found += root.made_of(selected, name) if is_narrowed else root.each(name)
    elif document.kind is Kind.MODEL_CONFIG and "ModelConfig" in classes:
        from sdfcheck.robot.includes.model_config import ModelConfig

        found.append(document.view(ModelConfig))
    return found if is_narrowed else [*found, *selected]


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
