"""Typing errors: names, numbers and tags, in SDFormat, URDF and xacro alike."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from sdfcheck.source.document import Value
from sdfcheck.source.sniff import Kind
from tests.planted.page import Change, Page, is_number, literal, words, write

VECTORS = {"xyz", "rpy", "size", "pose", "gravity", "axis", "scale", "ambient", "diffuse", "specular", "rgba"}
NUMBERS = {
    "radius",
    "length",
    "mass",
    "ixx",
    "iyy",
    "izz",
    "lower",
    "upper",
    "effort",
    "velocity",
    "mu",
    "damping",
}
ATTRIBUTES = {
    "name",
    "type",
    "link",
    "joint",
    "filename",
    "value",
    "xyz",
    "rpy",
    "lower",
    "upper",
    "radius",
    "length",
    "ixx",
}


def misspelled(name: str) -> str:
    """A name in which two letters in the middle are exchanged, or one is left out."""
    for i, (a, b) in enumerate(pairwise(name)):
        if i and a != b:
            return f"{name[:i]}{b}{a}{name[i + 2 :]}"
    return name[:-1]


def misspelled_element(page: Page) -> Iterator[Change]:
    for each in page.known:
        if each.parent is not None and len(each.name) > 3:
            end = page.document.spans.end_name(each)
            name = misspelled(each.name)
            edits = [(span.start, span.end, name) for span in (each.span, end) if span is not None]
            yield Change(tuple(edits), each.span.start)


def misspelled_attribute(page: Page) -> Iterator[Change]:
    for each in page.known:
        for name in ATTRIBUTES.intersection(each.attributes):
            span = page.document.spans.attribute_name(each, name)
            yield Change(((span.start, span.end, misspelled(name)),), span.start)


def one_number_less(page: Page) -> Iterator[Change]:
    for value in _numeric(page, VECTORS):
        parts = words(value)
        if len(parts) > 2 and (
            len(parts) != 4 or value.attribute == "rgba"
        ):  # the last number of a color may lack
            yield Change(((parts[-2][1], parts[-1][1], ""),), parts[0][0])


def comma_for_dot(page: Page) -> Iterator[Change]:
    for value in _numeric(page, VECTORS | NUMBERS):
        for start, end, text in words(value):
            if "." in text.strip("."):
                yield Change(((start, end, text.replace(".", ",")),), start)


def letter_in_number(page: Page) -> Iterator[Change]:
    for value in _numeric(page, VECTORS | NUMBERS):
        for start, end, text in words(value):
            yield Change(((start, end, f"{text}O"),), start)


def undeclared_prefix(page: Page) -> Iterator[Change]:
    for each in page.named("link", "joint", "model", "visual", "collision"):
        yield Change(((each.span.end, each.span.end, ' acme:id="7"'),), each.span.start)


def unclosed_tag(page: Page) -> Iterator[Change]:
    for each in page.known:
        place = page.place(each)
        if each.parent is not None and place.close != place.close_end:
            yield Change(((place.close, place.close_end, ""),), place.start)


def wrong_end_tag(page: Page) -> Iterator[Change]:
    for each in page.known:
        end = page.document.spans.end_name(each)
        if end is not None and len(each.name) > 3:
            yield Change(((end.start, end.end, misspelled(each.name)),), end.start)


def repeated_attribute(page: Page) -> Iterator[Change]:
    for each in page.known:
        for name in each.attributes:
            span = page.document.spans.attribute_whole(each, name)
            yield Change(((span.end, span.end, span.text),), span.end)


def missing_quote(page: Page) -> Iterator[Change]:
    for each in page.known:
        for name in each.attributes:
            end = page.document.spans.attribute_whole(each, name).end
            yield Change(((end - 1, end, ""),), end - 1)


def undefined_property(page: Page) -> Iterator[Change]:
    """A property of the file is misspelled; those of other files are known where a robot includes both."""
    defined = {each.get("name", str) for each in page.all if each.name == "xacro:property"}
    for each in page.all:
        for name, text in each.attributes.items():
            inner = text[2:-1]
            if text == f"${{{inner}}}" and inner in defined and page.document.kind is Kind.XACRO:
                yield write(Value(each, name, text), f"${{{misspelled(inner)}}}")


def undefined_macro(page: Page) -> Iterator[Change]:
    defined = {f"xacro:{each.get('name', str)}" for each in page.all if each.name == "xacro:macro"}
    for each in page.all:
        if each.name in defined:
            end = page.document.spans.end_name(each)
            edits = [(span.end, span.end, "x") for span in (each.span, end) if span is not None]
            yield Change(tuple(edits), each.span.start)


def wrong_macro_parameter(page: Page) -> Iterator[Change]:
    defined = {f"xacro:{each.get('name', str)}" for each in page.all if each.name == "xacro:macro"}
    for each in page.all:
        for name in each.attributes if each.name in defined else ():
            span = page.document.spans.attribute_name(each, name)
            yield Change(((span.start, span.end, f"{name}_x"),), each.span.start)


TYPING_ERRORS = (
    *(misspelled_element, misspelled_attribute, one_number_less, comma_for_dot, letter_in_number),
    *(undeclared_prefix, unclosed_tag, wrong_end_tag, repeated_attribute, missing_quote),
    *(undefined_property, undefined_macro, wrong_macro_parameter),
)


def _numeric(page: Page, names: set[str]) -> Iterator[Value]:
    """Values that are numbers only."""
    for each in page.known:
        found = [each.attribute(name) for name in names.intersection(each.attributes)]
        if each.name in names:
            found += [each.attribute("value") or (None if each.nodes else each.own_value)]
        for value in found:
            if value is not None and literal(value) and all(is_number(text) for _, _, text in words(value)):
                yield value
