"""Joints of a block with one mistake, for one diagnostic."""

from collections.abc import Callable
from typing import TypeVar

from sdfcheck import ControlComponent, Ros2Control

Key = TypeVar("Key", bound=tuple[str, ...])


def alike(
    block: Ros2Control, key: Callable[[ControlComponent], Key | None]
) -> dict[Key, list[ControlComponent]]:
    """The joints of a block that have a key, by their key."""
    found: dict[Key, list[ControlComponent]] = {}
    for component in block.components:
        if component.what == "joint" and (own := key(component)) is not None:
            found.setdefault(own, []).append(component)
    return found
