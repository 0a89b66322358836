"""Lists the packages: the engine with its folders of data, and ``rules/`` under its import name ``sdfcheck_rules``.

Writes ``rules/conditions.py`` first, which is made from the rules and is not in the repository.
"""

import importlib.util
import sys
from pathlib import Path

from setuptools import find_namespace_packages, setup

ROOT = Path(__file__).resolve().parent
_CONDITIONS = ROOT / "rules" / "conditions.py"
_FAMILIES = find_namespace_packages("rules", exclude=["*__pycache__*"])


def _is_current() -> bool:
    """Whether no rule was changed after the conditions were written."""
    if not _CONDITIONS.exists():
        return False
    written = _CONDITIONS.stat().st_mtime
    return all(path.stat().st_mtime <= written for path in (ROOT / "rules").rglob("*.py"))


def _write_conditions() -> None:
    """Collect the conditions of the rules in one module; it takes the standard library alone."""
    sys.path.insert(0, str(ROOT))
    home = ROOT / "rules"
    spec = importlib.util.spec_from_file_location(
        "sdfcheck_rules", home / "__init__.py", submodule_search_locations=[str(home)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["sdfcheck_rules"] = package
    spec.loader.exec_module(package)
    from sdfcheck.lint.rulebook import conditions

    if conditions.main([]):
        sys.exit("the conditions of the rules cannot be written")
    _CONDITIONS.touch()


if not _is_current():
    _write_conditions()

setup(
    packages=[
        *find_namespace_packages(include=["sdfcheck", "sdfcheck.*"], exclude=["*__pycache__*"]),
        "sdfcheck_rules",
        *(f"sdfcheck_rules.{family}" for family in _FAMILIES),
    ],
    package_dir={"sdfcheck_rules": "rules"},
)
