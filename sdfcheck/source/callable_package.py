"""Packages that are functions, too."""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Any


class CallablePackage(ModuleType):
    """Calls the function of the same name in the package's module ``call``.

    Importing a module of a package makes the package an attribute of the one around it,
    where a function of its name would have been: so the package itself is the function.
    """

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        from importlib import import_module

        function = getattr(import_module(f"{self.__name__}.call"), self.__name__.rpartition(".")[2])
        return function(*arguments, **options)


def make_callable(name: str) -> None:
    """Make a package that is being imported callable."""
    sys.modules[name].__class__ = CallablePackage
