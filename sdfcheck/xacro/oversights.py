"""Oversights that xacro accepts, with a warning or without.

``name`` is what it is about, ``other`` a further place that has to do with it.
"""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.record import Record
from sdfcheck.source.text import Span


class Oversight(Record):
    """Something that xacro does not stop for."""

    span: Span
    name: str
    other: Span | None = None
    near: str | None = None


class RedefinedSymbol(Oversight):
    """A property or parameter has the name of something that expressions know: ``pi``."""


class PrefixedMacroName(Oversight):
    """The name of a macro begins with ``xacro:``."""


class DeprecatedFunction(Oversight):
    """A function is called without the module that it is in, ``near``."""


class RedefinedMacro(Oversight):
    """A macro of that name is defined before, at ``other``."""


class OverwrittenProperty(Oversight):
    """A property has a value that nothing reads before it gets another, at ``other``."""


class OverwrittenParameter(Oversight):
    """A property in a macro replaces the parameter of its name, at ``other``, before anything reads it."""


class UnusedArgument(Oversight):
    """An argument that nothing asks for."""


class UnusedMacro(Oversight):
    """A macro of a robot that nothing calls."""


class UnknownPropertyScope(Oversight):
    """xacro does not know the scope of a property."""


class NeverEqualText(Oversight):
    """A text is compared with one that differs in its letters' case only; ``near`` is what it has."""


class TruthComparedWithText(Oversight):
    """A property that xacro makes true or false is compared with the text ``near``."""


class ArgumentForParameter(Oversight):
    """A macro asks for the argument that has the name of its own parameter, at ``other``."""


class ForgottenPrefix(Oversight):
    """A macro names a link or joint without the prefix with which it defines it, at ``other``; ``near`` is both."""


class EmptiedBlock(Oversight):
    """A call gives an element without content, and the parameter takes its content only."""


class UnusualXacroNamespace(Oversight):
    """The prefix is bound to a name that is nearly the customary one, ``near``."""


class ParameterFlaw(Enum):
    """The oddity of a macro's parameter."""

    COMMA = "comma"
    DOUBLED = "doubled"
    BLANK = "blank"
    NO_COLON = "no colon"


class OddParameter(Oversight):
    """A parameter of a macro that is not written as xacro takes ``params`` apart."""

    flaw: ParameterFlaw = ParameterFlaw.COMMA

    @property
    def is_fatal(self) -> bool:
        """Can a call of the macro not be expanded?"""
        return self.flaw in {ParameterFlaw.COMMA, ParameterFlaw.DOUBLED}
