"""The names of Ignition, as Gazebo was called up to Fortress, and what they are now."""

import re

FILE = re.compile(r"(?:lib)?ignition-gazebo\d*-([\w-]+?)(?:\.so)?")
CLASS = re.compile(r"ignition::(gazebo(?=::|\Z))?")
_LATER = {
    "particle-emitter2-system": "particle-emitter-system",
    "ignition::gazebo::systems::ParticleEmitter2": "gz::sim::systems::ParticleEmitter",
}
"""Names that are gone since then, and what took their place."""


def new_file(name: str) -> str | None:
    """The present name of a plugin's file: systems lose `lib` and `.so`, too; None if it is not
    Ignition's.
    """
    found = FILE.fullmatch(name.strip())
    return f"gz-sim-{_LATER.get(found[1], found[1])}" if found else None


def new_class(name: str) -> str | None:
    """The present name of a class; None if it is not Ignition's."""
    if name in _LATER:
        return _LATER[name]
    new = CLASS.sub(lambda found: "gz::sim" if found[1] else "gz::", name, count=1)
    return new if CLASS.match(name) else None
