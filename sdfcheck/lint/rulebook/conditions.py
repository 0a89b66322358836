"""Writes the conditions of a pack's rules into one module, so that a clean file loads it and no rule.

``python -m sdfcheck.lint.rulebook.conditions [PACK]``; with ``--check`` only compares. Each static
method ``applies`` is copied, with what it uses of the modules of its pack: constants and
functions under the module's name, and imports. A condition that cannot be copied is refused.
"""

from __future__ import annotations

import ast
import builtins
import copy
import os
import sys
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.lint.rule import Rule
from sdfcheck.lint.rulebook.index import keep
from sdfcheck.lint.rulebook.pack import CONDITIONS, Pack, PackError, rule_classes
from sdfcheck.lint.rulebook.plugins import import_pack
from sdfcheck.lint.run import BUILT_IN

_HEAD = '''"""The conditions of the rules, so that a clean file loads one module; written by ``make generate``."""

# The types are checked where the conditions are written.
# mypy: ignore-errors
'''


class _Module:
    """The source of a module of a pack: its statements, and those that define names."""

    def __init__(self, pack: Pack, name: str) -> None:
        self.path = Path(sys.modules[name].__file__ or "")
        self.prefix = name.removeprefix(f"{pack.package}.").replace(".", "_")
        self.statements = ast.parse(self.path.read_text(encoding="utf-8")).body
        self.defined: dict[str, ast.stmt | None] = {}
        """Name → its definition; None: there are several."""
        for node in self.statements:
            for defined in _defines(node):
                self.defined[defined] = None if defined in self.defined else node

    def method(self, qualified: str) -> ast.FunctionDef | None:
        """The definition of ``Class.method``."""
        owner, _, name = qualified.rpartition(".")
        for node in self.statements:
            if isinstance(node, ast.ClassDef) and node.name == owner:
                return next((m for m in node.body if isinstance(m, ast.FunctionDef) and m.name == name), None)
        return None

    def refusal(self, node: ast.AST | None, text: str) -> PackError:
        return PackError(f"{self.path}:{getattr(node, 'lineno', 1)}: {text}")


class _Conditions:
    """The parts of the module: the imports, the definitions by name, and the conditions by code."""

    def __init__(self, pack: Pack) -> None:
        self._pack = pack
        self._modules: dict[str, _Module] = {}
        self._imports: set[str] = set()
        self._definitions: dict[str, str] = {}
        self._names: dict[str, str] = {}

    def add(self, rule: type[Rule]) -> None:
        """Copy the condition of a rule, its own or that of a class that it extends."""
        module = self._module(rule.applies.__module__)
        node = module.method(rule.applies.__qualname__)
        if node is None or [ast.unparse(decorator) for decorator in node.decorator_list] != ["staticmethod"]:
            raise module.refusal(node, f"`applies` of {rule.code} is to be a static method of its class")
        self._names[rule.code] = self._define(module, node, f"{rule.code}_applies")

    def take(self, module: _Module, name: str, use: ast.AST) -> str:
        """Copy what a name of a module is; the name that it has among the conditions."""
        node = module.defined[name]
        if isinstance(node, ast.Import | ast.ImportFrom):
            return self._import(module, node, name)
        if (isinstance(node, ast.FunctionDef) and not node.decorator_list) or _is_constant(node):
            assert node is not None
            return self._define(module, node, f"{module.prefix}__{name}")
        raise module.refusal(use, f"a condition uses `{name}`: not a constant, plain function or import")

    def deferred(self, call: ast.Call) -> ast.Call | None:
        """A call of ``re.compile`` as one that compiles at the first use; None for packs that may pass patterns on."""
        if self._pack.package != BUILT_IN:
            return None
        self._imports.add("from sdfcheck.source.text import pattern")
        return ast.Call(ast.Name("pattern", ast.Load()), call.args, call.keywords)

    def text(self) -> str:
        table = "".join(f"    {code!r}: {name},\n" for code, name in sorted(self._names.items()))
        imports = "".join(f"{line}\n" for line in sorted(self._imports))
        return "\n".join((_HEAD, imports, *self._definitions.values(), f"CONDITIONS = {{\n{table}}}\n"))

    def _define(self, module: _Module, node: ast.stmt, name: str) -> str:
        if name not in self._definitions:
            self._definitions[name] = ""  # a function may call itself
            node = _Copier(self, module, node).visit(copy.deepcopy(node))
            if isinstance(node, ast.FunctionDef):
                node.name, node.decorator_list = name, []
            del self._definitions[name]  # what it uses comes before it
            self._definitions[name] = f"{ast.unparse(ast.fix_missing_locations(node))}\n"
        return name

    def _import(self, module: _Module, node: ast.Import | ast.ImportFrom, name: str) -> str:
        alias = next(alias for alias in node.names if (alias.asname or alias.name) == name)
        home = (node.module or "") if isinstance(node, ast.ImportFrom) else alias.name
        if home == self._pack.package or home.startswith(f"{self._pack.package}."):
            inner = self._module(home)
            if alias.name in inner.defined:
                return self.take(inner, alias.name, inner.defined[alias.name] or inner.statements[0])
        if home.partition(".")[0] not in {"sdfcheck", *sys.stdlib_module_names}:
            raise module.refusal(node, f"a condition cannot import `{name}` from `{home or '.'}`")
        if isinstance(node, ast.Import) or home == "sdfcheck":
            known = f"{home.replace('.', '_')}_"
            self._imports.add(f"import {home} as {known}")
            if isinstance(node, ast.ImportFrom):
                known = f"{known}.{alias.name}"  # loaded when it is first used
        else:
            known = f"{home.replace('.', '_')}_{alias.name}"
            self._imports.add(f"from {home} import {alias.name} as {known}")
        return known

    def _module(self, name: str) -> _Module:
        if name not in self._modules:
            if name not in sys.modules or not f"{name}.".startswith(f"{self._pack.package}."):
                raise PackError(f"{name}: a condition cannot be in a module outside of the pack")
            self._modules[name] = _Module(self._pack, name)
        return self._modules[name]


class _Copier(ast.NodeTransformer):
    """Renames what a definition uses of its module; leaves out annotations and documentation."""

    def __init__(self, conditions: _Conditions, module: _Module, node: ast.stmt) -> None:
        self._conditions, self._module = conditions, module
        self._local = set(_bound(node))

    def visit_Name(self, node: ast.Name) -> ast.expr:
        is_of_module = node.id in self._module.defined
        if node.id in self._local:
            if is_of_module:
                raise self._module.refusal(node, f"`{node.id}` is a name of the module and a local one")
        elif is_of_module:
            return ast.parse(self._conditions.take(self._module, node.id, node), mode="eval").body
        elif not hasattr(builtins, node.id):
            raise self._module.refusal(node, f"a condition uses `{node.id}`: not defined in its module")
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        if ast.unparse(node.func) == "re.compile" and "re" in self._module.defined:
            node.args = [self.visit(argument) for argument in node.args]
            node.keywords = [self.visit(keyword) for keyword in node.keywords]
            if deferred := self._conditions.deferred(node):
                return deferred
            node.func = self.visit(node.func)
            return node
        return self.generic_visit(node)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        if ast.get_docstring(node) is not None:
            node.body = node.body[1:] or [ast.Pass()]
        node.returns = None
        return self.generic_visit(node)

    def visit_arg(self, node: ast.arg) -> ast.arg:
        node.annotation = None
        return node

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.AST | None:
        return None if node.value is None else self.visit(ast.Assign([node.target], node.value))

    def visit_Global(self, node: ast.Global) -> ast.AST:
        raise self._module.refusal(node, "a condition holds no state")


def _defines(node: ast.AST) -> Iterator[str]:
    """The names that a statement of a module defines."""
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        yield node.name
    elif isinstance(node, ast.Import | ast.ImportFrom):
        yield from (alias.asname or alias.name for alias in node.names)
    elif isinstance(node, ast.Assign):
        yield from (name for target in node.targets for name in _stored(target))
    elif isinstance(node, ast.AnnAssign):
        yield from _stored(node.target)
    else:
        yield from _stored(node)


def _stored(node: ast.AST) -> Iterator[str]:
    for part in ast.walk(node):
        if isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store):
            yield part.id


def _bound(node: ast.stmt) -> Iterator[str]:
    """The names that a definition binds within itself."""
    inside = node.value if isinstance(node, ast.Assign | ast.AnnAssign) else node
    for part in ast.walk(inside) if inside is not None else ():
        if isinstance(part, ast.arg):
            yield part.arg
        elif isinstance(part, ast.ExceptHandler | ast.MatchAs | ast.MatchStar) and part.name is not None:
            yield part.name
        elif isinstance(part, ast.FunctionDef | ast.Import | ast.ImportFrom) and part is not node:
            yield from _defines(part)
    yield from _stored(inside) if inside is not None else ()


def _is_constant(node: ast.stmt | None) -> bool:
    """Does a statement define one constant value, not a container that is filled later?"""
    value = node.value if isinstance(node, ast.Assign | ast.AnnAssign) else None
    if isinstance(value, ast.Call):
        return bool(value.args or value.keywords)
    if isinstance(value, ast.List | ast.Set):
        return bool(value.elts)
    return bool(value.keys) if isinstance(value, ast.Dict) else value is not None


def render(pack: Pack) -> str:
    """The module of the conditions of a pack; raises PackError for what cannot be copied."""
    conditions = _Conditions(pack)
    modules, faults = import_pack(pack)
    if faults:
        raise PackError(str(faults[0]))
    rules = [rule for module in modules for rule in rule_classes(module)]
    for rule in sorted(rules, key=lambda rule: rule.code):
        if rule.applies is not Rule.applies:
            conditions.add(rule)
    return conditions.text()


def is_current(path: Path, text: str) -> bool:
    """Does a file say the same? Versions of Python lay out the same code differently."""
    written = path.read_text(encoding="utf-8") if os.path.isfile(path) else ""
    try:
        return written.startswith(_HEAD) and ast.dump(ast.parse(written)) == ast.dump(ast.parse(text))
    except SyntaxError:
        return False


def main(arguments: list[str]) -> int:
    try:
        return keep(arguments, CONDITIONS, render, is_current)
    except PackError as error:
        print(error)
        return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
