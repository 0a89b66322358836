"""Names in plugins: what they call by a name that the result has for something else, or for nothing."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.urdf_to_sdf.context import Context
from sdfcheck.source.element import Element


class PluginNames:
    """Reports plugins that name links and joints which were merged or renamed; they stay as written."""

    def __init__(self, context: Context) -> None:
        self.context = context
        plan = context.plan
        self.gone: dict[str, tuple[LossKind, str]] = {}
        for name, new in plan.names.joints.items():
            if name in plan.merged_joints:
                self.gone[name] = LossKind.MERGED_LINK, f"joint `{name}` was merged"
            elif new != name:
                self.gone[name] = LossKind.RENAMED, f"joint `{name}` is now named `{new}`"
        for name, new in plan.names.links.items():
            survivor = plan.home[name][0]
            if survivor != name:
                self.gone[name] = LossKind.MERGED_LINK, f"link `{name}` is now part of link `{survivor}`"
            elif new != name and not plan.is_world(name):
                self.gone[name] = LossKind.RENAMED, f"link `{name}` is now named `{new}`"
            else:
                self.gone.pop(name, None)

    def report(self, block: Element) -> None:
        """Look at the plugins in a ``<gazebo>`` block."""
        if not self.gone:
            return
        for plugin in block.walk():
            if plugin.name != "plugin":
                continue
            for part in plugin.walk():
                if (found := self.gone.get(part.content)) is not None:
                    kind, what = found
                    self.context.note(
                        part, kind, f"<{part.name}> of {plugin.title} stays as it is, but {what}"
                    )
