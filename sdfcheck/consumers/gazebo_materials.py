"""Materials that are looked up in scripts, which new Gazebo does not load."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sdfcheck.consumers.gazebo_problems import ScriptMaterial
from sdfcheck.formats.sdf.survey import survey
from sdfcheck.source.document import Document

_COLOURS = ("ambient", "diffuse", "emissive", "pbr")


def told_once(found: Iterable[ScriptMaterial]) -> Iterator[ScriptMaterial]:
    """One problem for each script."""
    by_script: dict[str, list[ScriptMaterial]] = {}
    for problem in found:
        by_script.setdefault(problem.script, []).append(problem)
    for first, *others in by_script.values():
        yield ScriptMaterial(first.target, first.script, 1 + len(others))


def script_materials(document: Document) -> Iterator[ScriptMaterial]:
    """Materials of visuals that consist of a script; one that has colours beside it is seen by all."""
    for material in survey(document).index.get("material", ()):
        parent, script = material.parent, material.find("script")
        if parent is None or parent.name != "visual" or script is None:
            continue
        if any(material.has(name) for name in _COLOURS):
            continue
        name = script.find("name")
        named = name is not None and name.content
        yield ScriptMaterial(name.own_value if name is not None and named else script, named or "")
