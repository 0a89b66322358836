"""Included models: found, read once, and said by what name they go.

Source: libsdformat 17's parser.cc for what an include accepts, gz-sim for the folders
in which it looks.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from enum import Enum
from itertools import islice
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.files.regular import names_in
from sdfcheck.files.uris import locate
from sdfcheck.formats import history
from sdfcheck.formats.findings import text_problems
from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.problems import MisplacedElement, MissingElement, UnknownAttribute
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import SDF, schema
from sdfcheck.formats.sdf.survey import PARAMETERS, defined_alone, examine, notes, survey, version_of
from sdfcheck.formats.version import NEWEST
from sdfcheck.robot.includes.model_config import CONFIG, config_of, model_file
from sdfcheck.robot.naming.name import Name, Namesakes
from sdfcheck.robot.values import is_true
from sdfcheck.source.altered import Altered, Xml, copied
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple, Record
from sdfcheck.source.sniff import Kind

# Includes that multiply.


MOST_MODELS = 10_000
"""So many included models are looked into: includes of includes can multiply without end."""
DEEPEST = 50


INCLUDABLE = ("model", "actor", "light")
"""The parts that an included file may hold, in the order in which libsdformat prefers them."""


class Obstacle(Enum):
    """Why an include brings nothing."""

    NO_URI = "no uri"
    NOT_FOUND = "not found"
    NO_CONFIG = "no model.config"
    BAD_CONFIG = "bad model.config"
    UNREADABLE = "unreadable"
    OUTSIDE = "outside of what is read"
    BROKEN = "broken"
    FOREIGN = "foreign"
    POINTER = "a pointer of Git LFS"
    XACRO = "xacro"
    NO_MODEL = "no model"


class Included(NamedTuple):
    """The parts that one ``include`` brings.

    ``model`` is the included file's model, actor or light (or a URDF's robot), in a
    document of its own, None where there is none to be had, for the reason in
    ``obstacle``; ``kind`` is what it counts as. Where the include has parameters, it is in
    a copy of the file that they have changed; ``faults`` are what is wrong with them.
    ``name`` is the name by which it goes here, None where it is not known.
    """

    include: Element
    uri: Value | None
    name: str | None
    merge: bool
    is_static: bool
    file: Path | None = None
    """The file that is meant, after a folder's ``model.config``."""
    document: Document | None = None
    """The file as it was read, also where it holds no model."""
    config: Document | None = None
    """The ``model.config`` of the folder that the uri leads to."""
    model: Element | None = None
    kind: str | None = None
    obstacle: Obstacle | None = None
    faults: tuple[object, ...] = ()


def included(document: Document, include: Element) -> Included:
    """Resolve one include of a document, once; its parameters are carried out."""
    resolved = document.view(_Resolved)
    if include in resolved:
        return resolved[include]
    read = include.origin if isinstance(include, Xml) else None
    if read is not None and isinstance(document, Altered) and document.copies.get(read) is include:
        found = included(read.document, read)._replace(include=include)
    else:
        found = resolved[include] = _resolve(document, include)  # where it leads back to itself
        found = with_parameters(found)
    resolved[include] = found
    return found


def with_parameters(found: Included) -> Included:
    """The same after the parameters of the include are carried out, in a copy."""
    if not found.include.has(PARAMETERS):
        return found

    changed = Parameters(found, included, bring)
    return found._replace(model=changed.model, faults=tuple(changed.problems))


def bring(include: Element, found: Included) -> None:
    """Let an include of a copied document bring something else than its file."""
    include.document.view(_Resolved)[include] = found


def includes_of(document: Document) -> list[Element]:
    """The includes that libsdformat follows: those in place, and misplaced ones too."""
    surveyed = survey(document)
    misplaced = [
        problem.element
        for problem in surveyed.problems
        if isinstance(problem, MisplacedElement) and problem.element.name == "include"
    ]
    return [*surveyed.index.get("include", ()), *misplaced]


def is_made_static(document: Document) -> bool:
    """Was the document reached by an include that makes its model static?"""
    include = document.included_by[-1].element.parent if document.included_by else None
    static = include.find("static") if include is not None else None
    return static is not None and is_true(static.content)


def included_element(document: Document) -> Element | None:
    """The model, actor or light of a file, or the robot of a URDF."""
    root = document.root
    if root is None:
        return None
    if root.name == "robot":
        return root
    if root.name != "sdf":
        return None
    return next((found for kind in INCLUDABLE if (found := root.find(kind)) is not None), None)


def is_description(document: Document) -> bool:
    """Was a text without any element meant to be a robot description? Others are not shown in findings."""
    return document.kind in {Kind.BROKEN_XML, Kind.EMPTY, Kind.XACRO}


def ring(document: Document, include: Element) -> tuple[Value, ...]:
    """The includes that lead from one in this document back to it, outside in; empty if none do."""
    goal = os.path.realpath(document.path)
    seen: set[Document] = set()
    # Depth first without recursion: a chain of includes may be long.
    stack: list[tuple[Document, Element, tuple[Value, ...]]] = [(document, include, ())]
    while stack:
        holder, element, chain = stack.pop()
        found = included(holder, element)
        if found.document is None or found.uri is None:
            continue
        chain = (*chain, found.uri)
        if os.path.realpath(found.document.path) == goal:
            return chain
        if found.document not in seen and len(chain) < _LONGEST_CHAIN:
            seen.add(found.document)
            stack += [(found.document, deeper, chain) for deeper in reversed(includes_of(found.document))]
    return ()


_LONGEST_CHAIN = 100


class _Resolved(dict[Element, Included]):
    def __init__(self, document: Document) -> None:
        super().__init__()


def _resolve(document: Document, include: Element) -> Included:
    name, static, uri = include.find("name"), include.find("static"), include.find("uri")
    found = Included(
        include,
        uri.own_value if uri is not None and uri.content else None,
        (name.content or None) if name is not None else None,
        is_true(include.attributes.get("merge", "")),
        static is not None and is_true(static.content),
    )
    if found.uri is None:
        return found._replace(obstacle=Obstacle.NO_URI)
    path = locate(document, found.uri.text).path
    if path is None or document.library is None:
        return found._replace(obstacle=Obstacle.NOT_FOUND)
    found = _find_file(document, found, path)
    return found if found.file is None else _read(document, found, found.file)


def _find_file(document: Document, found: Included, path: Path) -> Included:
    """The file itself, or what the folder's ``model.config`` says."""
    if not os.path.isdir(path):
        return found._replace(file=path)
    config = config_of(document, path)
    if config is None:
        if not _is_model(document, path):
            return found._replace(obstacle=Obstacle.NOT_FOUND)
        is_outside = _is_refused(document, path / CONFIG)
        return found._replace(obstacle=Obstacle.OUTSIDE if is_outside else Obstacle.NO_CONFIG)
    _note_origin(document, config, found)
    file = model_file(config)
    return found._replace(config=config, file=file, obstacle=None if file else Obstacle.BAD_CONFIG)


def _is_model(document: Document, folder: Path) -> bool:
    """Is a folder without a ``model.config`` where models are looked for, or does it hold one?"""
    library = library_of(document)
    is_asked_for = library is not None and folder.parent in library.model_folders
    return is_asked_for or any(name.endswith(".sdf") for name in names_in(folder))


def _read(document: Document, found: Included, file: Path) -> Included:
    library = library_of(document)
    assert library is not None
    other = library.document(file, of=document)
    if other is None:
        is_outside = _is_refused(document, file)
        return found._replace(obstacle=Obstacle.OUTSIDE if is_outside else Obstacle.UNREADABLE)
    _note_origin(document, other, found)
    found = found._replace(document=other)
    if other.kind is Kind.LFS_POINTER:
        return found._replace(obstacle=Obstacle.POINTER)
    if other.root is None:
        return found._replace(obstacle=Obstacle.BROKEN if is_description(other) else Obstacle.FOREIGN)
    if other.root.name not in {"sdf", "robot"}:
        return found._replace(obstacle=Obstacle.BROKEN if other.kind is Kind.SDF else Obstacle.FOREIGN)
    if other.root.name == "robot" and other.source.contains("<xacro:"):
        return found._replace(obstacle=Obstacle.XACRO)
    model = included_element(other)
    if model is None:
        return found._replace(obstacle=Obstacle.NO_MODEL)
    kind = "model" if model.name == "robot" else model.name
    own = model.attributes.get("name", "").strip() or None
    return found._replace(model=model, kind=kind, name=found.name or own)


def _is_refused(document: Document, file: Path) -> bool:
    library = library_of(document)
    return library is not None and file in library.refused


def _note_origin(document: Document, other: Document, found: Included) -> None:
    """The include that leads to a file: the first, or the first one that is not in a static model."""
    if found.uri is None or other is document:
        return
    if not other.included_by or (is_made_static(other) and not found.is_static):
        other.included_by = (*document.included_by, found.uri)
        document.is_referred_to = True


# Problems of the parameters of an include.


class ParameterFault(Enum):
    """The ways in which an entry of ``experimental:params`` fails."""

    NO_ID = "no element_id"
    OPEN_END = "element_id ends in ::"
    UNKNOWN_ACTION = "unknown action"
    NO_NAME = "no name"
    EMPTY_NAME = "empty name"
    TAKEN = "taken"
    NOTHING = "names nothing"
    OTHER_KIND = "names another kind"
    NO_PARENT = "no parent"
    UNKNOWN_ENTRY = "unknown element"
    NO_CHILD_ACTION = "child without action"
    ABSENT_CHILD = "absent child"
    UNKNOWN_CHILD = "unknown child"
    UNKNOWN_ATTRIBUTE = "unknown attribute"
    NAME_ASSUMED = "name assumed"
    NO_CHANGE = "no change"


class InvalidParameter(Record):
    """An entry of an include's parameters, or a part of one, that fails or does not do what it
    says.

    ``other`` is the second party: the kind of element that the id names, the element in which a
    child is absent, the name that is assumed.
    """

    place: Element | Value
    fault: ParameterFault
    entry: Element
    other: str = ""
    suggestion: str | None = None


# The model that an include with parameters brings: a copy that they change, and its elements by id.
#
# The included document itself never changes: another include may bring it as it is. Models that it
# includes are copied, too, as soon as a parameter reaches into them.


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

    def __init__(
        self,
        found: Included,
        included: Callable[[Document, Element], Included],
        bring: Callable[[Element, Included], None],
    ) -> None:
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
        document = found.model.document  # type: ignore[union-attr]
        assert isinstance(document, Altered)
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


def changeable(element: Element | None) -> Xml:
    """An element of a copy."""
    assert isinstance(element, Xml)
    return element


def copy_for(holder: Element, element: Element, without: frozenset[str] = frozenset()) -> Xml:
    """A copy of an element, but for some attributes, for the document of another one."""
    made = copied(element, without)
    for part in made.walk():
        part.document = holder.document
    return made


def _take_over(include: Element, model: Element, name: str) -> None:
    """Write into a copied model what its include says of it: from now on it is the model's own."""
    model.attributes["name"] = name
    outside, inside = changeable(include), changeable(model)
    for kind in _OVERRIDDEN:
        given, own = include.find(kind), model.find(kind)
        if given is not None:
            made = copy_for(model, given)
            if own is not None:
                inside.replace(own, made)
            else:
                inside.append(made)
    placement = include.find("placement_frame")
    if placement is not None and placement.content:
        model.attributes["placement_frame"] = placement.content
    for child in list(include.children()):
        if child.name in {"name", "placement_frame", *_OVERRIDDEN}:
            outside.remove(child)


# ``experimental:params``: what the entries of an include do to the model, and what is wrong with them.
#
# An entry names its target by ``element_id`` and says what to do with it, or has children
# that say so each for themselves. One that fails is skipped, the others count. Source:
# libsdformat 17's ParamPassing.cc, checked against what it does.


ACTIONS = ("add", "modify", "remove", "replace")
_OWN_ATTRIBUTES = frozenset({"element_id", "action"})


class Parameters:
    """The parameters of one include, carried out: the model as they change it, and their problems.

    A URDF, which libsdformat converts before it changes it, stays as it is.
    """

    def __init__(
        self,
        found: Included,
        included: Callable[[Document, Element], Included],
        bring: Callable[[Element, Included], None],
    ) -> None:
        self.alterations = Alterations(found, included, bring)
        self.problems: list[object] = []
        for block in found.include.children(PARAMETERS):
            for entry in block.children():
                _Entry(self, entry).run()
        self.alterations.finish()
        is_urdf = found.model is not None and found.model.name == "robot"
        self.model = found.model if is_urdf else self.alterations.model


class _Entry:
    """One entry, while it is carried out."""

    def __init__(self, whole: Parameters, entry: Element) -> None:
        self.alterations = whole.alterations
        self.found = whole.problems
        self.entry = entry

    def run(self) -> None:
        entry = self.entry
        element_id, action = entry.attribute("element_id"), entry.attribute("action")
        if element_id is None:
            self.fault(entry, ParameterFault.NO_ID)
        elif element_id.text.endswith("::"):
            self.fault(element_id, ParameterFault.OPEN_END)
        elif action is not None and action.text not in ACTIONS:
            self.unknown_action(action)
        elif action is not None and action.text == "add":
            self.add(element_id)
        else:
            self.change(element_id, action.text if action is not None else "")

    def fault(
        self, place: Element | Value, fault: ParameterFault, other: str = "", suggestion: str | None = None
    ) -> None:
        self.found.append(InvalidParameter(place, fault, self.entry, other, suggestion))

    def unknown_action(self, action: Value) -> None:
        self.fault(action, ParameterFault.UNKNOWN_ACTION, suggestion=suggest(action.text, ACTIONS))

    # Entries

    def add(self, element_id: Value) -> None:
        entry, model = self.entry, self.alterations
        name = entry.attribute("name")
        if name is None:
            self.fault(entry, ParameterFault.NO_NAME)
            return
        if not name.text:
            self.fault(name, ParameterFault.EMPTY_NAME)
            return
        definition = self.top_level()
        if definition is None:
            return
        self.fits(entry, definition)
        path = f"{element_id.text}::{name.text}" if element_id.text else name.text
        if entry.name != "plugin" and model.find(path, entry.name) is not None:
            self.fault(name, ParameterFault.TAKEN)
            return
        parent = model.find(element_id.text, None) if element_id.text else model.top
        if parent is not None:
            self.put(model.own(parent), entry)
        elif model.complete:
            self.fault(element_id, ParameterFault.NO_PARENT, "", suggest(element_id.text, model.ids(None)))

    def change(self, element_id: Value, action: str) -> None:
        entry, model = self.entry, self.alterations
        definition = self.top_level()
        if definition is None:
            return
        if action == "replace":
            self.fits(entry, definition)
        target = model.find(element_id.text, entry.name)
        if target is None:
            self.not_found(element_id)
        elif action == "replace":
            self.exchange(model.outermost(target), entry)
        elif action == "remove":
            self.remove(entry, target)
        elif action == "modify":
            self.modify(entry, model.own(target))
        else:
            self.each_child(model.own(target), definition)

    def not_found(self, element_id: Value) -> None:
        model, kind = self.alterations, self.entry.name
        other = model.find(element_id.text, None)
        if other is not None and other.element.name != "robot":
            self.fault(element_id, ParameterFault.OTHER_KIND, other.element.name)
        elif model.complete:
            near = suggest(element_id.text, model.ids(kind)) or suggest(element_id.text, model.ids(None))
            self.fault(element_id, ParameterFault.NOTHING, "", near)

    def top_level(self) -> Definition | None:
        """The definition of the entry's element, which has to be one that the format defines by itself."""
        name = self.entry.name
        definition = defined_alone(name)
        if definition is None:
            self.fault(self.entry, ParameterFault.UNKNOWN_ENTRY, suggestion=suggest(name, SDF.table.stems()))
        return definition

    def each_child(self, target: Element, definition: Definition) -> None:
        children = list(self.entry.children())
        if not children:
            self.fault(self.entry, ParameterFault.NO_CHANGE)
        for child in children:
            action = child.attribute("action")
            if action is None:
                self.fault(child, ParameterFault.NO_CHILD_ACTION)
            elif action.text not in ACTIONS:
                self.unknown_action(action)
            else:
                self.change_child(child, action.text, target, definition)

    def change_child(self, child: Element, action: str, target: Element, definition: Definition) -> None:
        if action in {"add", "replace"}:
            place = definition.children.get(child.name)
            if place is None:
                near = suggest(child.name, definition.children)
                self.fault(child, ParameterFault.UNKNOWN_CHILD, self.entry.name, near)
                return
            if not self.fits(child, place) or action == "add":
                self.put(target, child)
                return
        part = self.part(child, target, may_rename=action == "modify")
        if part is None:
            return
        if action == "remove":
            self.remove(child, Place(part))
        elif action == "modify":
            self.modify(child, part)
        else:
            self.exchange(part, child)

    # Steps

    def fits(self, element: Element, definition: Definition) -> bool:
        """Note what is wrong with an element that is to be added, and say whether it is sound."""
        problems = [
            problem
            for problem in examine(element, definition)
            if not (isinstance(problem, UnknownAttribute) and problem.attribute in _OWN_ATTRIBUTES)
        ]
        self.found += problems
        return not problems

    def put(self, parent: Element, entry: Element) -> None:
        changeable(parent).append(copy_for(parent, entry, _OWN_ATTRIBUTES))

    def exchange(self, old: Element, entry: Element) -> None:
        changeable(old.parent).replace(old, copy_for(old, entry, _OWN_ATTRIBUTES))

    def part(self, wanted: Element, target: Element, *, may_rename: bool = False) -> Element | None:
        """The child of the target that is meant; None, and a word about it, if there is none."""
        parts = list(target.children(wanted.name))
        name = wanted.attributes.get("name")
        if name is not None:
            named = [part for part in parts if part.attributes.get("name") == name]
            parts = named or (parts if may_rename else [])
        if not parts:
            self.absent(wanted, target)
            return None
        first = parts[0]
        if name is None and (assumed := first.attributes.get("name")) is not None:
            definition = definition_of(first)
            if definition is not None and "name" in definition.required_attributes:
                self.fault(wanted, ParameterFault.NAME_ASSUMED, assumed)
        return first

    def absent(self, wanted: Element, target: Element) -> None:
        if not self.alterations.complete:
            return
        name = wanted.attribute("name")
        siblings = [c.attributes.get("name", "") for c in target.children(wanted.name)]
        near = suggest(name.text, filter(None, siblings)) if name is not None else None
        self.fault(wanted if name is None else name, ParameterFault.ABSENT_CHILD, target.title, near)

    def remove(self, wanted: Element, place: Place) -> None:
        """Remove the target, or of its children those that are listed."""
        children = list(wanted.children())
        if not children and not wanted.content:
            target = self.alterations.outermost(place)
            changeable(target.parent).remove(target)
            return
        target = self.alterations.own(place)
        for child in children:
            part = self.part(child, target)
            if part is not None:
                changeable(part.parent).remove(part)

    def modify(self, wanted: Element, target: Element) -> None:
        definition = definition_of(target)
        self.modify_attributes(wanted, target, definition)
        if wanted.content:
            if definition is not None and definition.type is not None:
                self.found += text_problems(wanted, definition)
            changeable(target).write(wanted.content)
            changeable(target).origin = wanted
            return
        for child in wanted.children():
            part = self.part(child, target, may_rename=True)
            if part is None:
                continue
            inner = definition_of(part)
            if child.content or next(child.children(), None) is not None:
                self.modify(child, part)
            elif inner is not None and inner.type is None:
                self.fault(child, ParameterFault.NO_CHANGE)
            else:
                self.modify_attributes(child, part, inner)

    def modify_attributes(self, wanted: Element, target: Element, definition: Definition | None) -> None:
        for name, text in wanted.attributes.items():
            if name in _OWN_ATTRIBUTES:
                continue
            if ":" not in name and definition is not None and name not in definition.attributes:
                near = suggest(name, definition.attributes)
                self.fault(Value(wanted, name, text), ParameterFault.UNKNOWN_ATTRIBUTE, definition.name, near)
            elif name == "name":
                self.alterations.rename(target, text)
            else:
                target.attributes[name] = text


def definition_of(element: Element) -> Definition | None:
    """The definition of an element of a copy, in the newest version."""
    names: list[str] = []
    at = element
    while at.parent is not None:
        names.insert(0, at.name)
        at = at.parent
    document = element.document
    assert isinstance(document, Altered)
    definition: Definition | None = schema(version_of(document.original)).root
    for name in names:
        definition = definition.children.get(name) if definition is not None else None
    return history.in_version(definition, NEWEST) if definition is not None else None


# Merged includes: what may be merged where, and the names that come with it.
#
# Source: libsdformat 17's parser.cc: only links, nested models, joints, frames, grippers and plugins move
# into the parent, and a world takes no links and no grippers.


_MOVED = frozenset({"link", "model", "joint", "frame", "gripper"})
"""The named parts that move into the parent."""
_NOT_INTO_WORLDS = frozenset({"link", "gripper"})

_Taken = dict[str, Name]
"""The names that are given already."""


def merged_namesakes(document: Document) -> list[Namesakes]:
    """The names that are taken where a document merges models."""
    pairs: list[Namesakes] = []
    for parent, group in _by_parent(document).items():
        if merged := [found for found in group if _is_merged(found, parent)]:
            pairs += _clashes(parent, merged, _taken(document, parent, group))
    return pairs


def _by_parent(document: Document) -> dict[Element, list[Included]]:
    """The includes of a document by the elements that they are in."""
    by_parent: dict[Element, list[Included]] = {}
    for include in includes_of(document):
        if include.parent is not None:
            by_parent.setdefault(include.parent, []).append(included(document, include))
    return by_parent


def _is_merged(found: Included, parent: Element) -> bool:
    """Is it a model that becomes part of its parent?"""
    if not found.merge or found.model is None or found.kind != "model":
        return False
    if parent.name == "world":
        return all(kind not in _NOT_INTO_WORLDS for kind, _, _ in moved(found))
    return parent.name == "model"


def moved(found: Included) -> Iterator[tuple[str, str, Element]]:
    """The named parts of a model that is merged, as its parameters change it."""
    model = found.model
    if model is None:
        return
    if model.name == "robot":
        children = [(child.name, child.attributes.get("name", ""), child) for child in model.children()]
    else:
        children = notes(model.document).named.get(model, [])
    for kind, name, child in children:
        if kind in _MOVED and name.strip():
            yield kind, name.strip(), child


def _taken(document: Document, parent: Element, group: list[Included]) -> _Taken:
    """The names that the parent gives itself, and those of the models that it includes whole."""
    taken: _Taken = {}
    for kind, name, child in notes(document).named.get(parent, ()):
        if kind != "plugin":
            taken.setdefault(name.strip(), Name(kind, name.strip(), Value(child, "name", name), parent))
    for found in group:
        if not found.merge and found.name and found.uri is not None:
            own = found.include.find("name")
            value = own.own_value if own is not None and own.content else found.uri
            taken.setdefault(found.name, Name(found.kind or "model", found.name, value, parent))
    return taken


def _clashes(parent: Element, merged: list[Included], taken: _Taken) -> Iterator[Namesakes]:
    """Of each merged model the first name that is taken; of two models of one name that name is reported."""
    names: set[str | None] = set()
    for found in merged:
        if found.uri is not None:
            own = [Name(kind, name, found.uri, parent, is_merged=True) for kind, name, _ in moved(found)]
            clash = next((name for name in own if name.name in taken), None)
            if clash is not None and found.name not in names:
                yield Namesakes(taken[clash.name], clash)
            for name in own:
                taken.setdefault(name.name, name)
        names.add(found.name)


# Includes that multiply: files of files of files, each some times, make more models than anybody can look at.


class TooManyModels(WrongUsage):
    """A file brings more than can be looked into; what is known of it would not be the whole."""


class _Size(NamedTuple):
    """How many models the includes of a file bring in, and how long their longest chain is."""

    models: int
    depth: int


def refuse_too_many(document: Document) -> None:
    """Make sure that all of what a document includes can be looked into.

    Raises TooManyModels.
    """
    if document.root is None or document.root.name != "sdf":
        return
    size = _size(document, {}, ())
    if size.depth > DEEPEST:
        raise TooManyModels(f"{document.path}: includes lead through more than {DEEPEST} files")
    if size.models > MOST_MODELS:
        raise TooManyModels(f"{document.path}: its includes bring in more than {MOST_MODELS} models")


def _size(document: Document, known: dict[Document, _Size], chain: tuple[Document, ...]) -> _Size:
    """The size of each file is worked out once, however often it is included."""
    if document in known:
        return known[document]
    if document in chain:
        raise TooManyModels(f"{chain[0].path}: includes lead from {document.path} back to it")
    if len(chain) > DEEPEST:
        return _Size(0, DEEPEST + 1)
    models, depth = 0, 0
    for include in includes_of(document):
        found = included(document, include)
        if found.document is None or found.model is None or found.kind != "model":
            continue
        inner = _size(found.document, known, (*chain, document))
        models += 1 + inner.models
        depth = max(depth, 1 + inner.depth)
    size = known[document] = _Size(models, depth)
    return size


# What is wrong with the parameters and placement of includes. Problems of an included file are reported in that file.


def problems(document: Document) -> Iterator[object]:
    """The problems of the includes of an SDF document by itself, in no particular order."""
    for include in includes_of(document):
        brought = included(document, include)
        if _is_placed_in_vain(include):
            yield MissingElement(include, "pose", None, refused=True)
        yield from brought.faults


def _is_placed_in_vain(include: Element) -> bool:
    placement = include.find("placement_frame")
    return placement is not None and bool(placement.content) and not include.has("pose")
