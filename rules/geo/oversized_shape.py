from collections.abc import Iterator, Set
from math import inf

from sdfcheck import Bad, Diagnostic, Good, Link, Model, Rule, Severity, Shape, Value, used
from sdfcheck_rules.geo.scaffolds import ARM, mesh, wedge

MOST = 100.0
"""Times the longest distance between joints; the longest of 250 public robots is 71 times that long (a table)."""
LEAST = 1.0
"""m: smaller shapes are not that of a machine in millimeters."""
FLAT = 0.02
"""Times its length a floor is at most as thick."""
THIN = 0.1
"""m: what is thinner was not meant in millimeters."""
SCALED = '<visual><geometry><mesh filename="arm.obj" scale="«{0} {0} {0}»"/></geometry></visual>'
HEAVY = f'<inertial><mass value="{{1}}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>{SCALED}'
HULL = (
    f'<robot name="boat"><link name="hull">{HEAVY}</link><link name="pod">{HEAVY.replace("«", "").replace("»", "")}'
    '</link><joint name="j" type="revolute"><origin xyz="0 0 0.3"/><parent link="hull"/><child link="pod"/>'
    '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>'
)
LARGEST = 100.0
"""m: in 549 public robots with joints and meshes the longest shape is 0.05 to 2 m long; machines in millimeters have
one of more than this, wherever their joints are."""


class OversizedShape(Rule):
    """A shape is a hundred times longer than the distances between the joints of its robot.

    Meshes have no unit in STL and OBJ: exported in millimeters, they are a thousand times too large, unless
    `scale` says 0.001, and ten times with 0.01. Joints were then placed in meters, and the shapes do not fit them, or
    the robot is lighter than air of its size.
    """

    code = "GEO001"
    name = "oversized-shape"
    severity = Severity.WARNING
    remedy = """Write its size in meters; a mesh in millimeters gets a scale of `0.001 0.001 0.001`.

    STL and OBJ files have no unit, so the exporter's choice counts: set it to meters in the CAD program, or
    scale in Blender or MeshLab, or with `scale` of the `<mesh>` in visuals and collisions alike. For a box,
    cylinder or sphere divide the numbers by 1000. The moments of inertia were likely computed from the same
    drawing: compare them with `sdfcheck inertia FILE`.
    """
    looks_at = (Model,)
    scaffold = ARM

    bad = (
        Bad(
            mesh("visual", "«arm.obj»"),
            files={"arm.obj": wedge(300)},
            says="the mesh `arm.obj` is 300 m long, and the joints of robot `r` are at most 0.3 m apart:"
            " is it in millimeters?",
        ),
        Bad(
            mesh("visual", "arm.obj") + '<visual><geometry><box size="«200 20 20»"/></geometry></visual>',
            files={"arm.obj": wedge(0.3)},
            says="the box is 200 m long",
        ),
        Bad(
            mesh("visual", "«arm.obj»"),
            scaffold=ARM.replace("0 0 0.3", "0 0 300"),
            files={"arm.obj": wedge(300)},
            says="the mesh `arm.obj` is 300 m long, and parts of robots are shorter than 100 m: is it in millimeters?",
        ),
        Bad(
            HULL.format("0.01", "0.1"),
            scaffold="{}",
            files={"arm.obj": wedge(300)},
            says="the mesh `arm.obj` is 3 m long, and robot `boat` has 0.37 kg/m³ within its shapes, less than air"
            " (used 2 times): is its scale right?",
            also=("GEO015",),
        ),
    )
    good = (
        Good(HULL.format("0.001", "0.1"), scaffold="{}", files={"arm.obj": wedge(300)}),
        Good(mesh("visual", "arm.obj", ' scale="0.001 0.001 0.001"'), files={"arm.obj": wedge(300)}),
        Good(mesh("visual", "arm.obj"), files={"arm.obj": wedge(5)}, why="a platform"),
        Good(
            '<visual><geometry><box size="200 200 0.1"/></geometry></visual>',
            scaffold='<robot name="r"><link name="floor">{}</link><link name="a"/><link name="b"/>'
            '<joint name="f" type="fixed"><parent link="floor"/><child link="a"/></joint>'
            '<joint name="j" type="continuous"><origin xyz="0 0 0.3"/><parent link="a"/><child link="b"/></joint>'
            "</robot>",
            why="a floor",
        ),
        Good(
            '<visual><geometry><box size="1000 1000 10"/></geometry></visual>',
            scaffold='<robot name="cart"><link name="world">{}</link><link name="a"/><joint name="j" type="continuous">'
            '<origin xyz="0 0 0.3"/><parent link="world"/><child link="a"/></joint></robot>',
            why="the ground below a cart",
        ),
        Good('<visual><geometry><box size="300 0.05 0.05"/></geometry></visual>', why="a rail"),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return bool(oversized(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        shapes = oversized(model)
        shape = shapes[0]
        box, geometry = shape.geometry.box, shape.geometry
        assert box is not None, "it was compared"
        is_mesh = geometry.shape == "mesh"
        what = f"mesh `{geometry.uri.rpartition('/')[2]}`" if is_mesh else geometry.shape
        place = geometry.scale.value or geometry.uri_value if is_mesh else written_size(shape)
        kind = "robot" if model.is_urdf else "model"
        asked = "is its scale right" if is_mesh and geometry.scale.is_given else "is it in millimeters"
        compared = f"the joints of {kind} `{model.name}` are at most {model.reach:.3g} m apart"
        if max(box.size) <= MOST * model.reach:
            compared = (
                f"{kind} `{model.name}` has {model.density:.2g} kg/m³ within its shapes, less than air"
                if is_thin(model)
                else f"parts of robots are shorter than {LARGEST:.0f} m"
            )
        yield self.diagnostic(
            place or shape,
            f"the {what} is {max(box.size):.4g} m long, and {compared}{used(len(shapes))}: {asked}?",
            labels=dict.fromkeys(shapes[1:4], "this one as well"),
        )


def written_size(shape: Shape) -> Value | None:
    """The first measure of a primitive shape that is written."""
    geometry = shape.geometry
    measures = (geometry.size, geometry.length, geometry.radius, geometry.radii)
    return next((each.value for each in measures if each.is_given), None)


def is_ground(shape: Shape, moving: Set[Link | None]) -> bool:
    """Is it a flat shape of a link on which nothing moves, as the floor in a scene, or surely in meters, as a rail?

    A link `world` is the ground of the robot, also where joints move on it.
    """
    box = shape.geometry.box
    if box is None:
        return False
    is_fixed = shape.link not in moving or shape.link.name == "world"
    is_flat = is_fixed and min(box.size) < FLAT * max(box.size)
    return is_flat or (shape.geometry.shape != "mesh" and min(box.size) < THIN)


def is_long(link: Link) -> bool:
    """Has it a shape that is long enough to look at? For a robot without meshes little else is worked out."""
    boxes = (shape.geometry.box for shape in link.shapes)
    return any(box is not None and max(box.size) > LEAST for box in boxes)


def is_thin(model: Model) -> bool:
    """Is it lighter than air?"""
    return model.is_out_of_scale and model.density < 1


def oversized(model: Model) -> list[Shape]:
    """The shapes that are too long for the robot."""
    if not model.joints or model.may_be_static or not any(map(is_long, model.links)):
        return []
    most = max(MOST * model.reach, LEAST) if model.reach > 0.005 else inf
    if model.is_urdf:
        most = min(most, LARGEST)
    if is_thin(model):
        most = LEAST
    joints = [joint for joint in model.joints if joint.type != "fixed"]
    moving = {end for joint in joints for end in (joint.parent_link, joint.child_link)}
    return [
        shape
        for link in model.links
        for shape in link.shapes
        if (box := shape.geometry.box) is not None and most < max(box.size) and not is_ground(shape, moving)
    ]
