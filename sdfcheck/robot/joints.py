"""Joints of SDF models: their ends and leaders."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.source.document import Document

if TYPE_CHECKING:
    from sdfcheck.robot.joint_problems import Problem


def problems(document: Document) -> list[Problem]:
    """Everything about the joints of an SDF document that is wrong, in no particular order."""
    index = survey(document).index
    joints = index.get("joint")
    if not joints:
        return []
    from sdfcheck.robot.joint_ends import end_problems

    found = list(end_problems(document, joints))
    if index.get("mimic"):
        from sdfcheck.robot.mimics import mimic_problems

        found += mimic_problems(document)
    return found
