"""Rule packs: found, read, classified; the built-in one comes in by the same door.

A pack is an import package or a folder of Python files. A pack may ship an index
(``rule_index.py``, written by :mod:`sdfcheck.lint.index`) that says what can be known of
its rules without importing them, and with it their conditions in one module
(``conditions.py``, by :mod:`sdfcheck.lint.conditions`); one without an index is imported
whole. It may also ship tables of a vendor's own elements (``<prefix>.vendor.txt``),
against which documents that use the prefix are checked.
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from sdfcheck.formats.vendor.files import BUILT_IN as BUILT_IN_TABLES
from sdfcheck.formats.vendor.files import SUFFIX, prefix_of
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.run import RuleFacts
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.lint.rule import Rule

    Condition = Callable[[Any], bool]

BUILT_IN = "sdfcheck_rules"
INDEX = "rule_index"
"""The module of a pack that tells of its rules."""
CONDITIONS = "conditions"
"""The module of a pack with an index that holds the conditions of its rules."""


class PackError(Exception):
    """A pack that cannot be loaded; the text is fit for the user."""


class Pack(NamedTuple):
    """A pack's name as given, the folder of its modules and the package that they are imported as."""

    name: str
    folder: Path
    package: str


class RuleIndex:
    """The rules that are there: their facts at once, their conditions and classes when asked for."""

    def __init__(
        self, facts: Sequence[RuleFacts], tables: Sequence[Path] = (), conditions: Sequence[str] = ()
    ) -> None:
        """``conditions`` are the modules that hold conditions of the rules."""
        self.facts = tuple(sorted(facts))
        self.tables = {prefix_of(path): path for path in (*BUILT_IN_TABLES, *tables)}
        """Prefix → the table of the elements that it brings."""
        self._rules: dict[str, Rule] = {}
        self._conditions: dict[str, Condition] | None = None
        self._modules_of_conditions = conditions

    def condition(self, facts: RuleFacts) -> Condition:
        """What decides at little cost whether a rule has something to report."""
        if self._conditions is None:
            self._conditions = {}
            for module in self._modules_of_conditions:
                self._conditions.update(importlib.import_module(module).CONDITIONS)
        found = self._conditions.get(facts.code)
        return self.rule(facts).applies if found is None else found

    def rule(self, facts: RuleFacts) -> Rule:
        """The rule itself; its module is imported now if it was not before."""
        found = self._rules.get(facts.code)
        if found is None:
            module = sys.modules.get(facts.module) or importlib.import_module(facts.module)
            found = self._rules[facts.code] = next(c for c in rule_classes(module) if c.code == facts.code)()
        return found


def load_index(plugins: Sequence[str | Path] = ()) -> RuleIndex:
    """The built-in rules and those of the plugins (import names or folders).

    Raises PackError for a plugin that cannot be loaded or that takes a code, a name or a
    prefix that is taken.
    """
    facts: list[RuleFacts] = []
    tables = {prefix_of(path): path for path in BUILT_IN_TABLES}
    taken: dict[str, RuleFacts] = {}
    packs = [find_pack(name) for name in (BUILT_IN, *plugins)]
    for pack in packs:
        for fact in read_pack(pack):
            for key in (fact.code, fact.name):
                if key in taken:
                    raise PackError(f"plugin {pack.name}: {key} is taken by {taken[key].module}")
                taken[key] = fact
            facts.append(fact)
    for pack in packs[1:]:
        for path in read_tables(pack):
            first = tables.setdefault(prefix_of(path), path)
            if first is not path:
                raise PackError(f"plugin {pack.name}: the prefix {prefix_of(path)} is taken by {first}")
    conditions = [f"{pack.package}.{CONDITIONS}" for pack in packs if has_index(pack, CONDITIONS)]
    return RuleIndex(facts, tuple(tables.values()), conditions)


def read_tables(pack: Pack) -> list[Path]:
    """The tables of a pack's vendors; raises PackError for one that cannot be read."""
    paths = sorted(pack.folder.glob(f"*{SUFFIX}"))
    if paths:
        from sdfcheck.formats.vendor.definitions import DIALECTS, BadTable
        from sdfcheck.formats.vendor.table import vendor

        try:
            for path in paths:
                for dialect in DIALECTS:
                    vendor(path, dialect)
        except BadTable as error:
            raise PackError(f"plugin {pack.name}: {error}") from None
    return paths


def find_pack(name: str | Path) -> Pack:
    """Locate a pack: a folder if there is one of that name, else an import package."""
    folder = Path(name)
    if isinstance(name, Path) or "/" in name or folder.is_dir():
        if not folder.is_dir():
            raise PackError(f"plugin {name}: no such folder")
        return Pack(str(name), folder, f"sdfcheck_plugin_{folder.resolve().name}")
    import importlib.util

    try:
        spec = importlib.util.find_spec(name)
    except (ImportError, ValueError) as error:
        raise PackError(f"plugin {name}: {error}") from None
    if spec is None or not spec.submodule_search_locations:
        raise PackError(f"plugin {name}: no package of that name can be imported, and no folder is there")
    return Pack(name, Path(next(iter(spec.submodule_search_locations))), name)


def read_pack(pack: Pack) -> list[RuleFacts]:
    """The facts of a pack's rules: from its index, or else by importing all of it."""
    if has_index(pack):
        records = importlib.import_module(f"{pack.package}.{INDEX}").RULES
        return [from_record(record) for record in records]
    return [describe(rule) for module in import_pack(pack) for rule in rule_classes(module)]


def has_index(pack: Pack, *others: str) -> bool:
    """Does a pack ship an index, and the ``others`` of the modules that are written with it?"""
    written = (INDEX, *others)
    return pack.package == pack.name and all((pack.folder / f"{name}.py").is_file() for name in written)


def import_pack(pack: Pack) -> Iterator[ModuleType]:
    """Every module of a pack; raises PackError naming the one that fails."""
    written = {pack.folder / f"{name}.py" for name in (INDEX, CONDITIONS) if has_index(pack)}
    for path in sorted({*pack.folder.rglob("*.py")} - written):
        parts = path.relative_to(pack.folder).with_suffix("").parts
        name = ".".join((pack.package, *(part for part in parts if part != "__init__")))
        try:
            yield importlib.import_module(name) if pack.package == pack.name else _load_file(name, path)
        except Exception as error:  # a stranger's module may fail in any way
            raise PackError(f"plugin {pack.name}: {path.name}: {type(error).__name__}: {error}") from error


def _load_file(name: str, path: Path) -> ModuleType:
    if name in sys.modules:
        return sys.modules[name]
    import importlib.util

    spec = importlib.util.spec_from_file_location(name, path)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    try:
        spec.loader.exec_module(module)
    except BaseException:
        del sys.modules[name]
        raise
    return module


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
    from sdfcheck.consumers.reaction import by_dialect

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
        by_dialect(rule.affects),
        rule.__module__,
        tuple(kind.__name__ for kind in rule.looks_at),
    )


def summary(rule: type[Rule]) -> str:
    """The first paragraph of a rule's manual, on one line."""
    return " ".join((rule.__doc__ or "").strip().partition("\n\n")[0].split())


def to_record(facts: RuleFacts) -> dict[str, object]:
    return {**facts._asdict(), "severity": facts.severity.value}


def from_record(record: dict[str, object]) -> RuleFacts:
    fields = dict(record)
    fields["severity"] = Severity(fields["severity"])
    for name in ("selects", "explains", "looks_at"):
        fields[name] = tuple(fields[name])  # type: ignore[arg-type]
    return RuleFacts(**fields)  # type: ignore[arg-type]
