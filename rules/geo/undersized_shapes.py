from collections.abc import Iterator
from math import prod

from sdfcheck import Bad, Diagnostic, Good, Link, Model, Rule, Severity, Shape
from sdfcheck_rules.geo.scaffolds import mesh, wedge

LEAST = 0.01
"""Of the longest distance between joints: in 250 public robots the longest shape is more, where two links have any."""
TINY = 0.02
"""m: a robot heavier than any material whose shapes are all shorter is a thousand times too small as a whole."""
SMALLEST = 0.005
"""m: in 549 public robots with joints and meshes the longest shape is 0.05 to 2 m long, and never a thousandth."""
ABSURD = 1e8
"""kg/m³: osmium has 22,600, and a mesh in meters with a scale of 0.001 a thousand million times what it should have."""
LIGHT = 0.2
"""kg: what is lighter is often a mark."""
ROBOT = (
    '<robot name="r"><link name="base">{0}</link><link name="arm">{1}</link>'
    '<joint name="j" type="revolute"><origin xyz="0 0 0.3"/><parent link="base"/>'
    '<child link="arm"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>'
)


class UndersizedShapes(Rule):
    """All shapes of a robot are a hundred times shorter than the distances between its joints, or those of a link.

    A `scale` of 0.001 for meshes that are in meters already, or a COLLADA file that says millimeters and is in
    meters, leaves nothing to see, and nothing to touch. One link alone is judged by its mass: thousands of times that
    of any material say that its mesh is too small.
    """

    code = "GEO002"
    name = "undersized-shapes"
    severity = Severity.WARNING
    remedy = """Remove the `scale` of meshes that are in meters, or write the unit that the shapes have.

    Compare the size of one part with the real one: MeshLab shows the bounding box of a mesh. COLLADA files
    name their unit in `<unit meter="…">`, which Gazebo applies before `scale`; STL and OBJ have none. If
    the joints are in millimeters and the shapes in meters, correct the joints instead.
    """
    looks_at = (Model,)
    needs = ("<mesh", ":mesh")

    bad = (
        Bad(
            ROBOT.format(
                mesh("visual", "base.obj", ' scale="«0.001 0.001 0.001»"'),
                mesh("visual", "base.obj", ' scale="0.001 0.001 0.001"'),
            ),
            files={"base.obj": wedge(0.3)},
            says="the longest shape of robot `r` is 0.0003 m long, and its joints are up to 0.3 m apart",
        ),
        Bad(
            ROBOT.replace("0.3", "0.0003").format(
                mesh("visual", "base.obj", ' scale="«0.001 0.001 0.001»"'),
                mesh("visual", "base.obj", ' scale="0.001 0.001 0.001"'),
            ),
            files={"base.obj": wedge(0.3)},
            says="and the longest of a robot is some centimeters at least",
        ),
        Bad(
            ROBOT.format(
                '<inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
                + mesh("visual", "base.obj", ' scale="«0.001 0.001 0.001»"'),
                mesh("visual", "base.obj"),
            ),
            files={"base.obj": wedge(0.3)},
            says="link `base` has 2 kg in 0.0003 ×",
            also=("URD014",),
        ),
    )
    good = (
        Good(
            ROBOT.format(mesh("visual", "base.obj"), mesh("visual", "base.obj")),
            files={"base.obj": wedge(0.3)},
        ),
        Good(
            ROBOT.format('<visual><geometry><box size="0.001 0.001 0.001"/></geometry></visual>', ""),
            why="a mark, and the other link has no shape",
        ),
    )

    @staticmethod
    def applies(model: Model) -> bool:
        return longest(model) is not None or bool(tiny(model))

    def check(self, model: Model) -> Iterator[Diagnostic]:
        for link in tiny(model):
            assert link.extent is not None
            lengths = " × ".join(f"{length:.2g}" for length in link.extent.size)
            geometry = link.shapes[0].geometry
            yield self.diagnostic(
                geometry.scale.value or geometry.uri_value or link.shapes[0],
                f"{link.title} has {link.inertial.mass.text} kg in {lengths} m: are scale and unit right?",
            )
        shape = longest(model)
        box = shape.geometry.box if shape is not None else None
        if shape is None or box is None:
            return
        kind = "robot" if model.is_urdf else "model"
        value = shape.geometry.scale.value or shape.geometry.uri_value
        compared = f"its joints are up to {model.reach:.3g} m apart"
        if max(box.size) > LEAST * model.reach:
            compared = (
                f"it has {model.density:.2g} kg/m³ within its shapes, more than any material"
                if is_dense(model)
                else "the longest of a robot is some centimeters at least"
            )
        yield self.diagnostic(
            value or shape,
            f"the longest shape of {kind} `{model.name}` is {max(box.size):.3g} m long, and {compared}:"
            " are scale and unit right?",
        )


def tiny(model: Model) -> list[Link]:
    """The links with a mesh that is far too small for their mass; none where all shapes are too small."""
    if not model.joints or model.may_be_static or not model.has_mesh or model.is_out_of_scale:
        return []
    found = [
        link
        for link in model.links
        if link.has_mesh
        and link.inertial.mass.is_given
        and link.inertial.mass.number > LIGHT
        and (box := link.extent) is not None
        and link.inertial.mass.number > ABSURD * prod(box.size) > 0
    ]
    return found if found and longest(model) is None else []


def is_dense(model: Model) -> bool:
    """Is it heavier than any material of its size?"""
    return model.is_out_of_scale and model.density > 1


def longest(model: Model) -> Shape | None:
    """The longest of the shapes of at least two links, if it is too short for the robot, and all are known."""
    if not model.joints or model.may_be_static or not model.has_mesh:
        return None
    most = LEAST * model.reach if model.reach > 0.005 else 0.0
    if model.is_urdf:
        most = max(SMALLEST, most)
    if dense := is_dense(model):
        most = max(TINY, most)
    sizes: dict[Shape, float] = {}
    links = set()
    for link in model.links:
        for shape in link.shapes:
            box = shape.geometry.box
            if box is None and dense:
                continue
            if box is None or max(box.size) > most:
                return None
            sizes[shape] = max(box.size)
            links.add(link)
    is_known = len(sizes) * 2 >= sum(len(link.shapes) for link in model.links)
    return max(sizes, key=sizes.__getitem__) if len(links) > 1 and is_known else None
