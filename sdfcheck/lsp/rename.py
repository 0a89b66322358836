"""Renaming across files, and all places of a symbol."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from itertools import chain, zip_longest

from sdfcheck.lint.fix import TextEdit
from sdfcheck.lsp.names import (
    IN_XACRO,
    MOST_SEMANTICS,
    Expanded,
    Key,
    Place,
    as_written,
    everywhere,
    expansions,
    is_given,
    is_made,
    names_at,
    occurrences,
    parts_of,
    pieces,
    place_of,
    robots_about,
    roots_of,
    rows_of,
    semantics_of,
    total,
)
from sdfcheck.lsp.workspace import LiveExpander, Workspace
from sdfcheck.lsp.xacro_names import namings
from sdfcheck.robot.graph import Model, Scope
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, name_refusal, symbol_of, taken_by
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, Element
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import IN_QUOTES, Source, Span, Step, escape
from sdfcheck.xacro.language import BUILT_IN, KEYWORDS, is_literal, matches
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.static.definitions import Definitions, Macro, visible_definitions
from sdfcheck.xacro.static.reasons import giver_of

# How a new name of a part of a robot spreads through the xacro files that make the robot, and the proof of
# it.


_NODES = ("link", "joint", "frame", "model")
_DEEPEST = 8


class Refused(Exception):
    """A name that cannot be given; the message says why."""


class Spread:
    """The robots in which a file takes part, and the semantics about them; what a new name changes in all of them."""

    def __init__(self, workspace: Workspace, document: Document) -> None:
        self.workspace = workspace
        self.document = document
        own = roots_of(document)
        robots = robots_about(workspace, document) if document.kind is Kind.SRDF else own
        self._about = own if document.kind is Kind.SRDF else []
        self._robots = _unique(root for each in robots for root in roots_of(each))
        self.others: dict[str, list[Document]] = {}
        """Real path of a robot → the semantics about it that name what changes."""
        self.roots = _unique([*own, *self._robots])
        self.edits: dict[Place, TextEdit] = {}
        self.all: list[Expanded] = []
        self._names: list[dict[Key, str]] = []
        self._waiting: list[tuple[int, Key]] = []

    def is_needed(self, names: Collection[str]) -> bool:
        """Do other files than those that are like it have to be known to find all places of some names?"""
        if self.document.kind in {Kind.XACRO, Kind.SRDF}:
            return True
        self._meet(names)
        return any(self.others.values()) or any(map(is_made, self.roots))

    def _meet(self, names: Collection[str]) -> None:
        """Find the semantics that name some parts of the robots."""
        for robot in self._robots:
            if robot.kind in {Kind.URDF, Kind.XACRO}:
                own, is_whole = semantics_of(self.workspace, robot, names)
                if not is_whole:
                    raise Refused(f"more than {MOST_SEMANTICS} SRDF files may name it, too many to change")
                self.others[robot.source.real_path] = _unique([*self._about, *own])

    def _expand(self, names: Collection[str]) -> None:
        """Expand the robots, and the semantics that are about them, to find the places of some names."""
        self._meet(names)
        roots = _unique(chain(self.roots, *self.others.values()))
        self.all = [
            *(as_written(root, names) for root in roots if not is_made(root)),
            *expansions(self.workspace, [root for root in roots if is_made(root)]),
        ]
        self._names = [{} for _ in self.all]
        self.edits = {}

    # The spread

    def renamed(self, named: Occurrence, text: str) -> list[TextEdit]:
        """The edits that follow from another text at the place of a name.

        Raises:
            Refused: the name is taken or cannot be one, or more than the name would change.
        """
        kind = named.symbol.kind
        known: set[str] = set()
        names = {named.symbol.name, named.span.text.strip()}
        while not names <= known:
            known |= names
            self._expand(known)
            self._follow(named, text)
            names = {name for own in self._names for _, name in own}
        self._unreached(named)
        edits = [each for each in self.edits.values() if each.span.text != each.text]
        for edit in edits:
            if (
                not self._names_any()
                and (reason := name_refusal(kind, edit.span.text, edit.text)) is not None
            ):
                raise Refused(reason)
        self.prove(edits, {})
        return edits

    def _follow(self, named: Occurrence, text: str) -> None:
        """Write another text at the place of a name, and wherever that leads."""
        kind, span = named.symbol.kind, named.span
        is_elsewhere = named.symbol.span.source.real_path != span.source.real_path
        is_open = not named.is_definition and (named.symbol.span == span or is_elsewhere)
        keys = {key for one in self.all for key in names_at(one, span)}
        rows = (each for one in self.all for key in keys for each in one.by_name.get(key, ()))
        if is_open and not any(each.is_definition for each in rows):
            what = "robot is known that has" if is_elsewhere else "file is known that defines"
            raise Refused(f"no {what} {kind} `{named.symbol.name}`")
        self._write(span, text)
        while self._waiting:
            number, key = self._waiting.pop()
            self._everywhere_in(number, key)

    def _names_any(self) -> bool:
        return any(self._names)

    def _write(self, span: Span, text: str) -> None:
        """Write another text at a place; each name that the place expands to changes with it."""
        place = place_of(span)
        known = self.edits.get(place)
        if known is not None:
            if known.text != text:
                raise Refused(f"{_where(span)} cannot have two names: `{known.text}` and `{text}`")
            return
        self.edits[place] = TextEdit(span, text)
        for number, one in enumerate(self.all):
            for row in one.by_place.get(place, ()):
                self._name(number, row, _changed(span.text, text, total(row)))

    def _name(self, number: int, row: Occurrence, after: str | None) -> None:
        """A place comes to another value: what it names is called so from now on."""
        key = row.symbol.called
        fits = after is not None and after.startswith(row.before) and after.endswith(row.after)
        if after is None or not fits:
            raise Refused(f"{_where(row.span)} expands to `{total(row)}` in a way that cannot be followed")
        self._call(number, key, after[len(row.before) : len(after) - len(row.after)])

    def _call(self, number: int, key: Key, name: str) -> None:
        """Give a name in one expansion, and in those that are about the same robot."""
        known = self._names[number].get(key)
        if known == name or (known is None and key[1] == name):
            return
        if known is not None:
            raise Refused(f"{key[0]} `{key[1]}` cannot be called `{known}` and `{name}`")
        self._check(self.all[number], key, name)
        self._names[number][key] = name
        self._waiting.append((number, key))
        for other in self._linked(number, key[0]):
            if key in self.all[other].by_name:
                self._call(other, key, name)

    def _linked(self, number: int, kind: str) -> Iterator[int]:
        """The other expansions of the same file; the semantics of a robot, the robots of semantics."""
        own = self.all[number]
        for other, one in enumerate(self.all):
            is_other = (one.document.kind is Kind.SRDF) != (own.document.kind is Kind.SRDF)
            is_about = is_other and self._is_about(one.root, own.root) and kind in {"link", "joint"}
            if other != number and (one.root is own.root or is_about):
                yield other

    def _is_about(self, one: Document, other: Document) -> bool:
        """Is one of two files about the robot of the other?"""
        pairs = ((one, other), (other, one))
        return any(
            each.source.real_path == b.source.real_path
            for a, b in pairs
            for each in self.others.get(a.source.real_path, ())
        )

    def _check(self, one: Expanded, key: Key, name: str) -> None:
        kind = key[0]
        if (reason := name_refusal(*key, name)) is not None:
            raise Refused(reason)
        is_urdf = one.document.root is not None and one.document.root.name == "robot"
        for other in (kind,) if is_urdf or kind not in _NODES else _NODES:
            taken = one.by_name.get((other, name), ())
            if any(each.is_definition for each in taken):
                raise Refused(f"there is a {other} `{name}` already in {one.root.path.name}")

    def _everywhere_in(self, number: int, key: Key) -> None:
        """Write a new name wherever an expansion has the old one."""
        name = self._names[number][key]
        for row in self.all[number].by_name[key]:
            wanted = f"{row.before}{name}{row.after}"
            self._come_to(number, row.span, total(row), wanted)

    def _come_to(self, number: int, span: Span, value: str, wanted: str) -> None:
        """Let a place expand to another value: change what is written there, or what its expressions take."""
        text = span.text
        literal = _literal(text, value, wanted)
        if literal is not None:
            self._write(span, literal)
            return
        origins: tuple[Step, ...] = getattr(span, "origins", ())
        at = span
        for _ in range(_DEEPEST):
            found = _expression(text, value, wanted)
            given = None if found is None else self._giver(number, found[0], at, origins)
            if found is None or given is None:
                break
            at, origins = given
            text, value, wanted = at.text, found[1], found[2]
            literal = _literal(text, value, wanted)
            if literal is not None:
                known = self.edits.setdefault(place_of(at), TextEdit(at, literal))
                if known.text != literal:
                    break
                return
        raise Refused(f"{_where(span)} makes this name in a way that cannot be followed")

    def _giver(
        self, number: int, word: str, place: Span, origins: Sequence[Step]
    ) -> tuple[Span, tuple[Step, ...]] | None:
        """The place that gives a property, parameter or argument its value, and the calls around that."""
        found = giver_of(word, place, tuple(origins), visible_definitions(self.all[number].root))
        return None if found is None or not found[0].text else (found[0].span, found[1])

    # Where no expansion comes

    def _unreached(self, named: Occurrence) -> None:
        """Rename in branches that no expansion takes, and in macros that nobody calls, what is the same by its text."""
        reached = {place for one in self.all for place in one.by_place}
        before = tuple(self.edits.values())
        renamed: dict[Key, str] = {}
        for own in self._names:
            renamed.update(own)
        kinds = {named.symbol.kind, *(kind for kind, _ in renamed)}
        for element, macro in self._elements():
            for value, own_kinds, *_ in namings(element):
                span = value.span
                if (
                    place_of(span) in reached
                    or place_of(span) in self.edits
                    or not kinds.intersection(own_kinds)
                ):
                    continue
                text = self._as_elsewhere(span, macro, own_kinds, before, renamed)
                if text is not None:
                    self.edits[place_of(span)] = TextEdit(span, text)

    def _elements(self) -> Iterator[tuple[Element, Element | None]]:
        seen: set[str] = set()
        for root in _unique([*self.roots, *parts_of(self.document)]):
            for read in visible_definitions(root).readings:
                if read.document.source.real_path not in seen:
                    seen.add(read.document.source.real_path)
                    yield from read.elements

    def _as_elsewhere(
        self,
        span: Span,
        macro: Element | None,
        kinds: Sequence[str],
        edits: Iterable[TextEdit],
        renamed: dict[Key, str],
    ) -> str | None:
        """The new text of a place that no expansion reaches; None where it stays."""
        text = span.text
        for edit in edits:
            is_near = not self.all or _is_inside(edit.span, macro, span.source)
            if edit.span.text == text and is_near:
                return edit.text
        for kind in kinds:
            if is_literal(text) and (kind, text.strip()) in renamed:
                return text.replace(text.strip(), renamed[kind, text.strip()])
        is_vague = not is_literal(text) and macro is None and any(each.is_literal for each in pieces(text))
        for kind, name in renamed:
            if is_vague and kind in kinds and pieces(text, name):
                raise Refused(f"{_where(span)} may be `{name}`, and no expansion shows whether it is")
        return None

    # The proof

    def prove(self, edits: Sequence[TextEdit], arguments: Mapping[str, str]) -> None:
        """Expand the changed files: the robots must be the same but for the names; ``arguments`` have new ones.

        Raises:
            Refused: they are not.
        """
        if not self.roots or not edits:
            return
        if not self.all:
            made = [root for root in self.roots if is_made(root)]
            self.all = expansions(self.workspace, made)
            self._names = [{} for _ in self.all]
        texts = _texts(edits)
        for one, names in zip(self.all, self._names, strict=True):
            if isinstance(one.document, ExpandedDocument) and not one.is_partial:
                given = {arguments.get(name, name): value for name, value in one.arguments.items()}
                self._prove(one, one.document, given, names, texts)

    def _prove(
        self,
        one: Expanded,
        document: ExpandedDocument,
        arguments: Mapping[str, str],
        names: dict[Key, str],
        texts: dict[str, str],
    ) -> None:
        read = {os.path.abspath(source.path): source.real_path for source in document.provenance.files}
        changed = {path: texts[real] for path, real in read.items() if real in texts}
        if not changed:
            return
        expander = self.workspace.caches.xacro(
            self.workspace.settings_for(one.root.path), one.root.path
        ).expander
        assert isinstance(expander, LiveExpander)
        after = expander.tried(one.root, arguments, changed).text
        if after is None:
            raise Refused(f"{one.root.path.name} could not be expanded any more")
        wanted = _expected(document, names)
        if after == wanted:
            return
        lines = zip_longest(wanted.splitlines(), after.splitlines(), fillvalue="")
        line = next(b.strip() for a, b in lines if a != b)
        raise Refused(f"more than this name would change in {one.root.path.name}: `{line[:80]}`")


def _expected(document: ExpandedDocument, names: dict[Key, str]) -> str:
    """The expanded text with other names."""
    text = document.source.text
    if not names:
        return text
    flat = Document(Source(document.path, text), document.kind, [])
    flat.library = document.library
    places: dict[tuple[int, int], str] = {}
    for row in rows_of(flat):
        name = names.get(row.symbol.called)
        if name is not None and row.span.source is flat.source:
            places[row.span.start, row.span.end] = escape(f"{row.before}{name}{row.after}", IN_QUOTES)
    for (start, end), name in sorted(places.items(), reverse=True):
        text = text[:start] + name + text[end:]
    return text


def _texts(edits: Iterable[TextEdit]) -> dict[str, str]:
    """Real path → the text after edits."""
    texts: dict[str, str] = {}
    for edit in sorted(edits, key=lambda each: -each.span.start):
        source = edit.span.source
        text = texts.get(source.real_path, source.text)
        texts[source.real_path] = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return texts


def _unique(documents: Iterable[Document]) -> list[Document]:
    return list({each.source.real_path: each for each in documents}.values())


def _where(span: Span) -> str:
    return f"`{span.text}` in {span.source.path.name}, line {span.begin.line},"


def _is_inside(span: Span, macro: Element | None, source: Source) -> bool:
    """Is a place in the body of a macro; without one, in the same file outside of macros?"""
    if macro is None:
        return span.source.real_path == source.real_path
    whole = macro.document.spans.whole(macro)
    return whole.source.real_path == span.source.real_path and whole.start < span.start < whole.end


def _differences(before: str, after: str) -> Iterator[tuple[int, int, str]]:
    """The range of a text that is replaced and by what, as far to the right and to the left as may be."""
    shortest = min(len(before), len(after))
    head = next((n for n in range(shortest) if before[n] != after[n]), shortest)
    tail = next((n for n in range(shortest - head) if before[-1 - n] != after[-1 - n]), shortest - head)
    yield head, len(before) - tail, after[head : len(after) - tail]
    tail = next((n for n in range(shortest) if before[-1 - n] != after[-1 - n]), shortest)
    head = next((n for n in range(shortest - tail) if before[n] != after[n]), shortest - tail)
    yield head, len(before) - tail, after[head : len(after) - tail]


def _literal(text: str, value: str, wanted: str) -> str | None:
    """The text that expands to another value, changed in one literal piece; None if that is not possible."""
    for first, last, new in _differences(value, wanted):
        for piece in pieces(text, value):
            if piece.is_literal and piece.first <= first and last <= piece.last and "&" not in text:
                start = piece.start + first - piece.first
                return f"{text[:start]}{escape(new, IN_QUOTES)}{text[start + last - first :]}"
    return None


def _changed(text: str, new: str, value: str) -> str | None:
    """The value of a text whose literal pieces change; None if it is not certain."""
    if is_literal(text):
        return new.strip() if text.strip() == value else None
    old, now = list(pieces(text, value)), list(pieces(new))
    if [each.is_literal for each in old] != [each.is_literal for each in now]:
        return None
    return "".join(
        new[there.start : there.end] if there.is_literal else value[here.first : here.last]
        for here, there in zip(old, now, strict=True)
    )


def _expression(text: str, value: str, wanted: str) -> tuple[str, str, str] | None:
    """The one word whose value must change, with its value and the wanted one."""
    for first, last, new in _differences(value, wanted):
        for piece in pieces(text, value):
            if piece.is_literal or not (piece.first <= first and last <= piece.last):
                continue
            match = next(matches(text[piece.start : piece.end]), None)
            word = "" if match is None else (match["code"] or "").strip()
            if match is not None and match["command"] is not None:
                word = f"$({' '.join(match['command'].split())})"
            if word.isidentifier() or word.startswith("$(arg "):
                own = value[piece.first : piece.last]
                return word, own, own[: first - piece.first] + new + own[last - piece.first :]
    return None


# Giving something another name, wherever it is named.


_IN_EXPRESSIONS = frozenset({"property", "parameter"})
_IDENTIFIER = re.compile(r"[^\W\d]\w*")
_XML_NAME = re.compile(r"[^\W\d][\w.-]*")


class Target(NamedTuple):
    """A name that can be given anew, and the piece of its place that a person writes: the rest are expressions."""

    named: Occurrence
    piece: Span

    @property
    def shown(self) -> str:
        """The name or piece that a person changes: of a name with expressions elsewhere what it is here."""
        is_whole = self.piece == self.named.span and is_literal(self.named.symbol.name)
        return self.named.symbol.name if is_whole else self.piece.text


def target(document: Document, offset: int) -> Target | None:
    """The name that would be given anew at a place; of a name with expressions the literal piece there, or the nearest.

    Raises:
        Refused: all of the name is made by expressions.
    """
    named = occurrences(document).at(offset)
    if named is None:
        return None
    span = named.span
    if named.symbol.kind in IN_XACRO or not is_made(document) or "$" not in span.text:
        return Target(named, span)
    literal = [each for each in pieces(span.text) if each.is_literal]
    if not literal:
        words = occurrences(document).within(span)
        if not words:
            raise Refused(f"`{span.text}` is made of expressions: rename what they take")
        word = min(words, key=lambda each: abs(each.span.start - offset))
        return Target(word, word.span)
    at = offset - span.start
    nearest = min(literal, key=lambda each: max(each.start - at, at - each.end, 0))
    return Target(named, span.source.span(span.start + nearest.start, span.start + nearest.end))


def rename(workspace: Workspace, document: Document, target: Target, name: str) -> list[TextEdit]:
    """The edits that give a symbol another name, in all files of the project.

    Raises:
        Refused: the name is taken, or cannot be one; or the robots would not stay the same but for the name.
    """
    named, piece = target
    symbol, span = named.symbol, named.span
    if name == target.shown:
        return []
    spread = Spread(workspace, document)
    home = None if spread.roots or piece != span else _home(workspace, document, named)
    if home is not None:
        edits = rename(workspace, home[0], Target(home[1], home[1].span), name)
        if any(place_of(each.span) == place_of(span) for each in edits):
            return edits
    if symbol.kind in IN_XACRO or not spread.is_needed({symbol.name}):
        edits = _everywhere(workspace, document, symbol, name)
        spread.prove(edits, {symbol.name: name} if symbol.kind == "argument" else {})
        return edits
    text = span.text[: piece.start - span.start] + name + span.text[piece.end - span.start :]
    return spread.renamed(named, text)


def _home(workspace: Workspace, document: Document, named: Occurrence) -> tuple[Document, Occurrence] | None:
    """The file that defines a name of another one, and the definition, if it is written as the name is."""
    place = named.symbol.span
    home = None if named.is_definition else workspace.document(place.source.path)
    if home is None or place.source.real_path == document.source.real_path:
        return None
    found = next((each for each in occurrences(home).around(place.start) if each.is_definition), None)
    return (home, found) if found is not None and found.span.text == named.span.text else None


def _everywhere(workspace: Workspace, document: Document, symbol: Symbol, name: str) -> list[TextEdit]:
    """The edits where a name is written the same way everywhere."""
    _check_form(symbol, name)
    found = everywhere(workspace, document, symbol)
    if not any(each.is_definition for each in found):
        raise Refused(f"no file is known that defines {symbol.kind} `{symbol.name}`")
    documents = {each.span.source.path: workspace.document(each.span.source.path) for each in found}
    for other in filter(None, documents.values()):
        _check_free(other, symbol, name)
        if symbol.kind == "argument" and is_given(workspace, other, symbol.name):
            raise Refused(
                f"`{symbol.name}` is given to {other.path.name} from outside, which would not change"
            )
    return [TextEdit(each.span, _written(each, name)) for each in found]


def _written(occurrence: Occurrence, name: str) -> str:
    return escape(f"{occurrence.before}{name}{occurrence.after}", IN_QUOTES)


def _check_form(symbol: Symbol, name: str) -> None:
    """Can this be a name at all?"""
    if symbol.kind in _IN_EXPRESSIONS and not _IDENTIFIER.fullmatch(name):
        raise Refused(f"`{name}` cannot be used in expressions: write letters, digits and underscores")
    if symbol.kind == "macro" and (not _XML_NAME.fullmatch(name) or name in KEYWORDS):
        raise Refused(f"`{name}` cannot be the name of an element")
    if symbol.kind in _IN_EXPRESSIONS and name in BUILT_IN:
        raise Refused(f"`{name}` means something else in expressions")
    reason = None if symbol.kind in IN_XACRO else name_refusal(symbol.kind, symbol.name, name)
    if reason is not None:
        raise Refused(reason)
    if symbol.kind == "argument" and (not name or re.search(r"[\s$(){}]", name)):
        raise Refused(f"`{name}` cannot be the name of an argument")


def _check_free(document: Document, symbol: Symbol, name: str) -> None:
    """Is the name taken where the symbol is known?"""
    if document.kind is Kind.SRDF and not is_made(document):
        return  # it defines groups only
    taken = _taken_in_xacro if is_made(document) else _taken_in_robot
    for kind in taken(document, symbol, name):
        raise Refused(f"there is a {kind} `{name}` already in {document.path.name}")


def _taken_in_xacro(document: Document, symbol: Symbol, name: str) -> Iterator[str]:
    visible = visible_definitions(document)
    if symbol.kind == "macro":
        yield from ["macro"] * (name in visible.macros)
    elif symbol.kind == "argument":
        yield from ["argument"] * any(name in read.arguments for read in visible.readings)
    elif symbol.kind in _IN_EXPRESSIONS:
        yield from _taken_in_expressions(visible, symbol, name)
    else:
        others = (each.symbol for each in occurrences(document).all)
        yield from (other.kind for other in others if other.name == name and other.kind == symbol.kind)


def _taken_in_expressions(visible: Definitions, symbol: Symbol, name: str) -> Iterator[str]:
    """Would the name be taken for another, or another for it?"""
    macros = [macro for read in visible.readings for macro in read.macros]
    lasts = any(
        each.name == symbol.name and each.lasts for read in visible.readings for each in read.properties
    )
    own = None if lasts else next((macro for macro in macros if _is_in(symbol, macro)), None)
    if own is not None:
        if name in own.words or name in _parameters_of(own):
            yield f"name in macro `{own.name}`"
        return
    if name in visible.properties:
        yield "property"
    for macro in macros:
        if symbol.name in macro.words and name in _parameters_of(macro):
            yield f"parameter of macro `{macro.name}`"


def _parameters_of(macro: Macro) -> set[str]:
    return {parameter.name.lstrip("*") for parameter in macro.parameters}


def _is_in(symbol: Symbol, macro: Macro) -> bool:
    """Is a symbol a macro's own: a parameter, or a property in its body?"""
    whole = macro.element.document.spans.whole(macro.element)
    return whole.source is symbol.span.source and whole.start < symbol.span.start < whole.end


def _taken_in_robot(document: Document, symbol: Symbol, name: str) -> Iterator[str]:
    root = root_of(document)
    if symbol.owner:
        wanted = symbol._replace(name=name).called
        yield from [symbol.kind] * any(each.symbol.called == wanted for each in occurrences(document).all)
        return
    for scope in _scopes(root.scopes):
        if symbol.kind == "material":
            if isinstance(scope, Model) and root.is_urdf and name in scope.material_names.defined:
                yield "material"
            continue
        own = (symbol_of(node) for node in scope.nodes.values())
        is_there = any(each is not None and each.key == symbol.key for each in own)
        is_there = is_there or (root.is_urdf and symbol.kind == "joint")
        if is_there and (other := taken_by(scope, symbol.kind, name)) is not None:
            yield other.kind


def _scopes(scopes: Iterable[Scope]) -> Iterator[Scope]:
    waiting = list(scopes)
    while waiting:
        scope = waiting.pop()
        yield scope
        waiting += scope.models
