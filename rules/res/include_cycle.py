import os
from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Include, Rule, Severity, Value

SELF = (
    '<sdf version="1.12"><model name="{}"><link name="l"/>'
    "<include><uri>{}</uri><name>again</name></include></model></sdf>"
)


class IncludeCycle(Rule):
    """A model includes itself, directly or by way of others.

    No consumer guards against it: libsdformat and Gazebo include until the stack is full,
    and crash.
    """

    code = "RES003"
    name = "include-cycle"
    severity = Severity.ERROR
    remedy = """Remove the include that leads back, or move the shared part to a file of its own.

    The labels show the way around. A file that wants to be used twice is included by a third one, not by
    itself.
    """
    looks_at = (Include,)

    bad = (
        Bad(
            SELF.format("self", "«self.sdf»"),
            file="self.sdf",
            files={"self.sdf": SELF.format("self", "self.sdf")},
            says="includes itself",
        ),
        Bad(
            SELF.format("a", "«b.sdf»"),
            file="a.sdf",
            files={"a.sdf": SELF.format("a", "b.sdf"), "b.sdf": SELF.format("b", "a.sdf")},
            says="by way of b.sdf",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12"><model name="m"><link name="l"/>'
            "<include><uri>arm.sdf</uri><name>left</name></include>"
            "<include><uri>arm.sdf</uri><name>right</name></include></model></sdf>",
            files={"arm.sdf": '<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>'},
            why="twice is not in a circle",
        ),
    )

    @staticmethod
    def applies(include: Include) -> bool:
        # Each cycle is reported once, in the file of it that comes first by its path.
        ring = include.ring
        return bool(ring) and real_path(ring[0]) == min(map(real_path, ring))

    def check(self, include: Include) -> Iterator[Diagnostic]:
        first, *others = include.ring
        ways = [step.element.document.path.name for step in others]
        message = f"{include.document.path.name} includes itself"
        if ways:
            message += f" by way of {', '.join(ways)}"
        yield self.diagnostic(first, message, labels=dict.fromkeys(others, "and from here"))


def real_path(step: Value) -> str:
    return os.path.realpath(step.element.document.path)
