"""The problems of a xacro file that reading it shows; expressions are judged by their text."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Sequence
from keyword import iskeyword

from sdfcheck.files.library import library_of
from sdfcheck.files.packages import has_file, package_around
from sdfcheck.formats.near_names import guess, nearest
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import (
    BUILT_IN,
    COMMANDS,
    FIND,
    KEYWORDS,
    LONGEST_CODE,
    PREFIX,
    SYMBOLS,
    expressions,
    is_literal,
    replaced,
    syntax_tree,
)
from sdfcheck.xacro.problems import (
    NO_TRUTH,
    WRONG_NAME,
    CounterpartProperty,
    ExpansionFailure,
    Failure,
    Mismatch,
    Problem,
    UndeclaredXacroPrefix,
    UndefinedArgument,
    UndefinedBlock,
    UndefinedMacro,
    UndefinedProperty,
    UnevaluatedExpression,
    UnknownPackage,
    UnusedMacroParameter,
    UnusedProperty,
    WrongMacroArguments,
    XacroIncludeCycle,
)
from sdfcheck.xacro.static.definitions import (
    Call,
    Command,
    Definitions,
    Expression,
    Include,
    Macro,
    element_problems,
    free_names,
    is_conditional,
    is_robot,
    keyword,
    knows_all,
    own_attributes,
    place,
    reading,
    texts,
    visible_definitions,
)
from sdfcheck.xacro.static.likely_mistakes import missing_prefixes, oversights, parameter_place
from sdfcheck.xacro.static.project import (
    definer,
    includers,
    is_included,
    is_whole,
    passed,
    possible_files,
    project_names,
)

# Expressions that are wrong whatever the values: recognized by the text alone.


BRACES = re.compile(r"(?<!\$)\{([^{}$\"':,]+)\}")
"""An expression whose dollar was forgotten, perhaps; also the inner part of one that has it."""
_BRACELESS = re.compile(r"\$([A-Za-z_]\w*)")
"""An expression whose braces were forgotten, perhaps."""
_NUMBERS = frozenset(
    "xyz rpy size radius length scale ixx iyy izz ixy ixz iyz lower upper effort velocity damping friction".split()
)
"""Attributes of URDF that hold numbers alone."""
_NAMED = re.compile(r"(?<![\w.])[^\W\d]")
_SIGN = re.compile(r"[{($]")
_ENDLESS = re.compile(r"\$[{(]")
_IN_NUMBERS = re.compile(r"\$?\{([^{}$]+)\}|\$?([^\s{}$]+)")
"""One of the numbers, or what is in its place."""
_FOR_ANGLES = frozenset({"pi", "radians"})
_INSIDE = re.compile(r"/([^\s$<>\"]+)")
"""A path into a package."""
_ARGUMENT = re.compile(r"arg\s+([^\s${}]+)\s*$")
_TRUTHS = frozenset({"true", "True", "false", "False"})

_CONSTANTS = {"M_PI": "pi", "PI": "pi", "Pi": "pi", "M_E": "e"}
"""Names of constants elsewhere → those of xacro."""

Found = ExpansionFailure | UndefinedArgument | UndefinedBlock | UnevaluatedExpression


def expression_problems(document: Document, visible: Definitions) -> Iterator[Found]:
    """The problems of the expressions, substitutions, conditions and inclusions of a document."""
    invalid = {each.name: each for each in reading(document).properties if _is_invalid(each.name)}
    for each in invalid.values():
        detail = f"{WRONG_NAME} `{each.name}`"
        yield ExpansionFailure(
            document.spans.attribute_value(each.element, "name"), Failure.EXPRESSION, detail
        )
    yield from _expressions(document, [*invalid])
    yield from _unevaluated(document, visible)
    yield from _commands(document, visible)
    yield from _conditions(document)
    yield from _blocks(document, visible)
    for include in visible.missing:
        detail = f"{include.filename}: no such file or directory"
        yield ExpansionFailure(_filename(include), Failure.FILE, detail)
    for include in visible.unmatched:
        if not include.optional:
            yield ExpansionFailure(_filename(include), Failure.PATTERN, include.filename)


def _is_invalid(name: str) -> bool:
    return name != "" and is_literal(name) and (iskeyword(name) or not name.isidentifier())


def _expressions(document: Document, invalid: Sequence[str]) -> Iterator[ExpansionFailure]:
    """The expressions that fail, unless they use one of the ``invalid`` names."""
    for found in reading(document).expressions:
        reason = _fault(found.code, found.element)
        if reason is not None and not any(name in found.code for name in invalid):
            whole = f"${{{found.code}}}"
            span = place(found.element, found.attribute, whole)
            yield ExpansionFailure(span, Failure.EXPRESSION, reason, whole)


def _fault(code: str, element: Element) -> str | None:
    """Why a piece of code has no value in any case, None if it may have one."""
    if "$" in code or len(code) > LONGEST_CODE:
        return None  # made of what is put into it, or not read
    try:
        tree = syntax_tree(code.strip())
    except SyntaxError as error:
        return error.msg
    except (ValueError, RecursionError, MemoryError):
        return "invalid syntax"
    if any(_divides_by_zero(node) for node in ast.walk(tree)) and not is_conditional(element):
        return "division by zero"
    return None


def _divides_by_zero(node: ast.AST) -> bool:
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, ast.Div | ast.FloorDiv | ast.Mod):
        return False
    return isinstance(node.right, ast.Constant) and node.right.value == 0


def _unevaluated(document: Document, visible: Definitions) -> Iterator[UnevaluatedExpression]:
    """Names that are known here in braces without dollar, or without braces, and expressions without end."""
    outside = frozenset(visible.properties)
    inside = outside.union(visible.parameters)
    for element, macro in reading(document).elements:
        known = outside if macro is None else inside
        for attribute, text in (*texts(element, "{($"), *_named_numbers(element)):
            plain = replaced(text, lambda match: " " * len(match[0]))
            is_number = attribute in _NUMBERS and element.name[: len(PREFIX)] != PREFIX
            pieces = () if _is_free(element) else _among_numbers(plain) if is_number else _loose(plain, known)
            for start, written, code in pieces:
                names = free_names(code)
                if names and names <= (known | _FOR_ANGLES if is_number else known):
                    span = _place_at(element, attribute, start, written)
                    value = element.attribute(attribute) if attribute else None
                    yield UnevaluatedExpression(span, f"${{{code}}}", False, value, is_number)
            for rest in _endless(text, plain):
                yield UnevaluatedExpression(place(element, attribute, rest), rest, is_open=True)


def _named_numbers(element: Element) -> Iterator[tuple[str, str]]:
    """The attributes for numbers with a name in them, and without any sign of an expression."""
    for attribute, text in element.attributes.items():
        if attribute in _NUMBERS and _NAMED.search(text) and not _SIGN.search(text):
            yield attribute, text


def _place_at(element: Element, attribute: str | None, start: int, written: str) -> Span:
    """The place of a piece of a value, by where it starts there, or else where such a piece is first."""
    if attribute is not None:
        whole = element.document.spans.attribute_value(element, attribute)
        exact = whole.source.span(whole.start + start, whole.start + start + len(written))
        if exact.text == written:
            return exact
    return place(element, attribute, written)


def _among_numbers(plain: str) -> Iterator[tuple[int, str, str]]:
    """The pieces of a value for numbers, as those of a text; none where an expression has no end."""
    for match in () if _ENDLESS.search(plain) else _IN_NUMBERS.finditer(plain):
        yield match.start(), match[0], match[1] or match[2]


def _loose(plain: str, known: frozenset[str]) -> Iterator[tuple[int, str, str]]:
    """The pieces of a text that may be expressions: where and how they are written, and the code of each."""
    for match in BRACES.finditer(plain):
        yield match.start(), match[0], match[1]
    for match in _BRACELESS.finditer(plain):
        name = match[1]
        while name not in known and "_" in name:
            name = name.rpartition("_")[0]
        yield match.start(), f"${name}", name


def _endless(text: str, plain: str) -> Iterator[str]:
    """The expressions that lack their end; ``plain`` is the text without those that have one."""
    for _, code in expressions(text):
        if "${" in code:
            yield "${" + code.partition("${")[0]
    for start in (plain.find("${"), plain.find("$(")):
        if start >= 0:
            yield text[start:].strip()


def _is_free(element: Element) -> bool:
    """Whether braces may be meant: in code, templates and the like that somebody else reads."""
    return element.name in {"param", "plugin", "xacro:property"}


_IN_LAUNCH_FILES = {"find-pkg-share": "find", "find-pkg-prefix": "find", "var": "arg"}
"""Words of launch files, each with what xacro has for it."""


def _commands(document: Document, visible: Definitions) -> Iterator[ExpansionFailure | UndefinedArgument]:
    declared = {name for read in visible.readings for name in read.arguments}
    for found in reading(document).commands:
        word = found.text.partition(" ")[0].strip()
        if word not in COMMANDS and "$" not in word:
            whole = f"$({found.text})"
            span = place(found.element, found.attribute, whole)
            meant, own = nearest(word, COMMANDS), _IN_LAUNCH_FILES.get(word)
            if meant is None and own is not None:
                detail = f"`{word}` is a word of launch files: xacro has `{own}`"
            else:
                detail = f"there is no `{word}`{f'; did you mean `{meant}`?' if meant else ''}"
            yield ExpansionFailure(span, Failure.EXPRESSION, detail, whole)
        argument = _ARGUMENT.match(found.text)
        if argument and argument[1] not in declared:
            near = guess(document, argument[1], declared, surely=not knows_all(document))
            if near is not None and argument[1] not in project_names(document):
                span = place(found.element, found.attribute, found.text, argument[1])
                yield UndefinedArgument(span, argument[1], near)


def _conditions(document: Document) -> Iterator[ExpansionFailure]:
    for element, _ in reading(document).elements:
        if keyword(element) in {"if", "unless"}:
            text = own_attributes(element, "if").get("value", "0")
            if is_literal(text) and text not in _TRUTHS and not _is_whole(text):
                value = element.attribute("value")
                span = value.span if value is not None else element.span
                yield ExpansionFailure(span, Failure.EXPRESSION, f"`{text}`{NO_TRUTH}")


def _is_whole(text: str) -> bool:
    try:
        int(text)
    except ValueError:
        return False
    return True


def _blocks(document: Document, visible: Definitions) -> Iterator[UndefinedBlock]:
    known = {name.lstrip("*") for name in visible.parameters} | visible.properties
    for element, _ in reading(document).elements:
        if element.name != f"{PREFIX}insert_block":
            continue
        name = element.attributes.get("name", "")
        if name in known or not is_literal(name) or name in project_names(document):
            continue
        near = guess(document, name, known, surely=not knows_all(document))
        if near is not None:
            yield UndefinedBlock(element.document.spans.attribute_value(element, "name"), name, near)


def _filename(include: Include) -> Span:
    return include.element.document.spans.attribute_value(include.element, "filename")


_DECLARED = re.compile(r"\sxmlns:xacro\s*=")


def problems(document: Document) -> Iterator[Problem]:
    """The problems of a xacro document."""
    if document.root is None:
        return
    yield from _undeclared(document)
    visible = visible_definitions(document)
    yield from missing_prefixes(document)
    yield from element_problems(document)
    wrong = list(expression_problems(document, visible))
    yield from wrong
    yield from _undefined_macros(document, visible)
    yield from _undefined_properties(document, visible)
    yield from _wrong_arguments(document, visible)
    found = list(oversights(document, visible))
    meant = {each.near for each in found if isinstance(each, CounterpartProperty)}
    for each in wrong:
        meant |= free_names(each.meant[2:-1]) if isinstance(each, UnevaluatedExpression) else frozenset()
    unread: list[UnusedProperty | UnusedMacroParameter] = [
        *_unused_properties(document, visible),
        *_unused_parameters(document, visible),
    ]
    yield from (each for each in unread if each.name not in meant)
    for cycle in visible.cycles:
        if cycle.certain:
            element = cycle.include.element
            span = document.spans.attribute_value(element, "filename")
            yield XacroIncludeCycle(span, cycle.include.filename, cycle.steps)
    yield from _unknown_packages(document)
    yield from found


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
    defined = {*visible.macros, *KEYWORDS}
    for call in reading(document).calls:
        if call.name in visible.macros or call.name.rpartition(".")[2] in visible.macros:
            continue
        # A macro wraps one of a like name rather than that it calls itself.
        known = defined - {call.macro.attributes.get("name") if call.macro is not None else None}
        if knows_all(document):
            near = guess(document, call.name, known, surely=False)
        else:
            elsewhere = project_names(document)
            # A definition of an include that is not here may be like a name of another library.
            near = guess(document, call.name, known if visible.is_open else known | elsewhere, surely=True)
            if near is None or call.name in elsewhere or not _takes(visible.macros.get(near, ()), call):
                continue
        if _may_be_included(call.name, document, visible):
            continue
        yield UndefinedMacro(_called(call), call.name, near, ends=_ends(call))


def _takes(macros: Sequence[Macro], call: Call) -> bool:
    """Does one of the macros of a name take all that a call gives? Of keywords that is not known."""
    given = call.element.attributes.keys()
    return not macros or any(
        not each.is_clear or given <= {parameter.name for parameter in each.parameters} for each in macros
    )


def _may_be_included(macro: str, document: Document, visible: Definitions) -> bool:
    """Is a macro in a file to which the path of an include leads with another value of an argument?"""
    path = definer(document, "macro", macro)
    return path is not None and any(
        path in possible_files(document, each.filename, read.document.path)
        for read in visible.readings
        for each in read.includes
    )


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
    unclear = {macro.element for macro in reading(document).macros if not macro.is_clear}
    for found in reading(document).expressions:
        if found.macro in unclear:
            continue
        known = outside if found.macro is None else inside
        for name in sorted(free_names(found.code) - known - BUILT_IN - dashed):
            is_function = re.search(rf"(?<![\w.]){name}\s*\(", found.code) is not None
            is_certain = knows_all(document)
            candidates = known | BUILT_IN if is_function else known
            near = guess(document, name, candidates, surely=not is_certain)
            if not is_certain and name in project_names(document):
                continue
            # A file that includes a library may define properties, but hardly functions.
            is_guess = not is_certain and near is None and not is_function
            if is_guess and not document.view(_is_closed):
                continue
            span = place(found.element, found.attribute, found.code, name)
            yield UndefinedProperty(span, name, _CONSTANTS.get(name, near), is_dormant=is_guess)


def _is_closed(document: Document) -> bool:
    """Are all that a file includes, and all that include it, in the project, as far as that can be known?"""
    library = library_of(document)
    waiting, seen = [document], {document.path}
    while waiting:
        each = waiting.pop()
        if library is None or each.root is None or visible_definitions(each).reaches_out:
            return False
        for path in includers(each):
            if path not in seen:
                seen.add(path)
                found = library.document(path, Kind.XACRO, document)
                if found is None:
                    return False
                waiting.append(found)
    return is_whole(document)


def _wrong_arguments(document: Document, visible: Definitions) -> Iterator[Problem]:
    for call in reading(document).calls:
        macros = visible.macros.get(call.name, [])
        if len(macros) != 1 or call.element.name == "xacro:call":
            continue
        macro = macros[0]
        if not macro.is_clear:
            continue
        if visible.is_open and macro.element.document in visible.conditional:
            continue  # another branch, which is not known, may define it in another way
        given = [*call.element.attributes]
        taken = {p.name for p in macro.parameters if not p.is_block}
        names = tuple(p.name for p in macro.parameters)
        missing = tuple(
            p.name for p in macro.parameters if not p.is_block and not p.is_optional and p.name not in given
        )
        for name in given:
            if name not in taken:
                span = document.spans.attribute_name(call.element, name)
                near = (
                    missing[0]
                    if len(missing) == 1
                    else nearest(name.removeprefix(PREFIX), taken.difference(given))
                )
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


def _unused_properties(document: Document, visible: Definitions) -> Iterator[UnusedProperty]:
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
        if found.name in SYMBOLS:
            continue  # reported as a redefined symbol
        seen.add(found.name)
        yield UnusedProperty(document.spans.attribute_value(found.element, "name"), found.name)


def _unused_parameters(document: Document, visible: Definitions) -> Iterator[UnusedMacroParameter]:
    expressions_in: dict[Element | None, list[Expression]] = {}
    for found in reading(document).expressions:
        expressions_in.setdefault(found.macro, []).append(found)
    for macro in reading(document).macros:
        unread = [
            each for each in macro.parameters if not _is_read(each.name.lstrip("*"), macro, visible, set())
        ]
        literals = _literals_in(macro) if unread else {}
        unknown = _unknown_uses(expressions_in.get(macro.element, ()), macro, visible) if unread else {}
        for parameter in unread:
            span, literal = parameter_place(macro, parameter), literals.get(_plain(parameter.name))
            is_free = definer(document, "macro", macro.name) is None
            is_free |= not any(passed(document, macro.name, parameter.name.lstrip("*")))
            meant = nearest(parameter.name, unknown, document) if unknown else None
            cause = None if meant is None else unknown[meant]
            yield UnusedMacroParameter(span, parameter.name, macro.name, literal, is_free, cause)


def _unknown_uses(found: Iterable[Expression], macro: Macro, visible: Definitions) -> dict[str, Span]:
    """The names in the expressions of a macro's body that nothing defines, each with its first place."""
    known = {each.name for each in macro.parameters}.union(visible.properties, SYMBOLS)
    uses: dict[str, Span] = {}
    for each in found:
        for name in sorted(free_names(each.code) - known - uses.keys()):
            uses[name] = place(each.element, each.attribute, f"${{{each.code}}}", name)
    return uses


def _literals_in(macro: Macro) -> dict[str, Value]:
    """The fixed texts of elements in a macro's body, by their names without case and underscores."""
    found: dict[str, Value] = {}
    for element in macro.element.below:
        if element.content and is_literal(element.content):
            found.setdefault(_plain(element.name), element.own_value)
    return found


def _plain(name: str) -> str:
    return name.replace("_", "").lower()


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
            near = _owner(command, document) or nearest(match[1], set(packages.names))
            yield UnknownPackage(span, match[1], near)


def _owner(command: Command, document: Document) -> str | None:
    """The package of the file, if that has what is asked of another one: it may have had that name before."""
    element, own = command.element, package_around(document.path)
    written = element.text if command.attribute is None else element.attributes[command.attribute]
    path = _INSIDE.match(written.partition(f"$({command.text})")[2])
    if own is None or path is None:
        return None
    return own[1] if has_file(own[0], path[1]) else None
