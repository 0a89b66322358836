"""The problems of a xacro file that reading it shows: no expression is evaluated."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.files.library import library_of
from sdfcheck.formats.near_names import guess, nearest
from sdfcheck.source.document import Document
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import BUILT_IN, FIND, KEYWORDS, PREFIX
from sdfcheck.xacro.problems import (
    Mismatch,
    Problem,
    UndeclaredXacroPrefix,
    UndefinedMacro,
    UndefinedProperty,
    UnknownPackage,
    UnusedMacroParameter,
    UnusedProperty,
    WrongMacroArguments,
    XacroIncludeCycle,
)
from sdfcheck.xacro.static.definitions import Definitions, is_robot, knows_all, visible_definitions
from sdfcheck.xacro.static.elements import element_problems
from sdfcheck.xacro.static.expressions import expression_problems
from sdfcheck.xacro.static.names import free_names
from sdfcheck.xacro.static.oversights import oversights, parameter_place
from sdfcheck.xacro.static.prefixes import missing_prefixes
from sdfcheck.xacro.static.project import is_included, project_names
from sdfcheck.xacro.static.reading import Call, Macro, place, reading

_DECLARED = re.compile(r"\sxmlns:xacro\s*=")


def problems(document: Document) -> Iterator[Problem]:
    """The problems of a xacro document."""
    if document.root is None:
        return
    yield from _undeclared(document)
    visible = visible_definitions(document)
    yield from missing_prefixes(document)
    yield from element_problems(document)
    yield from expression_problems(document, visible)
    yield from _undefined_macros(document, visible)
    yield from _undefined_properties(document, visible)
    yield from _wrong_arguments(document, visible)
    yield from _unused_properties(document, visible)
    yield from _unused_parameters(document, visible)
    for cycle in visible.cycles:
        if cycle.certain:
            element = cycle.include.element
            span = document.spans.attribute_value(element, "filename")
            yield XacroIncludeCycle(span, cycle.include.filename, cycle.steps)
    yield from _unknown_packages(document)
    yield from oversights(document, visible)


def _undeclared(document: Document) -> Iterator[Problem]:
    if _DECLARED.search(document.source.text):
        return
    assert document.root is not None
    uses = [each for each in document.elements if each.name.startswith(PREFIX)]
    if uses:
        name = document.spans.name(uses[0])
        span = name.source.span(name.start, name.start + len(PREFIX) - 1)
        tag = document.spans.start_tag(document.root)
        end = tag.attributes[-1].value_end + 1 if tag.attributes else tag.name_end
        yield UndeclaredXacroPrefix(span, len(uses), document.source.span(end, end))


def _undefined_macros(document: Document, visible: Definitions) -> Iterator[Problem]:
    known = {*visible.macros, *KEYWORDS}
    for call in reading(document).calls:
        if call.name in visible.macros or call.name.rpartition(".")[2] in visible.macros:
            continue
        if knows_all(document):
            near = guess(document, call.name, known, surely=False)
        else:
            elsewhere = project_names(document)
            # A definition of an include that is not here may be like a name of another library.
            near = guess(document, call.name, known if visible.is_open else known | elsewhere, surely=True)
            if near is None or call.name in elsewhere:
                continue
        yield UndefinedMacro(_called(call), call.name, near, ends=_ends(call))


def _called(call: Call) -> Span:
    """The name of the macro in a call."""
    if call.element.name == "xacro:call":
        return call.element.document.spans.attribute_value(call.element, "macro")
    span = call.element.span
    return span.source.span(span.start + len(PREFIX), span.end)


def _ends(call: Call) -> tuple[Span, ...]:
    """The name of the macro in the end tag of a call."""
    end = call.element.document.spans.end_name(call.element)
    if end is None or call.element.name == "xacro:call":
        return ()
    return (end.source.span(end.start + len(PREFIX), end.end),)


def _undefined_properties(document: Document, visible: Definitions) -> Iterator[Problem]:
    outside, inside = visible.properties, visible.properties | visible.parameters
    # A name with a hyphen, which expressions take for a minus, is reported where it is defined.
    dashed = {part for name in outside if "-" in name for part in name.split("-")}
    for found in reading(document).expressions:
        known = outside if found.macro is None else inside
        for name in sorted(free_names(found.code) - known - BUILT_IN - dashed):
            is_function = re.search(rf"(?<![\w.]){name}\s*\(", found.code) is not None
            is_certain = knows_all(document)
            candidates = known | BUILT_IN if is_function else known
            near = guess(document, name, candidates, surely=not is_certain)
            # A file that includes a library may define properties, but hardly functions.
            if not is_certain and (name in project_names(document) or (near is None and not is_function)):
                continue
            yield UndefinedProperty(place(found.element, found.attribute, found.code, name), name, near)


def _wrong_arguments(document: Document, visible: Definitions) -> Iterator[Problem]:
    for call in reading(document).calls:
        macros = visible.macros.get(call.name, [])
        if len(macros) != 1 or call.element.name == "xacro:call":
            continue
        macro = macros[0]
        if visible.is_open and macro.element.document in visible.conditional:
            continue  # another branch, which is not known, may define it in another way
        given = [name for name in call.element.attributes if not name.startswith(PREFIX)]
        taken = {p.name for p in macro.parameters if not p.is_block}
        names = tuple(p.name for p in macro.parameters)
        missing = tuple(
            p.name for p in macro.parameters if not p.is_block and not p.is_optional and p.name not in given
        )
        for name in given:
            if name not in taken:
                span = document.spans.attribute_name(call.element, name)
                near = missing[0] if len(missing) == 1 else nearest(name, taken.difference(given))
                missing = tuple(each for each in missing if each != near)
                yield WrongMacroArguments(
                    span, macro.name, Mismatch.UNKNOWN, (name,), names, _definition(macro), near=near
                )
        if missing:
            span = call.element.span
            yield WrongMacroArguments(span, macro.name, Mismatch.MISSING, missing, names, _definition(macro))
        else:
            yield from _wrong_blocks(call, macro, names)


def _wrong_blocks(call: Call, macro: Macro, names: tuple[str, ...]) -> Iterator[Problem]:
    blocks = list(call.element.children())
    if any(block.name.startswith(PREFIX) for block in blocks):
        return
    wanted = [p.name for p in macro.parameters if p.is_block]
    if len(blocks) < len(wanted):
        lacking = tuple(wanted[len(blocks) :])
        yield WrongMacroArguments(
            call.element.span, macro.name, Mismatch.MISSING_BLOCK, lacking, names, _definition(macro)
        )
    elif len(blocks) > len(wanted):
        extra = blocks[len(wanted)]
        yield WrongMacroArguments(
            extra.span, macro.name, Mismatch.EXTRA_BLOCK, (extra.name,), names, _definition(macro)
        )


def _definition(macro: Macro) -> Span:
    return macro.element.document.spans.attribute_value(macro.element, "name")


def _unused_properties(document: Document, visible: Definitions) -> Iterator[Problem]:
    if visible.is_open:
        return
    robot = is_robot(document) and not is_included(document)
    seen = set()
    for found in reading(document).properties:
        if (found.macro is None and not robot) or found.name in visible.words or found.name in seen:
            continue
        attributes = found.element.attributes
        if attributes.get("remove") or attributes.get("scope") or not found.name.isidentifier():
            continue
        seen.add(found.name)
        yield UnusedProperty(document.spans.attribute_value(found.element, "name"), found.name)


def _unused_parameters(document: Document, visible: Definitions) -> Iterator[Problem]:
    for macro in reading(document).macros:
        for parameter in macro.parameters:
            if not _is_read(parameter.name.lstrip("*"), macro, visible, set()):
                yield UnusedMacroParameter(parameter_place(macro, parameter), parameter.name, macro.name)


def _is_read(name: str, macro: Macro, visible: Definitions, seen: set[str]) -> bool:
    """Whether a macro's body reads a name, or a macro that it calls reads the caller's."""
    if name in macro.words or (macro.has_includes and (visible.is_open or name in visible.words)):
        return True
    for call in macro.calls:
        if call == "call" or call not in visible.macros:
            return True
        if call in seen:
            continue
        seen.add(call)
        for called in visible.macros[call]:
            own = {p.name.lstrip("*") for p in called.parameters if not p.forwards}
            if any(p.forwards and p.name == name for p in called.parameters):
                return True
            if name not in own and _is_read(name, called, visible, seen):
                return True
    return False


def _unknown_packages(document: Document) -> Iterator[Problem]:
    """Packages that an expansion needs for certain; in a robot the expansion itself reports the others."""
    if (library := library_of(document)) is None:
        return
    packages = library.packages(document.path)
    seen = set()
    for command in reading(document).commands:
        match = FIND.match(command.text)
        if match is None or not command.certain or match[1] in seen or "$" in match[1]:
            continue
        seen.add(match[1])
        if packages.find(match[1]) is None:
            span = place(command.element, command.attribute, command.text, match[1])
            near = nearest(match[1], set(packages.names))
            yield UnknownPackage(span, match[1], near)
