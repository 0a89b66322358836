"""Why something does not fit the table of SDFormat."""

from __future__ import annotations

import math
from collections.abc import Callable

from sdfcheck.formats import history, problems
from sdfcheck.formats.choices import Verdict
from sdfcheck.formats.findings import (
    Findings,
    counted,
    folded,
    folded_attributes,
    folded_children,
    folded_texts,
    folded_values,
    judge,
    text_problems,
)
from sdfcheck.formats.near_names import distance as edits
from sdfcheck.formats.near_names import suggest, with_another_word, without_unit
from sdfcheck.formats.schema import NOT_GIVEN, AttributeDefinition, Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.values import read_at
from sdfcheck.formats.urdf.schema import all_settings, urdf
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.problems import SyntaxDefect, SyntaxKind
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

_NUMBERS = frozenset(("double", "float", "int", "unsigned int", "vector2d", "vector3", "pose"))


def _holds(element: Element, meant: Definition) -> bool:
    """Whether an element holds numbers that another one accepts."""
    return meant.type in _NUMBERS and bool(element.content and meant.accepts(element.content))


def _setting(name: str, block: Definition) -> str | None:
    """The setting of a ``<gazebo>`` block that libsdformat writes as an element of a name."""
    for each, setting in all_settings().items():
        if (
            setting.about == block.name
            and not setting.negated
            and name in {path[-1] for path in setting.counterparts}
        ):
            return each
    return None


def _same(text: str) -> Callable[[str], bool]:
    """Says whether a text has the same numbers, or words."""

    def numbers(text: str) -> list[float] | list[str]:
        words = text.lower().split()
        try:
            return list(map(float, words))
        except ValueError:
            return words

    wanted = numbers(text)
    return lambda other: numbers(other) == wanted


# Where an element that is in the wrong place was meant to be.


_BELOW = 1
"""The rank of what is in the parent."""


def likely_parents(places: tuple[str, ...], parent: Element, definition: Definition) -> tuple[str, ...]:
    """Those of ``places`` (names from the start of a definition) that are the likeliest from ``parent``.

    First comes what encloses the parent (an element set one level too deep), the nearest
    first, then what can be reached from there (one level too high); all of them if there is neither.
    The children of the parent are likely in any case.
    """
    chain = _chain(parent)
    ranked: dict[int, list[tuple[int, str]]] = {}
    for place in places:
        steps = place.split("/")
        inner = _inside(steps, chain, definition)
        rank, distance = (_BELOW, 0) if inner else _rank(steps, chain)
        ranked.setdefault(rank, []).append((distance, inner or place))
    best = sorted(ranked[min(ranked)])
    children = sorted(ranked.get(_BELOW, ())) if min(ranked) < _BELOW else []
    return tuple(place for _, place in (*children, *best))


def _chain(element: Element) -> list[str]:
    """The names of an element and of what encloses it, from the inside out."""
    names = [element.name]
    while (parent := element.parent) is not None:
        names.append(parent.name)
        element = parent
    return names


def _inside(steps: list[str], chain: list[str], definition: Definition) -> str:
    """The part of a place that is in the parent, for one that begins there or with what encloses it; else empty."""
    for number, step in enumerate(steps):
        if step in definition.children and steps[:number] == chain[:number][::-1]:
            return "/".join(steps[number:])
    return ""


def _rank(steps: list[str], chain: list[str]) -> tuple[int, int]:
    inwards = steps[::-1]
    for distance in range(len(chain)):
        if chain[distance : distance + len(inwards)] == inwards:
            return 0, distance
    if steps[0] in chain[:-1]:
        return 2, chain.index(steps[0])
    return 3, 0


# Without these the file is refused; for all else that is required a default is taken.
_REFUSED = frozenset(
    (
        ("joint", "parent"),
        ("joint", "child"),
        ("world/include", "uri"),
        ("model/include", "uri"),
        ("material/script", "uri"),
        ("material/script", "name"),
        ("mesh/submesh", "name"),
    )
)

# libsdformat reads these wherever they are.
_FOUND_ANYWHERE = frozenset(("include",))

# Unknown children of these are refused, not ignored.
_CLOSED = frozenset(("material/pbr",))

# Without these the rest of the model is another one.
# Not in any version, and yet what Gazebo reads: reported among the names of its generations.
_NEVER_STANDARD = frozenset(("sensor/gz_frame_id", "sensor/ignition_frame_id"))

# The table allows one, and the consumers take all.
REPEATABLE = frozenset(("geometry/polyline", "contact/collision", "multicamera/camera", "world/physics"))

_FIVE, _SEVEN = Version(1, 5), Version(1, 7)


Named = dict[Element, list[tuple[str, str, Element]]]
"""Parent → (element name, value of its ``name``, element)."""


_OF_URDF = {("mesh", "filename"): "uri"}
"""An attribute of URDF: the child that SDFormat has for it, where that has another name."""


def _unless_known(suggestion: str | None, name: str, places: tuple[str, ...]) -> str | None:
    """A suggestion for a name, unless that is rather the name of an element in other places."""
    if not places or suggestion is None:
        return suggestion
    given, meant = (each.replace("_", "").lower() for each in (name, suggestion))
    return suggestion if edits(given, meant, 1) <= 1 else None


def _cut_short(name: str, parent: Element, place: Definition) -> str | None:
    """The only required child that is not there and begins as a name does: ``name`` for ``n``."""
    absent = [each for each in place.required_children if each.startswith(name) and not parent.has(each)]
    return absent[0] if len(absent) == 1 else None


class _Misplaced:
    """Siblings that are in the wrong place, and go into one other; nothing else is near to their names."""

    def __init__(self, first: problems.MisplacedElement, definition: Definition) -> None:
        self.first = first
        self.definition = definition
        """Of their parent."""
        self.places = first.places
        self.is_default = first.is_default
        self.others: list[Element] = []

    def takes(self, other: problems.MisplacedElement) -> bool:
        """Add another one, if it goes where these go."""
        common = tuple(place for place in self.places if place in other.places)
        if not common:
            return False
        self.places = common
        self.is_default = self.is_default and other.is_default
        self.others.append(other.element)
        return True

    @property
    def problem(self) -> problems.MisplacedElement:
        places = likely_parents(self.places, self.first.parent, self.definition)
        others = tuple(self.others)
        return self.first.changed(places=places, others=others, is_default=self.is_default)


class SdfFindings(Findings):
    """The problems of one SDFormat document, collected during its walk."""

    def __init__(self, document: Document, version: Version, named: Named) -> None:
        super().__init__(document, version)
        self.named = named
        self.elsewhere: set[tuple[Element, str]] = set()
        """Children that elements lack only because these are inside a custom element."""
        self.replaced: dict[Element, list[str]] = {}
        """Custom elements → the required ones that are absent where they are given."""
        self.misspelled: dict[tuple[Element, str], Span] = {}
        """Parts that elements lack only because a child or attribute of theirs is misspelled, with its place."""
        self.unknown: list[tuple[problems.UnknownElement, Definition]] = []
        self.misplaced: dict[Element, list[_Misplaced]] = {}
        """Those of each parent, by where they go."""
        self.missing_children: list[tuple[Element, Definition, str]] = []
        self.uses_too_new: dict[tuple[str, str, Version], list[Element]] = {}
        defects = [problem for problem in document.problems if isinstance(problem, SyntaxDefect)]
        self.unclosed = min(
            (one.span.start for one in defects if one.kind is SyntaxKind.UNCLOSED_ELEMENT), default=math.inf
        )
        """Where the first end tag is missing: elements after it may be where they are only for that."""
        self.surplus = {one.detail: one.span.start for one in defects if one.kind is SyntaxKind.EXTRA_END_TAG}
        """Where the last end tag too many of a name is: elements before it may have been meant to be inside."""

    def root(self, root: Element, definition: Definition) -> None:
        """The root's attributes; its version decides against what everything else is checked."""
        for name in root.attributes:
            if name != "version" and ":" not in name and not name.startswith("xmlns"):
                self.unknown_attribute(root, definition, name)

    # Elements

    def too_new(self, element: Element, definition: Definition, attribute: str, since: Version) -> None:
        parent = element.parent
        place = f"{parent.name}/{element.name}" if parent is not None and not attribute else ""
        if place not in history.READ_IN_ALL_VERSIONS:
            self.uses_too_new.setdefault((definition.place, attribute, since), []).append(element)

    def unknown_element(self, child: Element, parent: Element, place: Definition) -> None:
        name = child.name
        old = history.last_version(place, name)
        if old is not None:
            successor = history.successor(place, name)
            if not history.carried_over(place, name, self.version):
                self.found.append(problems.RemovedElement(child, parent, None, old, successor))
            return
        if (parent.name, name) == ("link", "contact") and _is_of_pybullet(child):
            return
        if child.span.start >= self.unclosed:
            return
        is_sdf = self.document.kind is Kind.SDF
        suggestion = suggest(name, place.children) or without_unit(name, place.children)
        suggestion = suggestion or (None if is_sdf else _setting(name, place))
        known = history.known_parents(name, self.version)
        suggestion = _unless_known(suggestion, name, known)
        if known and not self.is_of_another_kind(child):
            if not self.is_cut_off(child, parent, known):
                # Drake refuses SDFormat for it, whatever it says.
                is_default = not is_sdf and self.is_default(child)
                ignored = name not in _FOUND_ANYWHERE
                self.misplace(
                    problems.MisplacedElement(child, parent, known, suggestion, ignored, is_default), place
                )
        elif f"{place.name}/{name}" not in _NEVER_STANDARD:
            refused = place.path in _CLOSED
            suggestion = (
                suggestion or with_another_word(name, place.children) or _cut_short(name, parent, place)
            )
            self.unknown.append((problems.UnknownElement(child, parent, suggestion, refused), place))

    def misplace(self, found: problems.MisplacedElement, place: Definition) -> None:
        """Note an element that is somewhere else in the format; siblings that go into one place together."""
        parent, meant = found.parent, found.suggestion
        if meant is not None or not found.ignored:
            self.found.append(found.changed(places=likely_parents(found.places, parent, place)))
            if meant is not None and not parent.has(meant):
                self.misspelled.setdefault((parent, meant), found.element.span)
            return
        groups = self.misplaced.setdefault(parent, [])
        if not any(group.takes(found) for group in groups):
            groups.append(_Misplaced(found, place))

    def is_cut_off(self, child: Element, parent: Element, places: tuple[str, ...]) -> bool:
        """Did the element that it belongs into end too early, with another end tag after it?"""
        ended = {name for name in places if child.span.start < self.surplus.get(name, 0)}
        before = next((each for each in parent.children() if each.name in ended), None) if ended else None
        return before is not None and before.span.start < child.span.start

    def is_default(self, element: Element) -> bool:
        """Has an element the value that holds wherever one of its name is not written?"""
        known = (schema(self.version).at(each.place) for each in history.known_places(element.name))
        defaults = [each.given_default for each in known if each is not None]
        return bool(element.content) and bool(defaults) and all(map(_same(element.content), defaults))

    def is_of_another_kind(self, element: Element) -> bool:
        """Has it a word that no place of its name lists? It is somebody's own, whatever it is called."""
        known = (schema(self.version).at(each.place) for each in history.known_places(element.name))
        lists = [each.choices for each in known if each is not None]
        return bool(element.content and lists) and all(
            each is not None and each.judge(element.content) is Verdict.UNKNOWN for each in lists
        )

    def custom(self, child: Element, parent: Element, place: Definition) -> None:
        super().custom(child, parent, place)
        prefix, _, local = child.name.partition(":")
        if prefix == "sdf" and local in place.children and not parent.has(local):
            self.replaced.setdefault(child, []).append(local)
        name = child.attributes.get("name")
        if name is not None:
            self.named.setdefault(parent, []).append((child.name, name, child))
        self.elsewhere.update((parent, each.element.name) for each in self.displaced.get(child, ()))

    def repeated(self, element: Element, first: Element, parent: Element) -> bool:
        # The content of the root is judged as a whole, by the analysis of structure.
        places = {f"{kind}/{element.name}" for kind in (parent.name, parent.attributes.get("type", ""))}
        if parent.parent is not None and REPEATABLE.isdisjoint(places):
            self.found.append(problems.RepeatedElement(element, first, parent))
        return False

    def missing(self, parent: Element, place: Definition, name: str) -> None:
        self.missing_children.append((parent, place, name))

    def replacement(self, parent: Element, place: Definition, name: str) -> Element | None:
        """The custom sibling that may have been put in the place of a required child that is not there."""
        child = place.children[name]
        customs = [custom for custom, owner, _ in self.customs if owner is parent and not custom.nodes]
        customs.sort(key=lambda custom: custom.name.partition(":")[2] != name)
        fitting = (custom for custom in customs if custom.content and child.accepts(custom.content))
        return next(fitting, None) if child.type is not None else None

    def absent(self, parent: Element, place: Definition, name: str) -> problems.MissingElement:
        """A required child that is not there."""
        child = place.children[name]
        default = None if child.default == NOT_GIVEN else child.default
        refused = (place.path, name) in _REFUSED or self.is_refused_axis(parent, name)
        fits = child.type is not None and bool(child.accepts(parent.content))
        return problems.MissingElement(parent, name, default or None, refused, fits=fits)

    def is_refused_axis(self, axis: Element, name: str) -> bool:
        """An axis without direction in the frame of the model, as older files say it.

        The conversion says so on its ``xyz``, and makes an empty one, which is refused.
        """
        if name != "xyz" or self.version >= _SEVEN:
            return False
        frame = axis.find("use_parent_model_frame")
        if frame is None:
            return self.version < _FIVE  # where that is the usual meaning
        return frame.content.lower() in {"true", "1"}

    # Attributes

    def unknown_attribute(self, element: Element, definition: Definition, name: str) -> None:
        old = history.last_version(definition, "@" + name)
        if history.carried_over(definition, "@" + name, self.version):
            if old is None:
                self.too_new(element, definition, name, history.since(definition, "@" + name))
        elif (element.name, name) == ("pose", "frame") and self.version < _SEVEN:
            return  # it is converted in every pose, also in those of includes, which never had it
        elif old is not None:
            successor = history.successor(definition, "@" + name)
            parent = element.parent if element.parent is not None else element
            self.found.append(problems.RemovedElement(element, parent, name, old, successor))
        elif not self.is_one_too_many(element):
            lacking = [each for each in definition.attributes if each not in element.attributes]
            suggestion = suggest(name, lacking)
            if suggestion is not None:
                self.misspelled[element, suggestion] = Value(element, name, "").name_span
            meant = _OF_URDF.get((element.name, name), name)
            child = meant if meant in definition.children else None
            self.found.append(problems.UnknownAttribute(element, name, suggestion, child=child))

    def missing_attribute(self, element: Element, definition: Definition, name: str) -> None:
        until, cause = history.required_until(definition, name), self.misspelled.get((element, name))
        self.found.append(problems.MissingAttribute(element, name, empty=False, until=until, cause=cause))

    def attribute_value(
        self, element: Element, definition: Definition, known: AttributeDefinition, text: str
    ) -> None:
        value = Value(element, known.name, text)
        if not text.strip():
            until = history.required_until(definition, known.name)
            if known.name == "name" and known.required:
                self.found.append(problems.EmptyName(value, until))
            elif known.required:
                self.found.append(problems.MissingAttribute(element, known.name, empty=True, until=until))
            return
        newest = history.in_version(definition, NEWEST)
        counterpart = newest.attributes.get(known.name) if newest else None
        if counterpart is not None and counterpart.accepts(text):
            return
        self.found += judge(value, known, read_at(known, text))

    # Values

    def value(self, element: Element, parent: Element, definition: Definition) -> None:
        for child in element.children():
            self.unexpected(child, element, definition)
        self.found += text_problems(element, definition)

    def judge_unknown(self) -> None:
        """Note the unknown elements, and what they were meant to be."""
        taken: dict[tuple[Element, str], bool] = {}
        for problem, place in self.unknown:
            self.found.append(problem)
            if (name := problem.suggestion) is not None:
                key = problem.parent, name
                if key not in taken:
                    taken[key] = problem.parent.has(name) and place.children[name].single
                if not taken[key]:
                    self.misspelled.setdefault(key, problem.element.span)

    def judge_misplaced(self) -> None:
        """Note elements in place of a child that is missing: its older name, or one that holds its numbers.

        The latter only where nothing else is missing.
        """
        lacking: dict[Element, list[tuple[str, Definition]]] = {}
        for parent, place, name in self.missing_children:
            if (parent, name) not in self.misspelled:
                lacking.setdefault(parent, []).append((name, place.children[name]))
        for at, problem in enumerate(self.found if lacking else ()):
            if isinstance(problem, problems.RemovedElement) and problem.successor is not None:
                self.misspelled[problem.parent, problem.successor] = problem.element.span
            elif isinstance(problem, problems.MisplacedElement) and not (
                problem.suggestion or problem.others
            ):
                absent = lacking.get(problem.parent, ())
                if len(absent) == 1 and _holds(problem.element, absent[0][1]):
                    self.found[at] = problem.changed(suggestion=absent[0][0])
                    self.misspelled[problem.parent, absent[0][0]] = problem.element.span

    def conclude(self) -> list[object]:
        self.judge_unknown()
        self.found += [group.problem for groups in self.misplaced.values() for group in groups]
        self.judge_misplaced()
        for parent, place, name in self.missing_children:
            if (parent, name) in self.elsewhere:
                continue
            cause = self.misspelled.get((parent, name))
            if cause is None and (custom := self.replacement(parent, place, name)) is not None:
                self.replaced.setdefault(custom, []).append(name)
            else:
                self.found.append(self.absent(parent, place, name).changed(cause=cause))
        self.found = _without_strange_sensors(self.found)
        self.found = folded_values(folded_children(folded_attributes(folded_texts(self.found))))
        root = self.document.root
        declaration = root.attribute("version") if root is not None else None
        is_known = declaration is not None and Version.parse(declaration.text) is not None
        for (_, attribute, since), uses in self.uses_too_new.items() if is_known else ():
            assert declaration is not None, "without one nothing is too new"
            if attribute:
                self.found.append(
                    problems.TooNewAttribute(uses[0], attribute, since, declaration, tuple(uses))
                )
            else:
                self.found.append(problems.TooNewElement(uses[0], since, declaration, tuple(uses)))
        return folded(counted(self.found, self.strange))


def _without_strange_sensors(found: list[object]) -> list[object]:
    """The problems, without those in a sensor whose type is like none of the format: its plugin reads its settings."""
    strange = {
        each.value.element
        for each in found
        if isinstance(each, problems.UnknownChoice)
        and (each.value.element.name, each.value.attribute) == ("sensor", "type")
        and each.suggestion is None
    }
    if not strange:
        return found
    return [each for each in found if not _is_inside(each, strange)]


def _is_inside(problem: object, sensors: set[Element]) -> bool:
    """Is a problem below one of these sensors? What the sensor itself lacks is somebody's mistake as ever."""
    value = getattr(problem, "value", None)
    at = value.element if isinstance(value, Value) else getattr(problem, "element", None)
    return isinstance(at, Element) and any(around in sensors for around in at.around)


def _is_of_pybullet(contact: Element) -> bool:
    """Is it the `contact` of a link of URDF, which PyBullet reads in SDFormat, too?"""
    known = urdf().children["link"].children["contact"].children
    names = {each.name for each in contact.children()}
    return bool(names) and names <= known.keys()
