"""Names that nothing may have, and those that may be given again."""

from sdfcheck import Consumer, Model, Name, Root


def is_free(first: Name, later: Name, root: Root) -> bool:
    """Is the later one in a ``<gazebo>`` block, and the first one a link or joint that libsdformat leaves out?"""
    if not later.is_extension or first.is_extension:
        return False
    robot = root.scopes[0]
    if not isinstance(robot, Model):
        return False
    built = robot.as_built_by(Consumer.GAZEBO)
    known = {*built.links, *built.joints, *(frame.name for frame in built.frames)}
    return first.kind in {"link", "joint"} and first.name not in known


def is_reserved(name: Name, root: Root) -> bool:
    """Does libsdformat keep it for itself? In URDF a link may be called ``world``, and many robots begin with it."""
    text = name.name
    is_word = text == "world" and not (root.is_urdf and name.kind == "link")
    is_framed = len(text) >= 4 and text.startswith("__") and text.endswith("__")
    return (is_word or is_framed) and name.is_compared
