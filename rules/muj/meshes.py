"""The mesh files that MuJoCo reads of a URDF robot."""

from collections.abc import Iterator

from sdfcheck import Geometry, Model, Value


def mesh_files(model: Model) -> Iterator[Value]:
    """The files of the meshes that are read."""
    for geometry in meshes(model):
        if (value := geometry.uri_value) is not None:
            yield value


def meshes(model: Model) -> Iterator[Geometry]:
    """Those of collisions, and of visuals where they are kept; what xacro left over is reported for itself."""
    settings = compiler(model)
    kinds = ("collision", "visual") if settings.get("discardvisual") == "false" else ("collision",)
    for link in model.links:
        for shape in link.shapes:
            value = shape.geometry.uri_value
            if value is None or shape.kind not in kinds or shape.geometry.shape != "mesh":
                continue
            if "${" not in value.text and "$(" not in value.text:
                yield shape.geometry


def compiler(model: Model) -> dict[str, str]:
    """The attributes of ``<mujoco><compiler>`` in the robot."""
    found: dict[str, str] = {}
    for extension in model.children("mujoco"):
        for settings in extension.children("compiler"):
            found |= settings.attributes
    return found
