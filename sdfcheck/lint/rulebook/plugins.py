"""Plugins: packs of rules from folders and installed distributions, found, loaded and called with care."""

from __future__ import annotations

import ast
import importlib
import io
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, redirect_stdout
from functools import cache, wraps
from importlib import import_module, util
from pathlib import Path
from types import ModuleType, NoneType, TracebackType
from typing import TYPE_CHECKING, Any
from zlib import crc32

from sdfcheck.formats.vendor import BUILT_IN as BUILT_IN_TABLES
from sdfcheck.formats.vendor import SUFFIX, prefix_of
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.example import Bad, Good
from sdfcheck.lint.fix import Fix, TextEdit
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
from sdfcheck.lint.run import BUILT_IN, RuleFacts
from sdfcheck.source.document import Element
from sdfcheck.source.errors import REPORT_IT
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span, shown

if TYPE_CHECKING:
    from collections.abc import Iterable


# Where a pack is: a folder, an entry point of an installed distribution, or an import name.

GROUP = "sdfcheck.rules"
"""The entry points by which installed packs are known."""


def find_pack(name: str | Path) -> Pack:
    """Locate a pack: a folder if the name is a path, else an entry point, else a package or module.

    Raises: PackError: the pack is not found.
    """
    if isinstance(name, Path) or "/" in name or os.sep in name:
        return _in_folder(Path(name))
    module = None if name == BUILT_IN else _entry_point(name)
    return _imported(name, module or name)


def _in_folder(folder: Path) -> Pack:
    if not os.path.isdir(folder):
        raise PackError("no such folder", str(folder))
    real = folder.resolve()
    # Two folders of one name are two packs.
    package = f"sdfcheck_plugin_{re.sub(r'[^0-9A-Za-z]', '_', real.name)}_{crc32(str(real).encode()):08x}"
    return Pack(str(folder), Path(os.path.abspath(folder)), package)


def _entry_point(name: str) -> str | None:
    """The module that an installed distribution declares under a name; None if none does."""
    from importlib.metadata import entry_points

    modules = sorted({point.value.strip() for point in entry_points(group=GROUP, name=name)})
    if len(modules) > 1:
        raise PackError(f"several installed packages declare it: {', '.join(modules)}", name)
    if modules and not re.fullmatch(r"\w+(\.\w+)*", modules[0]):
        raise PackError(
            f"its entry point `{modules[0]}` should name a package or module and nothing in it", name
        )
    return modules[0] if modules else None


def _imported(name: str, module: str) -> Pack:
    try:
        spec = util.find_spec(module)
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # the packages around it are imported, and may fail in any way
        raise PackError(described(error), name) from error
    if spec is not None and spec.submodule_search_locations:
        return Pack(name, Path(next(iter(spec.submodule_search_locations))), module)
    if spec is not None and spec.origin is not None and spec.origin.endswith(".py"):
        return Pack(name, Path(spec.origin).parent, module, Path(spec.origin))
    if module != name:
        raise PackError(f"its entry point names `{module}`, which cannot be imported", name)
    raise PackError(f"no folder, no entry point `{GROUP}` and no package of that name is there", name)


def read_tables(pack: Pack) -> list[Path]:
    """The tables of a pack's vendors; raises PackError for one that cannot be read."""
    paths = [] if pack.file is not None else sorted(pack.folder.glob(f"*{SUFFIX}"))
    if paths:
        from sdfcheck.formats.vendor.definitions import BadTable
        from sdfcheck.formats.vendor.table import check_tables

        try:
            check_tables(paths)
        except BadTable as error:
            raise PackError(str(error), pack.name) from None
    return paths


@cache
def tables_of(plugins: tuple[str | Path, ...]) -> tuple[Path, ...]:
    """The tables of all plugins; none of one that cannot be loaded, which linting reports."""
    return tuple(table for plugin in plugins for table in _readable(plugin))


def _readable(plugin: str | Path) -> list[Path]:
    try:
        return read_tables(find_pack(plugin))
    except PackError:
        return []


# Where something of a pack is written: file and line of a class, of its examples, of a failure.

_LONGEST = 200
"""More of an error's text does not help on one line."""


class Misbehavior(Exception):
    """A rule does what rules must not do: where, and in words for its author."""

    def __init__(self, place: str, text: str) -> None:
        super().__init__(text)
        self.place = place


def described(error: BaseException) -> str:
    """An error on one line, whatever it is."""
    try:
        text = error.msg if isinstance(error, SyntaxError) else str(error)
    except Exception:
        text = ""
    text = " ".join(text.split())
    text = text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"
    if isinstance(error, Misbehavior):
        return text
    return f"{type(error).__name__}: {text}" if text else type(error).__name__


def at(path: Path | str, line: int) -> str:
    """A place as people and terminals understand it."""
    return f"{shown(Path(path))}:{line}"


def failure(facts: RuleFacts, error: BaseException) -> tuple[str, str]:
    """The failure of a rule, its place, and the way to fix it."""
    place = error.place if isinstance(error, Misbehavior) else place_of_error(error, facts.module)
    where = f" at {place}" if place else ""
    message = f"rule {facts.code} {facts.name} failed{where}: {described(error)}"
    if facts.is_built_in:
        return message, REPORT_IT
    return message, f'correct the rule, or leave it out with `ignore = ["{facts.name}"]`'


def place_of_error(error: BaseException, module: str, *folders: Path) -> str | None:
    """The innermost place within the package of a module, or within folders, at which an error came up."""
    roots = (*_roots(module), *(f"{folder}{os.sep}" for folder in folders))
    if isinstance(error, SyntaxError) and str(error.filename).startswith(roots):
        return at(str(error.filename), error.lineno or 1)
    places = [(file, line) for file, line in _frames(error.__traceback__) if file.startswith(roots)]
    return at(*places[-1]) if places else None


def place_of_check(rule: type) -> str:
    """Where the ``check`` of a rule begins; the class, if it is not a plain function."""
    code = getattr(getattr(rule, "check", None), "__code__", None)
    return at(code.co_filename, code.co_firstlineno) if code else place_of_class(rule)


def place_of_class(rule: type, attribute: str = "") -> str:
    """Where a class assigns an attribute; the class itself, if it does not."""
    node = _class(rule)
    line = 1 if node is None else node.lineno
    value = None if node is None else _assigned(node, attribute)
    return at(_file(rule), line if value is None else value.lineno)


def places_of_examples(rule: type, attribute: str, count: int) -> list[str]:
    """Where the examples in ``bad`` or ``good`` are, one by one as far as they are written so."""
    owner = next(base for base in rule.__mro__ if attribute in vars(base))
    node = _class(owner)
    value = None if node is None else _assigned(node, attribute)
    if isinstance(value, ast.Tuple | ast.List) and len(value.elts) == count:
        return [at(_file(owner), item.lineno) for item in value.elts]
    return [place_of_class(owner, attribute)] * count


def _roots(module: str) -> tuple[str, ...]:
    top = sys.modules.get(module.partition(".")[0])
    folders = tuple(f"{folder}{os.sep}" for folder in getattr(top, "__path__", ()))
    file = getattr(top, "__file__", None)
    return (*folders, file) if file else folders or ("\0",)


def _frames(trace: TracebackType | None) -> Iterator[tuple[str, int]]:
    while trace is not None:
        yield trace.tb_frame.f_code.co_filename, trace.tb_lineno
        trace = trace.tb_next


def _file(rule: type) -> str:
    return getattr(sys.modules.get(rule.__module__), "__file__", None) or rule.__module__


def _class(rule: type) -> ast.ClassDef | None:
    classes = [node for node in ast.walk(_tree(_file(rule))) if isinstance(node, ast.ClassDef)]
    return next((node for node in classes if node.name == rule.__name__), None)


def _tree(file: str) -> ast.Module:
    try:
        return ast.parse(Path(file).read_bytes())
    except (OSError, SyntaxError, ValueError):
        return ast.Module([], [])


def _assigned(node: ast.ClassDef, attribute: str) -> ast.expr | None:
    """The value that the body of a class gives an attribute."""
    for part in reversed(node.body):
        targets = part.targets if isinstance(part, ast.Assign) else [getattr(part, "target", None)]
        if any(isinstance(target, ast.Name) and target.id == attribute for target in targets):
            return getattr(part, "value", None)
    return None


# Calls to rules of plugins, which may do anything: what they return is checked, what they print set aside.

# Prints of rules go to stderr: stdout carries the report.


class Aside(io.TextIOBase):
    """A stream to stderr that says once whose prints these are."""

    def __init__(self, whose: str) -> None:
        self._whose = whose
        self._is_named = False

    def write(self, text: str) -> int:
        """Write to stderr."""
        if not self._is_named and text:
            self._is_named = True
            sys.stderr.write(f"warning: {self._whose} prints; this is not part of the report:\n")
        return sys.stderr.write(text)

    def flush(self) -> None:
        """Nothing is held back."""
        sys.stderr.flush()


@contextmanager
def aside(name: str) -> Iterator[None]:
    """While this lasts, what is printed is the plugin's."""
    with redirect_stdout(Aside(f"plugin {name}")):
        yield


_END = object()
_LONG = 60
"""More of a strange value does not help on one line."""


def guard(rule: Rule) -> None:
    """Hold a rule to what rules promise.

    Its ``check`` then raises Misbehavior for a result that is not a diagnostic of the rule; prints
    of ``check`` and ``applies`` go to stderr.
    """
    place = place_of_check(type(rule))
    prints = Aside(f"rule {rule.code} {rule.name} ({place})")
    applies, check = rule.applies, rule.check

    @wraps(applies)
    def guarded_applies(subject: Any) -> bool:
        with redirect_stdout(prints):
            return applies(subject)

    @wraps(check)
    def guarded_check(subject: Any) -> Iterator[Diagnostic]:
        with redirect_stdout(prints):
            items = _iterated(check(subject), place)
        while True:
            with redirect_stdout(prints):
                item: Any = next(items, _END)
            if item is _END:
                return
            if wrong := next(_wrong(item, rule), None):
                raise Misbehavior(place, wrong)
            yield item

    vars(rule).update(applies=guarded_applies, check=guarded_check)


def _iterated(returned: Any, place: str) -> Iterator[Any]:
    """The diagnostics that a rule yields."""
    if isinstance(returned, Diagnostic):
        raise Misbehavior(place, "`check` returned a Diagnostic: yield it")
    if isinstance(returned, str) or not isinstance(returned, Iterable):
        raise Misbehavior(place, f"`check` should yield diagnostics, and returned {_shortened(returned)}")
    return iter(returned)


def _wrong(item: Any, rule: Rule) -> Iterator[str]:
    """The fault of something that a rule has yielded."""
    if not isinstance(item, Diagnostic):
        yield f"`check` yielded {_shortened(item)}, not a Diagnostic: use self.diagnostic(…)"
        return
    fields = item._asdict()
    if (item.code, item.name) != (rule.code, rule.name):
        yield f"`check` yielded a diagnostic of {item.code} {item.name}, not of its own"
    for field, kind, expected in _FIELDS:
        if not isinstance(fields[field], kind):
            yield f"`check` yielded a diagnostic with {_shortened(fields[field])} as {field}: it should be {expected}"
    if not all(isinstance(text, str) for _, text in item.labels):
        yield "`check` yielded a diagnostic with a label that is not a text"
    if item.fix is not None and not all(_is_edit(edit) for edit in item.fix.edits):
        yield "`check` yielded a diagnostic with a fix whose edits are not Edits of a span and a text"


_FIELDS: tuple[tuple[str, type | tuple[type, ...], str], ...] = (
    ("message", str, "a text"),
    ("severity", Severity, "a Severity"),
    ("span", Span, "an element, a value or a Span"),
    ("labels", tuple, "pairs of a place and a text"),
    ("help", (str, NoneType), "a text"),
    ("fix", (Fix, NoneType), "a Fix, as sdfcheck.replace and sdfcheck.edit make it"),
)


def _is_edit(edit: Any) -> bool:
    fields = tuple(edit) if isinstance(edit, TextEdit) else (None, None)
    return isinstance(fields[0], Span) and isinstance(fields[1], str)


def _shortened(value: object) -> str:
    text = repr(value)
    return text if len(text) < _LONG else f"{text[:_LONG]}…"


# The rules of a pack, imported: those that can run, and what is wrong with the others, at its place.

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
    from sdfcheck.formats.describe import UnknownPlace, describe

    try:
        describe(selector)
    except UnknownPlace as error:
        return f"`selects` has `{selector}`, which is nowhere: {error}"
    return None


def _looks_at(value: object) -> str | None:
    if text := _tuple_of("looks_at", type, "classes, such as Joint")(value):
        return text
    from sdfcheck.lint.subjects import OF_TEXT, OF_VENDORS
    from sdfcheck.robot.root import ELEMENTS, SPECIAL

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
        raise PackError(f"there are neither rules nor tables (*{SUFFIX}) in it", pack.name)
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
    if not os.path.isfile(start):
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
