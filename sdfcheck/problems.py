"""The kinds of problem that the analyses find; rules put them into words.

Each is a small named tuple; its class says what its fields hold.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sdfcheck.formats.namespace_problems import *  # noqa: F403
    from sdfcheck.formats.problems import *  # noqa: F403
    from sdfcheck.formats.urdf_problems import *  # noqa: F403
    from sdfcheck.formats.vendor_problems import *  # noqa: F403
    from sdfcheck.model.drake_problems import *  # noqa: F403
    from sdfcheck.model.file_problems import *  # noqa: F403
    from sdfcheck.model.frames import *  # noqa: F403
    from sdfcheck.model.gazebo_problems import *  # noqa: F403
    from sdfcheck.model.include_problems import *  # noqa: F403
    from sdfcheck.model.inertia import *  # type: ignore[assignment]  # noqa: F403
    from sdfcheck.model.joint_problems import *  # noqa: F403
    from sdfcheck.model.model_config import *  # type: ignore[assignment]  # noqa: F403
    from sdfcheck.model.mujoco_urdf import *  # type: ignore[assignment]  # noqa: F403
    from sdfcheck.model.names import *  # type: ignore[assignment]  # noqa: F403
    from sdfcheck.model.robot_problems import *  # noqa: F403
    from sdfcheck.model.rotation_checks import *  # type: ignore[assignment]  # noqa: F403
    from sdfcheck.source.problems import *  # noqa: F403
    from sdfcheck.source.xacro.problems import *  # noqa: F403

_HOMES = (
    "sdfcheck.source.problems",
    "sdfcheck.formats.namespace_problems",
    "sdfcheck.formats.problems",
    "sdfcheck.model.names",
    "sdfcheck.model.frames",
    "sdfcheck.model.joint_problems",
    "sdfcheck.model.rotation_checks",
    "sdfcheck.model.inertia",
    "sdfcheck.formats.urdf_problems",
    "sdfcheck.model.robot_problems",
    "sdfcheck.model.file_problems",
    "sdfcheck.model.include_problems",
    "sdfcheck.model.model_config",
    "sdfcheck.source.xacro.problems",
    "sdfcheck.formats.vendor_problems",
    "sdfcheck.model.drake_problems",
    "sdfcheck.model.gazebo_problems",
    "sdfcheck.model.mujoco_urdf",
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
