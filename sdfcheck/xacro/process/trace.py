"""Follows xacro while it expands, so that every element still knows where it was written.

Runs in the process that expands. xacro builds a DOM and copies macro bodies with
``cloneNode``; the DOM's user data, with its handler that is called for copies, carries
the places. xacro's own code is not changed: a few of its functions are replaced while it runs.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, MutableSequence
from itertools import chain
from typing import Any, SupportsIndex
from xml.dom.expatbuilder import ExpatBuilderNS
from xml.dom.minicompat import NodeList

# The children of nodes while xacro replaces one after the other. Runs in the process that expands.

MANY = 2048
"""With so many children a node is read into :class:`ManyChildren`."""
_WINDOW = 32


class Children(NodeList[Any]):
    """The children of a node; one is looked for where the last one was found.

    xacro replaces the nodes of a file one after the other, and would go through all before each.
    """

    __slots__ = ("_near",)

    def index(self, node: Any, *between: SupportsIndex) -> int:
        near = getattr(self, "_near", 0)
        try:
            found = super().index(node, *(between or (max(0, near - _WINDOW), near + _WINDOW)))
        except ValueError:
            found = super().index(node, *between)
        self._near = found
        return found

    def remove(self, node: Any) -> None:
        del self[self.index(node)]


class ManyChildren(MutableSequence[Any]):
    """Children in two lists, those before the last change and, turned around, those after it.

    A change next to the last one moves none of the others.
    """

    __slots__ = ("_after", "_before")

    def __init__(self, nodes: Iterable[Any]) -> None:
        self._before: list[Any] = []
        self._after = [*nodes][::-1]

    def __len__(self) -> int:
        return len(self._before) + len(self._after)

    def __iter__(self) -> Iterator[Any]:
        return chain([*self._before], self._after[::-1])

    def __getitem__(self, at: Any) -> Any:
        if isinstance(at, slice):
            return [*self][at]
        number = range(len(self))[at]
        inside = number - len(self._before)
        return self._before[number] if inside < 0 else self._after[-1 - inside]

    def __setitem__(self, at: Any, node: Any) -> None:
        if isinstance(at, slice):
            nodes = [*self]
            nodes[at] = node
            self._before, self._after = [], nodes[::-1]
        else:
            self._go_to(range(len(self))[at])
            self._after[-1] = node

    def __delitem__(self, at: Any) -> None:
        if isinstance(at, slice):
            self[at] = ()
        else:
            self._go_to(range(len(self))[at])
            self._after.pop()

    def insert(self, index: int, value: Any) -> None:
        self._go_to(min(index, len(self)))
        self._before.append(value)

    def index(self, value: Any, start: int = 0, stop: int | None = None) -> int:
        middle = len(self._before)
        for number in range(max(start, middle - _WINDOW), min(middle + _WINDOW, len(self))):
            if self[number] is value:
                return number
        return [*self].index(value, start, len(self) if stop is None else stop)

    def _go_to(self, number: int) -> None:
        """Let the two lists meet before the child of that number."""
        while len(self._before) > number:
            self._after.append(self._before.pop())
        while len(self._before) < number:
            self._before.append(self._after.pop())


KEY = "place"

Place = tuple[int, int, int]
"""File number, line, column, both from 1."""


class Step:
    """One step of how an element came to be: a macro call or an include, and where that is."""

    __slots__ = ("kind", "name", "outer", "place")

    def __init__(self, kind: str, name: str, place: Place, outer: Step | None) -> None:
        self.kind = kind
        self.name = name
        self.place = place
        self.outer = outer


class Written:
    """The marks on an element."""

    __slots__ = ("place", "step")

    def __init__(self, place: Place, step: Step | None) -> None:
        self.place = place
        self.step = step


class Crumbs:
    """Where the expansion is just now, in memory that the waiting process sees."""

    __slots__ = ("memory", "used")

    def __init__(self, memory: Any) -> None:
        self.memory = memory
        self.used = 16

    def file(self, path: str) -> None:
        raw = os.fsencode(path) + b"\n"
        if self.used + len(raw) < len(self.memory):
            self.memory[self.used : self.used + len(raw)] = raw
            self.used += len(raw)

    def at(self, place: Place) -> None:
        self.memory[:12] = b"".join(number.to_bytes(4, "little") for number in place)

    @staticmethod
    def read(memory: Any) -> tuple[list[str], Place]:
        """The files and the place that were noted last."""
        numbers = [int.from_bytes(memory[at : at + 4], "little") for at in (0, 4, 8)]
        names = bytes(memory[16:]).rstrip(b"\0").split(b"\n")[:-1]
        return [os.fsdecode(name) for name in names], (numbers[0], numbers[1], numbers[2])


class Tracer:
    """Knows the places of one expansion."""

    def __init__(self, xacro: Any, texts: Mapping[str, str], crumbs: Crumbs) -> None:
        self.xacro = xacro
        self.texts = texts
        """Path → text, for files that are not read from disk: the one that is expanded, and others."""
        self.crumbs = crumbs
        self.unprefixed: frozenset[tuple[str, int, int]] = frozenset()
        """The elements, by file, line and column, that are taken for xacro's though they lack its prefix."""
        self.files: list[str] = []
        self.definitions: dict[str, Written] = {}
        self.include: Step | None = None
        self.body: Any = None
        self.call: Any = None
        """The macro body that is being copied, and the call that it is copied for."""

    def install(self) -> None:
        """Replace xacro's functions by those that take notes."""
        xacro = self.xacro
        self.handle_macro_call, xacro.handle_macro_call = xacro.handle_macro_call, self.take_macro_call
        self.resolve_macro, xacro.resolve_macro = xacro.resolve_macro, self.take_macro
        self.process_include, xacro.process_include = xacro.process_include, self.take_include
        self.grab_property, xacro.grab_property = xacro.grab_property, self.take_property
        xacro.parse = self.parse

    # xacro's functions, with notes taken

    def parse(self, inp: Any, filename: str | None = None) -> Any:
        if filename is None:
            return inp
        text = self.texts.get(filename)
        if text is None:
            text = self.texts.get(os.path.abspath(os.path.join(self.xacro.root_dir, filename)))
        if text is not None:
            return Builder(self, self.number(filename)).parseString(text)
        try:
            file = self.xacro.open(os.path.join(self.xacro.root_dir, filename))
        except OSError as error:
            self.xacro.filestack.pop()
            raise self.xacro.XacroException(f"{error.strerror}: {error.filename}", exc=error) from error
        with file:
            return Builder(self, self.number(filename)).parseFile(file)

    def number(self, filename: str) -> int:
        if filename in self.files:
            return self.files.index(filename)
        self.files.append(filename)
        self.crumbs.file(filename)
        return len(self.files) - 1

    def take_macro_call(self, node: Any, macros: Any, symbols: Any) -> Any:
        data = node.getUserData(KEY)
        if data is not None:
            self.crumbs.at(data.place)
        if node.tagName[:6] != "xacro:":
            return False
        if data is not None and node.tagName != "xacro:call":
            self.call = Step("macro", node.tagName[6:], data.place, data.step)
        return self.handle_macro_call(node, macros, symbols)

    def take_macro(self, fullname: str, macros: Any, symbols: Any) -> Any:
        found = self.resolve_macro(fullname, macros, symbols)
        self.body = found[2].body
        return found

    def take_include(self, element: Any, macros: Any, symbols: Any, function: Any) -> None:
        outer, data = self.include, element.getUserData(KEY)
        self.crumbs.at(data.place)
        self.include = Step("include", element.getAttribute("filename"), data.place, data.step)
        self.process_include(element, macros, symbols, function)
        self.include = outer

    def take_property(self, element: Any, table: Any) -> None:
        data = element.getUserData(KEY)
        self.crumbs.at(data.place)
        name = element.getAttribute("name")
        self.definitions[name] = data
        self.grab_property(element, table)

    # the DOM's handler of user data

    def handle(self, operation: int, key: str, data: Written, src: Any, dst: Any) -> None:
        """A copy was made: of a macro's body for a call, or of a block that was passed to one."""
        if self.body is not None:
            if src is self.body:
                self.body = None
            data = Written(data.place, self.call)
        dst.setUserData(KEY, data, self)


class Builder(ExpatBuilderNS):
    """Builds the DOM, and notes the place of each start tag."""

    def __init__(self, tracer: Tracer, number: int) -> None:
        super().__init__()
        self.tracer = tracer
        self.number = number
        self.path = os.path.abspath(tracer.files[number])

    def start_element_handler(self, name: str, attributes: Any) -> None:
        super().start_element_handler(name, attributes)
        parser = self.getParser()
        place = (self.number, parser.CurrentLineNumber, parser.CurrentColumnNumber + 1)
        tracer = self.tracer
        self.curNode.setUserData(KEY, Written(place, tracer.include), tracer)

    def end_element_handler(self, name: str) -> None:
        node: Any = self.curNode
        super().end_element_handler(name)
        if len(node.childNodes) > MANY:
            node.childNodes = ManyChildren(node.childNodes)
        place: Place = node.getUserData(KEY).place
        if self.tracer.unprefixed and (self.path, *place[1:]) in self.tracer.unprefixed:
            node.tagName = node.nodeName = f"xacro:{node.tagName}"
