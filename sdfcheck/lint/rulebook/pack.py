"""A pack of rules: where it is, what is known of its rules, what may be wrong with it.

A pack is an import package, a module or a folder of Python files. A package may have an
index (``rule_index.py``, written by :mod:`sdfcheck.lint.rulebook.index`) that says what can be known
of its rules without importing them, and with it their conditions in one module
(``conditions.py``, by :mod:`sdfcheck.lint.rulebook.conditions`), as the built-in one has; a pack
without an index is imported whole (:mod:`sdfcheck.lint.rulebook.plugins`). A pack may also bring
tables of a vendor's own elements (``<prefix>.vendor.txt``), against which documents that
use the prefix are checked.
"""

from __future__ import annotations

import importlib
import os
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.run import BUILT_IN, RuleFacts
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.lint.rule import Rule

INDEX = "rule_index"
"""The module of a pack that lists its rules."""
CONDITIONS = "conditions"
"""The module of a pack with an index that holds the conditions of its rules."""


class PackError(Exception):
    """A pack that cannot be loaded at all; the text is fit for the user. ``plugin`` is its name as given."""

    def __init__(self, reason: str, plugin: str = "") -> None:
        super().__init__(reason, plugin)
        self.plugin = plugin

    def __str__(self) -> str:
        return f"plugin {self.plugin}: {self.args[0]}" if self.plugin else str(self.args[0])


class Pack(NamedTuple):
    """A pack's name as given, the folder of its modules and the name that they are imported by.

    ``file`` is its only module, for a pack that is not a package.
    """

    name: str
    folder: Path
    package: str
    file: Path | None = None

    @property
    def is_importable(self) -> bool:
        """Whether Python finds it by its name, so that it is not a mere folder."""
        return not self.package.startswith("sdfcheck_plugin_")


class Fault(NamedTuple):
    """The error that keeps a rule or a module of a pack from being loaded, and where: ``path:line``."""

    place: str
    text: str

    def __str__(self) -> str:
        return f"{self.place}: {self.text}"


def read_index(package: str) -> list[RuleFacts]:
    """The facts of a pack's rules, as its index has them."""
    return [from_record(record) for record in importlib.import_module(f"{package}.{INDEX}").RULES]


def has_index(pack: Pack, *others: str) -> bool:
    """Does a pack have an index, and the ``others`` of the modules that are written with it?"""
    if not pack.is_importable or pack.file is not None:
        return False
    return all(os.path.isfile(pack.folder / f"{name}.py") for name in (INDEX, *others))


def rule_classes(module: ModuleType) -> list[type[Rule]]:
    """The rules that a module defines (not those that it imports)."""
    from sdfcheck.lint.rule import Rule

    return [
        value
        for value in vars(module).values()
        if isinstance(value, type)
        and issubclass(value, Rule)
        and value.__module__ == module.__name__
        and "code" in vars(value)
    ]


def describe(rule: type[Rule]) -> RuleFacts:
    """The facts of a rule, from its class."""
    from sdfcheck.consumers.measured import always_known
    from sdfcheck.consumers.reaction import by_dialect

    is_built_in = rule.__module__.startswith(f"{BUILT_IN}.")
    fixed = [bad for bad in rule.bad if bad.fixed is not None]
    fixable = "" if not fixed else "safe" if any(not bad.unsafe for bad in fixed) else "unsafe"
    return RuleFacts(
        rule.code,
        rule.name,
        rule.code.rstrip("0123456789"),
        rule.severity,
        summary(rule),
        fixable,
        rule.default,
        rule.selects,
        tuple(kind.__name__ for kind in rule.explains),
        always_known(rule.code) if is_built_in else by_dialect(rule.affects),
        rule.__module__,
        tuple(kind.__name__ for kind in rule.looks_at),
        rule.needs,
        rule.preview,
    )


def summary(rule: type[Rule]) -> str:
    """The first paragraph of a rule's manual, on one line."""
    return " ".join((rule.__doc__ or "").strip().partition("\n\n")[0].split())


Record = tuple[Any, ...]
"""The facts of a rule as an index has them: constants only, which load fastest."""

_SEVERITIES = {severity.value: severity for severity in Severity}
_SEVERITY, _AFFECTS = RuleFacts._fields.index("severity"), RuleFacts._fields.index("affects")


def to_record(facts: RuleFacts) -> Record:
    affects = tuple((consumer, tuple(reactions.items())) for consumer, reactions in facts.affects.items())
    return tuple(facts._replace(severity=facts.severity.value, affects=affects))  # type: ignore[arg-type]


def from_record(record: Record) -> RuleFacts:
    values = list(record)
    values[_SEVERITY] = _SEVERITIES[record[_SEVERITY]]
    values[_AFFECTS] = {consumer: dict(reactions) for consumer, reactions in record[_AFFECTS]}
    return RuleFacts(*values)
