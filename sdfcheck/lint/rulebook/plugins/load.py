"""The rules of a pack, imported: those that can run, and what is wrong with the others, at its place."""

from __future__ import annotations

import importlib
import re
import sys
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module, util
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from sdfcheck.formats.vendor import BUILT_IN as BUILT_IN_TABLES
from sdfcheck.formats.vendor import SUFFIX, prefix_of
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.example import Bad, Good
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
from sdfcheck.lint.rulebook.plugins.call import aside
from sdfcheck.lint.rulebook.plugins.find import find_pack, read_tables
from sdfcheck.lint.rulebook.plugins.place import at, described, place_of_class, place_of_error
from sdfcheck.lint.run import BUILT_IN, RuleFacts
from sdfcheck.source.document import Element
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from collections.abc import Iterable


# Faults that keep a rule from running at all: attributes that are missing or malformed.


_CODE = r"[A-Z][A-Z0-9]*[A-Z][0-9]{3,}|[A-Z][0-9]{3,}"
_NAME = r"[a-z][a-z0-9]*(-[a-z0-9]+)*"
_DIALECTS = ("sdf", "urdf", "xacro", "model-config")


class Flaw(NamedTuple):
    """The fault of an attribute of a rule."""

    attribute: str
    text: str


def flaws(rule: type[Rule]) -> Iterator[Flaw]:
    """The faults of a rule, one for each attribute at most."""
    for attribute, examine in _EXAMINED.items():
        value = vars(rule).get(attribute) if attribute == "code" else getattr(rule, attribute, None)
        text = examine(value) if value is not None else _MISSING.get(attribute)
        if text:
            yield Flaw(attribute, text)
    if not (rule.__doc__ or "").strip():
        yield Flaw("", "has no docstring, which is its manual")
    if rule.check is Rule.check:
        yield Flaw("", "has no `check`")
    if text := _looks_nowhere(rule):
        yield Flaw("", text)


_SUBJECTS = ("looks_at", "selects", "explains")
"""The attributes that say what a rule looks at."""


def _looks_nowhere(rule: type[Rule]) -> str | None:
    """The fault of the three attributes that list the targets of a rule, taken together."""
    if not any(getattr(rule, attribute) for attribute in _SUBJECTS):
        return f"looks at nothing: give it {' or '.join(f'`{name}`' for name in _SUBJECTS)}"
    if Element in rule.looks_at and not rule.selects:
        return "looks at elements, and has no `selects` that says at which"
    return None


def _spelled(attribute: str, form: str, what: str) -> Callable[[Any], str | None]:
    def examine(value: Any) -> str | None:
        is_sound = isinstance(value, str) and re.fullmatch(form, value)
        return None if is_sound else f"`{attribute}` should be {what}, not {value!r}"

    return examine


def _tuple_of(attribute: str, kind: type, what: str, *, needed: bool = False) -> Callable[[Any], str | None]:
    """Demands a tuple of instances of a type."""

    def examine(value: Any) -> str | None:
        # A single example is a named tuple, so that a forgotten comma leaves a tuple of its fields.
        if type(value) in (tuple, list) and all(isinstance(item, kind) for item in value):
            return f"has no `{attribute}` example" if needed and not value else None
        comma = ": a comma is missing after it" if isinstance(value, kind) else ""
        return f"`{attribute}` should be a tuple of {what}{comma}"

    return examine


def _examples(attribute: str, kind: type) -> Callable[[Any], str | None]:
    listed = _tuple_of(attribute, kind, f"{kind.__name__}(…)", needed=True)

    def examine(value: Any) -> str | None:
        if text := listed(value):
            return text
        strange = next((example for example in value if not isinstance(example.text, str)), None)
        return (
            None if strange is None else f"`{attribute}` has an example that is not a text: {strange.text!r}"
        )

    return examine


def _selects(value: object) -> str | None:
    form = "selectors, such as `sdf:joint/axis`"
    return _tuple_of("selects", str, form)(value) or next(filter(None, map(_selector, value)), None)  # type: ignore[call-overload]


def _selector(selector: str) -> str | None:
    """The fault of a selector: an unknown dialect, or a place that the format does not have."""
    dialect, colon, path = selector.partition(":")
    if not colon or dialect not in _DIALECTS:
        return f"`selects` has `{selector}`, which should begin with one of {', '.join(f'`{d}:`' for d in _DIALECTS)}"
    if not path or not all(path.split("/")) or "@" in path:
        return f"`selects` has `{selector}`, which should name an element after the colon, such as `{dialect}:joint`"
    if dialect in ("xacro", "model-config"):
        return None
    from sdfcheck.formats.describe.description import UnknownPlace
    from sdfcheck.formats.describe.place import describe

    try:
        describe(selector)
    except UnknownPlace as error:
        return f"`selects` has `{selector}`, which is nowhere: {error}"
    return None


def _looks_at(value: object) -> str | None:
    if text := _tuple_of("looks_at", type, "classes, such as Joint")(value):
        return text
    from sdfcheck.lint.subjects import OF_TEXT, OF_VENDORS
    from sdfcheck.robot.graph import ELEMENTS
    from sdfcheck.robot.root import SPECIAL

    known = (*ELEMENTS, *SPECIAL, *OF_TEXT, *OF_VENDORS, Element.__name__)
    strange = [kind.__name__ for kind in value if kind.__name__ not in known]  # type: ignore[attr-defined]
    return f"`looks_at` has `{strange[0]}`, which is not a part of a robot" if strange else None


def _explains(value: object) -> str | None:
    if text := _tuple_of("explains", type, "kinds of problem, such as `problems.UnknownElement`")(value):
        return text
    problems = import_module("sdfcheck.problems")

    strange = [kind for kind in value if getattr(problems, kind.__name__, None) is not kind]  # type: ignore[attr-defined]
    return f"`explains` has `{strange[0].__name__}`, which is not a kind of problem" if strange else None


def _affects(value: object) -> str | None:
    from sdfcheck.consumers.reaction import by_dialect

    try:
        by_dialect(value)  # type: ignore[arg-type]
    except Exception:
        return f"`affects` should say what consumers do, such as {{Consumer.DRAKE: REFUSES}}, not {value!r}"
    return None


def _instance(attribute: str, kind: type, what: str) -> Callable[[Any], str | None]:
    def examine(value: Any) -> str | None:
        return None if isinstance(value, kind) else f"`{attribute}` should be {what}, not {value!r}"

    return examine


_EXAMINED: dict[str, Callable[[Any], str | None]] = {
    "code": _spelled("code", _CODE, "capitals and three digits, such as `ABC001`"),
    "name": _spelled("name", _NAME, "lower-case words joined by hyphens, such as `zero-effort`"),
    "severity": _instance("severity", Severity, "a Severity, such as Severity.WARNING"),
    "looks_at": _looks_at,
    "selects": _selects,
    "needs": _tuple_of("needs", str, "texts, such as `<mesh`"),
    "explains": _explains,
    "affects": _affects,
    "default": _instance("default", bool, "True or False"),
    "preview": _instance("preview", bool, "True or False"),
    "remedy": _instance("remedy", str, "a text in Markdown"),
    "scaffold": _instance("scaffold", str, "a text with {} where the examples go"),
    "bad": _examples("bad", Bad),
    "good": _examples("good", Good),
}
_MISSING = {
    "code": "has no `code` of its own, such as `ABC001`",
    "name": "has no `name`, such as `zero-effort`",
    "severity": "has no `severity`, such as Severity.WARNING",
    "bad": "has no `bad` example",
    "good": "has no `good` example",
}


# The rules of a pack, imported: those that can run, and what is wrong with the others.


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
    tables = dict(BUILT_IN_TABLES)
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
    return Plugins(
        tuple(found),
        tuple(tables.values())[len(BUILT_IN_TABLES) :],
        conditions,
        tuple(sorted(faults, key=_order)),
    )


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
