"""Problems of xacro files, found by reading or by expanding them, and oversights that xacro accepts.

``origins`` lead from the nearest macro call or include outwards; they are empty where
no expansion was needed to find the problem. ``is_dormant``: xacro would stop there, but no
expansion reaches the place.
"""

from __future__ import annotations

from enum import Enum

from sdfcheck.source.document import Value
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span, Step
from sdfcheck.xacro.language import PREFIX, REQUIRED

# Oversights that xacro accepts, with a warning or without.
#
# ``name`` is what it is about, ``other`` a further place that has to do with it.


class Oversight(Record):
    """Something that xacro does not stop for."""

    span: Span
    name: str
    other: Span | None = None
    near: str | None = None


class RedefinedSymbol(Oversight):
    """A property or parameter has the name of something that expressions know: ``pi``; ``near``: and its value."""


class PrefixedMacroName(Oversight):
    """The name of a macro begins with ``xacro:``."""


class DeprecatedFunction(Oversight):
    """A function is called without the module that it is in, ``near``."""


class DoubledPrefix(Oversight):
    """A name begins with the same property twice."""


class RedefinedMacro(Oversight):
    """A macro of that name is defined before, at ``other``."""


class OverwrittenProperty(Oversight):
    """A property has a value that nothing reads before it gets another, at ``other``."""


class ReplacedProperty(Oversight):
    """An included file gives a property another value than the one at ``other``, for which the macro ``near`` is."""


class OverwrittenParameter(Oversight):
    """A property in a macro replaces the parameter of its name, at ``other``, before anything reads it."""


class UnusedArgument(Oversight):
    """An argument that nothing asks for."""


class UnusedMacro(Oversight):
    """A macro of a robot that nothing calls."""


class EmptyRobot(Oversight):
    """A robot that a launch file expands, of macros alone; nothing calls this one."""


class UnknownPropertyScope(Oversight):
    """xacro does not know the scope of a property."""


class NeverEqualText(Oversight):
    """A text is compared with one that differs in its letters' case only; ``near`` is what it has."""


class TruthComparedWithText(Oversight):
    """A property that xacro makes true or false is compared with the text ``near``."""


class ArgumentForParameter(Oversight):
    """A macro asks for the argument that has the name of its own parameter, at ``other``."""


class CounterpartProperty(Oversight):
    """An element reads the property of its counterpart; nothing reads its own, ``near``, which is at ``other``.

    ``holder`` is the joint or link, in words, ``places`` are the other places in it.
    """

    holder: str = ""
    places: tuple[Span, ...] = ()


class ForgottenPrefix(Oversight):
    """A macro names a link or joint without the prefix with which it defines it, at ``other``; ``near`` is both."""


class NameByDefault(Oversight):
    """A name is that of a link or joint, at ``other``, at most by the default of an argument in ``near``."""


class EmptiedBlock(Oversight):
    """A call gives an element without content, and the parameter takes its content only."""


class ReboundPrefix(Oversight):
    """A prefix is bound to another name by a file that this one includes, at ``other``."""


class UnusualXacroNamespace(Oversight):
    """The prefix is bound to a name that is nearly the customary one, ``near``."""


class ParameterFlaw(Enum):
    """The oddity of a macro's parameter."""

    COMMA = "comma"
    DOUBLED = "doubled"
    BLANK = "blank"
    NO_COLON = "no colon"
    NO_NAME = "no name"
    NO_DEFAULT = "no default"


class OddParameter(Oversight):
    """A parameter of a macro that is not written as xacro takes ``params`` apart."""

    flaw: ParameterFlaw = ParameterFlaw.COMMA

    @property
    def is_fatal(self) -> bool:
        """Can a call of the macro not be expanded?"""
        return self.flaw not in {ParameterFlaw.BLANK, ParameterFlaw.NO_COLON}


class Failure(Enum):
    """The ways in which an expansion fails that have no kind of problem of their own."""

    EXPRESSION = "expression"
    NUMBER = "number"
    ARGUMENT = "argument"
    VARIABLE = "variable"
    WITHHELD = "withheld"
    FILE = "file"
    SUBMODULE = "submodule"
    IGNORED = "ignored"
    BUILT = "built"
    ABOVE = "above"
    SYNTAX = "syntax"
    TEXT = "text"
    PATTERN = "pattern"
    RECURSION = "recursion"
    LIMIT = "limit"
    REFUSED = "refused"


class Reason(Record):
    """Why xacro stops at something, in words, and a place that has to do with it.

    ``cause`` is a fault that is reported by itself where its file is looked at; ``argument``
    one whose default leads there, so that another value may be meant.
    """

    words: str
    place: Span | None = None
    label: str = ""
    cause: Span | None = None
    argument: str = ""
    help: str = ""


NO_KEY = "the YAML has no key"
"""The beginning of the reason why an expression fails that asks for one."""
NO_TRUTH = " is neither true nor false"
"""Its end, where a condition does."""
WRONG_NAME = "a property cannot have the name"
"""Its beginning, where a property has a name that it cannot have."""
_NO_BLOCK = "Undefined block"
"""The same, of a block."""


class ExpansionFailure(Record):
    """xacro cannot expand the file; ``detail`` is the name or the reason that the kind of failure has.

    ``cause`` is the fault in the text, of the file itself or of one that it includes.
    """

    span: Span
    kind: Failure
    detail: str
    expression: str = ""
    origins: tuple[Step, ...] = ()
    is_dormant: bool = False
    reason: Reason | None = None
    cause: Span | None = None

    @property
    def is_absence(self) -> bool:
        """Does a file that it reads lack a key, wherever that is asked for?"""
        return self.kind is Failure.EXPRESSION and self.detail.startswith(NO_KEY)

    @property
    def lacks_block(self) -> bool:
        """Is a block inserted that nothing defines, as far as the expansion has come?"""
        return self.kind is Failure.EXPRESSION and self.detail.startswith(_NO_BLOCK)


class UndeclaredXacroPrefix(Record):
    """``xacro:`` is used ``count`` times and not declared; ``insertion`` is where a declaration goes."""

    span: Span
    count: int
    insertion: Span


class UndefinedName(Record):
    """A name that is defined nowhere, where it is used; ``near`` is a known name that may be meant."""

    span: Span
    name: str
    near: str | None = None
    origins: tuple[Step, ...] = ()
    others: tuple[Span, ...] = ()
    """Further uses, where they are reported with this one."""
    ends: tuple[Span, ...] = ()
    """The name in the end tags of the elements that use it as theirs."""
    is_dormant: bool = False
    reason: Reason | None = None


class UndefinedMacro(UndefinedName):
    """A called name is not a macro."""


class UndefinedProperty(UndefinedName):
    """A name in an expression is not a property, parameter or function."""


class UndefinedBlock(UndefinedName):
    """The inserted name is not a block that a macro takes or a property holds."""


class UndefinedArgument(Record):
    """``$(arg name)``, and only an argument of another name, ``near``, is declared."""

    span: Span
    name: str
    near: str
    is_dormant: bool = False


class UnevaluatedExpression(Record):
    """A text that looks like an expression and is not one: ``meant`` is the right spelling.

    ``is_open``: its end is missing, so that xacro drops the rest of the value or takes too
    much of it; what was meant cannot be known.
    """

    span: Span
    meant: str
    is_open: bool
    value: Value | None = None
    """The attribute that holds it."""
    is_number: bool = False
    """Is it in the place of a number, so that nothing else depends on it?"""


class WrongXacroAttribute(Record):
    """An element of xacro's lacks an attribute (``is_missing``), or has one that it does not take."""

    span: Span
    element: str
    attribute: str
    is_missing: bool
    near: str | None = None
    is_dormant: bool = False

    @property
    def is_fatal(self) -> bool:
        """Whether xacro stops here if it gets here, or does without a value that was meant."""
        if self.is_dormant or self.is_missing:
            return not self.is_dormant
        own = self.element.removeprefix(PREFIX)
        return self.near is not None and self.near in {*REQUIRED.get(own, ()), "params", "value"}


class IgnoredIncludeContent(Record):
    """An element inside of ``xacro:include``."""

    span: Span
    element: str


class MissingXacroPrefix(Record):
    """Elements of one name that are xacro's but for the prefix: the first, the others, and where it goes.

    ``is_fatal``: xacro fails, for something asks for what they should have defined. ``is_missed``: a
    joint names a link that they would bring. ``is_bare``: no link has an inertial without them.
    """

    span: Span
    name: str
    others: tuple[Span, ...]
    edits: tuple[Span, ...]
    is_fatal: bool = False
    is_missed: bool = False
    is_bare: bool = False


class UnusedProperty(Record):
    """A property that nothing reads."""

    span: Span
    name: str


class UnusedMacroParameter(Record):
    """A parameter that its macro's body does not read; ``literal`` is the text of an element there of that name.

    ``is_free``: no call in the project gives it a value, or several files define the macro, for callers to choose one.
    ``cause`` is the place of a misspelled name that may mean it.
    """

    span: Span
    name: str
    macro: str
    literal: Value | None = None
    is_free: bool = False
    cause: Span | None = None


class XacroIncludeCycle(Record):
    """A file that includes itself, directly or by way of others; ``steps`` are the includes on the way."""

    span: Span
    name: str
    steps: tuple[Span, ...] = ()
    origins: tuple[Step, ...] = ()


class UnknownPackage(Record):
    """``$(find name)``, and no package of that name is known."""

    span: Span
    name: str
    near: str | None
    origins: tuple[Step, ...] = ()


class Mismatch(Enum):
    """How a call and a macro's parameters disagree."""

    MISSING = "missing"
    UNKNOWN = "unknown"
    MISSING_BLOCK = "missing block"
    EXTRA_BLOCK = "extra block"


class WrongMacroArguments(Record):
    """A call that gives a macro other parameters than it takes.

    ``names`` are those at fault, ``near`` is what one was meant to be.
    """

    span: Span
    macro: str
    kind: Mismatch
    names: tuple[str, ...]
    parameters: tuple[str, ...]
    definition: Span | None
    origins: tuple[Step, ...] = ()
    near: str | None = None
    is_dormant: bool = False


Problem = (
    ExpansionFailure
    | UndeclaredXacroPrefix
    | UndefinedMacro
    | UndefinedProperty
    | UndefinedBlock
    | UndefinedArgument
    | UnevaluatedExpression
    | WrongXacroAttribute
    | IgnoredIncludeContent
    | MissingXacroPrefix
    | UnusedProperty
    | UnusedMacroParameter
    | XacroIncludeCycle
    | UnknownPackage
    | WrongMacroArguments
    | Oversight
)

CanBeDormant = (
    ExpansionFailure | UndefinedName | UndefinedArgument | WrongXacroAttribute | WrongMacroArguments
)
"""The problems at which xacro stops if it reaches them."""


def dormant(problem: Problem) -> Problem:
    """The problem as one that no expansion reaches."""
    return problem.changed(is_dormant=True) if isinstance(problem, CanBeDormant) else problem
