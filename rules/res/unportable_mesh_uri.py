import os
from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Resource,
    Root,
    Rule,
    Severity,
    accepts,
    used,
    warns,
)
from sdfcheck_rules.res.absences import looking_for, reactions

RELATIVE = ""
MODEL = "model"
PLAIN = "/"
BY_FOLDER = (Consumer.DRAKE, Consumer.MUJOCO)
"""Consumers that look for a relative path from the folder of the robot alone."""
WORDS = {RELATIVE: "a relative path", MODEL: "`model://`", PLAIN: "a path without `file://`"}
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
MESH = '<visual><geometry><mesh filename="{}"/></geometry></visual>'


class UnportableMeshUri(Rule):
    """The address of a mesh in a URDF is one that not all consumers of URDF resolve.

    ROS programs such as RViz know `package://`, `file://` and web addresses; a relative
    path, `model://`, or the bare path that xacro makes of `$(find arm)/meshes/arm.stl` shows no mesh there. Drake,
    MuJoCo and Gazebo do resolve paths, from the folder of the robot: Drake and MuJoCo refuse a robot whose meshes are
    there from another one only, in which a program is started. A mesh in the `meshdir` of MuJoCo's settings is one that
    the others do not find. Reported once for each kind of address.
    """

    code = "RES013"
    name = "unportable-mesh-uri"
    severity = Severity.INFO
    remedy = """Write it as `package://PACKAGE/meshes/…`, which most consumers of URDF resolve.

    RViz and the like find the package where it is installed; Gazebo translates it to `model://` and looks
    in the folders of `GZ_SIM_RESOURCE_PATH`. For Drake and sdfcheck the package has to be known by its
    `package.xml`. MuJoCo wants relative paths: see `sdfcheck rule unopened-mesh`.
    """
    looks_at = (Root,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(MESH.format("«meshes/arm.stl»"), says="relative path"),
        Bad(
            MESH.format("«meshes/arm.obj»"),
            file="urdf/arm.urdf",
            files={"package.xml": "<package><name>arm</name></package>", "meshes/arm.obj": OBJ},
            says="is not resolved by ROS programs, and leads to no file from the folder of the robot",
        ),
        Bad(
            '<robot name="r"><mujoco><compiler meshdir="meshes"/></mujoco><link name="l">'
            f"{MESH.format('«arm.stl»')}</link></robot>",
            scaffold="{}",
            files={"meshes/arm.stl": ""},
            says="and MuJoCo alone looks for it in the `meshdir`",
        ),
        Bad(
            MESH.format("«model://arm/a.stl»") + MESH.format("model://arm/b.stl"),
            says="(used 2 times) is not resolved",
        ),
        Bad(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="l">'
            f"{MESH.format('«$(find arm)/meshes/arm.obj»')}</link></robot>",
            scaffold="{}",
            file="urdf/arm.urdf.xacro",
            files={"package.xml": "<package><name>arm</name></package>", "meshes/arm.obj": OBJ},
            says="a path without `file://` is not resolved by ROS programs",
        ),
    )
    good = (Good(MESH.format("package://arm/meshes/arm.stl")), Good(MESH.format("file:///opt/arm.stl")))

    @staticmethod
    def applies(root: Root) -> bool:
        return root.is_urdf and any(scheme(resource) is not None for resource in root.resources)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        schemes = [scheme(resource) for resource in root.resources]
        for kind, what in WORDS.items():
            uses = [resource for resource, own in zip(root.resources, schemes, strict=True) if own == kind]
            if uses:
                message = f"{what}{used(len(uses))} is not resolved by ROS programs"
                far = list(filter(is_elsewhere, uses)) if kind == RELATIVE else []
                if far:
                    message += ", and leads to no file from the folder of the robot"
                readers = {each for use in far for each in looking_for(use)}
                affects = {each: REFUSES if each in readers else accepts("finds it") for each in BY_FOLDER}
                hidden = list(filter(is_for_mujoco, uses))
                if hidden:
                    message += ", and MuJoCo alone looks for it in the `meshdir`"
                    affects |= reactions(hidden, REFUSES) | {
                        Consumer.GAZEBO: warns("shows nothing in its place"),
                        Consumer.MUJOCO: affects[Consumer.MUJOCO],
                    }
                yield self.diagnostic(uses[0].uri_value, message, affects=affects)


def is_elsewhere(resource: Resource) -> bool:
    """Is the file of a relative path there, though not beside the robot: in the folder where a program starts?"""
    location = resource.location
    if location is None or location.path is None:
        return False
    return not os.path.exists(os.path.join(resource.document.path.parent, resource.uri))


def is_for_mujoco(resource: Resource) -> bool:
    """Is the file of a mesh in the folder that the robot names for MuJoCo, and nowhere else?"""
    location = resource.location
    return location is not None and location.path is None and location.is_local and resource.is_in_mesh_folder


def scheme(resource: Resource) -> str | None:
    """The scheme of an address that ROS programs do not resolve; None for others, and for what is malformed."""
    uri = resource.uri
    if uri.startswith("/") and resource.is_urdf and resource.uri_value is not None:
        return PLAIN if resource.uri_value.span.text.startswith("$(find") else None
    if not resource.is_urdf or "$" in uri or "\\" in uri:
        return None
    head, delimiter, _ = uri.partition("://")
    found = head.lower() if delimiter else RELATIVE
    return found if found in (RELATIVE, MODEL) and ":/" not in head else None
