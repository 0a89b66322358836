"""Resolved poses agree with Drake's, on real models."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from sdfcheck.files.library import Library
from sdfcheck.robot.graph import Model
from sdfcheck.robot.motion.poses import Array, angle_between
from sdfcheck.robot.part import Node
from sdfcheck.robot.root import root_of
from tests.peers import drake_poses
from tests.peers.findings import SHARED

TOLERANCE = 1e-9
LEAST_FILES, LEAST_FRAMES = 200, 800

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not drake_poses.is_installed(), reason="Drake is not installed"),
]


def resolved(path: Path) -> Iterator[tuple[str, Array]]:
    """Our poses of links and frames, by the names that Drake gives them."""
    document = Library().document(path)
    assert document is not None
    root = root_of(document)
    for top in root.scopes:
        models = top.models if top.kind == "world" else (top,)
        for model in models:
            for name, node in model.all_nodes(f"{model.name}::"):
                if node.kind == "link" or (node.kind == "frame" and not is_misplaced_by_drake(node)):
                    yield name, root.poses.reached(model, node)
                if isinstance(node, Model) and node.is_readable:
                    yield f"{name}::__model__", root.poses.reached(model, node)


def is_misplaced_by_drake(frame: Node) -> bool:
    """Drake 1.51 loses the offset of what a frame is attached to: a joint, or a frame that comes later."""
    order = list(frame.scope.nodes.values())
    at: Node | None = frame
    while at is not None and at.kind == "frame":
        on = at.attachment
        if on is not None and on.kind == "joint":
            return True
        if (
            on is not None
            and on.kind == "frame"
            and on.scope is at.scope
            and order.index(on) > order.index(at)
        ):
            return True
        at = on
    return False


def disagreements(paths: list[Path]) -> tuple[int, int, list[str]]:
    """How many files and frames could be compared, and where the poses differ."""
    theirs = drake_poses.poses(paths)
    compared, wrong = 0, []
    for path, frames in theirs.items():
        for name, pose in resolved(path):
            if name not in frames:
                continue
            compared += 1
            other = np.array(frames[name])
            apart = float(np.linalg.norm(pose[:3, 3] - other[:3, 3]))
            turned = angle_between(pose[:3, :3], other[:3, :3])
            if apart > TOLERANCE or turned > TOLERANCE:
                wrong.append(f"{path.name}: {name} is {apart:.3g} m and {turned:.3g} rad away")
    return len(theirs), compared, wrong


def has_curve(path: Path) -> bool:
    """Has it a joint of Drake's own that moves its child even at zero?"""
    return b"curvilinear" in path.read_bytes()


@pytest.mark.skipif(not SHARED.is_dir(), reason="the files to compare on are not here")
def test_poses_of_real_models() -> None:
    paths = [path for path in sorted((SHARED / "corpus").rglob("*.sdf")) if not has_curve(path)]
    files, frames, wrong = disagreements(paths)
    assert not wrong, "\n".join(wrong)
    assert files >= LEAST_FILES
    assert frames >= LEAST_FRAMES


ARM = """\
<sdf version="1.9"><model name="arm" canonical_link="tip">
  <pose>0.1 0.2 0.3 0.4 0.5 0.6</pose>
  <link name="root"><pose>1 2 3 0.1 0.2 0.3</pose></link>
  <link name="tip"><pose relative_to="wrist">0 0 0.5 0 0 1</pose></link>
  <frame name="handle" attached_to="root"><pose>0 0.25 0 0.7 0 0</pose></frame>
  <frame name="wrist" attached_to="handle">
    <pose relative_to="root" degrees="true">0 1 0 0 45 90</pose></frame>
  <frame name="plain"/>
</model></sdf>
"""
BUILT = """\
<sdf version="1.9"><model name="built" placement_frame="base">
  <pose>3 2 1 0.3 0.2 0.1</pose>
  <link name="base"><pose rotation_format="quat_xyzw">1 0 0 0 0 0.6 0.8</pose></link>
  <frame name="spot" attached_to="base"><pose>0 0 1 1 0 0</pose></frame>
  <model name="inner" placement_frame="deep::l"><pose relative_to="spot">1 1 1 0.5 0.5 0.5</pose>
    <model name="deep"><pose>0 0 2 0 0.25 0</pose><link name="l"><pose>0 0 0.125 0 0 1</pose></link></model>
  </model>
  <include><uri>{uri}</uri><name>first</name></include>
  <include><uri>{uri}</uri><name>second</name><placement_frame>handle</placement_frame>
    <pose relative_to="inner::deep">0 1 0 0 0 1</pose></include>
  {merged}
  <frame name="last" attached_to="spot"><pose>0 0 1 0 1 0</pose></frame>
</model></sdf>
"""
MERGED = {
    "none": "",
    "with a pose": '<include merge="true"><uri>{uri}</uri>'
    '<pose relative_to="spot">5 0 0 0 0 2</pose></include>',
    "without one": '<include merge="true"><uri>{uri}</uri></include>',
    "placed": '<include merge="true"><uri>{uri}</uri><pose>5 0 0 0 0 2</pose>'
    "<placement_frame>wrist</placement_frame></include>",
}


@pytest.mark.parametrize("merged", MERGED)
def test_poses_of_a_model_made_of_models(merged: str, tmp_path: Path) -> None:
    arm, built = tmp_path / "arm.sdf", tmp_path / "built.sdf"
    arm.write_text(ARM)
    uri = f"file://{arm}"
    built.write_text(BUILT.format(uri=uri, merged=MERGED[merged].format(uri=uri)))
    files, frames, wrong = disagreements([built])
    assert not wrong, "\n".join(wrong)
    assert files == 1
    assert frames == (18 if merged == "none" else 23)
