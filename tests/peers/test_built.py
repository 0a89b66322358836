"""The robot that we expect Gazebo to build is the one that libsdformat 17 prints.

Asked is ``gz-sdformat-sdf``, the program of libsdformat 17, where it is on the path.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from lxml import etree

from sdfcheck.consumers.gazebo import BuiltJoint, BuiltLink, BuiltShape, GazeboRobot
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.files.library import Library
from sdfcheck.robot.root import root_of
from tests.peers.findings import SHARED

PROGRAM = shutil.which("gz-sdformat-sdf")
LEAST_PARTS, LEAST_SHARE = 5_500, 0.995
MOST_DIFFERENT = 0.006
"""So large a share may be written otherwise: blocks bring links and joints of their own."""
FRICTION = {"mu1": "mu", "mu2": "mu2"}

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(PROGRAM is None, reason="libsdformat 17 is not installed"),
    pytest.mark.skipif(not SHARED.is_dir(), reason="the corpus is not here"),
]


def printed(path: Path) -> etree._Element | None:
    """The model that libsdformat makes of a robot; None where it refuses it."""
    assert PROGRAM is not None
    run = subprocess.run([PROGRAM, "-p", str(path)], capture_output=True, text=True, check=False)
    _, start, rest = run.stdout.partition("<sdf")
    if not start:
        return None
    return etree.fromstring(start + rest, etree.XMLParser(recover=True)).find("model")


def theirs(model: etree._Element) -> Iterator[tuple[object, ...]]:
    for frame in model.iterfind(".//frame[@name]"):
        yield "frame", frame.get("name"), frame.get("attached_to")
    for holder in model.iter("link", "joint"):
        name = holder.get("name")
        if holder.tag == "link":
            yield "link", name
        else:
            yield "joint", name, holder.get("type"), holder.findtext("parent"), holder.findtext("child")
        for sensor in holder.iterfind("sensor"):
            yield "sensor", holder.tag, name, sensor.get("name"), sensor.get("type")
        for shape in (*holder.iterfind("visual"), *holder.iterfind("collision")):
            yield shape.tag, name, shape.get("name")
            for setting in FRICTION.values():
                if (text := shape.findtext(f"surface/friction/ode/{setting}")) is not None:
                    yield "setting", name, shape.get("name"), setting, float(text)


def ours(robot: GazeboRobot) -> Iterator[tuple[object, ...]]:
    for frame in robot.frames:
        yield "frame", frame.name, frame.attached_to
    for link in robot.links.values():
        yield "link", link.name
        yield from sensors(link)
        for kind, shapes in (("visual", link.visuals), ("collision", link.collisions)):
            for shape in shapes:
                yield kind, link.name, shape.name
                yield from settings(link, shape)
    for joint in robot.joints.values():
        yield "joint", joint.name, joint.type, joint.parent, joint.child
        yield from sensors(joint)


def sensors(holder: BuiltLink | BuiltJoint) -> Iterator[tuple[object, ...]]:
    for sensor in holder.sensors:
        yield "sensor", holder.origin.kind, holder.name, sensor.name, sensor.type


def settings(link: BuiltLink, shape: BuiltShape) -> Iterator[tuple[object, ...]]:
    last = {each.name: each.get("value") or each.content for each in shape.settings if each.name in FRICTION}
    for name, text in last.items():
        yield "setting", link.name, shape.name, FRICTION[name], float(text)


def test_the_robot_that_libsdformat_builds() -> None:
    total, different = 0, []
    for path in sorted((SHARED / "corpus").rglob("*.urdf")):
        model, document = printed(path), Library().document(path)
        if model is None or document is None:
            continue
        robot = root_of(document).models[0]
        added = {part.name for part in robot.extended.nodes.values() if part.is_extension}
        mine = set(ours(robot.as_built_by(Consumer.GAZEBO)))
        wanted = {part for part in theirs(model) if part[1] not in added or part[0] == "frame"}
        total += len(mine | wanted)
        different += [(path.name, *part) for part in mine ^ wanted]
    assert total > LEAST_PARTS
    assert len(different) <= (1 - LEAST_SHARE) * total, different


def without(model: etree._Element, selected: str) -> etree._Element:
    """A model without some elements."""
    found: Any = model.xpath(f".//{selected}")
    for element in found:
        element.getparent().remove(element)
    return model


def bodies(model: etree._Element) -> Iterator[tuple[object, ...]]:
    """Names and masses, of frames without what they are attached to."""
    for part in theirs(model):
        yield part[:2] if part[0] == "frame" else part
    for link in model.iter("link"):
        yield "mass", link.get("name"), round(float(link.findtext("inertial/mass", "nan")), 6)


def test_the_robot_that_is_written_like_gazebo() -> None:
    total, different = 0, []
    for path in sorted((SHARED / "corpus").rglob("*.urdf")):
        model, document = printed(path), Library().document(path)
        if model is None or model.find("link") is None or document is None:
            continue
        done = urdf_to_sdf(document, Options(like=Consumer.GAZEBO))
        assert done.verification is not None
        assert done.verification.is_equal, path
        own = etree.fromstring(done.text.encode()).find("model")
        assert own is not None
        own = without(own, "*[namespace-uri() != '']")
        model = without(model, "*[geometry/sphere/radius=0 or geometry/box/size='0 0 0']")
        mine, wanted = set(bodies(own)), set(bodies(model))
        mine = {part for part in mine if part[0] != "frame" or part in wanted}  # others are Drake's
        total += len(mine | wanted)
        different += [(path.name, *part) for part in mine ^ wanted]
    assert total > LEAST_PARTS
    assert len(different) <= MOST_DIFFERENT * total, different
