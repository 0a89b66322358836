"""Small frozen values whose classes are cheap to make.

A run on one small SDFormat file defines 100 records and 50 named tuples. As frozen dataclasses
with slots and :class:`typing.NamedTuple` they made the whole process slower by 50 ms, 77 to
127 ms (65 %); the named tuples alone by 3 to 13 ms (2 to 10 %, two series). Measured as user and
system time, which ``/usr/bin/time -f '%U %S'`` prints: two copies of an ordinary installation
that differ in nothing else, in turn, 12 to 40 runs of each; the shortest of each for the times,
the median of the pairs for the percentages; Python 3.11.
"""

from __future__ import annotations

import sys
from collections import _tuplegetter  # type: ignore[attr-defined]
from collections.abc import Callable, Iterable
from types import ModuleType
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn, TypeVar

if TYPE_CHECKING:
    from inspect import Signature


if TYPE_CHECKING:
    from typing import NamedTuple

    from typing_extensions import dataclass_transform
else:

    def dataclass_transform(**_: object) -> Any:
        return lambda cls: cls


T = TypeVar("T", bound="Record")


def _complete(cls: Any, values: tuple[object, ...], named: dict[str, object]) -> tuple[object, ...]:
    """The values of all fields: those given in order, those given by name, and defaults."""
    fields, defaults = cls._fields, cls._field_defaults
    lacking = len(fields) - len(values)
    if not named and 0 < lacking <= len(defaults):  # the frequent case
        return values + tuple(defaults.values())[-lacking:]
    given = {**defaults, **dict(zip(fields, values, strict=False)), **named}
    if (
        len(values) > len(fields)
        or given.keys() != set(fields)
        or not named.keys().isdisjoint(fields[: len(values)])
    ):
        raise TypeError(f"{cls.__name__} takes {', '.join(fields)}")
    return tuple(given[field] for field in fields)


__all__ = ["NamedTuple", "Record"]


@dataclass_transform(frozen_default=True)
class _RecordType(type):
    """Turns annotations into slots, in their order."""

    def __new__(cls, name: str, bases: tuple[type, ...], namespace: dict[str, Any]) -> _RecordType:
        own = tuple(
            f for f, kind in namespace.get("__annotations__", {}).items() if "ClassVar" not in str(kind)
        )
        defaults = {field: namespace.pop(field) for field in own if field in namespace}
        namespace["__slots__"] = own
        made = super().__new__(cls, name, bases, namespace)
        made._fields = (*getattr(made, "_fields", ()), *own)
        made._field_defaults = {**getattr(made, "_field_defaults", {}), **defaults}
        return made

    _fields: tuple[str, ...]
    _field_defaults: dict[str, Any]


class Record(metaclass=_RecordType):
    """A frozen value: fields in the order of their annotations, equal when they are."""

    _fields: ClassVar[tuple[str, ...]]
    _field_defaults: ClassVar[dict[str, Any]]

    if not TYPE_CHECKING:

        def __init__(self, *values: object, **named: object) -> None:
            for field, value in zip(self._fields, _complete(type(self), values, named), strict=True):
                object.__setattr__(self, field, value)

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"{type(self).__name__} is frozen")

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._values() == other._values()

    def __hash__(self) -> int:
        return hash((type(self), self._values()))

    def __repr__(self) -> str:
        pairs = zip(self._fields, self._values(), strict=True)
        return f"{type(self).__name__}({', '.join(f'{field}={value!r}' for field, value in pairs)})"

    def changed(self: T, **changes: object) -> T:
        """The same with other values in some fields."""
        return type(self)(**{**dict(zip(self._fields, self._values(), strict=True)), **changes})

    def _values(self) -> tuple[object, ...]:
        return tuple(getattr(self, field) for field in self._fields)


class _TupleType(type):
    """Turns the annotations of a direct subclass of :class:`NamedTuple` into places of the tuple."""

    def __new__(cls, name: str, bases: tuple[type, ...], namespace: dict[str, Any]) -> _TupleType:
        if any(isinstance(base, _TupleType) and not hasattr(base, "_fields") for base in bases):
            fields = tuple(namespace.get("__annotations__", ()))
            defaults = {field: namespace.pop(field) for field in fields if field in namespace}
            namespace |= {field: _tuplegetter(number, None) for number, field in enumerate(fields)}
            namespace |= {"_fields": fields, "_field_defaults": defaults, "__match_args__": fields}
            namespace["__slots__"] = ()
        return super().__new__(cls, name, bases, namespace)


if not TYPE_CHECKING:

    class NamedTuple(tuple, metaclass=_TupleType):
        """The same as :class:`typing.NamedTuple`, for type checkers and for all other users."""

        __slots__ = ()

        def __new__(cls, *values: object, **named: object) -> NamedTuple:
            if named or len(values) != len(cls._fields):
                values = _complete(cls, values, named)
            return tuple.__new__(cls, values)

        @classmethod
        def _make(cls, values: Iterable[object]) -> NamedTuple:
            return cls(*values)

        def _replace(self, **changes: object) -> NamedTuple:
            made = tuple.__new__(type(self), map(changes.pop, self._fields, self))
            if changes:
                raise TypeError(f"{type(self).__name__} has no {', '.join(changes)}")
            return made

        def _asdict(self) -> dict[str, object]:
            return dict(zip(self._fields, self, strict=True))

        def __getnewargs__(self) -> tuple[object, ...]:
            return tuple(self)

        def __repr__(self) -> str:
            pairs = ", ".join(f"{field}={value!r}" for field, value in self._asdict().items())
            return f"{type(self).__name__}({pairs})"


# Packages that are functions, too.


class CallablePackage(ModuleType):
    # Importing a module of a package makes the package an attribute of the one around it,
    # where a function of its name would have been: so the package itself is the function
    # of the same name in its module ``call``, with its signature and manual.

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        return _function(self)(*arguments, **options)

    @property
    def __signature__(self) -> Signature:
        from inspect import signature

        return signature(_function(self))

    @property
    def __doc__(self) -> str:  # type: ignore[override]
        name = self.__name__.rpartition(".")[2]
        return f"{name}{self.__signature__}\n\n{_function(self).__doc__}"


def _function(package: ModuleType) -> Callable[..., Any]:
    from importlib import import_module

    module = import_module(f"{package.__name__}.call")
    function: Callable[..., Any] = getattr(module, package.__name__.rpartition(".")[2])
    return function


def make_callable(name: str) -> None:
    """Make a package that is being imported callable."""
    sys.modules[name].__class__ = CallablePackage
