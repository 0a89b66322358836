"""The parts of a xacro file to lint: its own problems, and the documents that it expands to."""

from __future__ import annotations

import re
from bisect import bisect_right, insort
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from sdfcheck.files.packages import TEMPLATE
from sdfcheck.formats.urdf.survey import is_unknown, is_whole, lacks_parts
from sdfcheck.source.document import Document, Element
from sdfcheck.source.problems import SyntaxDefect
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span
from sdfcheck.xacro.expansion import Expander, Expansion
from sdfcheck.xacro.language import PREFIX
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.problems import (
    ExpansionFailure,
    Failure,
    Mismatch,
    MissingXacroPrefix,
    OddParameter,
    Problem,
    UndeclaredXacroPrefix,
    UndefinedArgument,
    UndefinedBlock,
    UndefinedMacro,
    UndefinedProperty,
    UnevaluatedExpression,
    UnknownPackage,
    WrongMacroArguments,
    WrongXacroAttribute,
    XacroIncludeCycle,
    dormant,
)
from sdfcheck.xacro.static import analysis
from sdfcheck.xacro.static.definitions import is_robot, keyword
from sdfcheck.xacro.static.project import is_called, is_expanded, is_included
from sdfcheck.xacro.static.reasons import at_values, with_reason

# Files that are only a part of a robot: another file includes them and has the rest.


_WHOLES = ("actor", "include", "light", "model", "world")
"""What SDFormat has in its root."""
_ABOUT_LINKS = frozenset({"gazebo", "material", "ros2_control", "transmission"})


def is_launched_source(document: Document) -> bool:
    """Are there expressions of xacro in a robot that the project expands, whatever its name says?

    A launch file does, or somebody did, and keeps the result.
    """
    if document.kind is not Kind.URDF or not is_unknown(document.source.text):
        return False
    from sdfcheck.xacro.static.launches import is_launched

    return is_launched(document) or is_expanded(document)


def is_fragment(document: Document) -> bool:
    """Whether a robot only says something about links that it does not have, or another file has what it lacks.

    That file includes it, and has links, parts that it names, or the values of its expressions.
    """
    root = document.root
    if root is None or document.kind is not Kind.URDF:
        return False
    names = {child.name for child in root.children()}
    if names and names <= _ABOUT_LINKS:
        return True
    return not is_whole(document) and is_included(document)


def _lacks_parts(document: Document) -> bool:
    """Whether a robot lacks parts; SDFormat does if it holds nothing of a root: the settings of a world, a shape."""
    root = document.root
    if root is not None and root.name == "sdf" and any(root.children()):
        return not any(map(root.has, _WHOLES))
    return lacks_parts(document)


_MISLEADING = (MissingXacroPrefix, UndeclaredXacroPrefix, UnevaluatedExpression)
"""With one of these an expansion fails, or shows what follows from them."""


_ENDS = ("parent", "child")
_FINAL = frozenset({Failure.LIMIT, Failure.RECURSION, Failure.REFUSED, Failure.TEXT})
"""After one of these nothing of a file is expanded."""


class Prepared(NamedTuple):
    """``problems`` are those of the xacro file itself, ``documents`` its expansions.

    ``partial`` are expansions of what can be expanded, where xacro refuses the file.
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
    misread = {type(each) for each in found if isinstance(each, _MISLEADING) and not _is_of_a_number(each)}
    if expander is None or misread - {MissingXacroPrefix} or not is_robot(document):
        found = [dormant(each) if _is_uncalled(each, document) else each for each in found]
        return Prepared(tuple(with_reason(problem, document) for problem in _merged(found)), ())
    sets = list(argument_sets) or [{}]
    expansions = [
        expand_as_launched(document, expander.expand, arguments) for arguments in sets if not misread
    ]
    parts = {
        index: expand_as_launched(document, expander.expand_partly, arguments)
        for index, arguments in enumerate(sets)
        if misread or goes_on(expansions[index])
    }
    shown = tuple(part.document for part in parts.values() if part.document is not None)
    _open(shown, document)
    outcomes = [parts.get(index, whole) for index, whole in enumerate(expansions)]
    if not misread and all(map(_lacks_packages_only, outcomes)):
        found = list(_unreached(found, document, shown))
    if not any(map(stops, found)):
        known = [*expansions, *(part for part in parts.values() if part.document is not None)]
        failures = [problem for each in known for problem in each.problems]
        found += [each for each in failures if not (_needs_includer(each) and is_included(document))]
    if misread:
        found = list(_as_they_stop(found, document, expander, zip(sets, parts.values(), strict=True)))
    documents = tuple(_documents(expansions, document))
    found = [each for each in found if not _is_template(each.span.source)]
    explained = [with_reason(each, document) for each in _merged(at_values(found, document))]
    return _without_templates(Prepared(tuple(explained), documents, shown))


def _is_of_a_number(problem: Problem) -> bool:
    return isinstance(problem, UnevaluatedExpression) and problem.is_number


def _open(parts: Iterable[ExpandedDocument], document: Document) -> None:
    """Say of expansions of what can be expanded whether they may be judged as robots."""
    for part in parts:
        part.library = document.library
        part.is_open = not is_complete(part) or is_included(document) or not UnknownParts(part).is_whole


def _without_templates(prepared: Prepared) -> Prepared:
    """Let no robot be judged as a whole of which a build makes a part."""
    unfinished = tuple(filter(_holds_template, prepared.documents))
    for part in unfinished:
        part.is_open = True
    finished = tuple(each for each in prepared.documents if each not in unfinished)
    return prepared._replace(documents=finished, partial=(*prepared.partial, *unfinished))


def _holds_template(document: ExpandedDocument) -> bool:
    """Is a part of a robot made of what a build would change first?"""
    return any(map(_is_template, document.provenance.files))


def _is_template(source: Source) -> bool:
    return source.path.suffix == TEMPLATE


def _as_they_stop(
    found: Iterable[Problem],
    document: Document,
    expander: Expander,
    parts: Iterable[tuple[Mapping[str, str], Expansion]],
) -> Iterator[Problem]:
    """The problems, with what elements without their prefix do to the robot as it is written.

    ``parts`` are the arguments, each with the expansion as if the prefixes were there: what fails there alone is
    not reached.
    """
    fails = lacks = is_bare = False
    is_read = True
    for arguments, part in parts:
        whole = expand_as_launched(document, expander.expand, arguments)
        known, problems = (
            {(type(each), each.span.source.path, each.span.start) for each in one.problems}
            for one in (part, whole)
        )
        fails |= whole.document is None and not problems <= known
        is_read &= whole.document is not None
        lacks |= whole.document is not None and _lacks_ends(whole.document)
        is_bare |= whole.document is not None and _lacks_inertials(whole.document)
    for each in found:
        if isinstance(each, MissingXacroPrefix):
            yield each.changed(is_fatal=fails, is_missed=lacks, is_bare=is_bare)
        else:
            yield dormant(each) if is_read else each


def _lacks_ends(document: Document) -> bool:
    """Does a joint name a link that the robot does not have?"""
    root = document.root
    if root is None or root.name != "robot":
        return False
    links = {link.get("name") for link in root.children("link")}
    ends = (end for joint in root.children("joint") for name in _ENDS for end in joint.children(name))
    return any(name not in links for name in (end.get("link") for end in ends) if name and name != "world")


def _lacks_inertials(document: Document) -> bool:
    """Has no link of a robot an inertial?"""
    root = document.root
    return (
        root is not None
        and root.name == "robot"
        and not any(link.has("inertial") for link in root.children("link"))
    )


def goes_on(expansion: Expansion) -> bool:
    """Can a part of a file be expanded that xacro refuses?"""
    return expansion.document is None and not any(
        isinstance(each, XacroIncludeCycle) or (isinstance(each, ExpansionFailure) and each.kind in _FINAL)
        for each in expansion.problems
    )


def _lacks_packages_only(expansion: Expansion) -> bool:
    """Was all of a file expanded but for packages that are not found?"""
    return expansion.document is not None and all(
        isinstance(each, UnknownPackage) for each in expansion.problems
    )


def expand_as_launched(
    document: Document,
    expand: Callable[[Document, Mapping[str, str]], Expansion],
    arguments: Mapping[str, str],
) -> Expansion:
    """An expansion; where it needs other arguments, one with what a launch file of the project gives."""
    whole = expand(document, arguments)
    if _needs_arguments(whole):
        from sdfcheck.xacro.static.launches import launched_arguments

        lacks = any(map(_is_missing_argument, whole.problems))
        for launched in launched_arguments(document):
            expansion = expand(document, {**launched, **arguments})
            if not _needs_arguments(expansion):
                return expansion
            if lacks and not any(map(_is_missing_argument, expansion.problems)):
                whole, lacks = expansion, False
    return whole


def _needs_arguments(expansion: Expansion) -> bool:
    """Does a file lack arguments, or is it refused with the defaults, which may be meant to be replaced?"""
    return expansion.document is None or any(map(_is_missing_argument, expansion.problems))


def _is_missing_argument(problem: Problem) -> bool:
    return isinstance(problem, ExpansionFailure) and problem.kind is Failure.ARGUMENT


def _documents(expansions: Iterable[Expansion], document: Document) -> Iterator[ExpandedDocument]:
    """The expansions that are whole: of a file that another one includes there may be a part only."""
    for expansion in expansions:
        expanded = expansion.document
        if expanded is None or not is_complete(expanded):
            continue
        if is_included(document) and _lacks_parts(expanded):
            continue
        expanded.library = document.library
        yield expanded


def _unreached(
    found: Iterable[Problem], document: Document, partial: Iterable[ExpandedDocument]
) -> Iterator[Problem]:
    """The problems as those that no expansion reached, but for what a partial one has left as it is.

    An include that every expansion passes has found its file: by what a launch file gives.
    """
    left = {start for part in partial for start in part.provenance.offsets_in(document.path)}
    for problem in found:
        starts = document.scan.starts
        number = bisect_right(starts, problem.span.start) - 1
        if number >= 0 and starts[number] in left:
            yield problem
        elif not (_is_missing_file(problem) and _is_passed(document, number)):
            yield dormant(problem)


def _is_uncalled(problem: Problem, document: Document) -> bool:
    """Is an expression that fails in a macro that no file of the project calls?"""
    if not isinstance(problem, ExpansionFailure) or problem.kind is not Failure.EXPRESSION:
        return False
    number = bisect_right(document.scan.starts, problem.span.start) - 1
    around = document.elements[number].around if number >= 0 else ()
    macros = (each.attributes.get("name", "") for each in around if keyword(each) == "macro")
    return any(name and not is_called(document, name) for name in macros)


def _is_missing_file(problem: Problem) -> bool:
    return isinstance(problem, ExpansionFailure) and problem.kind is Failure.FILE


def _is_passed(document: Document, number: int) -> bool:
    """Does every expansion come to an element, outside of branches and macros?"""
    return number >= 0 and not any(
        keyword(each) in {"if", "unless", "macro"} for each in document.elements[number].around
    )


def stops(problem: Problem) -> bool:
    """Whether an expansion that reaches a problem fails for it, in words that do not say so."""
    if getattr(problem, "is_dormant", False):
        return False
    if isinstance(problem, WrongXacroAttribute):
        return problem.is_fatal
    if isinstance(problem, OddParameter):
        return problem.is_fatal
    return isinstance(problem, UndefinedArgument | UndefinedBlock)


_NAME_ALONE = re.compile(r"\$\{\s*\w+\s*\}")


_OF_MACROS = (OddParameter, UnevaluatedExpression, WrongXacroAttribute)
"""On the line of a macro, these say that what it takes is not written as it is meant."""


def _line(span: Span) -> tuple[Path, int]:
    return span.source.path, span.begin.line


def _merged(found: list[Problem]) -> Iterator[Problem]:
    """The first of the problems of one kind at one place, and of those with one undefined name.

    Calls that give a macro what it asks for without taking it follow from that.
    """
    names: dict[tuple[type, str], list[UndefinedMacro | UndefinedProperty]] = {}
    asked: dict[tuple[Path, str], list[int]] = {}
    for problem in found:
        if isinstance(problem, UndefinedProperty):
            insort(asked.setdefault((problem.span.source.path, problem.name), []), problem.span.start)
    seen = set()
    unclear = {_line(each.span) for each in found if isinstance(each, _OF_MACROS)}
    for problem in found:
        if (
            isinstance(problem, WrongMacroArguments)
            and problem.definition
            and _line(problem.definition) in unclear
        ):
            continue
        key = type(problem), _subject(problem)
        if key in seen:
            continue
        seen.add(key)
        if isinstance(problem, UndefinedMacro | UndefinedProperty):
            names.setdefault((type(problem), problem.name), []).append(problem)
        elif not (isinstance(problem, WrongMacroArguments) and _is_asked_for(problem, asked)):
            yield problem
    for first, *others in names.values():
        places = tuple(other.span for other in others)
        ends = tuple(end for one in (first, *others) for end in one.ends)
        yield first.changed(others=places, ends=ends)


def _is_asked_for(call: WrongMacroArguments, asked: Mapping[tuple[Path, str], Sequence[int]]) -> bool:
    """Is a parameter that a macro does not take undefined in its body? ``asked``: file and name → where, in order."""
    macro = call.definition
    if macro is None or call.kind is not Mismatch.UNKNOWN:
        return False
    for name in call.names:
        places = asked.get((macro.source.path, name), ())
        n = bisect_right(places, macro.start)
        if n < len(places) and "</xacro:macro>" not in macro.source.text[macro.start : places[n]]:
            return True
    return False


def _subject(problem: Problem) -> object:
    """The subject of a problem: a package, argument or key that is not known is one, wherever it is asked for.

    So is a value that is wrong, where an expression is only its name.
    """
    if isinstance(problem, UnknownPackage):
        return problem.name
    if isinstance(problem, ExpansionFailure) and (problem.kind is Failure.ARGUMENT or problem.is_absence):
        return problem.detail
    if isinstance(problem, ExpansionFailure) and _NAME_ALONE.fullmatch(problem.span.text):
        return problem.span.text, problem.detail
    return problem.span.source.path, problem.span.start, problem.span.end


def is_complete(document: Document) -> bool:
    """Whether a document can stand alone: a robot with links, or SDFormat."""
    root = document.root
    return root is not None and (document.kind is not Kind.URDF or root.has("link"))


def _needs_includer(problem: Problem) -> bool:
    """Whether a file that includes this one may give what an expansion lacks."""
    lacks_block = isinstance(problem, ExpansionFailure) and problem.lacks_block
    return (
        lacks_block
        or _is_missing_argument(problem)
        or isinstance(problem, UndefinedMacro | UndefinedProperty)
    )


# The parts of an expansion that depend on values, packages or files that are not known.
#
# An expression without a value is still in the expansion, as it is written: ``$(arg name)``.

_ADDRESSES = frozenset({"filename", "parameters", "texture", "uri"})
"""Attributes and elements that are addresses of files: nothing else in the robot depends on them."""
_SHAPING = frozenset({"child", "inertia", "joint", "link", "mass", "name", "parent", "reference", "type"})
"""Attributes and elements on which the links and joints depend that consumers build."""

_SHAPED = frozenset({"inertial", "joint", "link", "robot", "visual"})
"""Elements that have another meaning for the robot with another child in them, or define a material for others."""


def has_unknown_value(span: Span) -> bool:
    """Have the expressions at a place of an expansion no value?"""
    return is_unknown(getattr(span, "value", None) or "")


class UnknownParts:
    """``is_whole``: all links, joints and materials are there; the rest decides nothing about what is built of them."""

    def __init__(self, document: ExpandedDocument) -> None:
        self._provenance = document.provenance
        self._places: set[tuple[str, int]] = set()
        self.is_whole = True
        for element in document.elements:
            region = self._region(element)
            for each in region.walk() if region is not None else ():
                self._places.add(self._place(each.index))

    def touch(self, span: Span) -> bool:
        """Does what is at a place depend on something that is not known?"""
        number = self._provenance.last_before(span.source, span.start)
        return has_unknown_value(span) or (number >= 0 and self._place(number) in self._places)

    def _place(self, number: int) -> tuple[str, int]:
        return str(self._provenance.source(number).path), self._provenance.offset(number)

    def _region(self, element: Element) -> Element | None:
        """The element that has another meaning for what is not known of this one."""
        parent = element.parent
        if parent is None:
            return None
        is_left = element.name.startswith(PREFIX)
        unknown = {name for name, text in element.attributes.items() if is_unknown(text)}
        if is_unknown(element.content):
            unknown.add(element.name)
        if not is_left and unknown <= _ADDRESSES:
            return element if unknown else None
        is_setting = parent.name == "gazebo" and "reference" in parent.attributes
        is_part = is_left and parent.name in _SHAPED
        if is_setting or is_part or unknown & _SHAPING or element.document.kind is not Kind.URDF:
            self.is_whole = False
        return element if parent.parent is None else parent
