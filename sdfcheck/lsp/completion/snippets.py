"""An element with what it cannot do without."""

from __future__ import annotations

from itertools import count

from sdfcheck.formats.describe.spot import Spot
from sdfcheck.formats.sdf.schema import NOT_GIVEN, AttributeDefinition, Definition
from sdfcheck.formats.urdf.table import UrdfElement
from sdfcheck.lsp.completion.item import escaped

_DEEPEST = 3


class Snippet:
    """Writes elements with numbered places to fill in."""

    def __init__(self) -> None:
        self._number = count(1)

    def element(self, name: str, spot: Spot) -> str:
        """An element, from its name on; the ``<`` before it is there."""
        if spot.definition is not None:
            return self._sdf(name, spot.definition, 0)
        if spot.urdf is not None:
            return self._urdf(name, spot.urdf, 0)
        return f"{name}>{self._stop()}</{name}>"

    def attribute(self, name: str, choices: tuple[str, ...] = (), default: str = "") -> str:
        """An attribute with the place of its value."""
        return f'{name}="{self._stop(choices, default)}"'

    def _sdf(self, name: str, element: Definition, depth: int) -> str:
        head = name + "".join(
            f" {self._sdf_attribute(element.attributes[each])}" for each in element.required_attributes
        )
        if element.type:
            choices = element.choices.listed if element.choices else ()
            return f"{head}>{self._stop(choices, _default(element.default))}</{name}>"
        needed = [] if depth >= _DEEPEST else list(element.needed_children)
        body = [f"<{self._sdf(each, element.children[each], depth + 1)}" for each in needed]
        return self._with_body(name, head, body, depth, is_empty=not element.children and not element.open)

    def _urdf(self, name: str, element: UrdfElement, depth: int) -> str:
        head = name
        for each in element.required_attributes:
            attribute = element.attributes[each]
            head += " " + self.attribute(each, attribute.choices, attribute.default)
        if element.value is not None:
            return f"{head}>{self._stop()}</{name}>"
        needed = [] if depth >= _DEEPEST else list(element.required_children)
        body = [f"<{self._urdf(each, element.children[each], depth + 1)}" for each in needed]
        return self._with_body(name, head, body, depth, is_empty=not element.children and not element.open)

    def _with_body(self, name: str, head: str, body: list[str], depth: int, *, is_empty: bool) -> str:
        if is_empty:
            return f"{head}/>"
        inner = "\n".join(f"\t{line}" for text in body for line in text.split("\n"))
        if depth and not body:
            return f"{head}>{self._stop()}</{name}>"
        last = f"\n\t{self._stop()}" if not body else ""
        return f"{head}>{last}" + (f"\n{inner}" if inner else "") + f"\n</{name}>"

    def _sdf_attribute(self, attribute: AttributeDefinition) -> str:
        choices = attribute.choices.listed if attribute.choices else ()
        return self.attribute(attribute.name, choices, _default(attribute.default))

    def _stop(self, choices: tuple[str, ...] = (), default: str = "") -> str:
        number = next(self._number)
        if choices and len(choices) <= 30 and not any(set(each) & set(",|$}\\") for each in choices):
            return f"${{{number}|{','.join(choices)}|}}"
        return f"${{{number}:{escaped(default)}}}" if default else f"${number}"


def _default(text: str | None) -> str:
    return "" if text is None or text == NOT_GIVEN else text


def plain(snippet: str) -> str:
    """A snippet without its tab stops: what was offered first is filled in."""
    import re

    text = re.sub(r"\$\{\d+\|([^,|]*)[^}]*\|\}", r"\1", snippet)
    text = re.sub(r"\$\{\d+:((?:[^}\\]|\\.)*)\}", lambda match: re.sub(r"\\(.)", r"\1", match[1]), text)
    return re.sub(r"\$\d+", "", text)
