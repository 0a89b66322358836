"""Expands what can be expanded of a file that xacro refuses. Runs in the process that expands, nowhere else.

An expression that has no value becomes a placeholder: its own text, with a mark in place of the dollar. The mark goes
wherever the text goes: an expression that meets it has no value either. An element that xacro stops at, and
a condition that nobody can decide, stay in the result as they are.
"""

from __future__ import annotations

import os
import re
from typing import Any

from sdfcheck.xacro.process import failure
from sdfcheck.xacro.process.interpreter import Interpreter, Refused, TooMuch
from sdfcheck.xacro.process.trace import KEY, Tracer

MARK = "\ue000"
"""In place of the dollar of an expression that has no value, which xacro would evaluate once more."""

MOST = 8
"""So many failures are reported."""

_FATAL = (TooMuch, Refused, MemoryError, RecursionError)
"""Failures that are not of the file alone: they end the expansion."""
_DECISIONS = frozenset(
    {"xacro:attribute", "xacro:element", "xacro:if", "xacro:insert_block", "xacro:property", "xacro:unless"}
)
"""Elements of xacro that bring no names but those of the properties in them."""
_FROM_ELSEWHERE = frozenset({"argument", "macro", "property"})
"""The kinds of name that an element may define that is left as it is."""


_WRONG_PARAMETERS = ("Invalid parameter", "Undefined parameters")
"""The beginnings of xacro's messages about calls."""
_UNDEFINED_BLOCK = "Undefined block"
"""The beginning of xacro's message about a block, which a property may define."""
_WORD = re.compile(r"[^\W\d]\w*")


class Undecided(Exception):
    """An expression, condition or address depends on a placeholder."""


class Cautious(Interpreter):
    """Evaluates no expression in which a placeholder takes part."""

    def value(self, node: Any, scope: Any) -> Any:
        value = super().value(node, scope)
        if isinstance(value, str) and MARK in value:
            raise Undecided
        return value


class Perseverance:
    """Lets xacro go on after what it stops at."""

    def __init__(self, xacro: Any, tracer: Tracer) -> None:
        self.xacro = xacro
        self.tracer = tracer
        self.reports: list[failure.Record] = []
        self._seen: set[tuple[object, ...]] = set()
        self._is_open = False
        """Whether an element is left as it is that may define names."""
        self._evaluate, xacro.safe_eval = xacro.safe_eval, self.evaluate
        self._extend, xacro.eval_extension = xacro.eval_extension, self.extend
        self._decide, xacro.get_boolean_value = xacro.get_boolean_value, self.decide
        self._locate, xacro.abs_filename_spec = xacro.abs_filename_spec, self.locate
        self._grab_property, xacro.grab_property = xacro.grab_property, self.grab_property
        self._eval_all, xacro.eval_all = xacro.eval_all, self.eval_all

    # xacro's functions, which do not fail here or say that they depend on a placeholder

    def evaluate(self, expression: str, symbols: Any, locals: Any = None) -> object:
        return self._attempt(f"{{{expression}}}", self._evaluate, expression, symbols)

    def extend(self, text: str) -> object:
        return self._attempt(text[1:], self._extend, text)

    def _attempt(self, text: str, function: Any, *arguments: Any) -> object:
        """The value that a function gives for a text after its dollar, or the placeholder for it."""
        try:
            if MARK not in text:
                return function(*arguments)
        except Exception as error:
            self._note(error)
        return MARK + text

    def decide(self, value: object, condition: str) -> object:
        if isinstance(value, str) and MARK in value:
            raise Undecided
        return self._decide(value, condition)

    def locate(self, path: str) -> object:
        if MARK in path:
            raise Undecided
        return self._locate(path)

    def grab_property(self, element: Any, table: Any) -> None:
        name = element.getAttribute("name")
        if self._is_open and element.hasAttribute("default") and name not in table:
            element.removeAttribute("default")  # an element that is left as it is may define it
            element.setAttribute("value", f"{MARK}{{{name}}}")
        self._grab_property(element, table)

    def eval_all(self, node: Any, macros: Any, symbols: Any) -> None:
        """Evaluate the attributes of a node, then its children one by one; a failure ends its own element only."""
        children = [*node.childNodes]
        for child in reversed(children):
            node.removeChild(child)
        try:
            self._eval_all(node, macros, symbols)
        except Exception:
            for child in children:
                node.appendChild(child)
            raise
        before: list[Any] = []  # xacro drops comments before its elements
        for child in children:
            before.append(child)
            if child.nodeType != child.ELEMENT_NODE and "$" not in child.data:
                continue
            alone = node.ownerDocument.createElement(node.tagName)
            alone.setUserData(KEY, node.getUserData(KEY), self.tracer)
            alone.parentNode = node
            for each in before:
                alone.appendChild(each)
            self._eval_alone(alone, child, macros, symbols)
            self._take_attributes(node, alone, child)
            for done in [*alone.childNodes]:
                node.appendChild(done)
            before.clear()
        for child in before:
            node.appendChild(child)

    def _take_attributes(self, node: Any, alone: Any, child: Any) -> None:
        """Give a node the attributes that ``xacro:attribute`` gave; one without a known name stays as it is."""
        for name, value in alone.attributes.items():
            if MARK in name:
                alone.appendChild(child)
            else:
                node.setAttribute(name, value)

    def _eval_alone(self, alone: Any, child: Any, macros: Any, symbols: Any) -> None:
        written = dict(child.attributes.items()) if child.nodeType == child.ELEMENT_NODE else {}
        error = self._failure(alone, macros, symbols)
        if error is not None and str(error).startswith(_WRONG_PARAMETERS):
            self._correct(child, written, macros, symbols)
            error = self._failure(alone, macros, symbols)
        if error is not None:
            self._leave(child, macros, symbols)

    def _failure(self, alone: Any, macros: Any, symbols: Any) -> Exception | None:
        """Evaluate all in a node: the failure, which is noted."""
        stacks = self.xacro.filestack, self.xacro.macrostack
        depths = [len(stack or ()) for stack in stacks]
        include = self.tracer.include
        try:
            self._eval_all(alone, macros, symbols)
        except Exception as error:
            self._note(error)
            self.tracer.include = include
            for stack, depth in zip(stacks, depths, strict=True):
                del (stack or [])[depth:]
            return error
        return None

    def _correct(self, call: Any, written: dict[str, str], macros: Any, symbols: Any) -> None:
        """Give a call the parameters that its macro takes: any of those that it does not give may have been meant."""
        names = [*self.tracer.resolve_macro(call.tagName[6:], macros, symbols)[2].params]
        for name in [*call.attributes.keys()]:
            call.removeAttribute(name)
        for name in names:
            if not name.startswith("*"):
                call.setAttribute(name, written.get(name, f"{MARK}{{{name}}}"))

    def _note(self, error: Exception) -> None:
        """Report a failure, but for those that follow from a placeholder, or may; nothing goes on after some."""
        root = [*failure.causes(error)][-1]
        if isinstance(root, _FATAL):
            raise error
        if isinstance(root, Undecided):
            return
        report = failure.describe(error, self.tracer)
        kind, name = report["kind"], str(report.get("name", ""))
        message = str(report.get("message", ""))
        if MARK in f"{name}{message}":
            return  # a name that depends on a placeholder
        if self._is_open and (kind in _FROM_ELSEWHERE or message.startswith(_UNDEFINED_BLOCK)):
            return
        place = report.get("place") if not name or kind in {"macro", "property"} else None
        folder = os.path.dirname(name) if kind == "file" else ""
        if folder and not os.path.isdir(folder):
            name = folder  # all that should be in it is missing for one reason
        key = kind, name, message, place, None if name else report.get("step")
        if key not in self._seen and len(self.reports) < MOST:
            self._seen.add(key)
            self.reports.append(report)

    def _leave(self, element: Any, macros: Any, symbols: Any) -> None:
        """Leave an element as it is: what it may define has no value any more."""
        for each in [element, *element.getElementsByTagName("*")]:
            name = each.getAttribute("name")
            if each.tagName == "xacro:property":
                self._is_open |= not name.isidentifier()
                for word in _WORD.findall(name):  # one, or what expressions would make one of
                    self._forget(word, symbols, is_outward=each.hasAttribute("scope"))
            elif each.tagName.startswith("xacro:") and each.tagName not in _DECISIONS:
                self._is_open = True
                if each.tagName == "xacro:macro":
                    macros.pop(name, None)

    def _forget(self, name: str, table: Any, *, is_outward: bool) -> None:
        """Let a property have no value in a table, and outside of it if that ``is_outward``."""
        root = table.root
        while table is not root:
            table._setitem(name, f"{MARK}{{{name}}}", unevaluated=False)
            table = table.parent if is_outward else root
