import re
from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Plugin, Rule, Severity, Target

LIFT = "liftdrag"
SURFACE = re.compile("rudder|aileron|elevator|elevon|flap|fin(?=_|$)")
SPARE = "flap"
"""Many planes fly without them."""
CONTROLLER = "gz-sim-joint-position-controller-system"
FIN = (
    '<link name="{0}"/><joint name="{0}_joint" type="revolute"><parent>hull</parent><child>{0}</child>'
    "<axis><xyz>0 0 1</xyz></axis></joint>"
)
FINS = FIN.format("rudder") + FIN.format("elevator")
MODEL = f'<sdf version="1.9"><model name="m"><link name="hull"/>{FINS}{{}}</model></sdf>'


def lift(joint: str) -> str:
    """The lift of a surface, which a joint may change."""
    control = f"<control_joint_name>{joint}</control_joint_name>" if joint else ""
    return (
        '<plugin filename="gz-sim-lift-drag-system" name="gz::sim::systems::LiftDrag">'
        f"<area>1</area><link_name>hull</link_name>{control}</plugin>"
    )


def servo(joint: str) -> str:
    """A plugin that turns a joint."""
    return (
        f'<plugin filename="{CONTROLLER}" name="gz::sim::systems::JointPositionController"><joint_name>{joint}'
        "</joint_name><p_gain>1</p_gain></plugin>"
    )


class IdleControlSurface(Rule):
    """A rudder, flap or elevator turns without an effect, or nothing turns it.

    The lift of a surface follows the joint that `control_joint_name` of its LiftDrag plugin names: without it the
    surface turns, and the vehicle goes straight on. A joint that is named there, and that nothing turns while others
    are turned, leaves the vehicle without that control. Surfaces are known by their names.
    """

    code = "GAZ033"
    name = "idle-control-surface"
    severity = Severity.WARNING
    remedy = """Name the joint of the surface in `<control_joint_name>` of its LiftDrag plugin, and turn it.

    `<control_joint_rad_to_cl>` says how much lift a radian adds; its sign depends on the axis of the joint.
    `gz-sim-joint-position-controller-system` with the `<joint_name>` turns it on command.
    """
    looks_at = (Plugin,)
    needs = ("LiftDrag",)
    scaffold = MODEL
    sources = ("https://gazebosim.org/api/sim/8/classgz_1_1sim_1_1systems_1_1LiftDrag.html",)

    bad = (
        Bad(
            lift("elevator_joint") + servo("elevator_joint") + lift("") + servo("«rudder_joint»"),
            says="`rudder_joint` turns a surface, and no LiftDrag plugin names it in `control_joint_name`",
        ),
        Bad(
            lift("elevator_joint") + servo("elevator_joint") + lift("«rudder_joint»"),
            says="nothing turns `rudder_joint`, and other joints of surfaces are turned",
        ),
    )
    good = (
        Good("".join(each(f"{name}_joint") for name in ("rudder", "elevator") for each in (lift, servo))),
        Good(lift("rudder_joint") + lift("elevator_joint"), why="a program may turn them"),
        Good(servo("rudder_joint"), why="without lift it is for the looks"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return next(idle(plugin), None) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for target, message in idle(plugin):
            yield self.diagnostic(target, message)


def idle(plugin: Plugin) -> Iterator[tuple[Target, str]]:
    """The names of joints whose surface has no effect or no drive, and the words for it."""
    lifts = [each for each in plugin.siblings if lifts_by(each)]
    named = {name for each in lifts for name in texts(each, ("control_joint_name", "link_name"))}
    joint = plugin.find("joint_name")
    if plugin.known is not None and plugin.known.file == CONTROLLER and joint is not None and lifts:
        part = plugin.references[0].joint if plugin.references else None
        child = part.child_name if part is not None else ""
        if (
            part is not None
            and SURFACE.search(joint.content.lower())
            and named.isdisjoint((joint.content, child))
        ):
            words = "turns a surface, and no LiftDrag plugin names it in `control_joint_name`"
            yield joint.own_value, f"`{joint.content}` {words}"
    control = plugin.find("control_joint_name")
    if control is not None and lifts_by(plugin) and SPARE not in control.content:
        others = [each for each in plugin.siblings if not lifts_by(each)]
        turned = {element.content.rpartition("::")[2] for each in others for element in each.element.walk()}
        controls = {name for each in lifts for name in texts(each, ("control_joint_name",))}
        if control.content.rpartition("::")[2] not in turned and not turned.isdisjoint(controls):
            words = "and other joints of surfaces are turned"
            yield control.own_value, f"nothing turns `{control.content}`, {words}"


def lifts_by(plugin: Plugin) -> bool:
    """Is it one of the plugins for lift?"""
    return LIFT in plugin.filename.lower().replace("-", "").replace("_", "")


def texts(plugin: Plugin, names: tuple[str, ...]) -> Iterator[str]:
    """The names of joints or links in parameters, without those of models."""
    elements: list[Element] = [each for name in names for each in plugin.children(name)]
    for element in elements:
        yield element.content.rpartition("::")[2]
