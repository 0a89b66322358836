"""``experimental:params``: what the entries of an include do to the model, and what is wrong with them.

An entry names its target by ``element_id`` and says what to do with it, or has children
that say so each for themselves. One that fails is skipped, the others count. Source:
libsdformat 17's ParamPassing.cc, checked against what it does.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.formats.sdf import history
from sdfcheck.formats.sdf.problems import UnknownAttribute
from sdfcheck.formats.sdf.schema import Definition, schema
from sdfcheck.formats.sdf.survey import PARAMETERS, defined_alone, examine, survey
from sdfcheck.formats.sdf.table import stems
from sdfcheck.formats.sdf.value_problems import text_problems
from sdfcheck.formats.sdf.version import NEWEST
from sdfcheck.formats.suggest import suggest
from sdfcheck.robot.includes.alterations import Alterations, Place, changeable
from sdfcheck.robot.includes.parameter_problems import InvalidParameter, ParameterFault
from sdfcheck.source.element import Element, Value

if TYPE_CHECKING:
    from sdfcheck.robot.includes.alterations import Bring, Resolve
    from sdfcheck.robot.includes.included import Included

ACTIONS = ("add", "modify", "remove", "replace")
_OWN_ATTRIBUTES = frozenset({"element_id", "action"})


class Parameters:
    """The parameters of one include, carried out: the model as they change it, and their problems.

    A URDF, which libsdformat converts before it changes it, stays as it is.
    """

    def __init__(self, found: Included, included: Resolve, bring: Bring) -> None:
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
            self.fault(self.entry, ParameterFault.UNKNOWN_ENTRY, suggestion=suggest(name, stems()))
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
        changeable(parent).add(parent, entry, _OWN_ATTRIBUTES)

    def exchange(self, old: Element, entry: Element) -> None:
        changeable(old).replace(old, entry, _OWN_ATTRIBUTES)

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
            changeable(target).remove(target)
            return
        target = self.alterations.own(place)
        for child in children:
            part = self.part(child, target)
            if part is not None:
                changeable(part).remove(part)

    def modify(self, wanted: Element, target: Element) -> None:
        definition = definition_of(target)
        self.modify_attributes(wanted, target, definition)
        if wanted.content:
            if definition is not None and definition.type is not None:
                self.found += text_problems(wanted, definition)
            changeable(target).write(target, wanted)
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
    definition: Definition | None = schema(survey(changeable(element).original).version).root
    for name in names:
        definition = definition.children.get(name) if definition is not None else None
    return history.in_version(definition, NEWEST) if definition is not None else None
