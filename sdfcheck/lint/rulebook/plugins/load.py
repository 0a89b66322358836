"""The rules of a pack, imported: those that can run, and what is wrong with the others."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator, Sequence
from importlib import util
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

from sdfcheck.formats.vendor import BUILT_IN as BUILT_IN_TABLES
from sdfcheck.formats.vendor import SUFFIX, prefix_of
from sdfcheck.lint.rule import Rule
from sdfcheck.lint.rulebook.pack import (
    CONDITIONS,
    INDEX,
    Fault,
    Pack,
    PackError,
    describe,
    has_index,
    read_index,
)
from sdfcheck.lint.rulebook.plugins.find import find_pack
from sdfcheck.lint.rulebook.plugins.place import at, described, place_of_class, place_of_error
from sdfcheck.lint.rulebook.plugins.prints import aside
from sdfcheck.lint.rulebook.plugins.soundness import flaws
from sdfcheck.lint.run import BUILT_IN, RuleFacts
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterable

_ASIDE = ("__main__", "conftest", "setup")
"""Modules of a pack that hold no rules."""


class Loaded(NamedTuple):
    """The rules of a pack that can run, in order of files, and what is wrong with the rest."""

    rules: tuple[type[Rule], ...]
    faults: tuple[Fault, ...]


class Imported(NamedTuple):
    """The modules of a pack, and what came up in those that cannot be imported."""

    modules: list[ModuleType]
    faults: list[Fault]


class Plugins(NamedTuple):
    """The content of plugins: facts of rules, vendor tables, modules with conditions; their faults."""

    facts: tuple[RuleFacts, ...]
    tables: tuple[Path, ...]
    conditions: tuple[str, ...]
    faults: tuple[Fault, ...]


def load_plugins(
    names: Sequence[str | Path], others: Sequence[RuleFacts] = (), *, anew: bool = False
) -> Plugins:
    """The rules of plugins in addition to those of ``others``; ``anew``: without the indexes of the plugins.

    Raises:
        PackError: a plugin cannot be loaded at all, or takes a prefix that is taken.
    """
    taken = {key: fact.module for fact in others for key in (fact.code, fact.name)}
    found, faults = list[RuleFacts](), list[Fault]()
    tables = {prefix_of(path): path for path in BUILT_IN_TABLES}
    packs = [find_pack(name) for name in names]
    for pack in packs:
        own, wrong = _facts(pack, anew=anew)
        faults += wrong
        for fact, place in own:
            key = next((key for key in (fact.code, fact.name) if key in taken), None)
            if key is None:
                found.append(fact)
                taken.update({fact.code: place, fact.name: place})
            else:
                faults.append(Fault(place, f"{key} is taken by {taken[key]}; {_LEFT_OUT}"))
        for path in read_tables(pack):
            first = tables.setdefault(prefix_of(path), path)
            if first is not path:
                raise PackError(f"the prefix {prefix_of(path)} is taken by {first}", pack.name)
    conditions = tuple(f"{pack.package}.{CONDITIONS}" for pack in packs if has_index(pack, CONDITIONS))
    return Plugins(tuple(found), tuple(tables.values()), conditions, tuple(sorted(faults, key=_order)))


def _order(fault: Fault) -> tuple[str, int]:
    file, _, line = fault.place.rpartition(":")
    return file, int(line)


_LEFT_OUT = "the rule is left out"


def _facts(pack: Pack, *, anew: bool) -> tuple[list[tuple[RuleFacts, str]], tuple[Fault, ...]]:
    """The facts of a pack's rules, each with its place, and the faults: by its index, or by importing it."""
    index = pack.folder / f"{INDEX}.py"
    if has_index(pack) and not anew:
        return [(fact, at(index, 1)) for fact in _indexed(pack)], ()
    rules, faults = load_rules(pack)
    if not rules and not faults and not any(pack.folder.glob(f"*{SUFFIX}")):
        raise PackError("there are no rules in it", pack.name)
    facts = [describe(rule) for rule in rules]
    if has_index(pack) and pack.name != BUILT_IN and sorted(facts) != sorted(_indexed(pack)):
        faults = (*faults, Fault(at(index, 1), f"the index is not up to date; {_WRITE_IT.format(pack.name)}"))
    return list(zip(facts, (place_of_class(rule, "code") for rule in rules), strict=True)), faults


def _indexed(pack: Pack) -> list[RuleFacts]:
    """The facts that the index of a pack has."""
    try:
        return read_index(pack.package)
    except Exception as error:
        text = f"its index cannot be read ({described(error)}); {_WRITE_IT.format(pack.name)}"
        raise PackError(text, pack.name) from error


_WRITE_IT = "write it with `python -m sdfcheck.lint.rulebook.index {}`"


def load_rules(pack: Pack) -> Loaded:
    """Import all of a pack, and judge its rules.

    Raises:
        PackError: the package itself cannot be imported.
    """
    modules, faults = import_pack(pack)
    rules = []
    for rule in _rules(modules):
        wrong = list(flaws(rule))
        if wrong:
            texts = "; ".join(flaw.text for flaw in wrong)
            faults.append(
                Fault(place_of_class(rule, wrong[0].attribute), f"{rule.__name__}: {texts}; {_LEFT_OUT}")
            )
        else:
            rules.append(rule)
    return Loaded(tuple(rules), tuple(faults))


def _rules(modules: Iterable[ModuleType]) -> Iterator[type[Rule]]:
    """The rules that modules define, also faulty ones: all but those that others are derived from."""
    classes = [
        value
        for module in modules
        for value in vars(module).values()
        if isinstance(value, type) and issubclass(value, Rule) and value.__module__ == module.__name__
    ]
    bases = {base for rule in classes for base in rule.__mro__[1:]}
    for rule in dict.fromkeys(classes):
        if "code" in vars(rule) or (rule not in bases and not rule.__name__.startswith("_")):
            yield rule


def import_pack(pack: Pack) -> Imported:
    """Every module of a pack; one that fails does not keep the others from being imported.

    Raises:
        PackError: the package itself cannot be imported.
    """
    importlib.invalidate_caches()
    imported = Imported([], [])
    with aside(pack.name):
        try:
            _open(pack)
        except KeyboardInterrupt:
            raise
        except BaseException as error:  # a module of a plugin may fail in any way
            raise PackError(_failure(error, pack.package, pack.folder), pack.name) from error
        for name, path in _modules(pack):
            made = _import(name)
            if isinstance(made, ModuleType):
                imported.modules.append(made)
            else:
                place = place_of_error(made, pack.package) or at(path, 1)
                text = f"{path.name} cannot be imported: {described(made)}; its rules are left out"
                imported.faults.append(Fault(place, text))
    return imported


def _import(name: str) -> ModuleType | BaseException:
    try:
        return importlib.import_module(name)
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        return error


def _failure(error: BaseException, package: str, folder: Path) -> str:
    return f"{place_of_error(error, package, folder) or at(folder, 1)}: {described(error)}"


def _open(pack: Pack) -> None:
    """Import the package; a folder becomes one."""
    if pack.is_importable:
        importlib.import_module(pack.package)
        return
    if pack.package in sys.modules:
        return
    start = pack.folder / "__init__.py"
    if not start.is_file():
        package = ModuleType(pack.package)
        package.__path__ = [str(pack.folder)]
        sys.modules[pack.package] = package
        return
    spec = util.spec_from_file_location(pack.package, start, submodule_search_locations=[str(pack.folder)])
    assert spec
    assert spec.loader
    package = sys.modules[pack.package] = util.module_from_spec(spec)
    try:
        spec.loader.exec_module(package)
    except BaseException:
        del sys.modules[pack.package]
        raise


def _modules(pack: Pack) -> Iterator[tuple[str, Path]]:
    """The import names and files of a pack's modules; not of its tests."""
    if pack.file is not None:
        yield pack.package, pack.file
        return
    written = {pack.folder / f"{name}.py" for name in (INDEX, CONDITIONS) if has_index(pack)}
    for path in sorted({*pack.folder.rglob("*.py")} - written):
        *folders, stem = path.relative_to(pack.folder).with_suffix("").parts
        if stem in _ASIDE or stem.startswith("test_") or any(f[0] == "." or f == "tests" for f in folders):
            continue
        yield ".".join((pack.package, *folders, *([] if stem == "__init__" else [stem]))), path


def read_tables(pack: Pack) -> list[Path]:
    """The tables of a pack's vendors; raises PackError for one that cannot be read."""
    paths = [] if pack.file is not None else sorted(pack.folder.glob(f"*{SUFFIX}"))
    if paths:
        from sdfcheck.formats.vendor.definitions import DIALECTS, BadTable
        from sdfcheck.formats.vendor.table import vendor

        try:
            for path in paths:
                for dialect in DIALECTS:
                    vendor(path, dialect)
        except BadTable as error:
            raise PackError(str(error), pack.name) from None
    return paths
