"""The names of a URDF robot's parts."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.formats.urdf.survey import UrdfSurvey, survey
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

_ODD = re.compile(r"::|\A__|\A\s*\Z")


def problems(document: Document) -> Iterator[object]:
    """Everything wrong with the names of a URDF document, in no particular order."""
    surveyed = survey(document)
    if surveyed.root is None:
        return
    yield from _names(surveyed, surveyed.root)


def _names(surveyed: UrdfSurvey, root: Element) -> Iterator[object]:
    if (robot_name := root.attribute("name")) is not None and not robot_name.text.strip():
        from sdfcheck.formats.sdf.problems import EmptyName

        yield EmptyName(robot_name)
    given = [
        (kind, value)
        for kind in ("link", "joint", "material")
        for element in surveyed.top(kind)
        if (value := element.attribute("name")) is not None
    ]
    shared = {("" if kind == "joint" else kind.replace("link", ""), value.text) for kind, value in given}
    if len(shared) == len(given) and not any(_ODD.search(name) for _, name in shared):
        return
    from sdfcheck.formats.sdf.problems import EmptyName
    from sdfcheck.robot.names import ClashingName, DuplicateName

    taken: dict[tuple[str, str], Value] = {}
    for kind, value in given:
        name = value.text
        if not name.strip():
            yield EmptyName(value)
            continue
        earlier = taken.setdefault((kind, name), value)
        if earlier is not value:
            yield DuplicateName(value, earlier, root, name, kind)
        elif kind == "joint" and ("link", name) in taken:
            yield ClashingName(
                value, taken["link", name], root, name, "joint", "link", makes_frame=True, renamed=False
            )
        if kind != "material":
            yield from _unfit_for_sdformat(value)


def _unfit_for_sdformat(value: Value) -> Iterator[object]:
    """Names that are nothing special in URDF, and that libsdformat refuses in what it makes of it."""
    from sdfcheck.robot.names import DelimiterInName, ReservedName

    name = value.text
    if len(name) >= 4 and name.startswith("__") and name.endswith("__"):
        yield ReservedName(value)
    if "::" in name:
        yield DelimiterInName(value, refused=True, foreign=None)
