"""A second opinion: yourdfpy reads the URDF side, and its poses are compared with ours of the SDF side."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from sdfcheck.convert.verification import Difference
from sdfcheck.robot.motion.kinematics import link_poses
from sdfcheck.robot.motion.rotations import Array, angle_between, inverse
from sdfcheck.source.sniff import Kind
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.convert.result import Comparison, Conversion
    from sdfcheck.source.document import Document

TOLERANCE = 1e-6
"""The tolerance for a library that computes in chains of its own (m, rad)."""
CONFIGURATIONS = 16


def differences(done: Conversion, source: Document) -> list[Difference]:
    """In what yourdfpy's reading of the URDF differs from our reading of the SDF.

    Raises:
        WrongUsage: yourdfpy is not installed, or cannot read the file.
    """
    try:
        import yourdfpy
    except ImportError:
        raise WrongUsage(
            "--verify-with yourdfpy needs the package yourdfpy: install sdfcheck[verify]"
        ) from None
    from_urdf = source.kind is Kind.URDF
    text = source.source.text if from_urdf else done.text
    found: list[Difference] = []
    for comparison in done.comparisons:
        try:
            model = yourdfpy.URDF.load(io.BytesIO(text.encode()), load_meshes=False, build_scene_graph=True)
        except Exception as error:
            raise WrongUsage(f"yourdfpy cannot read the URDF: {' '.join(str(error).split())}") from None
        found += _compare(model, comparison, from_urdf=from_urdf)
    return found


def _compare(model: Any, comparison: Comparison, *, from_urdf: bool) -> list[Difference]:
    random = np.random.default_rng(4_711)
    found: dict[str, Difference] = {}
    axes = _axes(comparison, from_urdf=from_urdf)
    for _ in range(CONFIGURATIONS):
        drawn = dict(
            zip(model.actuated_joint_names, random.uniform(-1, 1, model.num_actuated_joints), strict=True)
        )
        model.update_cfg(drawn)
        other = comparison.result if from_urdf else comparison.source
        positions: dict[str, dict[int, float]] = {}
        for name, value in drawn.items():
            joint, axis = axes.get(name, (name, 0))
            if joint in comparison.correspondence.dropped_joints:
                continue
            positions.setdefault(joint, {})[axis] = float(value)
        given = {name: np.array([[v for _, v in sorted(by.items())]]) for name, by in positions.items()}
        poses = {name: pose[0] for name, pose in link_poses(other, given).items()}
        for name, apart in _apart(model, comparison, poses, from_urdf=from_urdf):
            if max(apart) > TOLERANCE:
                text = f"is {apart[0]:.3g} m and {apart[1]:.3g} rad from where yourdfpy has it"
                found.setdefault(name, Difference("link", name, text))
    return list(found.values())


def _axes(comparison: Comparison, *, from_urdf: bool) -> dict[str, tuple[str, int]]:
    """For each joint of the URDF the joint, and its axis, whose position is the same on the SDF side."""
    to, joints = comparison.correspondence, comparison.source.joints
    if from_urdf:
        return {name: to.joint_of_axis(name, 0) for name in joints}
    numbered = ((name, number) for name, joint in joints.items() for number in range(max(1, len(joint.axes))))
    return {to.joint_of_axis(name, number)[0]: (name, number) for name, number in numbered}


def _apart(
    model: Any, comparison: Comparison, poses: Mapping[str, Array], *, from_urdf: bool
) -> list[tuple[str, tuple[float, float]]]:
    """How far each link is from where yourdfpy has it, both seen from the first link."""
    to = comparison.correspondence
    ours: dict[str, Array] = {}
    theirs: dict[str, Array] = {}
    for name in comparison.source.links:
        counterpart = to.link(name)
        in_urdf = name if from_urdf else counterpart.link
        if name in to.dropped_links or in_urdf not in model.link_map:
            continue
        pose = poses.get(counterpart.link if from_urdf else name)
        if pose is not None:
            ours[name] = pose @ counterpart.offset if from_urdf else pose
            theirs[name] = model.get_transform(in_urdf)
            if not from_urdf:
                theirs[name] = theirs[name] @ counterpart.offset
    if not ours:
        return []
    first = next(iter(ours))
    result = []
    for name, pose in ours.items():
        here, there = inverse(ours[first]) @ pose, inverse(theirs[first]) @ theirs[name]
        shift = float(np.linalg.norm(here[:3, 3] - there[:3, 3]))
        result.append((name, (shift, angle_between(here[:3, :3], there[:3, :3]))))
    return result
