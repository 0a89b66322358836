"""Changing a description: text edits that leave every other byte alone."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.overwrite import overwrite
from sdfcheck.files.regular import read_named
from sdfcheck.formats.urdf.schema import definition
from sdfcheck.lint.diagnostic import named
from sdfcheck.lint.targets import errors
from sdfcheck.robot.graph import Model, Scope
from sdfcheck.robot.load import Unreadable, as_text, opened, parse
from sdfcheck.robot.naming.occurrences import name_refusal, node_names, taken_by
from sdfcheck.robot.part import Part
from sdfcheck.source.splice import replaced, splice
from sdfcheck.source.text import IN_QUOTES, escape

if TYPE_CHECKING:
    from types import TracebackType

    from sdfcheck.robot.graph import World
    from sdfcheck.robot.part import Node
    from sdfcheck.robot.root import Root
    from sdfcheck.source.document import Element, Value
    from sdfcheck.source.text import Span

Writable = str | bool | float | Iterable[float]
"""A value to write: text, truth, a number, or several numbers (a vector, ``[*pose.xyz, *pose.rpy]``)."""


class EditError(ValueError):
    """A change that cannot be made; the message says why."""


class Edit:
    """A description that is being changed: ``with sdfcheck.edit("robot.sdf") as robot:``.

    Parts are those of the file as it was read: they do not change while it is edited.
    Leaving the block without an exception saves the file.
    """

    def __init__(self, root: Root, path: Path | None) -> None:
        self.root = root
        self._path = path
        self._edits: dict[tuple[int, int], str] = {}
        self._added: set[tuple[Element, str]] = set()
        """The children of elements of the file that values have added."""

    def __enter__(self) -> Edit:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if kind is None and self._path is not None:
            self.save()

    @property
    def worlds(self) -> tuple[World, ...]:
        """The worlds, as they were read."""
        return self.root.worlds

    @property
    def models(self) -> tuple[Model, ...]:
        """The models that are in no world, as they were read."""
        return self.root.models

    def world(self, key: str | int) -> World:
        """A world by name or index; raises NotFound."""
        return self.root.world(key)

    def model(self, key: str | int) -> Model:
        """A model that is in no world, by name or index; raises NotFound."""
        return self.root.model(key)

    @property
    def text(self) -> str:
        """The text with all changes so far."""
        return replaced(self.root.document.source.text, self._sorted())

    def save(self, path: str | os.PathLike[str] | None = None) -> None:
        """Write the file, whole or not at all; by default where it was read.

        Raises:
            EditError: the changed text is not a description any more, or has an error that it did not have.
            OSError: the file cannot be written.
        """
        target = self._path if path is None else Path(path)
        if target is None:
            raise EditError("a text has no file to be saved in: give a path")
        self._check()
        data = read_named(self._path) if self._path is not None else None
        new = self.text.encode() if data is None else splice(data, self._sorted())
        if new != data or target != self._path:
            overwrite(target, new, instead=True)

    def _check(self) -> None:
        """Raise EditError if the changed text has an error that the text as it was read does not have."""
        before = self.root.document
        try:
            changed = parse(self.text, before.path).document
        except Unreadable as error:
            raise EditError(f"the changed text cannot be read: {error}") from None
        changed.library = before.library
        known = Counter((one.code, one.message) for one in errors(before))
        for wrong in errors(changed):
            if not known[wrong.code, wrong.message]:
                line = wrong.span.begin.line
                raise EditError(
                    f"line {line} of the changed text would be wrong: {wrong.message} [{wrong.code}]"
                )
            known[wrong.code, wrong.message] -= 1

    # Changes

    def rename(self, node: Node, name: str) -> None:
        """Give a link, joint, frame or model another name, wherever the file refers to it.

        That is in joints, poses, frames, mimics, plugins, states, ``<gazebo>`` blocks, transmissions,
        ``ros2_control`` and vendors' own elements, scoped names included. Other files are not looked at.

        Raises EditError for a name that is taken or cannot be one.
        """
        if (reason := name_refusal(node.kind, node.name, name)) is not None:
            raise EditError(reason)
        scope = node.scope if isinstance(node.holder, Scope) else None
        there = taken_by(scope, node.kind, name) if scope is not None else None
        if scope is not None and there is not None and there is not node:
            raise EditError(f"{scope.title} has a {there.kind} `{name}`")
        if isinstance(node, Model) and node.include is not None:
            given = node.include.find("name")
            if given is None:
                self.add(node.include, f"<name>{escape(name)}</name>")
            else:
                self._write(given.own_value, name)
        elif node.document is not self.root.document or node.name_value is None:
            raise EditError(
                f"the name of {node.kind} `{node.name}` is not written in {self.root.document.path}"
            )
        else:
            self._write(node.name_value, name)
        for span, other, before, after in node_names(self.root):
            if other is node:
                place = self._span(span)
                self._replace(place.start, place.end, escape(f"{before}{name}{after}", IN_QUOTES))

    def set(self, part: Part | Element, name: str, value: Writable) -> None:
        """Write an attribute or a child element: ``set(link, "inertial/mass", 2.5)``.

        An element of URDF with one attribute, such as ``mass``, is set like that too, whatever its attribute
        is called. A value that is there is replaced. A value that is not there is added: in URDF, and where
        the name begins with ``@``, as an attribute, else as a child element; with the elements around it that
        are not there.

        Raises EditError for a second value in an element that the first one has added, and for an element of
        URDF with several attributes, or none.
        """
        *path, last = name.split("/")
        element = part if not isinstance(part, Part) else part.element
        is_urdf = isinstance(part, Part) and part.is_urdf
        if is_urdf and (attribute := _holder_of_value(element, name)) is not None:
            path, last = [*path, last], attribute
        text, is_attribute = _text(value), last.startswith("@")
        last = last.removeprefix("@")
        for number, step in enumerate(path):
            child = element.find(step)
            if child is None:
                as_attribute = is_attribute or is_urdf
                self._add_around(element, path[number:], last, text, as_attribute=as_attribute)
                return
            element = child
        found = element.attribute(last) if is_attribute else element.value(last)
        if found is not None:
            self._write(found, text)
        elif is_attribute or is_urdf:
            end = self._span(element.document.spans.name(element)).end
            self._replace(end, end, f' {last}="{escape(text, IN_QUOTES)}"')
        else:
            self.add(element, f"<{last}>{escape(text)}</{last}>")

    def _add_around(
        self, element: Element, path: Sequence[str], name: str, text: str, *, as_attribute: bool
    ) -> None:
        """Add elements, one in the other, the last of which has a value."""
        if (element, path[0]) in self._added:
            raise EditError(f"`{path[0]}` of {element.title} is new: save before you set more in it")
        self._added.add((element, path[0]))
        *outer, inner = path
        whole = (
            f'<{inner} {name}="{escape(text, IN_QUOTES)}"/>'
            if as_attribute
            else f"<{inner}><{name}>{escape(text)}</{name}></{inner}>"
        )
        for step in reversed(outer):
            whole = f"<{step}>{whole}</{step}>"
        self.add(element, whole)

    def add(self, part: Part | Element, text: str) -> None:
        """Add an element, given as text, as the last child."""
        element = part.element if isinstance(part, Part) else part
        source, place = element.document.source, element.document.spans.place(element)
        self._span(element.span)
        outer = _indent(source.text, place.start)
        children = list(element.children())
        inner = (
            _indent(source.text, element.document.spans.place(children[-1]).start)
            if children
            else outer + "  "
        )
        lines = f"\n{inner}".join(text.strip().splitlines())
        if place.close == place.close_end:  # <link/> becomes <link>…</link>
            start = source.text.rindex("/", place.start, place.close_end)
            self._replace(start, place.close_end, f">\n{inner}{lines}\n{outer}</{element.name}>")
            return
        before = len(source.text[: place.close].rstrip())
        between = source.text[before : place.close]
        at = place.close if "\n" not in between else before
        self._replace(
            at, at, f"\n{inner}{lines}" + ("" if at == before and at != place.close else f"\n{outer}")
        )

    def remove(self, part: Part | Element) -> None:
        """Take an element out, with the spaces before it."""
        element = part.element if isinstance(part, Part) else part
        span = self._span(element.document.spans.whole(element))
        text, start = element.document.source.text, span.start
        begin = len(text[:start].rstrip(" \t"))
        line_end = begin - 1 if begin and text[begin - 1] == "\n" else begin
        if line_end < begin and line_end and text[line_end - 1] == "\r":
            line_end -= 1
        is_alone = line_end < begin or begin == 0
        self._replace(line_end if is_alone else start, span.end, "")

    # Edits of the text

    def _write(self, value: Value, text: str) -> None:
        if value.attribute is None and not value.text:
            element = value.element
            place = element.document.spans.place(element)
            self._span(element.span)
            if place.close == place.close_end:
                start = element.document.source.text.rindex("/", place.start, place.close_end)
                self._replace(start, place.close_end, f">{escape(text)}</{element.name}>")
            else:
                self._replace(place.close, place.close, escape(text))
            return
        if value.attribute is not None and not value.text:
            whole = self._span(value.element.document.spans.attribute_whole(value.element, value.attribute))
            self._replace(whole.start, whole.end, f' {value.attribute}="{escape(text, IN_QUOTES)}"')
            return
        span = self._span(value.span)
        self._replace(
            span.start, span.end, escape(text, IN_QUOTES) if value.attribute is not None else escape(text)
        )

    def _span(self, span: Span) -> Span:
        if span.source is not self.root.document.source:
            raise EditError(f"{span.source.path} is another file than the one that is edited")
        return span

    def _replace(self, start: int, end: int, text: str) -> None:
        """Note one edit; the same place again: insertions add up, replacements count anew."""
        if start == end:
            text = self._edits.get((start, end), "") + text
        elif (start, end) not in self._edits:
            for begin, stop in self._edits:
                if begin < end and start < stop:
                    raise EditError("two changes overlap: save after the first")
        self._edits[start, end] = text

    def _sorted(self) -> list[tuple[int, int, str]]:
        return [(start, end, text) for (start, end), text in sorted(self._edits.items())]


def edit(what: str | bytes | os.PathLike[str], *, tables: Sequence[Path] = ()) -> Edit:
    """Open a file to change it: ``with sdfcheck.edit("robot.sdf") as robot:``.

    ``what`` is the path of an SDFormat or URDF file, or a text (bytes, or a str that begins with
    ``<``), whose changed ``text`` is then read from the result. The expansion of a xacro file
    cannot be edited: the file itself can. ``tables`` are as for ``load``.

    Raises:
        OSError: the file cannot be read.
        Unreadable: it holds no robot description.
        EditError: the file is one for xacro.
    """
    root = opened(what, tables)
    if root.document.is_expanded:
        raise EditError(
            f"{root.document.path} is expanded by xacro: its text cannot be edited through the robot"
        )
    return Edit(root, Path(os.fsdecode(what)) if as_text(what) is None else None)


def _holder_of_value(element: Element, path: str) -> str | None:
    """The attribute of URDF that is all of the element at a path; None where the path is that of an attribute.

    Raises EditError where the element is more than one value.
    """
    outer, _, last = path.rpartition("/")
    top = definition(element)
    around = None if top is None else top.at(outer)
    child = None if around is None or last in around.attributes else around.children.get(last)
    if child is None or child.type is not None:
        return None
    names = [name for name, one in child.attributes.items() if name != "name" and not one.consumers]
    if len(names) != 1:
        all_of_them = f": set {named(f'{path}/{name}' for name in names)}" if names else ""
        raise EditError(f"`{last}` has no value of its own in URDF{all_of_them}")
    return names[0]


def _text(value: Writable) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return repr(float(value) if not isinstance(value, int) else int(value)).removesuffix(".0")
    return " ".join(_text(float(number)) for number in value)


def _indent(text: str, at: int) -> str:
    """The spaces at the beginning of a line."""
    line = text[text.rfind("\n", 0, at) + 1 : at]
    return line[: len(line) - len(line.lstrip())]
