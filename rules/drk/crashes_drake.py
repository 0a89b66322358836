from collections.abc import Callable, Iterator
from typing import Any

from sdfcheck import (
    REFUSES,
    Bad,
    Collision,
    Diagnostic,
    Dynamics,
    Geometry,
    Good,
    Inertial,
    Limit,
    Reaction,
    Root,
    Rule,
    Severity,
    Target,
    Transmission,
    Value,
)
from sdfcheck_rules.drk.contents import unread
from sdfcheck_rules.drk.effect import ABORTS, CRASHES, affects, does
from sdfcheck_rules.drk.frictions import friction, own_friction
from sdfcheck_rules.drk.scaffolds import COLLISION, ROBOT, ROBOT_JOINT

SPRUNG = frozenset(("continuous", "prismatic", "revolute"))
LIMITED = frozenset(("continuous", "prismatic", "revolute"))

BOX = "<geometry><box><size>1 1 1</size></box></geometry>"


class CrashesDrake(Rule):
    """The file ends the process that loads it with Drake, or ends it unread.

    An empty type of a transmission is a segmentation fault; most others are assertions, which end a
    C++ program and tell no place in the file. A negative damping is refused, and so is a file that
    holds neither exactly one model nor exactly one world, or whose model has a `namespace`.
    """

    code = "DRK015"
    name = "crashes-drake"
    severity = Severity.ERROR
    remedy = """Put one model, or one world, into the file.

    A second one goes into a file of its own, which a world can include. Limits of velocity, effort and
    damping are positive or left out; a transmission has a type; names of actuators are unique.
    """
    default = False
    looks_at = (Root, Collision, Dynamics, Geometry, Inertial, Limit, Transmission)
    selects = (
        "sdf:sdf",
        "urdf:robot",
        "sdf:collision",
        "sdf:joint/axis/dynamics",
        "sdf:geometry",
        "sdf:link/inertial",
        "urdf:robot/joint/dynamics",
        "urdf:robot/joint/limit",
        "urdf:robot/transmission",
    )
    scaffold = COLLISION

    bad = (
        Bad(
            '<transmission><«type»/><joint name="j"/><actuator name="m"/></transmission>',
            says="a transmission of empty type: Drake crashes",
            scaffold=ROBOT,
        ),
        Bad(
            '<transmission><type>SimpleTransmission</type><joint name="j"/><actuator name="m"/></transmission>'
            '<transmission><type>SimpleTransmission</type><joint name="j"/><actuator name="«m»"/></transmission>',
            says="actuator `m` for a second time: Drake refuses the file",
            scaffold=ROBOT,
            also=("URD030",),
        ),
        Bad(
            '<joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
            '<limit lower="-1" upper="1" effort="1" velocity="«-1»"/></joint>',
            says="a negative velocity limit: Drake aborts",
            scaffold=ROBOT_JOINT,
        ),
        Bad(
            f"{BOX}<surface><«friction»><torsional/></friction></surface><drake:proximity_properties>"
            "<drake:mu_dynamic>0.5</drake:mu_dynamic></drake:proximity_properties>",
            says="a friction without `ode` beside `drake:mu_dynamic`: Drake aborts",
        ),
        Bad(
            "<geometry><plane><normal>«0 0 0»</normal></plane></geometry>",
            says="a plane without direction: Drake aborts",
            also=("SCH022",),
        ),
        Bad(
            '<«sdf» version="1.9"><light name="sun" type="point"/></sdf>',
            says="a file with neither model nor world: Drake refuses the file",
            scaffold="",
        ),
        Bad(
            '<sdf version="1.9"><world name="w"/><«model» name="m"><link name="l"/></model></sdf>',
            says="a model beside a world: Drake refuses the file",
            scaffold="",
        ),
        Bad(
            '<sdf version="1.12"><model name="m" namespace="«n»"><link name="l"/></model></sdf>',
            says="`namespace` of a model: Drake refuses the file",
            scaffold="",
        ),
        Bad(
            '<sdf version="1.9"><world name="w"/><«world» name="v"/></sdf>',
            says="a second world: Drake refuses the file",
            scaffold="",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12"><model name="m"><plugin name="p" filename="f"><namespace>n</namespace></plugin>'
            '<link name="l"/></model></sdf>',
            scaffold="",
        ),
        Good(
            '<transmission><type>SimpleTransmission</type><joint name="j"/><actuator name="m"/>'
            "</transmission>",
            scaffold=ROBOT,
        ),
        Good(
            f"{BOX}<surface><friction><torsional/></friction></surface>",
            why="only Drake's own friction trips it",
        ),
        Good(
            "<geometry><heightmap><uri>a.png</uri><texture><normal>flat.png</normal></texture></heightmap></geometry>"
            "<surface><friction><ode><mu>0.2</mu></ode></friction></surface>",
            why="Drake makes nothing of a heightmap",
        ),
    )

    def check(self, part: Any) -> Iterator[Diagnostic]:
        for target, what, reaction, advice in LOOKS[type(part)](part):
            yield self.diagnostic(target, f"{what}: {does(reaction)}", affects=affects(reaction), help=advice)


Found = Iterator[tuple[Target, str, Reaction, str | None]]
"""Where something is wrong, what it is, what Drake does, and what to do."""


def _root(root: Root) -> Found:
    if (found := unread(root)) is not None:
        yield *found, REFUSES, None
    for model in root.elements.get("model", ()) if not root.is_urdf else ():
        if (given := model.attribute("namespace")) is not None:
            yield given, "`namespace` of a model", REFUSES, "remove it; Drake names parts by their models"
    named: set[str] = set()
    for transmission in root.models[0].transmissions if root.is_urdf else ():
        name = _actuator(transmission)
        if name is not None and name.text in named:
            yield (
                name,
                f"actuator `{name.text}` for a second time",
                REFUSES,
                "give each actuator a name of its own",
            )
        elif name is not None:
            named.add(name.text)


def _collision(collision: Collision) -> Found:
    standard = friction(collision)
    own = own_friction(collision) if standard is not None and not standard.has("ode") else None
    if standard is not None and own is not None:
        what = f"a friction without `ode` beside `{own.name}`"
        yield standard, what, ABORTS, "remove the `<friction>`, or write `<ode/>` into it"


def _dynamics(dynamics: Dynamics) -> Found:
    damping, stiffness, kind = dynamics.damping, dynamics.spring_stiffness, dynamics.joint.type
    if damping.number < 0 and kind != ("planar" if dynamics.is_urdf else "fixed"):
        yield damping, "a negative damping", REFUSES, "write a positive damping"
    if stiffness.number < 0 and kind in SPRUNG and not dynamics.is_urdf:
        reaction = REFUSES if kind == "prismatic" else ABORTS
        yield stiffness, "a negative spring stiffness", reaction, "write a positive stiffness"


def _geometry(geometry: Geometry) -> Found:
    normal = geometry.normal
    if geometry.shape == "plane" and normal and not any(normal):
        yield normal, "a plane without direction", ABORTS, "write a normal such as `0 0 1`"


def _inertial(inertial: Inertial) -> Found:
    for collision in inertial.link.collisions if inertial.is_automatic else ():
        mesh = collision.geometry
        if mesh.shape == "mesh" and mesh.uri_value is not None and mesh.uri and "://" not in mesh.uri:
            what = "an automatic inertia from a mesh with a relative path"
            yield mesh.uri_value, what, ABORTS, "name the mesh by `package://`, or write the inertia"


def _limit(limit: Limit) -> Found:
    if limit.velocity.number < 0 and limit.joint.type in LIMITED:
        yield limit.velocity, "a negative velocity limit", ABORTS, "write a positive velocity"


def _transmission(transmission: Transmission) -> Found:
    kind = transmission.type_value
    if kind is not None and not kind.text.strip():
        yield (
            kind,
            "a transmission of empty type",
            CRASHES,
            "write `transmission_interface/SimpleTransmission`",
        )


def _actuator(transmission: Transmission) -> Value | None:
    """The name of the actuator that Drake makes of a transmission."""
    kind = transmission.type_value
    if kind is None or "SimpleTransmission" not in kind.text or not transmission.actuators:
        return None
    return transmission.actuators[0].attribute("name")


LOOKS: dict[type, Callable[[Any], Found]] = {
    Root: _root,
    Collision: _collision,
    Dynamics: _dynamics,
    Geometry: _geometry,
    Inertial: _inertial,
    Limit: _limit,
    Transmission: _transmission,
}
