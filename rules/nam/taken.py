"""Names of URDF that what is in ``<gazebo>`` blocks may have, for Gazebo builds nothing of that name."""

from sdfcheck import Consumer, Model, Name, Root


def is_free(first: Name, later: Name, root: Root) -> bool:
    """Is the later one in a block, and the first one a link or joint that libsdformat leaves out?"""
    if not later.is_extension or first.is_extension:
        return False
    robot = root.scopes[0]
    if not isinstance(robot, Model):
        return False
    built = robot.as_built_by(Consumer.GAZEBO)
    known = {*built.links, *built.joints, *(frame.name for frame in built.frames)}
    return first.kind in {"link", "joint"} and first.name not in known
