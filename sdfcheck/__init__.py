"""Linter and converter for SDFormat, URDF and xacro robot descriptions.

Everything a program or a rule needs can be imported from here; it is loaded when it is
first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sdfcheck import problems
    from sdfcheck.consumers.reaction import (
        REFUSES,
        Consumer,
        Reaction,
        Verdict,
        accepts,
        by_effect,
        refuses,
        warns,
    )
    from sdfcheck.consumers.urdf_readers import lacking, repeating, undersized, unreadable
    from sdfcheck.convert.call import convert
    from sdfcheck.convert.loss import Loss, NotConvertible
    from sdfcheck.convert.result import Conversion
    from sdfcheck.lint.call import lint
    from sdfcheck.lint.diagnostic import Diagnostic, Label, Origin, Severity
    from sdfcheck.lint.example import (
        IN_COLLISION,
        IN_JOINT,
        IN_LINK,
        IN_MODEL,
        IN_ROBOT,
        IN_URDF_JOINT,
        IN_URDF_LINK,
        IN_VISUAL,
        IN_WORLD,
        SDF,
        Bad,
        Good,
    )
    from sdfcheck.lint.fix.fix import Applicability, Edit, Fix
    from sdfcheck.lint.rule import Rule, Target, edit, replace
    from sdfcheck.lint.run import Run
    from sdfcheck.lint.vendor_rule import VendorRule
    from sdfcheck.lint.wording import listed, named, used
    from sdfcheck.robot.load import Unreadable, load, parse
    from sdfcheck.robot.objects import Joint, Link, Model, NotFound, Root, World
    from sdfcheck.source.document import Document
    from sdfcheck.source.element import Element, Value
    from sdfcheck.source.text import Position, Source, Span
    from sdfcheck.source.wrong_usage import WrongUsage

__version__ = "0.1.0"

_HOMES = {
    "sdfcheck.convert.loss": "Loss NotConvertible",
    "sdfcheck.convert.result": "Conversion",
    "sdfcheck.lint.diagnostic": "Diagnostic Label Origin Severity",
    "sdfcheck.lint.example": (
        "IN_COLLISION IN_JOINT IN_LINK IN_MODEL IN_ROBOT IN_URDF_JOINT IN_URDF_LINK IN_VISUAL IN_WORLD SDF Bad Good"
    ),
    "sdfcheck.lint.fix.fix": "Applicability Edit Fix",
    "sdfcheck.consumers.reaction": "REFUSES Consumer Reaction Verdict accepts by_effect refuses warns",
    "sdfcheck.lint.rule": "Rule Target edit replace",
    "sdfcheck.lint.run": "Run",
    "sdfcheck.consumers.urdf_readers": "lacking repeating undersized unreadable",
    "sdfcheck.lint.vendor_rule": "VendorRule",
    "sdfcheck.lint.wording": "listed named used",
    "sdfcheck.robot.load": "Unreadable load parse",
    "sdfcheck.robot.objects": "Joint Link Model NotFound Root World",
    "sdfcheck.source.document": "Document",
    "sdfcheck.source.element": "Element Value",
    "sdfcheck.source.text": "Position Source Span",
    "sdfcheck.source.wrong_usage": "WrongUsage",
}
_HOME_OF = {name: module for module, names in _HOMES.items() for name in names.split()}

__all__ = [
    "IN_COLLISION",
    "IN_JOINT",
    "IN_LINK",
    "IN_MODEL",
    "IN_ROBOT",
    "IN_URDF_JOINT",
    "IN_URDF_LINK",
    "IN_VISUAL",
    "IN_WORLD",
    "REFUSES",
    "SDF",
    "Applicability",
    "Bad",
    "Consumer",
    "Conversion",
    "Diagnostic",
    "Document",
    "Edit",
    "Element",
    "Fix",
    "Good",
    "Joint",
    "Label",
    "Link",
    "Loss",
    "Model",
    "NotConvertible",
    "NotFound",
    "Origin",
    "Position",
    "Reaction",
    "Root",
    "Rule",
    "Run",
    "Severity",
    "Source",
    "Span",
    "Target",
    "Unreadable",
    "Value",
    "VendorRule",
    "Verdict",
    "World",
    "WrongUsage",
    "__version__",
    "accepts",
    "by_effect",
    "convert",
    "edit",
    "lacking",
    "lint",
    "listed",
    "load",
    "named",
    "parse",
    "problems",
    "refuses",
    "repeating",
    "replace",
    "undersized",
    "unreadable",
    "used",
    "warns",
]


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name in {"convert", "lint", "problems"}:
        return import_module(f"sdfcheck.{name}")
    if name not in _HOME_OF:
        raise AttributeError(f"module 'sdfcheck' has no attribute {name!r}")
    value = getattr(import_module(_HOME_OF[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
