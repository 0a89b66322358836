"""The marks by which SDFormat that was URDF becomes the same URDF again: attributes and elements under ``urdf:``.

They say nothing of the robot, and are not compared.
"""

from __future__ import annotations

from sdfcheck.source.document import Element

JOINT, PARENT = "urdf:joint", "urdf:parent"
"""On a frame that was a link: the frame that was its joint, and what that joint was fixed to."""
LINK = "urdf:link"
"""On a shape, sensor or end of a joint: the link that it was of."""
INERTIAL = "urdf:inertial"
"""In a frame that was a link, or a link that others became part of: its own inertial."""
PACKAGES = "urdf:packages"
"""On a model: the packages whose files are named as those of models."""
EMPTY = "urdf:empty"
"""In an element that is kept under the prefix: its attributes without a value, of which libsdformat complains."""
BLOCK = "urdf:block"
"""On an element that is kept under the prefix: it was in a ``<gazebo>`` block."""
WAS, NONE = "urdf:was", "none"
"""On a parameter of a plugin about a link: its text before the link became part of another."""
MERGED, NOTHING = "urdf:merged", "urdf:nothing"
"""For the way back alone: a joint that was merged, and the inertial of a link that has none."""
SCRIPTS = "file://media/materials/scripts/gazebo.material"
"""Where the scripts are that a ``<material>`` of a ``<gazebo>`` block names."""
MARKS = frozenset({BLOCK, EMPTY, JOINT, PARENT, LINK, INERTIAL, PACKAGES, WAS, MERGED, NOTHING})


def is_mark(element: Element) -> bool:
    """Is an element a mark? An ``inertial`` elsewhere is one that its author wrote in the wrong place."""
    holder = element.parent
    is_marked = element.name != INERTIAL or (holder is not None and holder.name in {"link", "frame"})
    return element.name in MARKS and is_marked
