from collections.abc import Iterator, Sequence
from math import dist

from sdfcheck import Bad, Diagnostic, Good, Joint, Plugin, Rule, Severity, Value

UPRIGHT = 0.9
"""Of the length of an axis: rotors that lift."""
ACROSS = 0.1
"""The z component of an axis that lies across it."""
FEWEST, QUAD, MOST = 4, 4, 16
DIRECTIONS = ("ccw", "cw")
MOTOR, WET = "motor_model", ("buoyancy", "hydrodynamics")
"""In the names of files: rotors, of which those under water need not be balanced."""
CORNERS = ((1, -1), (-1, 1), (1, 1), (-1, -1))


def rotors(*directions: str) -> str:
    """A multicopter with a rotor in each corner for each direction: front right, back left, front left, back right."""
    text = ""
    for number, ((x, y), direction) in enumerate(zip(CORNERS, directions, strict=True)):
        text += (
            f'<link name="rotor_{number}"><pose>{x} {y} 0 0 0 0</pose></link><joint name="j{number}" type="revolute">'
            f"<parent>base</parent><child>rotor_{number}</child><axis><xyz>0 0 1</xyz></axis></joint>"
            '<plugin filename="gz-sim-multicopter-motor-model-system"'
            f' name="gz::sim::systems::MulticopterMotorModel"><jointName>j{number}</jointName>'
            f"<linkName>rotor_{number}</linkName><turningDirection>{direction}</turningDirection>"
            f"<motorNumber>{number}</motorNumber></plugin>"
        )
    return text


class UnbalancedRotors(Rule):
    """The rotors of a multicopter do not turn in opposite directions in pairs, or not about their thrust.

    A rotor turns its vehicle the other way. Where not as many turn clockwise as counterclockwise, the vehicle spins as
    soon as it takes off. Of four rotors those across from each other turn in one direction, and the other two in the
    other; any other order mixes yaw with roll or pitch, and the vehicle flips. The thrust of a rotor is along the z
    axis of its link, whatever the axis of its joint is: one that lies across it turns the blades on edge.
    """

    code = "GAZ030"
    name = "unbalanced-rotors"
    severity = Severity.WARNING
    remedy = """Let rotors across from each other turn in one direction, and their neighbors in the other.

    PX4 and ArduPilot number the rotors of a quadrotor in X so that front right and back left are `ccw`, front left and
    back right `cw`. Of six or eight rotors in a ring each turns the other way than its neighbors.
    """
    looks_at = (Plugin,)
    needs = ("<turningDirection",)
    scaffold = '<sdf version="1.9"><model name="m"><link name="base"/>{}</model></sdf>'
    sources = ("https://docs.px4.io/main/en/airframes/airframe_reference.html",)

    bad = (
        Bad(
            rotors("ccw", "ccw", "cw", "«ccw»"),
            says="3 of 4 rotors turn `ccw`: this one turns the other way than the one across from it",
        ),
        Bad(
            rotors("«ccw»", "cw", "ccw", "cw"),
            says="the rotors across from each other turn in opposite directions",
        ),
        Bad(
            rotors("ccw", "ccw", "cw", "cw").replace("<xyz>0 0 1<", "<xyz>«1 0 0»<", 1),
            says="joint `j0` turns rotor `rotor_0` about another axis than that of its thrust, the z axis of the link",
        ),
    )
    good = (
        Good(rotors("ccw", "ccw", "cw", "cw")),
        Good(rotors("cw", "cw", "ccw", "ccw"), why="the other way around"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return culprit(plugin) is not None or edgewise(plugin) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        if (joint := edgewise(plugin)) is not None:
            what = (
                f"{joint.title} turns rotor `{joint.child_name}` about another axis than that of its thrust"
            )
            yield self.diagnostic(joint.axis.xyz, f"{what}, the z axis of the link")
        if (found := culprit(plugin)) is None:
            return
        value, other, message = found
        yield self.diagnostic(value, message, labels={other: "the other one"})


def culprit(plugin: Plugin) -> tuple[Value, Value, str] | None:
    """The direction that is wrong, another one, and the words for it; of the first rotor of a model alone."""
    files = [each.filename.lower().replace("-", "_") for each in plugin.siblings]
    if any(name in file for file in files for name in WET):
        return None
    beside = [each for each, file in zip(plugin.siblings, files, strict=True) if MOTOR in file]
    if not beside or beside[0].element is not plugin.element:
        return None
    found = list(lifting(beside))
    if len(found) % 2 or not FEWEST <= len(found) <= MOST:
        return None
    ways = [value.text.strip() for value, _ in found]
    most = max(DIRECTIONS, key=ways.count)
    opposed = [pair for pair in across(found) if pair[0].text.strip() != pair[1].text.strip()]
    if 2 * ways.count(most) == len(found):
        return (
            (*opposed[0], "the rotors across from each other turn in opposite directions")
            if opposed
            else None
        )
    count = f"{ways.count(most)} of {len(found)} rotors turn `{most}`"
    for value, other in opposed:
        if value.text.strip() == most:
            return value, other, f"{count}: this one turns the other way than the one across from it"
    value, other = [value for value, _ in found if value.text.strip() == most][:2]
    return value, other, f"{count}, so that the vehicle spins"


def edgewise(plugin: Plugin) -> Joint | None:
    """The joint of a rotor whose axis lies across the z axis of its link, where both are in one frame."""
    if MOTOR not in plugin.filename.lower().replace("-", "_"):
        return None
    joint = next((each.joint for each in plugin.references if each.joint is not None), None)
    if joint is None or joint.axis.expressed_in or (not joint.is_urdf and joint.has("pose")):
        return None
    xyz = joint.axis.xyz
    return (
        joint if len(xyz) == 3 and xyz.is_given and joint.axis.length > 0 and abs(xyz[2]) < ACROSS else None
    )


def across(found: list[tuple[Value, Sequence[float]]]) -> list[tuple[Value, Value]]:
    """Of four rotors each with the one that is farthest from it; nothing where one is that of two."""
    if len(found) != QUAD:
        return []
    pairs = [(value, max(found, key=lambda each: dist(each[1], position))[0]) for value, position in found]
    return pairs if len({id(other) for _, other in pairs}) == QUAD else []


def lifting(plugins: list[Plugin]) -> Iterator[tuple[Value, Sequence[float]]]:
    """The directions and places of the rotors that turn about the vertical."""
    for plugin in plugins:
        value = plugin.find("turningDirection")
        joints = [reference.joint for reference in plugin.references if reference.joint is not None]
        joint = joints[0] if joints else None
        if value is None or joint is None or joint.direction is None or joint.at_rest is None:
            continue
        if abs(joint.direction[2]) > UPRIGHT and value.content in DIRECTIONS:
            yield value.own_value, joint.at_rest.position
