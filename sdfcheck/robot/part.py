"""Parts: everything that a description is made of.

A part is an element with a meaning: a link, a joint, a sensor. Parts are made when they
are asked for, each once, and never change the document. Where the format takes a part
for granted that is not written, the part exists with its defaults and ``is_given`` is
False.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar, cast, overload

from sdfcheck.robot.kinds import class_named, part_class
from sdfcheck.robot.values import Flag, Number, Text, Vector
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.robot.custom import Custom
    from sdfcheck.robot.motion.pose import Pose
    from sdfcheck.robot.root import Root
    from sdfcheck.robot.scope import Scope
    from sdfcheck.source.document import Document
    from sdfcheck.source.element import Element, Value
    from sdfcheck.source.text import Span

T = TypeVar("T", str, int, float, bool)
P = TypeVar("P", bound="Part")

Registry = dict["Element", "Part"]
"""The parts that elements have become, of one reading of a file: two includes of it make two readings."""


class Part:
    """One part of a description.

    ``holder`` is the part that it is in (None for the root); ``is_urdf`` says which
    format it is written in: what ``<gazebo>`` holds in a URDF file is SDFormat.
    """

    kind: ClassVar[str] = ""
    """The name of its element in SDFormat."""
    is_scope: ClassVar[bool] = False
    """Is it a model or world?"""
    is_custom: ClassVar[bool] = False
    """Is it data with a prefix?"""

    holder: Part | None
    root: Root
    registry: Registry
    is_urdf: bool
    is_given: bool
    """Is it written in the text? Values that are not written have their defaults."""

    __slots__ = ("__dict__", "__weakref__", "element", "holder", "is_given", "is_urdf", "registry", "root")

    def __init__(self, holder: Part, element: Element | None) -> None:
        self.holder = holder
        self.root = holder.root
        self.registry = holder.registry
        self.is_urdf = holder.is_urdf
        self.is_given = element is not None
        self.element: Element = holder.element if element is None else element

    def __repr__(self) -> str:
        name = self.name
        return f"{type(self).__name__}({name!r})" if name else f"{type(self).__name__}()"

    # Identity

    @property
    def name(self) -> str:
        """Its name, without spaces around it; empty where it has none."""
        return (self._text("name") or "").strip()

    @property
    def name_value(self) -> Value | None:
        """Its name with the place of the text."""
        return self.element.attribute("name") if self.is_given else None

    @property
    def title(self) -> str:
        """Its name in a sentence: ``joint `elbow```."""
        return self.element.title

    @property
    def document(self) -> Document:
        """The file that it is written in; for what an include brings, the included file."""
        return self.element.document

    @property
    def span(self) -> Span:
        """The place of its name in the start tag."""
        return self.element.span

    def within(self, cls: type[P]) -> P | None:
        """The innermost part of a class that it is in: ``visual.within(Link)``."""
        at = self.holder
        while at is not None and not isinstance(at, cls):
            at = at.holder
        return at

    @property
    def scope_around(self) -> Scope | None:
        """The model or world that it is directly in."""
        return cast("Scope", self.holder) if self.holder is not None and self.holder.is_scope else None

    # Written values

    def value(self, name: str) -> Value | None:
        """The text of an attribute, else of a child element, with its place; None if there is neither."""
        return self.element.value(name) if self.is_given else None

    def attribute(self, name: str) -> Value | None:
        """The attribute of that name, prefix included: ``attribute("flatland:type")``."""
        return self.element.attribute(name) if self.is_given else None

    def has(self, name: str) -> bool:
        """Is there a child element of that name, prefix included?"""
        return self.is_given and self.element.has(name)

    @property
    def is_extension(self) -> bool:
        """Is it in a ``<gazebo>`` block of a URDF file, so that only Gazebo reads it?"""
        return self.root.is_urdf and not self.is_urdf

    def misspells(self, name: str) -> bool:
        """Does it lack a child or attribute of that name only because it is misspelled?"""
        if not self.is_given:
            return False
        if self.is_urdf:
            from sdfcheck.formats.urdf.misspellings import misspells

            return misspells(self.element, name)
        from sdfcheck.formats.sdf.survey import survey

        return (self.element, name) in survey(self.document).misspelled

    def find(self, name: str) -> Element | None:
        """The first child element of that name, prefix included."""
        return self.element.find(name) if self.is_given else None

    def children(self, name: str | None = None) -> Iterator[Element]:
        """The child elements, or those of one name."""
        return self.element.children(name) if self.is_given else iter(())

    def all_elements(self) -> Iterator[Element]:
        """All elements in it, those of plugins as well, in the order of the file."""
        return self.element.below if self.is_given else iter(())

    def lacks(self, name: str) -> bool:
        """Is there neither an attribute nor a child element of a name, not even a misspelled one?"""
        if self.value(name) is not None or self.misspells(name):
            return False
        if not self.is_unfinished:
            return True
        from sdfcheck.formats.urdf.misspellings import definition
        from sdfcheck.xacro.static.macro_survey import may_get

        return not may_get(self.element, name, definition(self.element))

    @property
    def is_unfinished(self) -> bool:
        """Is it in a file for xacro, which will put something into it?"""
        if self.document.kind is not Kind.XACRO or not self.is_given:
            return False
        from sdfcheck.xacro.static.macro_survey import is_unfinished

        return is_unfinished(self.element)

    def nearest(self, name: str, candidates: Iterable[str]) -> str | None:
        """The candidate that a misspelled name was probably meant to be; None if none is near.

        A document full of unknown names is not guessed at without end.
        """
        from sdfcheck.formats.near_names import nearest

        return nearest(name, candidates, self.document)

    @overload
    def get(self, name: str) -> str | None: ...
    @overload
    def get(self, name: str, type: type[T]) -> T | None: ...
    @overload
    def get(self, name: str, type: type[Vector]) -> Vector | None: ...
    @overload
    def get(self, name: str, type: type[Pose]) -> Pose | None: ...
    def get(self, name: str, type: Any = str) -> Any:
        """The value of an attribute, else of a child element: str, int, float, bool, Vector or Pose.

        ``name`` is as written, prefix included; ``camera/image/width`` leads to what is deeper.
        None if it is not there; ValueError, with the place, if it is not of the type.
        """
        *path, last = name.split("/")
        at: Element | None = self.element if self.is_given else None
        for step in path:
            at = None if at is None else at.find(step)
        if at is None:
            return None
        if type not in {str, int, float, bool, Vector}:
            return type.written(at, last)
        if type is not Vector:
            return at.get(last, type)
        value = at.value(last)
        if value is None:
            return None
        numbers = Vector.of(value, at, ())
        if value.text.strip() and not numbers:
            value.to(float)
        return numbers

    def setting(self, name: str) -> Number | Vector | Flag | Text:
        """A value of the standard, with the default of the format where it is not written.

        ``name`` is that of an attribute or a child element, ``camera/image/width`` that of what
        is deeper. Raises NotFound where the format has no such value here.
        """
        from sdfcheck.robot.access.defaults import setting

        return setting(self, name)

    @property
    def custom(self) -> dict[str, Custom]:
        """Prefixed attributes and elements by their names, the first of each."""
        found: dict[str, Custom] = {}
        if not self.is_given:
            return found
        for name in self.element.attributes:
            if ":" in name and not name.startswith("xml:"):
                made: Any = class_named("Custom")
                found[name] = made(self, self.element, self.element.attribute(name))
        for child in self.children():
            if child.is_custom and (part := self.part(child)).is_custom:
                found.setdefault(child.name, cast("Custom", part))
        return found

    def release(self) -> None:
        """Drop all parts of the reading, which refer to one another; its document is not needed any more."""
        for part in (self, *self.registry.values()):
            part.__dict__.clear()
        self.registry.clear()
        del self.root

    # For the parts themselves

    def part(self, element: Element) -> Part:
        """The part that a child element makes, each time the same."""
        found = self.registry.get(element)
        if found is None:
            found = self.registry[element] = part_class(self, element)(self, element)
        return found

    def _parts(self, name: str) -> Iterator[Any]:
        """The parts that the child elements of a name make."""
        return (self.part(child) for child in self.children(name))

    def _only(self, name: str, cls: type[P]) -> P:
        """The part of the first child element of a name; one with defaults if there is none."""
        child = self.find(name)
        if child is not None:
            found = self.part(child)
            if isinstance(found, cls):
                return found
        return cls(self, child)

    def _text(self, name: str) -> str | None:
        """The text of an attribute."""
        return self.element.text_of(name) if self.is_given else None

    def _number(self, name: str, default: float) -> Number:
        """A number: in SDFormat a child element, in URDF an attribute."""
        return Number.of(self._setting(name), self.element, default)

    def _vector(self, name: str, default: tuple[float, ...]) -> Vector:
        return Vector.of(self._setting(name), self.element, default)

    def _setting(self, name: str) -> Value | None:
        if not self.is_given:
            return None
        if self.is_urdf:
            return self.element.attribute(name)
        child = self.element.find(name)
        return None if child is None else child.own_value
