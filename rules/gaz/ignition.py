"""The names of Ignition, as Gazebo was called up to Fortress, and what they are now."""

import re

FILE = re.compile(r"(?:lib)?ignition-gazebo\d*-([\w-]+?)(?:\.so)?")
CLASS = re.compile(r"ignition::(gazebo(?=::|\Z))?")


def new_file(name: str) -> str | None:
    """The present name of a plugin's file: systems lose `lib` and `.so`, too; None if it is not
    Ignition's.
    """
    found = FILE.fullmatch(name.strip())
    return f"gz-sim-{found[1]}" if found else None


def new_class(name: str) -> str | None:
    """The present name of a class; None if it is not Ignition's."""
    new = CLASS.sub(lambda found: "gz::sim" if found[1] else "gz::", name, count=1)
    return new if CLASS.match(name) else None
