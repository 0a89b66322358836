"""Expressions that are wrong whatever the values: recognized by the text alone."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Sequence
from keyword import iskeyword

from sdfcheck.formats.near_names import guess, nearest
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import COMMANDS, PREFIX, expressions, is_literal, replaced
from sdfcheck.xacro.problems import (
    ExpansionFailure,
    Failure,
    UndefinedArgument,
    UndefinedBlock,
    UnevaluatedExpression,
)
from sdfcheck.xacro.static.definitions import Definitions, knows_all
from sdfcheck.xacro.static.elements import is_conditional, keyword, own_attributes
from sdfcheck.xacro.static.names import free_names
from sdfcheck.xacro.static.project import project_names
from sdfcheck.xacro.static.reading import Include, place, reading, texts

_BRACES = re.compile(r"\{([^{}$\"':,]+)\}")
_ARGUMENT = re.compile(r"arg\s+([^\s${}]+)\s*$")
_TRUTHS = frozenset({"true", "True", "false", "False"})

Found = ExpansionFailure | UndefinedArgument | UndefinedBlock | UnevaluatedExpression


def expression_problems(document: Document, visible: Definitions) -> Iterator[Found]:
    """The problems of the expressions, substitutions, conditions and inclusions of a document."""
    invalid = {each.name: each for each in reading(document).properties if _is_invalid(each.name)}
    for each in invalid.values():
        detail = f"Property names must be valid python identifiers: {each.name}"
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
    if "$" in code:
        return None  # made of what is put into it
    try:
        tree = ast.parse(code.strip(), mode="eval")
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
    """Braces around a name that is known here without their dollar, and expressions without end."""
    for element, macro in reading(document).elements:
        known = visible.properties | (visible.parameters if macro is not None else set())
        for attribute, text in texts(element, "{("):
            plain = replaced(text, lambda match: " " * len(match[0]))
            for match in _BRACES.finditer(plain):
                names = free_names(match[1])
                if names and names <= known and not _is_free(element):
                    span = place(element, attribute, match[0])
                    yield UnevaluatedExpression(span, f"${match[0]}", is_open=False)
            for rest in _endless(text, plain):
                yield UnevaluatedExpression(place(element, attribute, rest), rest, is_open=True)


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


def _commands(document: Document, visible: Definitions) -> Iterator[ExpansionFailure | UndefinedArgument]:
    declared = {name for read in visible.readings for name in read.arguments}
    for found in reading(document).commands:
        word = found.text.partition(" ")[0].strip()
        if word not in COMMANDS and "$" not in word:
            whole = f"$({found.text})"
            span = place(found.element, found.attribute, whole)
            meant = nearest(word, COMMANDS)
            detail = f"there is no `{word}`" + (f"; did you mean `{meant}`?" if meant else "")
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
                yield ExpansionFailure(span, Failure.EXPRESSION, f"`{text}` is neither true nor false")


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
