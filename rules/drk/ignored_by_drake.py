from collections.abc import Iterator

from sdfcheck import (
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Ignored,
    Reaction,
    Root,
    Rule,
    Severity,
    Value,
    ignored_by_drake,
    used,
)
from sdfcheck_rules.drk.contents import unread
from sdfcheck_rules.drk.scaffolds import AXIS, LINK, ROBOT

OUTDATED = {"physics": ("ode/provide_feedback",), "sensor": ("imu/topic",), "state": ("light", "model")}
"""Element → the paths in it that went out of the format and are not converted."""


class IgnoredByDrake(Rule):
    """A standard element or attribute that Drake ignores.

    Drake reads what it needs for dynamics and geometry. Sensors, plugins, joint friction, the surface
    parameters of Gazebo's engines and the like have no effect; for some of them there is a warning.
    """

    code = "DRK012"
    name = "ignored-by-drake"
    severity = Severity.INFO
    remedy = """Write it in Drake's way, where there is one, or leave it for the other consumers.

    Friction of contacts is `drake:proximity_properties` with `drake:mu_dynamic` and `drake:mu_static`,
    friction of joints is `damping` or a force of the program, sensors are systems of the diagram. There is
    nothing to do if the setting is for Gazebo alone.
    """
    default = False
    looks_at = (Root,)
    scaffold = LINK

    bad = (
        Bad(
            "<«enable_wind»>true</enable_wind>",
            says="`enable_wind` in `link` is ignored by Drake, with a warning",
        ),
        Bad(
            "<dynamics><«friction»>0.5</friction></dynamics>",
            says="`friction` in `axis/dynamics` is ignored by Drake, in silence",
            scaffold=AXIS,
        ),
        Bad(
            '<link name="c"/><joint name="k" type="fixed"><parent link="b"/><child link="c"/>'
            '<«calibration» rising="0"/></joint>',
            scaffold=ROBOT,
        ),
    )
    good = (
        Good("<gravity>true</gravity>", why="the only value that Drake knows"),
        Good("<dynamics><friction>0</friction></dynamics>", scaffold=AXIS),
    )

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for entry in ignored_by_drake("urdf" if root.is_urdf else "sdf"):
            uses = list(_uses(root, entry))
            if not uses or (entry.parents == ("sdf",) and unread(root) is not None):
                continue  # crashes-drake reports what is wrong at the top
            place = uses[0] if isinstance(uses[0], Element) else uses[0].name_span
            times, parent = used(len(uses)), "/".join(reversed(entry.parents))
            how = "with a warning" if entry.warned else "in silence"
            message = f"`{entry.name.removeprefix('@')}`{times} in `{parent}` is ignored by Drake, {how}"
            yield self.diagnostic(place, message, affects=_affects(uses))


def _affects(uses: list[Element | Value]) -> dict[Consumer, Reaction]:
    """Drake refuses what went out of the format, in what it ignores as well."""
    is_old = any(
        isinstance(use, Element) and any(_holds(use, path) for path in OUTDATED.get(use.name, ()))
        for use in uses
    )
    return {Consumer.DRAKE: REFUSES} if is_old else {}


def _holds(element: Element, path: str) -> bool:
    name, _, rest = path.partition("/")
    return any(not rest or _holds(child, rest) for child in element.children(name))


def _uses(root: Root, entry: Ignored) -> Iterator[Element | Value]:
    """Where something is written that Drake ignores."""
    for parent in root.elements.get(entry.parents[0], ()):
        if not _is_in(parent, entry.parents[1:]) or root.part_of(parent).is_urdf != root.is_urdf:
            continue  # what is in a <gazebo> block is written in SDFormat, and nothing to Drake
        if entry.name[0] == "@":
            value = parent.attribute(entry.name[1:])
            if value is not None and not _is(value, entry.unless):
                yield value
            continue
        for child in parent.children(entry.name):
            if not entry.unless or not _is(child.own_value, entry.unless):
                yield child


def _is_in(element: Element, parents: tuple[str, ...]) -> bool:
    """Are these the names of the elements around it, from the inside out?"""
    at = element.parent
    for name in parents:
        if at is None or at.name != name:
            return False
        at = at.parent
    return True


def _is(value: Value, wanted: str) -> bool:
    """Is it the value that Drake knows, in whichever spelling?"""
    word = value.text.strip().lower()
    if wanted in {"true", "false"}:
        return word in {wanted, "1" if wanted == "true" else "0"}
    return bool(wanted) and (word == wanted or value.number == float(wanted))
