"""Why a name is not known where a xacro file uses it, and where values come from."""

from __future__ import annotations

import math
import os
import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence
from keyword import iskeyword
from pathlib import Path

from sdfcheck.files.git import is_ignored
from sdfcheck.files.packages import project_root
from sdfcheck.files.regular import names_in
from sdfcheck.files.uris import empty_folder, is_built
from sdfcheck.source.document import Document, Element
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.scan import parse_start_tag
from sdfcheck.source.text import Source, Span, Step, relative_path
from sdfcheck.xacro.language import BUILT_IN, PREFIX, expressions, is_literal, substitutions
from sdfcheck.xacro.problems import (
    NO_TRUTH,
    WRONG_NAME,
    ExpansionFailure,
    Failure,
    Problem,
    Reason,
    UndefinedMacro,
    UndefinedName,
    UndefinedProperty,
)
from sdfcheck.xacro.static.definitions import (
    Definitions,
    Macro,
    Property,
    Reading,
    free_names,
    keyword,
    lacks_prefix,
    reading,
    visible_definitions,
)
from sdfcheck.xacro.static.likely_mistakes import missing_prefixes, parameter_place
from sdfcheck.xacro.static.project import definer

# Why a name is not known where a xacro file uses it: what beginners write, in words of its own.

_FOREIGN = {
    "else": "xacro has no `else`: repeat the value in `xacro:unless`",
    "elif": "xacro has no `elif`: write `xacro:if` once more",
    "elseif": "xacro has no `elseif`: write `xacro:if` once more",
    "endif": "xacro has no `endif`: what is inside of `xacro:if` is conditional",
    "for": "xacro has no loops: let a macro call itself",
    "foreach": "xacro has no loops: let a macro call itself",
    "loop": "xacro has no loops: let a macro call itself",
    "while": "xacro has no loops: let a macro call itself",
    "param": "parameters of a macro are listed in its attribute `params`",
    "params": "parameters of a macro are listed in its attribute `params`",
    "var": "a value with a name is a `xacro:property`",
    **dict.fromkeys(("error", "fatal", "warning"), "write `${xacro.fatal('…')}` to stop with a message"),
}
"""Elements of other languages → what xacro has instead."""

_ARGUMENT = re.compile(r"(?<!['\"])\$\(arg\s+(\w+)\)")
_LONGEST = 1000
"""Characters of an expression that is looked at."""
_NO_LETTER = re.compile(r"\W")
_OF_TEXT = re.compile(r"\bstr\b|'str'|sequence")
"""In the messages of Python about texts in the place of numbers."""
_OTHER_LANGUAGES = (
    (re.compile(r"&&|&amp;&amp;"), "Python writes `and` for `&&`"),
    (re.compile(r"\|\|"), "Python writes `or` for `||`"),
    (re.compile(r"\?[^:]*:"), "Python writes `a if condition else b` for `condition ? a : b`"),
    (re.compile(r"!(?!=)"), "Python writes `not` for `!`"),
    (re.compile(r"^\$\{\s*(?:find|arg|env|optenv|eval)\s+[^\s(]"), "write it in parentheses: `$({})`"),
    (re.compile(r"^\$\([^(]*\([^)]*\)$"), "xacro ends `$(…)` at the first `)`: write `${…}`"),
    (
        re.compile(r"^\$\{[^{]*\{[^}]*\}$"),
        "xacro ends `${…}` at the first `}`: write `dict(…)` for a dictionary",
    ),
)
"""A construct that expressions do not allow → its replacement."""


def with_reason(problem: Problem, document: Document) -> Problem:
    """The same problem with the reason for it, where that is known."""
    if isinstance(problem, UndefinedProperty):
        reason = _of_property(problem, visible_definitions(document))
        reason = reason or _of_condition(problem, document)
    elif isinstance(problem, UndefinedMacro):
        reason = _of_macro(problem, visible_definitions(document))
    elif isinstance(problem, ExpansionFailure) and problem.kind is Failure.ARGUMENT:
        reason = _of_argument(problem, visible_definitions(document))
    elif isinstance(problem, ExpansionFailure) and problem.kind is Failure.EXPRESSION:
        reason = _of_expression(problem, visible_definitions(document)) or _of_value(problem, document)
    elif isinstance(problem, ExpansionFailure) and problem.kind is Failure.FILE:
        path = _path(problem, document)
        if path is not None and (folder := empty_folder(document, path)):
            return problem.changed(
                kind=Failure.SUBMODULE, detail=relative_path(folder, problem.span.source.path.parent)
            )
        if path is not None and is_ignored(path):
            return problem.changed(kind=Failure.IGNORED, detail=problem.detail.rpartition(": ")[0])
        if path is not None and is_built(document, str(path)):
            return problem.changed(kind=Failure.BUILT, detail=problem.detail.rpartition(": ")[0])
        if folder := _folder_above(problem):
            return problem.changed(kind=Failure.ABOVE, detail=folder)
        reason = _of_file(problem, document)
    else:
        return problem
    return problem if reason is None else problem.changed(reason=reason)


def _of_property(problem: UndefinedProperty, visible: Definitions) -> Reason | None:
    name = problem.name
    for asked in _ARGUMENT.findall(_expression_around(problem.span)):
        if any(read.arguments.get(asked) == name for read in visible.readings):
            return Reason(f"`$(arg {asked})` becomes that name: write `'$(arg {asked})'`")
    for read in visible.readings:
        if name in read.argument_elements:
            place = _name(read.argument_elements[name])
            return Reason(f"it is an argument: write `$(arg {name})`", place, "the argument")
    found = [each for read in visible.readings for each in read.properties if each.name == name]
    if not found:
        return _elsewhere(problem, "property", visible) or _no_parameter(problem, visible)
    first = found[0]
    if all(lacks_prefix(each.element) for each in found):
        return _unprefixed(first.element)
    place = _name(first.element)
    if all(each.macro is not None for each in found):
        if _is_inside(problem.span, found):
            return _late(problem.span, place)
        macro = first.macro.attributes.get("name", "") if first.macro is not None else ""
        words = f'it is gone at the end of macro `{macro}`, unless it has scope="parent" or scope="global"'
        return Reason(words, place, "known in the macro only")
    outside = next(each for each in found if each.macro is None)
    if outside.value is None and not outside.element.nodes:
        return Reason("it has no value", _name(outside.element), "no `value` here")
    return _late(problem.span, _name(outside.element))


def _expression_around(span: Span) -> str:
    """The ``${…}`` that a place is in, or at the beginning of the value."""
    text = span.source.text
    start = text.rfind("${", 0, span.end + 2)
    end = text.find("}", span.start)
    return text[start:end] if 0 <= start < end and end - start < _LONGEST else ""


def _is_inside(span: Span, found: list[Property]) -> bool:
    """Is a place in the body of a macro that defines the property?"""
    for each in found:
        if each.macro is not None and _is_same(span.source, each.element.document.source):
            at = each.element.document.spans.place(each.macro)
            if at.start <= span.start < at.close:
                return True
    return False


def _of_macro(problem: UndefinedMacro, visible: Definitions) -> Reason | None:
    name = problem.name.removeprefix(PREFIX)
    if name in _FOREIGN:
        return Reason(_FOREIGN[name])
    macros = visible.macros.get(name, [])
    if macros and all(lacks_prefix(each.element) for each in macros):
        return _unprefixed(macros[0].element)
    if not macros:
        return _elsewhere(problem, "macro", visible)
    return _late(problem.span, _name(macros[0].element))


def _elsewhere(problem: UndefinedName, kind: str, visible: Definitions) -> Reason | None:
    """That a file of the project defines a name, and is not included."""
    source = problem.span.source
    read = _reading_of(source, visible)
    path = None if read is None else definer(read.document, kind, problem.name.removeprefix(PREFIX))
    if read is None or path is None or any(each.document.path == path for each in visible.readings):
        return None
    above = [each.element.span for each in read.includes if not each.conditional]
    place = next(
        (each for each in reversed(above) if each.start < problem.span.start), read.elements[0][0].span
    )
    name = Path(os.path.relpath(path, source.path.parent)).as_posix()
    return Reason(
        f"`{name}` defines it, and is not included",
        place,
        "the include belongs below this",
        help=f'write `<xacro:include filename="{name}"/>` in front of it',
    )


def _no_parameter(problem: UndefinedProperty, visible: Definitions) -> Reason | None:
    """That the macro around a name does not take it: where most names that are missing belong."""
    if problem.near is not None:
        return None
    read = _reading_of(problem.span.source, visible)
    macros = read.macros if read is not None else []
    above = bisect_left(macros, problem.span.start, key=lambda each: each.element.span.start)
    if not above:
        return None
    macro = macros[above - 1]
    element, params = macro.element, macro.element.attribute("params")
    if params is None or problem.span.start >= element.document.spans.place(element).close:
        return None
    return Reason(f"macro `{macro.name}` takes no such parameter", params.span, "its parameters")


def _of_condition(problem: UndefinedProperty, document: Document) -> Reason | None:
    """The value for which xacro passes the place of a name by, so that the name is not missed."""
    read = _reading_of(problem.span.source, visible_definitions(document))
    if read is None or not problem.is_dormant:
        return None
    starts = read.document.scan.starts
    number = bisect_right(starts, problem.span.start) - 1
    around = read.document.elements[number].around if number >= 0 else ()
    branches = [each for each in around if keyword(each) in {"if", "unless"}]
    values = filter(None, (each.attribute("value") for each in branches))
    found = [giver for value in values for giver in givers(value.span, (), document)]
    if len(found) != 1 or not is_literal(found[0].text):
        return None
    name, text, place = found[0]
    return Reason(f"xacro needs it if `{name}` is not `{text}`", place, f"`{name}` is set here")


def _reading_of(source: Source, visible: Definitions) -> Reading | None:
    return next((each for each in visible.readings if _is_same(each.document.source, source)), None)


def _is_same(one: Source, other: Source) -> bool:
    """Are two texts those of one file? An expansion reads its files again."""
    return one is other or (
        one.path.name == other.path.name and os.path.realpath(one.path) == os.path.realpath(other.path)
    )


def _of_argument(problem: ExpansionFailure, visible: Definitions) -> Reason | None:
    name = problem.detail
    for read in visible.readings:
        element = read.argument_elements.get(name)
        if element is not None and "default" in element.attributes and is_literal(name):
            return _late(problem.span, _name(element))
    return None


def _of_expression(problem: ExpansionFailure, visible: Definitions) -> Reason | None:
    text = problem.expression
    command = re.fullmatch(r"\$\(\s*([^\W\d]\w*)\s*\)", text)
    if command:
        for read in visible.readings:
            for each in read.properties:
                if each.name == command[1]:
                    words = f"`{each.name}` is a property: write `${{{each.name}}}`"
                    return Reason(words, _name(each.element), "the property")
        if any(command[1] in read.arguments for read in visible.readings):
            return Reason(f"write `$(arg {command[1]})`")
        if command[1] in visible.parameters:
            return Reason(f"`{command[1]}` is a parameter: write `${{{command[1]}}}`")
    for found, words in _OTHER_LANGUAGES:
        if found.search(text):
            return Reason(words.replace("{}", text[2:-1].strip()))
    invalid = re.fullmatch(f"{WRONG_NAME} `(.*)`", problem.detail)
    return None if invalid is None else _of_name(invalid[1])


def _of_name(name: str) -> Reason | None:
    """The reason why a property cannot have a name, and another one."""
    if not name:
        return Reason("give it one")
    if iskeyword(name):
        return Reason("Python has that word")
    usable = _NO_LETTER.sub("_", name)
    return Reason(f"write `{usable}`") if usable.isidentifier() else None


def _of_value(problem: ExpansionFailure, document: Document) -> Reason | None:
    """The source of the value with which an expression fails."""
    found = givers(problem.span, problem.origins, document)
    if not found:
        return None
    name, text, place = found[0]
    label = f"`{name}` is set here"
    for asked, default, _ in found if problem.is_absence else ():
        if asked.startswith(_GIVEN):
            argument = asked[len(_GIVEN) : -1]
            words = f"the default of argument `{argument}` is `{default}`"
            return Reason(words, place, label, argument=argument)
    return Reason(f"`{name}` is `{text}`", place, label)


def _of_file(problem: ExpansionFailure, document: Document) -> Reason | None:
    name, _, why = problem.detail.rpartition(": ")
    if "package://" in name:
        package, _, rest = name.partition("package://")[2].partition("/")
        return Reason(f"xacro does not know `package://`: write `$(find {package})/{rest}`")
    if not why.startswith(("no such file", "is a directory")) or "$" in name:
        return None
    path = problem.span.source.path.parent / name
    if document.library is not None:
        for each in names_in(path.parent):
            if each.casefold() == path.name.casefold() and each != path.name:
                return Reason(f"did you mean `{each}`?")
    return _of_default(path, problem, document)


def _path(problem: ExpansionFailure, document: Document) -> Path | None:
    """Where a missing file should be, as far as that is known."""
    name = problem.detail.rpartition(": ")[0]
    return visible_definitions(document).path_of(name, document, problem.span.source.path.parent)


def _folder_above(problem: ExpansionFailure) -> str:
    """The folder of the project above a file from which an include leads somewhere; empty if there is none."""
    path, name = problem.span.source.path.absolute(), problem.detail.rpartition(": ")[0]
    if "$" in name or os.path.isabs(name):
        return ""
    root = project_root(path)
    above = (folder for folder in path.parents[1:] if folder == root or root in folder.parents)
    found = next((folder for folder in above if os.path.isfile(folder / name)), None)
    return "" if found is None else relative_path(found, path.parent)


def _of_default(path: Path, problem: ExpansionFailure, document: Document) -> Reason | None:
    """The argument of a file whose default names what is missing: with another value the path may be there."""
    read = reading(document)
    asked = {giver.name for giver in givers(problem.span, problem.origins, document)}
    missing = next((each.name for each in (*reversed(path.parents), path) if not os.path.exists(each)), "")
    for name, default in read.arguments.items():
        if default == missing if default else f"{_GIVEN}{name})" in asked:
            place = read.argument_elements[name].attribute("default")
            words = f"the default of argument `{name}` is {f'`{default}`' if default else 'empty'}"
            return Reason(words, place.span if place is not None else None, "its default", argument=name)
    return None


def _late(span: Span, place: Span) -> Reason | None:
    """That a name is defined after its use, or in another file."""
    line = place.begin.line
    if _is_same(place.source, span.source):
        if place.start < span.start:
            return None
        return Reason(f"it is defined in line {line}, after this", place, "defined here")
    return Reason(
        f"it is defined in {place.source.path.name}:{line}, which comes later", place, "defined here"
    )


def _unprefixed(definition: Element) -> Reason:
    """That a definition lacks the prefix of xacro, which is reported at the first such element of its file."""
    document = definition.document
    cause = next((each.span for each in missing_prefixes(document) if each.name == definition.name), None)
    words = f"{document.path.name}:{definition.span.begin.line} lacks the prefix `xacro:`"
    return Reason(words, definition.span, "without the prefix `xacro:`", cause)


def _name(element: Element) -> Span:
    return element.document.spans.attribute_value(element, "name")


# Where the values in an expression come from: properties, parameters and arguments.

# Where the values in an expression come from: properties, parameters and arguments, with their places.


MOST = 3
"""So many are named."""

_CALL = re.compile(r"in macro `([^`]+)`")
_NAMED_ARGUMENT = re.compile(r"arg\s+(\S+)\s*$")
_GIVEN = "$(arg "
"""The beginning of an argument among names."""


class Giver(NamedTuple):
    """The text that gives a name its value, and its place."""

    name: str
    text: str
    span: Span


def givers(span: Span, origins: Sequence[Step], document: Document, most: int = MOST) -> list[Giver]:
    """The texts that give their values to the names at a place, and to the names in these values."""
    visible = visible_definitions(document)
    found: list[Giver] = []
    waiting = [(span.text, span, tuple(origins))]
    while waiting and len(found) < most:
        text, place, way = waiting.pop(0)
        for name in _names(text):
            giver = giver_of(name, place, way, visible)
            if giver is not None and all(giver[0].span != known.span for known in found):
                found.append(giver[0])
                waiting.append((giver[0].text, giver[0].span, giver[1]))
    return found[:most]


_COMPUTING = re.compile(
    r"can't multiply sequence|for (?!\+)\S+: '|bad operand type|must be real number|not supported between"
)
"""In the messages of Python about values with which it cannot compute; what is added may be meant for texts."""
_MISNUMBERED = re.compile(
    r"\s*([-+]?(\d+[.,]?\d*|[.,]\d+)([.,]\d*|\s*[^\W\d_]{1,4}|\s*[°%])?|[-+]?(inf|nan)|[Tt]rue|[Ff]alse)\s*"
)
"""A text that is meant for a number, and may have a comma or a unit in it."""
_LONGEST_NUMBER = 40
_MOST_TRIED = 20


def at_values(found: Iterable[Problem], document: Document) -> list[Problem]:
    """The problems; an expression that fails for one value is at the value, and those that fail for it too are not."""
    moved = [_at_value(each, document) for each in found]
    at_fault = set(values_at_fault(moved))
    if not at_fault:
        return moved
    return [each for each in moved if at_fault.isdisjoint(_spans_of_givers(each, document))]


def values_at_fault(found: Iterable[object]) -> Iterator[Span]:
    """The places of the values for which expressions fail."""
    for each in found:
        if isinstance(each, ExpansionFailure) and each.kind is Failure.NUMBER:
            yield each.span


def _spans_of_givers(problem: Problem, document: Document) -> Iterator[Span]:
    if isinstance(problem, ExpansionFailure) and problem.kind is Failure.EXPRESSION:
        for each in all_givers(problem.span, problem.origins, document):
            yield each.span


def _at_value(problem: Problem, document: Document) -> Problem:
    if not isinstance(problem, ExpansionFailure) or problem.kind is not Failure.EXPRESSION:
        return problem
    if problem.detail.endswith(NO_TRUTH):
        reason = Reason("a condition asks for one of them", problem.span, "asked for here")
        kind, tried = Failure.EXPRESSION, givers(problem.span, problem.origins, document)
        given = next((each for each in tried if f"`{each.text}`{NO_TRUTH}" == problem.detail), None)
    elif _OF_TEXT.search(problem.detail):
        reason = Reason(f"`{problem.expression}` computes with it", problem.span, "computed with here")
        kind, given = Failure.NUMBER, _wrong_number(problem, document)
    else:
        return problem
    if given is None:
        return problem
    detail = given.text if kind is Failure.NUMBER else problem.detail
    return problem.changed(
        span=given.span, kind=kind, detail=detail, expression="", origins=(), reason=reason
    )


def _wrong_number(problem: ExpansionFailure, document: Document) -> Giver | None:
    """The value with which an expression cannot compute: one meant for a number, else the only text that it names."""
    found = all_givers(problem.span, problem.origins, document)
    given = misnumbered(found)
    if given is not None or not _COMPUTING.search(problem.detail):
        return given
    named = {*_names(problem.span.text)}
    texts = [
        each for each in found if each.name in named and is_literal(each.text) and not _is_number(each.text)
    ]
    return texts[0] if len(texts) == 1 else None


def all_givers(span: Span, origins: Sequence[Step], document: Document) -> list[Giver]:
    """The same as :func:`givers`, as far as somebody would follow them."""
    return givers(span, origins, document, _MOST_TRIED)


def misnumbered(found: Iterable[Giver]) -> Giver | None:
    """The first text that is meant for a number but malformed."""
    for each in found:
        text = each.text
        if len(text) <= _LONGEST_NUMBER and _MISNUMBERED.fullmatch(text) and not _is_number(text):
            return each
    return None


def _is_number(text: str) -> bool:
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def _names(text: str) -> Iterator[str]:
    for _, code in expressions(text):
        yield from sorted(free_names(code) - BUILT_IN, key=code.find)
    for _, command in substitutions(text):
        if match := _NAMED_ARGUMENT.match(command):
            yield f"{_GIVEN}{match[1]})"


def giver_of(
    name: str, place: Span, way: tuple[Step, ...], visible: Definitions
) -> tuple[Giver, tuple[Step, ...]] | None:
    """The text that gives a name its value at a place inside some calls, and the scope that it is evaluated in."""
    if name.startswith(_GIVEN):
        return _argument(name, visible)
    for depth, step in enumerate(way):
        call = _CALL.match(step.text)
        macros = visible.macros.get(call[1].rpartition(".")[2], []) if call else []
        if len(macros) > 1:
            macros = [each for each in macros if _holds(each.element, place)]
        if len(macros) == 1:
            given, is_of_caller = _inside(name, step, macros[0], visible)
            if given is not None:
                return given, way[depth + is_of_caller :]
        place = step.span
    values = [each for each in visible.given.get(name, ()) if each.macro is None and each.value is not None]
    if len(values) != 1:
        return None
    value = values[0].element.attribute("value") or values[0].element.attribute("default")
    return None if value is None else (Giver(name, value.text, value.span), ())


def _holds(macro: Element, place: Span) -> bool:
    """Is a place in a macro?"""
    whole = macro.document.spans.whole(macro)
    return whole.source.real_path == place.source.real_path and whole.start <= place.start < whole.end


def _inside(name: str, step: Step, macro: Macro, visible: Definitions) -> tuple[Giver | None, bool]:
    """The text that gives a name its value in a macro's body, and whether that is the call itself."""
    for each in visible.given.get(name, ()):
        value = each.element.attribute("value")
        if each.macro is macro.element and value is not None:
            return Giver(name, value.text, value.span), False
    for parameter in macro.parameters:
        if parameter.name != name:
            continue
        source = step.span.source
        tag = parse_start_tag(source, step.span.start - 1)[0]
        for attribute in tag.attributes:
            if attribute.name == name:
                span = source.span(attribute.value_start, attribute.value_end)
                return Giver(name, span.text, span), True
        if parameter.default is not None:
            # Its names are those of the call.
            return Giver(name, parameter.default, parameter_place(macro, parameter)), True
    return None, False


def _argument(name: str, visible: Definitions) -> tuple[Giver, tuple[Step, ...]] | None:
    """The default of an argument."""
    own = name[len(_GIVEN) : -1]
    homes = [read for read in visible.readings if own in read.argument_elements]
    value = homes[0].argument_elements[own].attribute("default") if len(homes) == 1 else None
    return None if value is None else (Giver(name, value.text, value.span), ())
