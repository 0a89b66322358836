from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Resource, Root, Rule, Severity, used

RELATIVE = ""
MODEL = "model"
MESH = '<visual><geometry><mesh filename="{}"/></geometry></visual>'


class UnportableMeshUri(Rule):
    """The address of a mesh in a URDF is one that not all consumers of URDF resolve.

    ROS programs such as RViz know `package://`, `file://` and web addresses; a relative
    path or `model://` shows no mesh there. Drake, MuJoCo and Gazebo do resolve relative
    paths. Reported once for each kind of address.
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
            MESH.format("«model://arm/a.stl»") + MESH.format("model://arm/b.stl"),
            says="(used 2 times) is not resolved",
        ),
    )
    good = (Good(MESH.format("package://arm/meshes/arm.stl")), Good(MESH.format("file:///opt/arm.stl")))

    @staticmethod
    def applies(root: Root) -> bool:
        return root.is_urdf and any(scheme(resource) is not None for resource in root.resources)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        schemes = [scheme(resource) for resource in root.resources]
        for kind in (RELATIVE, MODEL):
            uses = [resource for resource, own in zip(root.resources, schemes, strict=True) if own == kind]
            if uses:
                what = f"`{kind}://`" if kind else "a relative path"
                message = f"{what}{used(len(uses))} is not resolved by ROS programs"
                yield self.diagnostic(uses[0].uri_value, message)


def scheme(resource: Resource) -> str | None:
    """The scheme of an address that ROS programs do not resolve; None for others, and for what is malformed."""
    uri = resource.uri
    if not resource.is_urdf or uri.startswith("/") or "$" in uri or "\\" in uri:
        return None
    head, delimiter, _ = uri.partition("://")
    found = head.lower() if delimiter else RELATIVE
    return found if found in (RELATIVE, MODEL) and ":/" not in head else None
