"""Who follows whom: the mimics of SDF joints, axis by axis.

Source: libsdformat 17's Joint.cc and parser.cc, checked against what they report.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.robot.joint_problems import MimicCycle, Problem, UnknownMimicLeader
from sdfcheck.robot.near_names import near_names
from sdfcheck.robot.scopes import Scope, scopes
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple

_AXES = ("axis", "axis2")


class _Axis(NamedTuple):
    joint: Element
    name: str


class _Mimic(NamedTuple):
    """An axis that follows another, and where it says so."""

    leader: Value
    on: _Axis


def mimic_problems(document: Document) -> Iterator[Problem]:
    """What is wrong with the mimics of an SDF document."""
    leaders: dict[_Axis, _Mimic] = {}
    for mimic in survey(document).index.get("mimic", ()):
        axis = mimic.parent
        joint = axis.parent if axis is not None else None
        scope = scopes(document).of(joint) if joint is not None else None
        if axis is None or joint is None or scope is None:
            continue
        found = _leader(document, joint, mimic, scope)
        if isinstance(found, _Mimic):
            leaders.setdefault(_Axis(joint, axis.tag), found)
        elif found is not None:
            yield found
    yield from _rings(leaders)


def _leader(document: Document, joint: Element, mimic: Element, scope: Scope) -> _Mimic | Problem | None:
    value = mimic.attribute("joint")
    if value is None or not (name := value.text.strip()):
        return None
    found = scope.find(name)
    if found is None or found.kind != "joint":
        if "" in name.split("::") or (found is None and scope.may_hold(name)):
            return None
        meant, _ = near_names(document).guess(
            scope, name, but=(joint.attributes.get("name", ""),), kind="joint"
        )
        return UnknownMimicLeader(value, joint, meant)
    wanted = mimic.attribute("axis")
    axis = (wanted.text.strip() if wanted is not None else "") or _AXES[0]
    if axis not in _AXES or not found.element.has(axis):
        return UnknownMimicLeader(wanted or value, joint, None, axis)
    return _Mimic(value, _Axis(found.element, axis))


def _rings(leaders: dict[_Axis, _Mimic]) -> Iterator[Problem]:
    done: set[_Axis] = set()
    for start in leaders:
        path: dict[_Axis, Value] = {}
        at = start
        while at in leaders and at not in path and at not in done:
            path[at], at = leaders[at]
        if at in path:
            axes = list(path)
            ring = axes[axes.index(at) :]
            names = tuple(axis.joint.attributes.get("name", "") for axis in ring)
            yield MimicCycle(tuple(path[axis] for axis in ring), names)
        done.update(path)
