"""Names that a model can hold: one space for links, joints and frames, no ``::``, nothing reserved."""

from __future__ import annotations

from sdfcheck.convert.loss import Loss, LossKind, loss_at
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.mechanism import Mechanism

WORLD = "world"


class Names:
    """The new names of links and joints; a link goes before a joint of its name."""

    def __init__(self, robot: Mechanism, *, world_is_root: bool) -> None:
        self.links: dict[str, str] = {}
        self.joints: dict[str, str] = {}
        self.losses: list[Loss] = []
        self._taken: set[str] = set()
        for name, link in robot.links.items():
            wished = f"{name}_link" if name == WORLD else legal(name)
            self.links[name] = self._settle(wished)
            # The root link `world` is the world itself, and only its shapes need a link.
            if self.links[name] != name and not (world_is_root and name == WORLD):
                self._report(
                    f"link `{name}` is named `{self.links[name]}`",
                    loss_at(link.element, LossKind.RENAMED, ""),
                )
        for name, joint in robot.joints.items():
            wished = legal(name)
            if joint.kind == "floating":  # it is not written: its name is free, also for a block's own joint
                self.joints[name] = wished
                continue
            if wished in self._taken:
                wished = f"{wished}_joint"
            self.joints[name] = self._settle(wished)
            if self.joints[name] != name:
                text = f"joint `{name}` is named `{self.joints[name]}`"
                self._report(text, loss_at(joint.element, LossKind.RENAMED, ""))

    def free(self, wished: str) -> str:
        """A name that nothing else has; it is taken from now on."""
        return self._settle(wished)

    def claim(self, name: str) -> bool:
        """Take a name; False if something else has it."""
        if name in self._taken:
            return False
        self._taken.add(name)
        return True

    def _settle(self, wished: str) -> str:
        name, number = wished, 1
        while name in self._taken:
            number += 1
            name = f"{wished}_{number}"
        self._taken.add(name)
        return name

    def _report(self, text: str, at: Loss) -> None:
        self.losses.append(Loss(at.kind, at.span, text, Severity.WARNING, (), at.origins))


def legal(name: str) -> str:
    """A name without what SDFormat reads into names."""
    text = name.replace("::", "__")
    if text == WORLD:
        return f"{WORLD}_"
    if len(text) > 4 and text.startswith("__") and text.endswith("__"):
        return f"{text[2:-2]}_"
    return text or "unnamed"
