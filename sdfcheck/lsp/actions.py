"""Actions on a text: fixes, refactorings, and other texts that are made of it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import count
from typing import TYPE_CHECKING

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.fix import TextEdit
from sdfcheck.lint.fix.fixer import Lint, fix_file, harmless
from sdfcheck.lint.one_file import Selected, lint_file
from sdfcheck.lint.suppress.add_ignores import ignoring
from sdfcheck.lsp.cursor import Cursor, Part, at, elements
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.decode import decode
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span, escape
from sdfcheck.xacro.language import BUILT_IN, KEYWORDS, PREFIX, is_literal, matches
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.static.definitions import own_words, reading, visible_definitions
from sdfcheck.xacro.static.project import project_names

if TYPE_CHECKING:
    from sdfcheck.convert.result import Conversion


_LINES = 20_000
"""Of longer texts all that lies between the first and the last difference is replaced."""


class Offer(NamedTuple):
    """Something that can be done about a diagnostic; ``is_fix`` is False for silencing it."""

    title: str
    diagnostic: Diagnostic
    edits: tuple[TextEdit, ...]
    is_fix: bool
    is_safe: bool


def offers(workspace: Workspace, buffer: Buffer, found: Sequence[Diagnostic], at: Span) -> list[Offer]:
    """The actions for the diagnostics that touch a range: fixes first, safe ones before others."""
    touched = [each for each in found if each.span.start <= at.end and at.start <= each.span.end]
    fixes = _harmless(workspace, buffer, [fix for each in touched for fix in _fixes(each)])
    silences = [silence for each in touched for silence in _silences(workspace, buffer, each)]
    return [*sorted(fixes, key=lambda offer: not offer.is_safe), *silences]


def _harmless(workspace: Workspace, buffer: Buffer, fixes: Sequence[Offer]) -> list[Offer]:
    file, lint = _trial(workspace, buffer)
    given = [(offer, offer.diagnostic.fix) for offer in fixes]
    kept = set(harmless(file, [fix for _, fix in given if fix is not None], lint))
    return [offer for offer, fix in given if fix in kept]


def _trial(workspace: Workspace, buffer: Buffer) -> tuple[Selected, Lint]:
    """An open text as a file, and how to lint what becomes of it."""
    settings = workspace.settings_for(buffer.path)

    def lint(file: Selected) -> tuple[Sequence[Diagnostic], int]:
        return lint_file(file, workspace.book, settings, workspace.caches)

    return Selected(buffer.path, buffer.data, buffer.kind), lint


def _fixes(diagnostic: Diagnostic) -> Iterator[Offer]:
    fix = diagnostic.fix
    if fix is not None and fix.edits:
        title = fix.title if fix.is_safe else f"{fix.title} (unsafe)"
        title = title[:1].upper() + title[1:]
        yield Offer(title, diagnostic, fix.edits, True, fix.is_safe)


def _silences(workspace: Workspace, buffer: Buffer, diagnostic: Diagnostic) -> Iterator[Offer]:
    rules = tuple(workspace.facts(buffer.path).values())
    document = buffer.document
    if diagnostic.span.source.text != document.source.text:
        return
    edits = ignoring(document, diagnostic, rules)
    if edits:
        is_near = edits[0].span.start > document.scan.starts[0]
        where = "here" if is_near else "in this file"
        yield Offer(f"Ignore {diagnostic.name} {where}", diagnostic, tuple(edits), False, True)


def fix_all(workspace: Workspace, buffer: Buffer) -> list[TextEdit]:
    """The edits that all safe fixes of an open text come to; none where they would do no good."""
    file, lint = _trial(workspace, buffer)
    fixed_file = fix_file(file, lint, unsafe=False)
    if not fixed_file.fixed:
        return []
    return differences(buffer.source, decode(fixed_file.after, buffer.path)[0].text)


def differences(source: Source, after: str) -> list[TextEdit]:
    """The edits that turn a text into another, line by line."""
    from difflib import SequenceMatcher

    before = source.text
    if before == after:
        return []
    old, new = before.splitlines(keepends=True), after.splitlines(keepends=True)
    same = next(
        (n for n, pair in enumerate(zip(old, new, strict=False)) if pair[0] != pair[1]),
        min(len(old), len(new)),
    )
    rest = min(len(old), len(new)) - same
    tail = next((n for n in range(rest) if old[-1 - n] != new[-1 - n]), rest)
    start = sum(map(len, old[:same]))
    middle, other = old[same : len(old) - tail], new[same : len(new) - tail]
    if len(middle) > _LINES:
        return [TextEdit(source.span(start, start + sum(map(len, middle))), "".join(other))]
    edits = []
    places = [start]
    for line in middle:
        places.append(places[-1] + len(line))
    for kind, first, last, begin, end in SequenceMatcher(None, middle, other, autojunk=False).get_opcodes():
        if kind != "equal":
            edits.append(TextEdit(source.span(places[first], places[last]), "".join(other[begin:end])))
    return edits


# Giving a value a name and elements a macro, so that the expansion stays as it is.


_WORDS = re.compile(r"(?:\$\{[^}]*\}|\$\([^)]*\)|\S)+")
_SIMPLE = re.compile(r"\s*[^\W\d]\w*\s*")
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_IN_CODE = re.compile(r"'[^']*'|\"[^\"]*\"|[^\W\d]\w*|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_LITERAL = re.compile(
    r"\s*(?:[-+]?[\d._]+(?:[eE][-+]?\d+)?|[-+]?(?:nan|inf(?:inity)?)|true|false)\s*", re.IGNORECASE
)
"""Texts that xacro takes for numbers and truth values: a property would hold another text."""
_VALUED = {"property": {"value", "default"}, "arg": {"default"}, "if": {"value"}, "unless": {"value"}}
"""Element of xacro → the attributes whose values may be given a name."""
_MOVABLE = frozenset({"if", "unless", "attribute", "element", "call"})
"""The elements of xacro that do the same in a macro."""
_IN_DOUBLE_QUOTES = {'"': "&quot;"}
_SCOPES = frozenset({"if", "unless", "macro"})
"""The elements of xacro in which a definition counts where it is carried out."""


class Extraction(NamedTuple):
    """Something that can be given a name."""

    title: str
    edits: tuple[TextEdit, ...]


def extractions(document: Document, chosen: Span) -> Iterator[Extraction]:
    """Ways to give a name to what is selected, or to the value at a place."""
    root = document.root
    if document.kind is not Kind.XACRO or root is None or not document.is_wellformed:
        return
    if PREFIX.rstrip(":") not in root.declared:
        return  # else its elements would mean nothing
    if (found := _property(document, chosen)) is not None:
        yield found
    if (found := _macro(document, chosen)) is not None:
        yield found


def _word(element: Element) -> str:
    """The word of the language that an element is; empty for all others, and for calls of macros."""
    word = element.name.removeprefix(PREFIX)
    return word if element.name.startswith(PREFIX) and word in KEYWORDS else ""


def _is_call(element: Element) -> bool:
    return element.name.startswith(PREFIX) and _word(element) in {"", "call"}


# Properties


def _property(document: Document, chosen: Span) -> Extraction | None:
    cursor = at(document, chosen.start)
    if cursor is None or cursor.part not in {Part.VALUE, Part.TEXT} or chosen.end > cursor.span.end:
        return None
    if cursor.element.parent is None:
        return None  # there is nothing before the root
    own = _word(cursor.element)
    if own and cursor.attribute not in _VALUED.get(own, ()):
        return None
    piece = _piece(cursor, chosen)
    if piece is None:
        return None
    place, value, is_code = piece
    name = _free(document, _name_for(cursor))
    holder = _holder(cursor.element)
    if not is_literal(value) and any(_word(each) == "property" for each in holder.below):
        return None  # which may be read in it
    text = f'<xacro:property name="{name}" value="{escape(value, _IN_DOUBLE_QUOTES)}"/>'
    edits = (_before(holder, text), TextEdit(place, name if is_code else f"${{{name}}}"))
    return Extraction(f"Extract property `{name}`", edits)


def _piece(cursor: Cursor, chosen: Span) -> tuple[Span, str, bool] | None:
    """The part of a value that gets a name, the value of the property, and whether it is in an expression."""
    whole = cursor.span
    source, text = whole.source, chosen.text
    if "&" in whole.text:
        return None
    place = source.span(chosen.start + len(text) - len(text.lstrip()), chosen.start + len(text.rstrip()))
    if not text:
        words = (source.span(*word.span()) for word in _WORDS.finditer(source.text, whole.start, whole.end))
        place = next((word for word in words if word.start <= chosen.start <= word.end), whole)
    for match in matches(whole.text):
        span = source.span(whole.start + match.start(), whole.start + match.end())
        is_apart = chosen.end <= span.start or span.end <= chosen.start
        if is_apart or (chosen.start <= span.start and span.end <= chosen.end):
            continue
        if match["code"] is None:
            return None
        number = _number(source.span(span.start + 2, span.end - 1), chosen)
        if number is not None:
            return number, number.text, True
        return None if text or _SIMPLE.fullmatch(match["code"]) else (span, span.text, False)
    value = _value(place, cursor) if place.text else None
    return None if value is None else (place, value, False)


def _number(code: Span, chosen: Span) -> Span | None:
    """The number of an expression that is selected, or at a place."""
    for match in _IN_CODE.finditer(code.text):
        start, end = code.start + match.start(), code.start + match.end()
        is_chosen = (start, end) == (chosen.start, chosen.end)
        is_at = chosen.start == chosen.end and start <= chosen.start <= end
        if match[0][0] in ".0123456789" and (is_chosen or is_at):
            return code.source.span(start, end)
    return None


def _value(place: Span, cursor: Cursor) -> str | None:
    """The value of a property that expands to a text; None where that is not certain."""
    text = place.text
    if not is_literal(text):
        first = next(matches(text), None)
        is_one = first is not None and first["code"] is not None and first.span() == (0, len(text))
        return text if is_one or re.search(r"[A-Za-z/]{2}|\s", _outside(text)) else None
    if not _LITERAL.fullmatch(text):
        return None if text[0] in "'\"" or "$" in text else text
    around = place.source.text[place.start - 1], place.source.text[place.end]
    is_word = all(sign.isspace() or sign in "\"'<>" for sign in around)
    return text if is_word and _NUMBER.fullmatch(text) and _means_the_same(text, cursor) else None


def _means_the_same(text: str, cursor: Cursor) -> bool:
    """Does a number mean the same where it is, in the way in which xacro would write it?"""
    as_written = str(int(text)) if re.fullmatch(r"[-+]?\d+", text) else repr(float(text))
    is_text = cursor.attribute == "name" or _word(cursor.element) == "arg"
    words = _WORDS.findall(cursor.span.text)
    is_numbers = all(_NUMBER.fullmatch(word) or word.startswith("${") for word in words)
    return as_written == text or (is_numbers and not is_text)


def _outside(text: str) -> str:
    """A text without its expressions."""
    pieces, end = [], 0
    for match in matches(text):
        pieces.append(text[end : match.start()])
        end = match.end()
    return "".join([*pieces, text[end:]])


def _name_for(cursor: Cursor) -> str:
    element = cursor.element
    parent = element.parent
    words = [element.name.rpartition(":")[2], cursor.attribute] if cursor.attribute else [element.name]
    if _word(element) and "name" in element.attributes:
        words = [element.attributes["name"], cursor.attribute]
    elif cursor.part is Part.TEXT and parent is not None and parent.parent is not None:
        words.insert(0, parent.name)
    return "_".join(words)


def _free(document: Document, wanted: str) -> str:
    """A name that nothing else has, made of the one that is wanted."""
    visible = visible_definitions(document)
    taken = visible.properties | visible.parameters | visible.words | BUILT_IN | KEYWORDS
    taken = taken | visible.macros.keys() | project_names(document)
    taken = taken | {name for read in visible.readings for name in read.arguments}
    plain = re.sub(r"\W+", "_", wanted).strip("_").lower() or "value"
    plain = f"value_{plain}" if plain[0].isdigit() else plain
    return next(name for n in count(1) if (name := plain if n == 1 else f"{plain}_{n}") not in taken)


def _holder(element: Element) -> Element:
    """The outermost element around one that is carried out just when it is: a definition may be put before it.

    The content of a call is a block, to which nothing can be added.
    """
    calls = [each for each in element.around if _is_call(each)]
    found = calls[-1] if calls else element
    while (above := found.parent) is not None and above.parent is not None and _word(above) not in _SCOPES:
        found = above
    return found


def _before(element: Element, *lines: str) -> TextEdit:
    """Lines before an element, as far to the right as it is."""
    start = element.document.spans.place(element).start
    indent = _indent(element.document, start)
    return TextEdit(
        element.document.source.span(start, start), "".join(f"{line}\n{indent}" for line in lines)
    )


def _indent(document: Document, start: int) -> str:
    text = document.source.text
    line = text[text.rfind("\n", 0, start) + 1 : start]
    return line if not line.strip() else line[: len(line) - len(line.lstrip())]


# Macros


def _macro(document: Document, chosen: Span) -> Extraction | None:
    taken = _chosen(document, chosen)
    if not taken or not _is_movable(taken):
        return None
    around = [taken[0], *taken[0].around]
    top = around[-2]  # below the root
    name = _free(document, f"{taken[0].attributes.get('name', taken[0].name)}_macro")
    passed = sorted(_passed(document, taken))
    at_top, whole = (
        _start(top),
        document.source.span(_start(taken[0]), document.spans.place(taken[-1]).close_end),
    )
    indent = _indent(document, at_top)
    params = f' params="{" ".join(passed)}"' if passed else ""
    definition = [
        f'<xacro:macro name="{name}"{params}>',
        *_lines(whole, _indent(document, whole.start), f"{indent}  "),
        f"{indent}</xacro:macro>",
        indent,
    ]
    given = "".join(f' {each}="${{{each}}}"' for each in passed)
    call = TextEdit(whole, f"<xacro:{name}{given}/>")
    if whole.start == at_top:  # where one edit only can begin
        edits: tuple[TextEdit, ...] = (TextEdit(whole, "\n".join(definition) + call.text),)
    else:
        edits = (TextEdit(document.source.span(at_top, at_top), "\n".join(definition)), call)
    return Extraction(f"Extract macro `{name}`", edits)


def _start(element: Element) -> int:
    return element.document.spans.place(element).start


def _chosen(document: Document, chosen: Span) -> Sequence[Element]:
    """The elements beside each other that a selection holds, if it holds nothing else."""
    text = chosen.text
    start, end = chosen.start + len(text) - len(text.lstrip()), chosen.start + len(text.rstrip())
    if start >= end or document.source.text[start] != "<":
        return ()
    spans = document.spans
    following = elements(document).around(start)
    if following is None or _start(following) != start or following.parent is None:
        return ()
    found: list[Element] = []
    while following is not None and spans.place(following).close_end <= end:
        found.append(following)
        following = following.next()
    return found if found and spans.place(found[-1]).close_end == end else ()


def _is_movable(taken: Iterable[Element]) -> bool:
    """Do elements make the same in a macro: they define no name, and are no block of a call?"""
    for element in taken:
        if any(_is_call(each) for each in element.around):
            return False
        if any(_word(each) not in _MOVABLE for each in element.walk() if _word(each)):
            return False
    return True


def _passed(document: Document, taken: Sequence[Element]) -> set[str]:
    """The names that elements read and that only the macro knows in which they are."""
    holder = next((each for each in taken[0].around if _word(each) == "macro"), None)
    if holder is None:
        return set()
    read = reading(document)
    words = {word for element in taken for each in element.walk() for word in own_words(each)}
    macros = (macro for macro in read.macros if macro.element is holder)
    own = {parameter.name for macro in macros for parameter in macro.parameters if not parameter.is_block}
    return words & (own | {each.name for each in read.properties if each.macro is holder})


def _lines(whole: Span, before: str, after: str) -> list[str]:
    """The lines of a text, as far to the right as ``after`` says."""
    first, *rest = whole.text.split("\n")
    return [after + first, *(after + line.removeprefix(before) if line.strip() else line for line in rest)]


# The robot of an open text, expanded where it is xacro, and the texts that are made of it.


_ROBOTS = frozenset({Kind.SDF, Kind.URDF})


class Robot(NamedTuple):
    """A document that describes a robot or world, and the files that it was made of."""

    document: Document
    files: tuple[Source, ...]


class Place(NamedTuple):
    """Lines of a made text, from 0, and the place that they come from."""

    first: int
    last: int
    span: Span


def robot_of(workspace: Workspace, buffer: Buffer, arguments: Mapping[str, str] | None = None) -> Robot:
    """The robot that a text describes; ``arguments`` are for xacro, over those of the configuration.

    Raises:
        WrongUsage: it describes none, or cannot be expanded.
    """
    from sdfcheck.robot.includes.included import refuse_too_many

    document = workspace.document(buffer.path)
    files: tuple[Source, ...] = ()
    if document is not None and document.kind is Kind.XACRO:
        document = _expanded(workspace, document, arguments or {})
        files = tuple(document.provenance.files)
    if document is None or document.root is None or document.kind not in _ROBOTS:
        raise WrongUsage(
            f"{buffer.path.name} looks like {buffer.kind.description}, not like a robot or world"
        )
    refuse_too_many(document)
    return Robot(document, files or (document.source,))


def _expanded(workspace: Workspace, document: Document, arguments: Mapping[str, str]) -> ExpandedDocument:
    from sdfcheck.xacro.prepare import expand_as_launched

    settings = workspace.settings_for(document.path)
    expander, sets, _ = workspace.caches.xacro(settings, document.path)
    if expander is None:
        raise WrongUsage("the setting expandXacro is off")
    done = expand_as_launched(document, expander.expand, {**(sets[0] if sets else {}), **arguments})
    if done.document is None:
        first = done.problems[0].span if done.problems else document.source.span(0, 0)
        place = f"{first.source.path.name}:{first.begin.line}"
        raise WrongUsage(f"{document.path.name} cannot be expanded: see the diagnostics of {place}")
    done.document.library = document.library
    return done.document


def expanded_text(
    workspace: Workspace, buffer: Buffer, arguments: Mapping[str, str] | None = None
) -> tuple[str, list[Place]]:
    """The text to which a xacro file expands, and where each of its elements was written.

    Raises:
        WrongUsage: as for :func:`robot_of`; or there is nothing to expand.
    """
    document = workspace.document(buffer.path)
    if document is None or document.kind is not Kind.XACRO:
        raise WrongUsage(f"{buffer.path.name} is {buffer.kind.description}: there is nothing to expand")
    expanded = _expanded(workspace, document, arguments or {})
    source, scan = expanded.source, expanded.scan
    places = [
        Place(
            source.position(scan.starts[element.index]).line - 1,
            source.position(scan.close_ends[element.index]).line - 1,
            element.span,
        )
        for element in expanded.elements
    ]
    return source.text, places


def converted(
    workspace: Workspace, buffer: Buffer, to: str, arguments: Mapping[str, str] | None = None
) -> Conversion:
    """The conversion of a text to ``"sdf"`` or ``"urdf"``, verified.

    Raises:
        WrongUsage: as for :func:`robot_of`; or there is no such conversion.
        NotConvertible: its own consumer refuses the text, or the target cannot say it in any way.
    """
    from sdfcheck.convert.call import convert
    from sdfcheck.robot.root import root_of

    return convert(root_of(robot_of(workspace, buffer, arguments).document), to)


def canonical_edits(workspace: Workspace, buffer: Buffer) -> Iterable[TextEdit]:
    """The edits that bring a text into canonical form.

    Raises:
        WrongUsage: it has none, or is broken.
    """
    from sdfcheck.convert.canonical import CanonicalStyle, canonical

    document = workspace.document(buffer.path)
    if document is not None and document.kind is Kind.XACRO:
        raise WrongUsage("xacro has no canonical form: `sdfcheck print` would expand it")
    if document is None or document.root is None or document.kind not in _ROBOTS:
        raise WrongUsage(
            f"{buffer.path.name} looks like {buffer.kind.description}, not like a robot or world"
        )
    return differences(buffer.source, canonical(document, CanonicalStyle()).text)


def keeps_expansion(workspace: Workspace, buffer: Buffer, edits: Iterable[TextEdit]) -> bool:
    """Does a text expand to the same elements after edits? Also true where it is not expanded on its own."""
    from sdfcheck.source.splice import replaced
    from sdfcheck.xacro.static.definitions import is_robot

    document = workspace.document(buffer.path)
    if document is None or not is_robot(document):
        return True
    try:
        before = _expanded(workspace, document, {})
    except WrongUsage:
        return True
    text = replaced(document.source.text, [(edit.span.start, edit.span.end, edit.text) for edit in edits])
    changed = Document(Source(document.path, text), Kind.XACRO, [])
    changed.library = document.library
    try:
        after = _expanded(workspace, changed, {})
    except WrongUsage:
        return False
    return _content(before) == _content(after)


def _content(document: Document) -> list[tuple[str, list[tuple[str, object]], object, int]]:
    """The elements with their attributes and texts; numbers as what they mean."""
    return [
        (
            element.name,
            [(name, _meaning(value)) for name, value in element.attributes.items()],
            _meaning(element.content),
            len(list(element.around)),
        )
        for element in document.elements
    ]


def _meaning(text: str) -> tuple[object, ...]:
    return tuple(map(_as_number, text.split()))


def _as_number(word: str) -> object:
    try:
        return float(word)
    except ValueError:
        return word
