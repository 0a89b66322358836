"""What there is to lint about a xacro file: its own problems, and the documents that come of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from sdfcheck.source.document import Document
from sdfcheck.source.problems import SyntaxDefect
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander, Expansion
from sdfcheck.xacro.fragment import lacks_links
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.problems import (
    ExpansionFailure,
    Failure,
    MissingXacroPrefix,
    Problem,
    UndeclaredXacroPrefix,
    UndefinedArgument,
    UndefinedBlock,
    UndefinedMacro,
    UndefinedProperty,
    UnevaluatedExpression,
    UnknownPackage,
    WrongXacroAttribute,
    dormant,
)
from sdfcheck.xacro.static import analysis
from sdfcheck.xacro.static.definitions import is_robot
from sdfcheck.xacro.static.project import is_included

_MISLEADING = (MissingXacroPrefix, UndeclaredXacroPrefix, UnevaluatedExpression)
"""With one of these an expansion fails, or shows what follows from them."""


class Prepared(NamedTuple):
    """``problems`` are those of the xacro file itself, ``documents`` its expansions.

    ``partial`` are expansions without the packages that are not found.
    """

    problems: tuple[Problem, ...]
    documents: tuple[ExpandedDocument, ...]
    partial: tuple[ExpandedDocument, ...] = ()


def prepare(
    document: Document, expander: Expander | None, argument_sets: Iterable[Mapping[str, str]] = ()
) -> Prepared:
    """Read a xacro document, and expand it once for each set of arguments (without one: once).

    A macro library is not expanded, nor is what cannot be, and nothing is without
    ``expander``. Two problems of one kind at one place are one, and so are all uses of one
    undefined name.
    """
    if any(isinstance(problem, SyntaxDefect) for problem in document.problems):
        return Prepared((), ())
    found: list[Problem] = list(analysis.problems(document))
    if expander is None or any(isinstance(each, _MISLEADING) for each in found) or not is_robot(document):
        return Prepared(tuple(_merged(found)), ())
    sets = list(argument_sets) or [{}]
    expansions = [expander.expand(document, arguments) for arguments in sets]
    if all(expansion.document is not None for expansion in expansions):
        found = [dormant(problem) for problem in found]
    elif not any(map(_stops, found)):
        failures = [problem for expansion in expansions for problem in expansion.problems]
        found += [p for p in failures if not (_needs_includer(p) and is_included(document))]
    documents = tuple(_documents(expansions, document))
    partial = [
        expander.expand_partly(document, arguments)
        for arguments, expansion in zip(sets, expansions, strict=True)
        if any(isinstance(problem, UnknownPackage) for problem in expansion.problems)
    ]
    return Prepared(tuple(_merged(found)), documents, tuple(filter(None, partial)))


def _documents(expansions: Iterable[Expansion], document: Document) -> Iterator[ExpandedDocument]:
    """The expansions that are whole: of a file that another one includes there may be a part only."""
    for expansion in expansions:
        expanded = expansion.document
        if expanded is None or not is_complete(expanded):
            continue
        if is_included(document) and lacks_links(expanded):
            continue
        expanded.library = document.library
        yield expanded


def _stops(problem: Problem) -> bool:
    """Whether an expansion that reaches a problem fails for it, in words that do not say so."""
    if isinstance(problem, WrongXacroAttribute):
        return problem.is_fatal
    return isinstance(problem, UndefinedArgument | UndefinedBlock)


def _merged(found: list[Problem]) -> Iterator[Problem]:
    """The first of the problems of one kind at one place, and of those with one undefined name."""
    names: dict[tuple[type, str], list[UndefinedMacro | UndefinedProperty]] = {}
    seen = set()
    for problem in found:
        key = type(problem), problem.span
        if key in seen:
            continue
        seen.add(key)
        if isinstance(problem, UndefinedMacro | UndefinedProperty):
            names.setdefault((type(problem), problem.name), []).append(problem)
        else:
            yield problem
    for first, *others in names.values():
        places = tuple(other.span for other in others)
        yield type(first)(first.span, first.name, first.near, first.origins, places, first.is_dormant)


def is_complete(document: Document) -> bool:
    """Whether a document can stand alone: a robot with links, or SDFormat."""
    root = document.root
    return root is not None and (document.kind is not Kind.URDF or root.has("link"))


def _needs_includer(problem: Problem) -> bool:
    """Whether a file that includes this one may give what an expansion lacks."""
    if isinstance(problem, ExpansionFailure):
        return problem.kind is Failure.ARGUMENT
    return isinstance(problem, UndefinedMacro | UndefinedProperty)
