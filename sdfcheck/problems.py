"""The kinds of problem that the analyses find; rules put them into words.

Each is a small named tuple; its class says what its fields hold.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sdfcheck.formats.problems import *  # noqa: F403
    from sdfcheck.robot.includes.included import *  # noqa: F403
    from sdfcheck.source.decode import *  # noqa: F403
    from sdfcheck.source.problems import *  # noqa: F403
    from sdfcheck.xacro.problems import *  # noqa: F403

_HOMES = (
    "sdfcheck.source.problems",
    "sdfcheck.source.decode",
    "sdfcheck.formats.problems",
    "sdfcheck.robot.includes.included",
    "sdfcheck.xacro.problems",
)


def __getattr__(name: str) -> Any:
    """Look the kind up in the layers, the lowest first, so that only what is needed is loaded."""
    from importlib import import_module

    if not name.startswith("_"):
        for home in _HOMES:
            value = vars(import_module(home)).get(name)
            if value is not None:
                globals()[name] = value
                return value
    raise AttributeError(f"no kind of problem is called {name!r}")
