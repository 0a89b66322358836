"""Values of a description: plain numbers, vectors and texts that know their place.

A :class:`Number` is a float and a :class:`Vector` a tuple of floats, so that they can be computed
with at once. A value that is not written has its default, says so (``is_given``), and has the place
where it would be written.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

if TYPE_CHECKING:
    from sdfcheck.source.document import Element, Value
    from sdfcheck.source.text import Span

T = TypeVar("T")
Key = TypeVar("Key")

MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
"""The moments and products of an inertia, by the names of their elements and attributes."""


class lazy(Generic[T]):  # noqa: N801 - used like `property`
    """A property that is worked out once and then kept by the object."""

    def __init__(self, compute: Callable[[Any], T]) -> None:
        self.compute = compute
        self.__doc__ = compute.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    @overload
    def __get__(self, owner: None, cls: type) -> lazy[T]: ...
    @overload
    def __get__(self, owner: object, cls: type) -> T: ...
    def __get__(self, owner: object | None, cls: type) -> T | lazy[T]:
        if owner is None:
            return self
        value = owner.__dict__[self.name] = self.compute(owner)
        return value


def grouped(each: Iterable[T], key: Callable[[T], Key]) -> dict[Key, list[T]]:
    """Those of each key, in the order given."""
    found: dict[Key, list[T]] = {}
    for one in each:
        found.setdefault(key(one), []).append(one)
    return found


class _Placed:
    """A value that knows its place: ``value`` is the text, None where the default is taken."""

    __slots__ = ()
    value: Value | None
    element: Element

    @property
    def is_given(self) -> bool:
        """Is it written in the text?"""
        return self.value is not None

    @property
    def text(self) -> str:
        """The text as written, without spaces around it; empty where it is not."""
        return self.value.text.strip() if self.value is not None else ""

    @property
    def span(self) -> Span:
        """The place of the text, or of the element that lacks it."""
        return self.element.span if self.value is None else self.value.span


class Number(_Placed, float):
    """A float as simulators read it, with its place in the text.

    ``value`` is the text with its place, None where the default is taken; ``element`` is
    the element that holds the value or would hold it.
    """

    __slots__ = ("element", "value")
    value: Value | None
    element: Element

    @classmethod
    def of(cls, value: Value | None, element: Element, default: float) -> Number:
        """The number that a text begins with, as libsdformat and urdfdom take it; nan if there is none."""
        if value is None or not (text := value.text.strip()):
            number, value = cls(default), None
        else:
            try:
                number = cls(text)
            except ValueError:
                from sdfcheck.formats.sdf.values import leading_float

                found = leading_float(text)
                number = cls("nan" if found is None else found.value)
        number.value, number.element = value, element
        return number

    @property
    def number(self) -> float:
        """The number if the text is exactly one, or the default; nan for a text that is not a number."""
        return float(self) if self.value is None else self.value.number

    def __repr__(self) -> str:
        return float.__repr__(self) + ("" if self.is_given else " (default)")

    def __reduce__(self) -> tuple[type[float], tuple[float]]:
        return float, (float(self),)


def number(name: str, default: float, says: str | None = None) -> lazy[Number]:
    """A property of a part: the number that it writes, in SDFormat as an element, in URDF as an attribute."""
    found: lazy[Number] = lazy(lambda part: part._number(name, default))
    found.__doc__ = says
    return found


def given_text(name: str, says: str) -> lazy[Value | None]:
    """A property of a part: the attribute that it writes, with its place."""
    found: lazy[Value | None] = lazy(lambda part: part.attribute(name))
    found.__doc__ = says
    return found


def word(name: str, default: str, says: str) -> lazy[str]:
    """A property of a part: the text of an attribute, without spaces around it."""
    found: lazy[str] = lazy(lambda part: (part._text(name) or default).strip())
    found.__doc__ = says
    return found


def vector(name: str, default: tuple[float, ...], says: str) -> lazy[Vector]:
    """A property of a part: the numbers that it writes, in SDFormat in an element, in URDF in an attribute."""
    found: lazy[Vector] = lazy(lambda part: part._vector(name, default))
    found.__doc__ = says
    return found


def parts(name: str, says: str | None = None) -> lazy[tuple[Any, ...]]:
    """A property of a part: the parts that its child elements of a name make."""
    found: lazy[tuple[Any, ...]] = lazy(lambda part: tuple(part._parts(name)))
    found.__doc__ = says
    return found


class Vector(_Placed, tuple[float, ...]):
    """Several numbers of one text, with their place; empty where the text is not made of numbers."""

    value: Value | None
    element: Element

    @classmethod
    def of(cls, value: Value | None, element: Element, default: Iterable[float]) -> Vector:
        """The numbers of a text, separated by spaces."""
        if value is None or not value.text.strip():
            numbers, value = cls(default), None
        else:
            try:
                numbers = cls(map(float, value.text.split()))
            except ValueError:
                numbers = cls(())
        numbers.value, numbers.element = value, element
        return numbers

    def __reduce__(self) -> tuple[type[tuple[float, ...]], tuple[tuple[float, ...]]]:
        return tuple, (tuple(self),)


class Flag(_Placed, int):
    """A truth value as simulators read it, with its place: true if it is not 0."""

    value: Value | None
    element: Element

    @classmethod
    def of(cls, value: Value | None, element: Element, default: bool) -> Flag:
        """The truth of a text: ``true`` and ``1`` are true, everything else is false."""
        if value is None or not value.text.strip():
            flag, value = cls(default), None
        else:
            flag = cls(is_true(value.text))
        flag.value, flag.element = value, element
        return flag

    def __repr__(self) -> str:
        return repr(bool(self))


class Text(_Placed, str):
    """A text with its place, without spaces around it."""

    value: Value | None
    element: Element

    @classmethod
    def of(cls, value: Value | None, element: Element, default: str) -> Text:
        """The text of a value, or the default."""
        if value is None or not value.text.strip():
            text, value = cls(default), None
        else:
            text = cls(value.text.strip())
        text.value, text.element = value, element
        return text


def is_true(text: str) -> bool:
    """The texts that the formats take for true."""
    return text.strip().lower() in {"true", "1"}


def reference_of(pose: Element | None) -> str:
    """The frame that a pose is written relative to; empty for the default."""
    value = reference_value(pose)
    return "" if value is None else value.text.strip()


def reference_value(pose: Element | None) -> Value | None:
    """The reference of a pose with its place: until 1.6 it was called ``frame``."""
    if pose is None or pose.name != "pose":
        return None
    old = pose.attribute("frame")
    if old is not None:
        from sdfcheck.formats.sdf.survey import version_of
        from sdfcheck.formats.version import Version

        if version_of(pose.document) < Version(1, 7):
            return old
    return pose.attribute("relative_to")
