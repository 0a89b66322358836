"""From an exception of xacro to what is wrong and where. Runs in the process that expands."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from types import FrameType, TracebackType
from typing import Any
from xml.parsers.expat import ExpatError, errors

from xacro.substitution_args import ArgException

from sdfcheck.xacro.problems import NO_KEY, NO_TRUTH, WRONG_NAME
from sdfcheck.xacro.process.interpreter import Refused, TooMuch
from sdfcheck.xacro.process.trace import KEY, Step, Tracer, Written

_TEXT_NODE = 3
_STACK = re.compile(r"\n?when evaluating expression .*", re.DOTALL)
_NO_KEY = "The yaml dictionary has no key"
_COUNTED = ("Invalid parameter", "Undefined parameters", "Not enough blocks", "Unused block")


class MissingPackage(Exception):
    """``$(find …)`` of a package that is nowhere."""


class MissingVariable(Exception):
    """``$(env …)`` of a variable that is not passed on."""


_NAMED = (
    (NameError, "property"),
    (MissingPackage, "package"),
    (MissingVariable, "variable"),
    (ArgException, "argument"),
)
_LIMITS = ((TooMuch, "limit"), (Refused, "refused"))

Record = dict[str, Any]


class Spot:
    """Where an expansion failed, as far as the frames show."""

    def __init__(self) -> None:
        self.data: Written | None = None
        self.attribute = ""
        self.expression = ""
        self.macro: FrameType | None = None

    def take(self, frame: FrameType, tracer: Tracer) -> None:
        """Look at one frame of xacro, the outer ones first."""
        names = frame.f_locals
        take = getattr(self, f"in_{frame.f_code.co_name}", None)
        if take is not None:
            take(names, tracer)
        if frame.f_code.co_name == "handle_macro_call":
            self.macro = frame

    def at(self, node: Any, attribute: str = "") -> None:
        while node is not None:
            data = node.getUserData(KEY)
            if data is not None:
                self.data, self.attribute, self.expression = data, attribute, ""
                return
            node = node.parentNode

    def in_eval_all(self, names: dict[str, Any], tracer: Tracer) -> None:
        node = names["node"]
        self.at(node, "" if "eval_comments" in names else str(names.get("name", "")))
        if node is not None and getattr(node, "nodeType", 0) == _TEXT_NODE:
            self.attribute = ""

    def in_handle_macro_call(self, names: dict[str, Any], tracer: Tracer) -> None:
        if "m" in names and "param" in names and "name" in names and names.get("default"):
            self.at(names["m"].body, "params")
        elif "block" not in names and "params" in names:
            self.at(names["node"], str(names.get("name", "")))
        else:
            self.at(names["node"])

    def in_handle_dynamic_macro_call(self, names: dict[str, Any], tracer: Tracer) -> None:
        self.at(names["node"], "macro")

    def in_grab_property(self, names: dict[str, Any], tracer: Tracer) -> None:
        self.at(names["elt"])

    def in_grab_macro(self, names: dict[str, Any], tracer: Tracer) -> None:
        self.at(names["elt"])

    def in_process_include(self, names: dict[str, Any], tracer: Tracer) -> None:
        self.at(names["elt"], "filename")

    def in__resolve_(self, names: dict[str, Any], tracer: Tracer) -> None:
        """A property is evaluated when it is first used; the mistake is where it is defined."""
        data = tracer.definitions.get(names["key"])
        if data is not None:
            self.data, self.attribute, self.expression = data, "value", ""

    def in_handle_expr(self, names: dict[str, Any], tracer: Tracer) -> None:
        self.expression = f"${{{names['s']}}}"

    def in_handle_extension(self, names: dict[str, Any], tracer: Tracer) -> None:
        self.expression = f"$({names['s']})"


def describe(error: BaseException, tracer: Tracer) -> Record:
    """The kind of a failure, for :mod:`sdfcheck.xacro.problems`, and its place."""
    spot = Spot()
    frames = [*_frames(error)]
    for frame in reversed(frames):
        if frame.f_code.co_name.endswith("writexml") and "a_name" in frame.f_locals:
            return _unwritten(frame.f_locals["self"], str(frame.f_locals["a_name"]))
    for frame in frames:
        if frame.f_globals.get("__name__", "").partition(".")[0] == "xacro":
            spot.take(frame, tracer)
    record = _judge(error, spot)
    if "at" in record:
        record["at"].insert(0, len(tracer.files) - 1)  # the file that was opened last
    if spot.data is not None:
        record["place"] = spot.data.place
        record["step"] = spot.data.step
    record.setdefault("attribute", spot.attribute)
    record["expression"] = spot.expression
    return record


def _unwritten(element: Any, attribute: str) -> Record:
    """An attribute whose value is not a text when the result is written: ``xacro:attribute`` takes any."""
    spot = Spot()
    spot.at(element, attribute)
    cause = f"`xacro:attribute` gives `{attribute}` a value that is not a text"
    message = f"{cause}, for which xacro fails: write `${{str(…)}}`"
    return {
        "kind": "other",
        "message": message,
        "place": spot.data.place if spot.data else None,
        "step": spot.data.step if spot.data else None,
        "attribute": attribute,
        "expression": "",
    }


def _judge(error: BaseException, spot: Spot) -> Record:
    root = list(causes(error))[-1]
    message = str(root)
    for kinds, kind in _NAMED:
        if isinstance(root, kinds):
            return {"kind": kind, "name": _name(root) if kind == "property" else message}
    for kinds, kind in _LIMITS:
        if isinstance(root, kinds):
            return {"kind": kind, "message": message}
    if isinstance(root, MemoryError):
        return {"kind": "limit", "message": "more memory is asked for than an expansion may have"}
    if isinstance(root, RecursionError):
        return _recursion(spot)
    if isinstance(root, ExpatError):
        what = errors.messages.get(root.code, message)
        return {"kind": "syntax", "message": what, "at": [root.lineno, root.offset + 1]}
    if isinstance(root, UnicodeDecodeError):
        what = f"byte 0x{root.object[root.start]:02x} is not {root.encoding.upper()}"
        # Only a part of the file was decoded: it is read once more to find the place.
        return {"kind": "syntax", "message": what, "at": [1, 1], "is_undecoded": True}
    if isinstance(root, OSError):
        return {"kind": "file", "name": str(root.filename), "message": (root.strerror or "").lower()}
    return _of_xacro(root, spot)


def _name(error: BaseException) -> str:
    """The name that is not defined."""
    return getattr(error, "name", None) or str(error).partition("'")[2].partition("'")[0]


def _of_xacro(root: BaseException, spot: Spot) -> Record:
    """Errors of xacro itself, recognized by their words."""
    text = _STACK.sub("", str(root.args[0] if root.args else root)).strip()
    if text.startswith("unknown macro name:"):
        return {"kind": "macro", "name": text.rpartition("xacro:")[2]}
    if text.startswith(_COUNTED) and spot.macro is not None:
        return _arguments(text, spot)
    if text.startswith("Property names must be valid"):
        spot.attribute = "name"
        text = f"{WRONG_NAME} `{text.partition(': ')[2]}`"
    if text.startswith("Xacro conditional"):
        spot.attribute, spot.expression = "value", ""
        text = f"`{text.rpartition(' evaluated to ')[2].split(chr(34))[1]}`{NO_TRUTH}"
    return {"kind": "other", "message": _words(root, text)}


def _words(root: BaseException, text: str) -> str:
    """The message of the exception, on one line."""
    text = " ".join(text.split())
    if isinstance(root, SyntaxError):
        text = root.msg
    if isinstance(root, KeyError):
        text = f"there is no {text}"
    if text.startswith(_NO_KEY):
        text = f"{NO_KEY} `{text.partition(chr(39))[2].rstrip(chr(39))}`"
    if type(root).__module__.partition(".")[0] == "yaml":
        text = "malformed YAML: " + " ".join(str(root).split())
    return text.rstrip(".") or type(root).__name__


def _arguments(text: str, spot: Spot) -> Record:
    assert spot.macro is not None
    names = spot.macro.f_locals
    macro = names["m"]
    record: Record = {
        "kind": "arguments",
        "macro": macro.body.getAttribute("name"),
        "what": text.split(maxsplit=1)[0],
        "parameters": list(macro.params),
    }
    if text.startswith("Invalid"):
        record["names"] = [names["name"]]
        spot.attribute = names["name"]
    else:
        record["names"] = list(names["params"]) if text.startswith("Undefined") else []
        spot.attribute = ""
    spot.at(names["node"], spot.attribute)
    if text.startswith("Unused"):
        record["names"] = [names["block"].tagName]
        spot.at(names["block"])
    data = macro.body.getUserData(KEY)
    record["definition"] = data.place if data else None
    return record


def _recursion(spot: Spot) -> Record:
    """Which call or include leads back to itself; the outermost of them is the place to look at."""
    steps = []
    step = spot.data.step if spot.data else None
    while step is not None:
        steps.append(step)
        step = step.outer
    seen: dict[tuple[str, str], Step] = {}
    for step in reversed(steps):
        first = seen.setdefault((step.kind, step.name), step)
        if first is not step:
            spot.data = Written(step.place, step.outer)
            spot.attribute = "filename" if step.kind == "include" else ""
            spot.expression = ""
            return {"kind": "recursion", "what": step.kind, "name": step.name}
    return {"kind": "other", "message": "the nesting is too deep"}


def causes(error: BaseException) -> Iterator[BaseException]:
    """The exception and those that xacro made it from."""
    cause: object = error
    while isinstance(cause, BaseException):
        yield cause
        cause = getattr(cause, "exc", None)


def _frames(error: BaseException) -> Iterator[FrameType]:
    """The frames that led to an error, the outer ones first; where it was caught, others are still at work."""
    callers: list[FrameType] = []
    caller: FrameType | None = sys._getframe(1)
    while caller is not None:
        callers.append(caller)
        caller = caller.f_back
    yield from reversed(callers)
    for cause in causes(error):
        trace: TracebackType | None = cause.__traceback__
        while trace is not None:
            yield trace.tb_frame
            trace = trace.tb_next
