"""The materials of a URDF robot, in the order in which urdfdom reads them: those of the robot, then of each link."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.formats.urdf.table import is_expression

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.parts.material import Material


class MaterialNames:
    """The materials that the names in a robot reach. Nobody reads those of collisions."""

    def __init__(self, model: Model) -> None:
        self.model = model
        self.defined: dict[str, Material] = {}
        """Name → the first definition: one of the robot, or of the first visual that says what it looks like."""
        self.redefined: list[tuple[Material, Material]] = []
        """Materials that look otherwise than the first of their name, with that one."""
        nameless = 0
        for material in model.materials:
            if name := material.element.text_of("name"):
                self.defined.setdefault(name, material)
            else:
                nameless += 1
        missing: dict[str, list[Material]] = {}
        for name, material in self._used():
            if material.has_look:
                first = self.defined.setdefault(name, material)
                if first.has_look and first.look != material.look:
                    self.redefined.append((material, first))
            elif name not in self.defined:
                missing.setdefault(name, []).append(material)
        # Where a material has lost its name, that is reported, not wherever it is missed.
        found = missing if len(missing) > nameless else {}
        self.undefined = {name: uses for name, uses in found.items() if not is_expression(name)}
        """Names of which nothing has said the look so far → the materials that only name them."""

    def _used(self) -> Iterator[tuple[str, Material]]:
        for link in self.model.links:
            for visual in link.visuals:
                value = visual.own_material.name_value
                if value is not None and value.text:
                    yield value.text, visual.own_material
