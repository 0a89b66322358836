"""The model that an include with parameters brings: a copy that they change, and its elements by id.

The included document itself never changes: another include may bring it as it is. Models that it
includes are copied, too, as soon as a parameter reaches into them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import islice
from typing import TYPE_CHECKING

from sdfcheck.source.altered import Altered
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.robot.includes.included import Included

    Resolve = Callable[[Document, Element], Included]
    Bring = Callable[[Element, Included], None]

_MOST_IDS = 2000
_MOST_VISITS = 20_000
"""So many elements are looked into for one include: models in models can multiply without end."""
_DEEPEST = 20
"""So many models in models are looked into, which ends where a model includes itself."""
_OVERRIDDEN = ("pose", "static")
"""The children of an include that are stronger than those of the model."""


class Place(NamedTuple):
    """An element of the model; ``include`` is the place of the innermost include that brought it.

    None where no include did but the one that has the parameters.
    """

    element: Element
    include: Place | None = None


class Alterations:
    """The copy of what one include brings; ``model`` is None where there is nothing to be had.

    ``included`` resolves an include of a document, ``bring`` changes what one brings.
    """

    __slots__ = ("_bring", "_brought", "_effort", "_included", "_own", "complete", "model")

    def __init__(self, found: Included, included: Resolve, bring: Bring) -> None:
        self._included, self._bring = included, bring
        self.model: Element | None = None
        self.complete = found.model is not None and found.model.name != "robot"
        """False where not all of the model is known: a URDF is converted, an include may be missing."""
        self._own: set[Altered] = set()
        self._brought: dict[Element, Element] = {}
        """Copied model → the include in this copy that brings it."""
        self._effort = _MOST_VISITS
        if found.model is not None:
            self.model = self._copy(found.model)

    # Elements by id

    @property
    def top(self) -> Place | None:
        """The place of the model itself."""
        return None if self.model is None else Place(self.model)

    def children(self, place: Place, depth: int = 0) -> Iterator[tuple[str, str, Place]]:
        """Kind, name and place of what an element holds, included models as well."""
        element, around = place
        self._effort -= 1
        if self._effort < 0:
            self.complete = False
            return
        for child in element.children():
            if name := child.attributes.get("name"):
                yield child.name, name, Place(child, around)
        for include in element.children("include"):
            found, at = self._included(element.document, include), Place(include, around)
            if found.model is None:
                self.complete = False
            elif found.merge:
                if depth < _DEEPEST:
                    yield from self.children(Place(found.model, at), depth + 1)
            elif found.name is not None:
                yield found.kind or "model", found.name, Place(found.model, at)

    def find(self, element_id: str, kind: str | None, start: Place | None = None) -> Place | None:
        """The element that an ``element_id`` names; the longest name that fits its beginning goes first."""
        start = start or self.top
        if start is None or element_id.count("::") > _DEEPEST:
            return None
        fitting = [
            (found, name, place)
            for found, name, place in self.children(start)
            if element_id == name or element_id.startswith(f"{name}::")
        ]
        fitting.sort(key=lambda entry: -len(entry[1]))
        for found, name, place in fitting:
            if element_id != name:
                deeper = self.find(element_id[len(name) + 2 :], kind, place)
                if deeper is not None:
                    return deeper
            elif kind is None or found == kind:
                return place
        return None

    def ids(self, kind: str | None) -> list[str]:
        """Every ``element_id`` that names an element, or one of a kind; not all of very many."""
        return list(islice(self._ids(kind, self.top), _MOST_IDS))

    def _ids(self, kind: str | None, place: Place | None, depth: int = 0) -> Iterator[str]:
        for found, name, child in self.children(place) if place is not None else ():
            if kind is None or found == kind:
                yield name
            if depth < _DEEPEST:
                yield from (f"{name}::{deeper}" for deeper in self._ids(kind, child, depth + 1))

    # Changes

    def own(self, place: Place) -> Element:
        """The element that may be changed: in the copy, or in one of what the copy includes."""
        if place.include is None:
            return place.element
        include = self.own(place.include)
        found = self._included(include.document, include)
        assert found.model is not None
        if found.model.document not in self._own:
            model = self._copy(found.model)
            self._brought[model] = include
            if not found.merge:
                _take_over(include, model, found.name or "")
            found = found._replace(model=model)
            self._bring(include, found)
        document = changeable(found.model)  # type: ignore[arg-type]
        return document.copies.get(place.element, place.element)

    def outermost(self, place: Place) -> Element:
        """The element that holds it: the include of a model that one brings, else the element itself."""
        around = place.include
        if around is not None:
            found = self._included(around.element.document, around.element)
            if found.model is place.element:
                return self.own(around)
        return self.own(place)

    def rename(self, element: Element, name: str) -> None:
        """Rename an element of the copy."""
        element.attributes["name"] = name
        include = self._brought.get(element)
        if include is not None:
            self._bring(include, self._included(include.document, include)._replace(name=name.strip()))

    def finish(self) -> None:
        """Number the elements of the copies, after the last change."""
        for document in self._own:
            document.number()

    def _copy(self, model: Element) -> Element:
        document = Altered(model.document)
        self._own.add(document)
        return document.copies[model]


def changeable(element: Element) -> Altered:
    """The document of an element of a copy."""
    assert isinstance(element.document, Altered)
    return element.document


def _take_over(include: Element, model: Element, name: str) -> None:
    """Write into a copied model what its include says of it: from now on it is the model's own."""
    model.attributes["name"] = name
    outside, inside = changeable(include), changeable(model)
    for kind in _OVERRIDDEN:
        given, own = include.find(kind), model.find(kind)
        if given is not None:
            if own is not None:
                inside.replace(own, given)
            else:
                inside.add(model, given)
    placement = include.find("placement_frame")
    if placement is not None and placement.content:
        model.attributes["placement_frame"] = placement.content
    for child in list(include.children()):
        if child.name in {"name", "placement_frame", *_OVERRIDDEN}:
            outside.remove(child)
