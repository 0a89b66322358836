"""Packages that are functions, too."""

from __future__ import annotations

import sys
from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from inspect import Signature


class CallablePackage(ModuleType):
    # Importing a module of a package makes the package an attribute of the one around it,
    # where a function of its name would have been: so the package itself is the function
    # of the same name in its module ``call``, with its signature and manual.

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        return _function(self)(*arguments, **options)

    @property
    def __signature__(self) -> Signature:
        from inspect import signature

        return signature(_function(self))

    @property
    def __doc__(self) -> str:  # type: ignore[override]
        name = self.__name__.rpartition(".")[2]
        return f"{name}{self.__signature__}\n\n{_function(self).__doc__}"


def _function(package: ModuleType) -> Callable[..., Any]:
    from importlib import import_module

    module = import_module(f"{package.__name__}.call")
    function: Callable[..., Any] = getattr(module, package.__name__.rpartition(".")[2])
    return function


def make_callable(name: str) -> None:
    """Make a package that is being imported callable."""
    sys.modules[name].__class__ = CallablePackage
