"""Changes that make no difference: none may change what is found."""

from __future__ import annotations

import random
import re
from collections import Counter
from collections.abc import Callable

from sdfcheck.source.document import Element
from sdfcheck.source.splice import Replacement, replaced
from tests.planted.page import Page, is_number, literal, words

Harmless = Callable[[Page, random.Random], str]
"""Gives the changed text; the same where there is nothing to change."""

NUMBERS = {"pose", "xyz", "rpy", "size", "radius", "length", "mass", "ixx", "iyy", "izz", "lower", "upper"}
_UNORDERED = {"joint", "collision"}
"""Siblings of which the order means nothing; a visual may use a material that one before it defines."""
_NAME = re.compile(r"[\w.:/-]+")


def carriage_returns(page: Page, chance: random.Random) -> str:
    return page.text.replace("\r\n", "\n").replace("\n", "\r\n")


def other_indentation(page: Page, chance: random.Random) -> str:
    return replaced(page.text, [(start, end, "\n\n\t") for start, end in _gaps(page)])


def comments(page: Page, chance: random.Random) -> str:
    gaps = _gaps(page)
    chosen = sorted(chance.sample(gaps, min(5, len(gaps))))
    return replaced(page.text, [(end, end, "<!-- as measured -->") for _, end in chosen])


def single_quotes(page: Page, chance: random.Random) -> str:
    edits: list[Replacement] = []
    for each in page.all:
        for name, text in each.attributes.items():
            span = page.document.spans.attribute_whole(each, name)
            if span.text.endswith('"') and "'" not in text:
                edits.append((span.start, span.end, re.sub('"', "'", span.text)))
    return replaced(page.text, sorted(edits))


def attributes_on_lines(page: Page, chance: random.Random) -> str:
    whole = page.document.spans.attribute_whole
    starts = sorted(whole(each, name).start for each in page.all for name in each.attributes)
    return replaced(page.text, [(start, start, "\n  ") for start in starts])


def attributes_in_other_order(page: Page, chance: random.Random) -> str:
    edits: list[Replacement] = []
    for each in page.all:
        spans = [page.document.spans.attribute_whole(each, name) for name in each.attributes]
        pairs = zip(spans, reversed(spans), strict=True)
        edits += [(span.start, span.end, f" {other.text.strip()}") for span, other in pairs]
    return replaced(page.text, sorted(edits))


def long_tags(page: Page, chance: random.Random) -> str:
    """``<a/>`` as ``<a></a>``."""
    edits: list[Replacement] = []
    for each in page.all:
        place = page.place(each)
        if page.text[place.end - 2 : place.end] == "/>":
            edits.append((place.end - 2, place.end, f"></{each.name}>"))
    return replaced(page.text, sorted(edits))


def other_numbers(page: Page, chance: random.Random) -> str:
    """``0.5`` as ``5.0e-1`` or ``0.500``."""
    edits: list[Replacement] = []
    for each in page.known:
        values = [each.attribute(name) for name in NUMBERS.intersection(each.attributes)]
        if each.name in NUMBERS and not each.nodes:
            values.append(each.own_value)
        for value in values:
            parts = words(value) if value is not None and literal(value) else []
            edits += [
                (start, end, f"{float(text)!r}00" if chance.random() < 0.5 else f"{text}e+0")
                for start, end, text in parts
                if is_number(text) and "." in text and "e" not in f"{float(text)!r}{text}".lower()
            ]
    return replaced(page.text, sorted(edits))


def siblings_in_other_order(page: Page, chance: random.Random) -> str:
    """Two neighbors of one kind that nothing but blanks separates."""
    edits: list[Replacement] = []
    for each in page.known if page.is_robot else ():
        other = each.next()
        if each.name in _UNORDERED and other is not None and other.name == each.name:
            first, second = page.place(each), page.place(other)
            between = page.text[first.close_end : second.start]
            is_apart = not edits or edits[-1][1] <= first.start
            if is_apart and first.close_end <= second.start and not between.strip():
                one, two = (
                    page.text[first.start : first.close_end],
                    page.text[second.start : second.close_end],
                )
                edits.append((first.start, second.close_end, f"{two}{between}{one}"))
    return replaced(page.text, edits)


def another_name(page: Page, chance: random.Random) -> str:
    """A link or joint is called otherwise, wherever it is named."""
    counted = Counter(_NAME.findall(page.text))
    exact = Counter(text for each in page.all for text in (*each.attributes.values(), each.content))
    names = [each.get("name", str) for each in page.named("link", "joint") if page.is_robot]
    tags = {each.name for each in page.all}
    usable = [name for name in names if name and name not in tags and counted[name] == exact[name]]
    if not usable:
        return page.text
    name = chance.choice(usable)
    return re.sub(rf"(?<![\w.:/-]){re.escape(name)}(?![\w.:/-])", f"{name}zq", page.text)


HARMLESS: tuple[Harmless, ...] = (
    *(carriage_returns, other_indentation, comments, single_quotes, attributes_on_lines),
    *(attributes_in_other_order, long_tags, other_numbers, siblings_in_other_order, another_name),
)


def _gaps(page: Page) -> list[tuple[int, int]]:
    """Where blanks alone are between the tags of elements that hold elements."""
    found = []
    for each in page.all:
        other = each.next()
        if isinstance(each.parent, Element) and other is not None and each.parent.name != "plugin":
            start, end = page.place(each).close_end, page.place(other).start
            if start < end and page.text[start:end].isspace():
                found.append((start, end))
    return sorted(found)
