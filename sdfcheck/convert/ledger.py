"""The books of a conversion: each item of the source, and what became of it.

Items are elements, attributes, texts and comments. A writer enters what it carries, translates or
merges (``take``) and what it leaves out (``lose``); ``close`` reports what nobody entered, so that
nothing disappears in silence. An item that a writer should have entered is a bug of the converter,
and is reported as such (CNV030). ``prove`` looks into the result for what is said to be carried as
it is.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from sdfcheck.convert.loss import Loss, LossKind, loss_at
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import Model
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Aside, Comment, Document, Element, Node
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

# The items of a source, as messages call them, and whether the format has them where they are.


_SHOWN = 30
_NAMED = frozenset({"frame", "joint", "link", "model"})
"""Parts that share the names of a model."""


def models(document: Document) -> list[Model]:
    """The models at the top of a file and of its worlds, in document order."""
    tops = ((top,) if isinstance(top, Model) else top.nodes.values() for top in root_of(document).scopes)
    return [node for nodes in tops for node in nodes if isinstance(node, Model) and node.is_readable]


def belongs(element: Element) -> bool:
    """Does the format have an element of that name at that place?"""
    if element.document.kind is Kind.URDF:
        from sdfcheck.formats.urdf.schema import definition as urdf_definition

        return urdf_definition(element) is not None
    from sdfcheck.formats.schema import Definition
    from sdfcheck.formats.sdf.schema import schema
    from sdfcheck.formats.version import NEWEST

    names = [each.name for each in (element, *element.around)]
    definition: Definition | None = schema(NEWEST).root
    for name in reversed(names[:-1]):
        definition = definition.children.get(name) if definition is not None else None
    return definition is not None


def texts(element: Element) -> Iterator[str]:
    """The texts right in an element that are not blank."""
    found = (element.text, *(node.tail for node in element.nodes))
    return (text for text in found if text and not text.isspace())


def shortened(text: str) -> str:
    """The beginning of a text, on one line."""
    words = " ".join(text.split())
    return words if len(words) <= _SHOWN else f"{words[:_SHOWN]}…"


def shown(element: Element) -> str:
    """The name of an element in a sentence, with its value if that is short, and its parent."""
    text = element.content
    value = ""
    if text and len(text) <= _SHOWN and next(element.children(), None) is None:
        value = f" ({text})"
    where = f" in {element.parent.title}" if element.parent is not None else ""
    return f"{element.title}{value}{where}"


def other_shapes(element: Element) -> list[Element]:
    """The shapes beside a shape in its geometry, which can have one; empty for any other element."""
    at = element.parent
    return (
        [child for child in at.children() if child is not element]
        if at is not None and at.name == "geometry"
        else []
    )


def is_named(element: Element) -> bool:
    """Is it one of the parts of which a model has one of each name?"""
    return element.name in _NAMED


TEXT = "#text"
"""Among the attributes of an element: its text is its value."""
EVERYTHING = "#everything"
"""Among the attributes: all texts and comments right in the element, and if it is alone, all attributes."""
Words = Mapping[str, frozenset[str]]
"""The elements that a converter has words for, and the attributes in which they say something."""
_KINDS = {
    "fluid_added_mass": LossKind.CHANGED_INERTIA,
    "frame": LossKind.DROPPED_FRAME,
    "material": LossKind.CHANGED_MATERIAL,
    "mimic": LossKind.DROPPED_MIMIC,
    "plugin": LossKind.DROPPED_PLUGIN,
    "sensor": LossKind.DROPPED_SENSOR,
}


class Ledger:
    """The outcomes of the items of a source; ``target`` is the format that it is written in.

    Without ``words`` the converter is to have an outcome for each element that is not custom.
    """

    def __init__(self, words: Words | None, target: str) -> None:
        self.losses: list[Loss] = []
        self._words = words
        self._target = target
        self._taken: dict[Node, frozenset[str]] = {}
        """Elements and comments, with the attributes that are entered."""
        self._names: set[str | None] = set()
        """The names of the links and joints that are entered."""
        self._whole: set[Node] = set()
        self._lost: set[Node] = set()
        self._copied: set[Node] = set()
        self._copies: list[tuple[Element, str]] = []
        """Custom elements and attributes that are said to be in the result."""
        self._reported: set[tuple[LossKind, Span, str]] = set()

    # Items in the result

    def take(self, element: Element | None, *attributes: str) -> None:
        """An element is said in the result, by its value and these attributes; without any, by all
        that mean something.

        Its content is entered apart. ``TEXT`` among the attributes is a value that is not in the
        words.
        """
        if element is not None:
            self._enter(element, frozenset(attributes) if attributes else self._known(element))

    def _known(self, element: Element) -> frozenset[str]:
        """The parts of an element with a meaning: attributes, and maybe its text."""
        if self._words is not None:
            return self._words.get(element.name, frozenset())
        return frozenset((TEXT, *(name for name in element.attributes if ":" not in name)))

    def take_parts(self, element: Element | None, *names: str) -> None:
        """An element, and its children of these names."""
        if element is not None:
            self.take(element)
            for child in element.children():
                if child.name in names:
                    self.take_all(child)

    def take_all(self, element: Element) -> None:
        """An element and all of the format in it are said in the result; custom data is entered apart."""
        self.take(element)
        for child in element.children():
            if not child.is_custom:
                self.take_all(child)

    def take_whole(self, element: Element) -> None:
        """An element is in the result, as it is or translated, with everything in it."""
        self._whole.add(element)

    def take_comment(self, comment: Aside) -> bool:
        """A comment is in the result; False if it was before."""
        is_new = comment not in self._taken and not self._is_within(comment, self._whole)
        self._taken[comment] = frozenset()
        return is_new

    def copy(self, element: Element) -> None:
        """An element with all that is in it is in the result; what is custom there under its own name."""
        if element in self._copied:
            return
        self.take_whole(element)
        self._copied.add(element)
        for part in element.walk():
            self._copies += [(part, name) for name in (part.name, *part.attributes) if ":" in name]

    def copy_attribute(self, element: Element, name: str) -> None:
        """A custom attribute is in the result under its own name."""
        self._enter(element, frozenset((name,)))
        self._copies.append((element, name))

    def is_free(self, element: Element) -> bool:
        """Has nobody but copies made anything of an element?"""
        return element in self._copied or not self.is_entered(element)

    def _enter(self, element: Element, attributes: frozenset[str]) -> None:
        before = self._taken.get(element)
        if before is None and is_named(element):
            self._names.add(element.get("name"))
        self._taken[element] = attributes if before is None else before | attributes

    # Items that are lost

    def lose(
        self, kind: LossKind, element: Element, message: str, severity: Severity = Severity.WARNING
    ) -> None:
        """An element, with what is in it, is not in the result."""
        self._lost.add(element)
        self.note(kind, element, message, severity)

    def drop(self, element: Element) -> None:
        """An element is not in the result, as a loss at another place says."""
        self._lost.add(element)

    def lose_attribute(
        self,
        element: Element,
        name: str,
        message: str,
        kind: LossKind = LossKind.DROPPED_ELEMENT,
        severity: Severity = Severity.WARNING,
    ) -> None:
        """An attribute is not in the result."""
        self._enter(element, frozenset((name,)))
        loss = loss_at(element, kind, message, severity)
        value = element.attribute(name)
        self._report(loss if value is None else loss.at(value.name_span))

    def note(
        self, kind: LossKind, element: Element, message: str, severity: Severity = Severity.WARNING
    ) -> None:
        """Something about an element is not in the result as it was; what is in the element is entered apart."""
        if element not in self._taken:
            self.take(element)
        self._report(loss_at(element, kind, message, severity))

    def _report(self, loss: Loss) -> None:
        key = (loss.kind, loss.span, loss.message)
        if key not in self._reported:  # an included model may come several times
            self._reported.add(key)
            self.losses.append(loss)

    # The balance

    @property
    def entered(self) -> frozenset[Element]:
        """The elements that writers have entered so far."""
        return frozenset(element for element in self._taken if isinstance(element, Element))

    def is_entered(self, element: Element) -> bool:
        """Is there an outcome for an element?"""
        return element in self._taken or self._is_within(element, self._whole, self._lost)

    def _is_within(self, node: Node, *covered: set[Node]) -> bool:
        at: Node | None = node
        while at is not None:
            if any(at in each for each in covered):
                return True
            at = at.parent
        return False

    def close(self, root: Element) -> None:
        """Report what is below a root (itself included) and has no outcome."""
        waiting = [root]
        while waiting:
            element = waiting.pop()
            if element in self._whole:
                continue
            if element not in self._taken and element not in self._lost:
                self._leave(element)
            if element in self._lost:
                self._report_custom(element)
                continue
            known = self._known(element)
            self._close_attributes(element, known)
            self._close_texts(element, known)
            waiting.extend(reversed(list(element.children())))

    @property
    def copies(self) -> frozenset[tuple[Element, str]]:
        """The custom elements and attributes, by element and name, that are in the result under their own name."""
        return frozenset(self._copies)

    def prove(self, result: Element) -> None:
        """Report what is said to be carried and is not in the result, whose root this is."""
        if not self._copies:
            return
        found: Counter[str] = Counter()
        for element in result.walk():
            found.update(name for name in (element.name, *element.attributes) if ":" in name)
        for element, name in self._copies:
            found[name] -= 1
            if found[name] < 0:
                self.forget(element, f"`{name}` of {element.title} is not in the result")

    def _leave(self, element: Element) -> None:
        """Nobody entered an element: the target has no word for it, or a writer forgot it."""
        if element.is_custom:
            text = f"{shown(element)} is left out: it has no place in {self._target}"
            self.lose(LossKind.DROPPED_ELEMENT, element, text)
        elif self._words is not None and element.name not in self._words:
            kind = _KINDS.get(element.name, LossKind.DROPPED_ELEMENT)
            self.lose(kind, element, f"{self._target} has no {shown(element)}")
        elif is_named(element) and not element.text_of("name", "").strip():
            text = f"{shown(element)} is left out: it has no name"
            self.lose(LossKind.DROPPED_ELEMENT, element, text)
        elif any(each.name == element.name for each in element.before):
            text = f"{shown(element)} is left out: there is another one before it"
            self.lose(LossKind.DROPPED_ELEMENT, element, text)
        elif not belongs(element):
            text = f"{shown(element)} is left out: it means nothing there"
            self.lose(LossKind.DROPPED_ELEMENT, element, text)
        elif any(shape in self._taken for shape in other_shapes(element)):
            text = f"{shown(element)} is left out: there is another shape before it"
            self.lose(LossKind.UNSUPPORTED_GEOMETRY, element, text)
        elif is_named(element) and element.get("name") in self._names:
            text = f"{shown(element)} is left out: another part of the model has its name"
            self.lose(LossKind.DROPPED_ELEMENT, element, text)
        else:
            self._lost.add(element)
            self.forget(element, shown(element))

    def forget(self, element: Element, item: str) -> None:
        """An item should have been entered, and was not."""
        self._report(loss_at(element, LossKind.UNACCOUNTED_ITEM, f"{item} is not accounted for"))

    def _report_custom(self, lost: Element) -> None:
        """Name the custom data in what is lost; what is of its own prefix goes with it."""
        waiting, own = [lost], f"{lost.name.partition(':')[0]}:" if lost.is_custom else ":"
        while waiting:
            element = waiting.pop()
            if element in self._whole:
                continue
            if element.is_custom and not element.name.startswith(own):
                text = f"`{element.name}` is left out with {lost.title}"
                self._report(loss_at(element, LossKind.DROPPED_ELEMENT, text))
                continue
            for name in element.attributes:
                is_new = name not in self._taken.get(element, ())
                if ":" in name and not name.startswith(own) and is_new:
                    self.lose_attribute(element, name, f"`{name}` is left out with {lost.title}")
            waiting.extend(element.children())

    def _close_attributes(self, element: Element, known: frozenset[str]) -> None:
        entered = self._taken[element]
        if entered == {EVERYTHING}:
            return
        for name in element.attributes:
            if name in entered:
                continue
            item = f"attribute `{name}` of {element.title}"
            if name in known and ":" not in name:
                self.forget(element, item)
            else:
                text = f"{item} is left out: it has no place in {self._target}"
                self.lose_attribute(element, name, text)

    def _close_texts(self, element: Element, known: frozenset[str]) -> None:
        """Words between elements, and comments."""
        entered = self._taken[element]
        if EVERYTHING in entered or not (element.text or element.nodes):
            return
        has_value = TEXT in entered or TEXT in known
        for text in texts(element):
            if has_value:
                has_value = False
                continue
            message = f"the text `{shortened(text)}` in {element.title} is left out: it has no place in {self._target}"
            self._report(loss_at(element, LossKind.DROPPED_ELEMENT, message))
        for node in element.nodes:
            if isinstance(node, Aside) and node not in self._taken:
                what = "a comment" if isinstance(node, Comment) else "an instruction"
                message = f"{what} in {element.title} is left out: `{shortened(node.text)}`"
                self._report(loss_at(element, LossKind.DROPPED_COMMENT, message, Severity.INFO))
