"""Rules, and what runs them; the package can be called: ``sdfcheck.lint("robot.sdf")``."""

import sys
from types import ModuleType
from typing import Any


class _Callable(ModuleType):
    """Importing a module of the package makes the package an attribute of ``sdfcheck``: so it is the function."""

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        from sdfcheck.lint.call import lint

        return lint(*arguments, **options)


sys.modules[__name__].__class__ = _Callable
