from collections.abc import Iterator

from sdfcheck import (
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Joint,
    Model,
    Rule,
    Severity,
    Target,
    Transmission,
    Value,
    warns,
)
from sdfcheck_rules.drk.effect import affects, does
from sdfcheck_rules.drk.scaffolds import AXIS, JOINT, ROBOT

OF_ACTUATORS = ("drake:rotor_inertia", "drake:gear_ratio", "drake:controller_gains")
NOT_ACTUATED_IN_SDF = frozenset(("ball", "fixed", "universal"))
ACTUATED_IN_URDF = frozenset(("continuous", "curvilinear", "prismatic", "revolute", "screw"))
REFUSED_IN_URDF = frozenset(("ball", "floating", "planar", "universal"))
"""The types for which Drake takes an actuator for a mistake."""
WITHOUT_LIMIT = frozenset(("curvilinear", "screw"))

NO_TRANSMISSION, NO_EFFORT = "no transmission names it", "its effort is 0"

DRIVE = '<transmission><type>{}</type><joint name="j"/><actuator name="m"/></transmission>'


NO_ACTUATOR = {Consumer.DRAKE: warns("makes no actuator")}


class UnactuatedJoint(Rule):
    """Drake makes no actuator for a joint.

    In URDF an actuator exists only through a transmission whose type contains `SimpleTransmission`, for
    a moving joint with an effort limit that is not 0. In SDF every joint with one axis is
    actuated unless its effort limit is 0; what is said about the rotor is then not read.
    """

    code = "DRK010"
    name = "unactuated-joint"
    severity = Severity.ERROR
    remedy = """Give a joint that moves a `SimpleTransmission` with a named actuator and a positive effort.

    ```xml
    <transmission>
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="shoulder"/>
      <actuator name="shoulder_motor"/>
    </transmission>
    ```

    In SDF the `<effort>` of the axis is enough. A joint that is passive on purpose needs none: ignore this,
    or remove the transmission.
    """
    default = False
    looks_at = (Joint, Model, Transmission)
    selects = ("sdf:joint", "urdf:robot", "urdf:robot/transmission")
    scaffold = ROBOT

    bad = (
        Bad(
            DRIVE.format("«transmission_interface/FourBarLinkageTransmission»"),
            says="`j` has no actuator in Drake: its transmission is not a SimpleTransmission",
        ),
        Bad(
            '<transmission><type>SimpleTransmission</type><joint name="j"/><«actuator»/></transmission>',
            says="the actuator has no name: Drake refuses the file",
        ),
        Bad(
            '<transmission><type>SimpleTransmission</type><joint name="«f»"/><actuator name="m"/>'
            "</transmission>",
            says="`f` has no actuator in Drake: it is fixed",
            also=("URD011",),
        ),
        Bad(
            DRIVE.format("SimpleTransmission"),
            says="joint `j`: its effort is negative",
            scaffold=ROBOT.replace('effort="5"', 'effort="«-1»"'),
        ),
        Bad(
            "",
            says="no transmission names it",
            scaffold=ROBOT.replace('<joint name="j"', '<«joint» name="j"'),
        ),
        Bad(
            "<limit><effort>«0»</effort></limit>",
            says="`j` has no actuator in Drake: its effort is 0",
            scaffold=AXIS,
        ),
        Bad(
            "<«drake:rotor_inertia»>1</drake:rotor_inertia>",
            says="so `drake:rotor_inertia` is not read",
            scaffold=JOINT.replace("revolute", "fixed").replace("<axis><xyz>0 0 1</xyz></axis>", ""),
        ),
    )
    good = (
        Good(DRIVE.format("transmission_interface/SimpleTransmission")),
        Good(DRIVE.format("SimpleTransmission"), scaffold=ROBOT.replace('effort="5"', 'effort="0.5"')),
        Good("<limit><effort>-1</effort></limit>", scaffold=AXIS, why="without limit"),
    )

    def check(self, part: Joint | Model | Transmission) -> Iterator[Diagnostic]:
        if isinstance(part, Joint):
            yield from self._of_joint(part)
        elif isinstance(part, Transmission):
            yield from self._of_transmission(part)
        elif not part.transmissions:
            moving = [joint for joint in part.driven.values() if joint.type in ACTUATED_IN_URDF]
            for first in moving[:1]:
                yield self._idle(first, first.name, NO_TRANSMISSION, others=len(moving) - 1)

    def _of_joint(self, joint: Joint) -> Iterator[Diagnostic]:
        unread = next((found for name in OF_ACTUATORS if (found := joint.find(name)) is not None), None)
        effort = joint.axis.limit.effort
        if joint.type in NOT_ACTUATED_IN_SDF:
            if unread is not None:
                yield self._idle(unread, joint.name, f"its type is {joint.type}", unread)
        elif effort.number == 0:
            yield self._idle(effort, joint.name, NO_EFFORT, unread)

    def _of_transmission(self, transmission: Transmission) -> Iterator[Diagnostic]:
        kind, joint = transmission.type_value, transmission.find("joint")
        value = joint.attribute("name") if joint is not None else None
        name = value.text if value is not None else ""
        if kind is None:
            yield self._refused(transmission, "", "the transmission has no type")
        elif not kind.text.strip():
            return  # crashes-drake
        elif "SimpleTransmission" not in kind.text:
            yield self._idle(kind, name, "its transmission is not a SimpleTransmission")
        elif (lack := _lack(transmission)) is not None:
            yield self._refused(lack[0], name, lack[1])
        elif value is not None and (driven := transmission.model.driven.get(name)) is not None:
            yield from self._of_driven(driven, value)

    def _of_driven(self, joint: Joint, value: Value) -> Iterator[Diagnostic]:
        effort = joint.axis.limit.effort
        if joint.is_fixed:
            yield self._idle(value, joint.name, "it is fixed")
        elif joint.type in REFUSED_IN_URDF:
            yield self._refused(value, joint.name, f"its type is {joint.type}")
        elif joint.type not in WITHOUT_LIMIT and effort.number == 0:
            yield self._idle(effort, joint.name, NO_EFFORT)
        elif joint.type not in WITHOUT_LIMIT and effort.number < 0:
            yield self._refused(effort, joint.name, "its effort is negative")

    def _refused(self, target: Target, joint: str, reason: str) -> Diagnostic:
        whose = f"joint `{joint}`: " if joint else ""
        return self.diagnostic(target, f"{whose}{reason}: {does(REFUSES)}", affects=affects(REFUSES))

    def _idle(
        self, target: Target, joint: str, reason: str, unread: Element | None = None, others: int = 0
    ) -> Diagnostic:
        more = f" (and {others} more)" if others else ""
        message = f"`{joint}`{more} has" if joint else "this makes"
        message += f" no actuator in Drake: {reason}"
        if unread is not None:
            message += f", so `{unread.name}` is not read"
        level = Severity.INFO if unread is None and reason == NO_EFFORT else Severity.WARNING
        return self.diagnostic(target, message, severity=level, affects=NO_ACTUATOR)


def _lack(transmission: Transmission) -> tuple[Target, str] | None:
    """Where a transmission lacks what an actuator needs, and what that is."""
    for what in ("actuator", "joint"):
        element = transmission.find(what)
        if element is None:
            return transmission, f"the transmission has no {what}"
        if element.attribute("name") is None:
            return element, f"the {what} has no name"
    return None
