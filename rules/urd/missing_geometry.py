from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    Bad,
    Collision,
    Consumer,
    Diagnostic,
    Element,
    Fix,
    Geometry,
    Good,
    Rule,
    Severity,
    Visual,
    accepts,
    rename,
    unreadable,
)

SHAPES = ("box", "capsule", "cylinder", "mesh", "sphere")


class MissingGeometry(Rule):
    """A visual or collision has no shape, or one that is not known, or a mesh without file.

    urdfdom stops reading the link there, so that it loses the visuals that follow and all
    of its collisions; the rest of the robot is read as if nothing had happened. Drake
    refuses the file. A shape with a prefix is meant for one consumer: a warning. So is a `plane` with its
    `normal`, for PyBullet.
    """

    code = "URD007"
    name = "missing-geometry"
    severity = Severity.ERROR
    remedy = """Give it a `<geometry>` with one shape: box, cylinder, sphere, or a mesh with its `filename`.

    Capsules are for URDF 1.1. A visual or collision that is not wanted is removed as a whole. In xacro,
    look at the condition that left the shape out.
    """
    looks_at = (Visual, Collision)
    selects = ("urdf:link/visual", "urdf:link/collision")
    scaffold = IN_URDF_LINK

    bad = (
        Bad('<«visual»><origin xyz="0 0 1"/></visual>', says="`visual` has no `geometry`"),
        Bad(
            '<collision name="c"><«geometry»/></collision>', says="the geometry of collision `c` has no shape"
        ),
        Bad("<visual><geometry><«mesh»/></geometry></visual>", says="the mesh of `visual` has no `filename`"),
        Bad(
            '<visual><geometry><«sphear» radius="1"/></geometry></visual>',
            fixed='<visual><geometry><sphere radius="1"/></geometry></visual>',
            unsafe=True,
            says="`sphear` is not a shape of URDF; did you mean `sphere`?",
        ),
        Bad(
            '<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a"><collision>'
            '<geometry><«drake:ellipsoid» a="1" b="2" c="3"/></geometry></collision></link></robot>',
            scaffold="",
            says="`drake:ellipsoid` is not a shape of URDF",
        ),
        Bad(
            '<collision><geometry><«plane» normal="0 0 1"/></geometry></collision>',
            says="`plane` is not a shape of URDF",
        ),
    )
    good = (Good('<visual><geometry><mesh filename="package://p/m.stl"/></geometry></visual>'),)

    @staticmethod
    def applies(shape: Visual | Collision) -> bool:
        return lacks_shape(shape.geometry) if shape.geometry.is_given else shape.lacks("geometry")

    def check(self, shape: Visual | Collision) -> Iterator[Diagnostic]:
        geometry, mesh = shape.geometry, shape.geometry.find("mesh")
        if not geometry.is_given:
            yield self.about(shape, shape.element, f"{shape.title} has no `geometry`")
        elif geometry.shape_element is None:
            yield self.about(shape, geometry.element, f"the geometry of {shape.title} has no shape")
        elif geometry.shape not in SHAPES:
            near = geometry.nearest(geometry.shape, SHAPES)
            guess = f"; did you mean `{near}`?" if near else ""
            message = f"`{geometry.shape}` is not a shape of URDF{guess}"
            yield self.about(shape, geometry.shape_element, message, rename(near, geometry.shape_element))
        if mesh is not None and geometry.part(mesh).lacks("filename"):
            yield self.about(shape, mesh, f"the mesh of {shape.title} has no `filename`")

    def about(
        self, shape: Visual | Collision, place: Element, message: str, fix: Fix | None = None
    ) -> Diagnostic:
        affects = {Consumer.MUJOCO: unreadable(shape.element)[Consumer.MUJOCO]}
        is_plane = place.name == "plane" and "normal" in place.attributes
        if place.name.startswith("drake:"):
            affects[Consumer.DRAKE] = accepts("knows it")
        if is_plane:
            affects[Consumer.PYBULLET] = accepts("knows it")
        severity = Severity.WARNING if place.is_custom or is_plane else None
        return self.diagnostic(place, message, severity=severity, affects=affects, fix=fix)


def lacks_shape(geometry: Geometry) -> bool:
    mesh = geometry.find("mesh")
    if mesh is not None and geometry.part(mesh).lacks("filename"):
        return True
    return geometry.shape not in SHAPES and not geometry.is_unfinished
