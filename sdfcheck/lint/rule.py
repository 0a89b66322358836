"""The base class of all rules."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Protocol

from sdfcheck.consumers.reaction import Affects, Consumer, Reaction
from sdfcheck.formats.near_names import question
from sdfcheck.lint.diagnostic import Diagnostic, Label, Missing, Origin, Severity
from sdfcheck.lint.example import Bad, Good
from sdfcheck.lint.fix import Applicability, Fix, TextEdit
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.source.document import Element


class Placed(Protocol):
    """Things with a place in the text: an object or value of the robot, a text, an element."""

    @property
    def span(self) -> Span:
        """Where it is."""


Target = Span | Placed
"""A target for a diagnostic: a span, or something that has one."""


class Rule:
    """One defect: its name, its manual (the docstring), its examples, its check.

    A rule looks at objects of the robot (``looks_at``), at elements (``selects``), or puts
    problems that reading found into words (``explains``). Selectors are paths of element
    names after a dialect: ``sdf:joint/axis/limit`` is each ``limit`` in an ``axis`` in a
    ``joint``; ``urdf:robot`` is the root. Rules hold no state, print nothing, raise nothing.
    """

    code: ClassVar[str]
    name: ClassVar[str]
    severity: ClassVar[Severity]
    remedy: ClassVar[str] = ""
    """The way to correct it, in Markdown: an imperative that findings without other advice show, then the reasons."""
    looks_at: ClassVar[tuple[type, ...]] = ()
    """Classes of the robot; :class:`Element` may be named with ``selects``."""
    selects: ClassVar[tuple[str, ...]] = ()
    """The elements that are looked at, or where the objects of the classes in ``looks_at`` have to be."""
    needs: ClassVar[tuple[str, ...]] = ()
    """Texts such as ``<mesh``: in a document without any of them, nothing is looked at."""
    explains: ClassVar[tuple[type, ...]] = ()
    affects: ClassVar[Affects] = {}
    """For rules of packs: which consumers are concerned, and what they do; empty: none, the file itself is at fault."""
    default: ClassVar[bool] = True
    """False: runs only when selected."""
    preview: ClassVar[bool] = False
    """True: not yet measured on public files; runs only with ``--preview``, or selected by its code or name."""
    since: ClassVar[str] = ""
    """The first version that has the rule; empty for the first release."""
    sources: ClassVar[tuple[str, ...]] = ()
    """Addresses of what the rule follows, where the ``SOURCES`` of its family's package are not enough."""
    scaffold: ClassVar[str] = "{}"
    bad: ClassVar[tuple[Bad, ...]]
    good: ClassVar[tuple[Good, ...]]

    @staticmethod
    def applies(subject: Any) -> bool:
        """Whether ``check`` has something to report about an object or element.

        It is asked about each of them, also in a clean file, and ``check`` is called where
        it says True. A rule without one of its own has ``check`` called for each.
        """
        return True

    def check(self, subject: Any) -> Iterator[Diagnostic]:
        """Look at one object, element or problem, and say what is wrong with it."""
        raise NotImplementedError

    def diagnostic(  # noqa: PLR0913 - all but two are named
        self,
        target: Target,
        message: str,
        *,
        meant: str | None = None,
        labels: Mapping[Any, str] | None = None,
        fix: Fix | None = None,
        help: str | None = None,
        severity: Severity | None = None,
        origins: tuple[Origin, ...] = (),
        affects: Mapping[Consumer, Reaction] | None = None,
        missing: Missing | None = None,
        cause: Span | None = None,
        repeats: Iterable[Target] = (),
    ) -> Diagnostic:
        """A diagnostic of this rule; ``labels`` are further targets and what they have to do with it.

        ``meant`` is the name that was probably meant there: an unsafe fix writes it, if no other ``fix`` is given.
        The first sentence of ``remedy`` is the help of one without a fix; an empty ``help`` leaves it out.
        ``severity``, and ``affects`` of a consumer, are given where they depend on the case. See :class:`Diagnostic`.
        """
        if meant:
            message = f"{message}; {question(span_of(target).text, meant)}"
            fix = fix or write_instead(meant, target)
        return Diagnostic(
            self.code,
            self.name,
            severity or self.severity,
            message,
            span_of(target),
            tuple(Label(span_of(place), text) for place, text in (labels or {}).items()),
            fix,
            advice(self.remedy) if help is None and fix is None else help or None,
            origins,
            tuple((consumer.value, reaction) for consumer, reaction in (affects or {}).items()),
            missing,
            cause,
            tuple(map(span_of, repeats)),
        )


def advice(remedy: str) -> str | None:
    """The first sentence of a rule's ``remedy`` as a finding shows it; None if there is not one."""
    text = " ".join(remedy.split()).partition(". ")[0].removesuffix(".")
    return text[:1].lower() + text[1:] or None


def span_of(target: Target) -> Span:
    return target if isinstance(target, Span) else target.span


def replace(target: Target, text: str, title: str, *, unsafe: bool = False) -> Fix:
    """A fix that replaces what ``target`` points at."""
    return make_fix(title, (TextEdit(span_of(target), text),), unsafe=unsafe)


def write_instead(name: str | None, *targets: Target) -> Fix | None:
    """The unsafe fix that writes the name which was probably meant at each of the targets.

    None without a name, and where it would have to be escaped in XML.
    """
    if not name or set(name) & set("<>&\"'"):
        return None
    return make_fix(f"write `{name}`", tuple(TextEdit(span_of(one), name) for one in targets), unsafe=True)


def rename(name: str | None, *elements: Element, unsafe: bool = True) -> Fix | None:
    """The fix that gives elements another name, which was probably meant, in their end tags, too."""
    if not name:
        return None
    edits = [
        TextEdit(span, name)
        for one in elements
        for span in (one.span, one.document.spans.end_name(one))
        if span is not None
    ]
    return make_fix(f"rename it to `{name}`", tuple(edits), unsafe=unsafe)


def rewrite(title: str, texts: Mapping[Element, str]) -> Fix | None:
    """The unsafe fix that writes elements otherwise, each with all that is in it.

    None without elements, and where that would lose a comment, an entity or an expression of xacro.
    """
    edits = [TextEdit(element.document.spans.whole(element), text) for element, text in texts.items()]
    if not edits or any(mark in edit.span.text for edit in edits for mark in ("<!", "<?", "&", "$")):
        return None
    return make_fix(title, tuple(edits), unsafe=True)


def make_fix(title: str, edits: tuple[TextEdit, ...], *, unsafe: bool = False) -> Fix:
    """A fix of several edits."""
    return Fix(title, edits, Applicability.UNSAFE if unsafe else Applicability.SAFE)
