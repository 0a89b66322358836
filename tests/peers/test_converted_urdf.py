"""URDF converted to SDFormat: the consumers that are installed take the results, and see the same robots in them."""

from __future__ import annotations

import json
import math
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from lxml import etree

from sdfcheck.cli.main import main
from sdfcheck.convert.comparison import Correspondence, verify
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import read
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.sniff import Kind, sniff
from tests.peers import cmdcheck, cmdprint, drake_poses, libsdformat
from tests.peers.findings import SHARED

VERSIONS = ("1.6", "1.9", "1.12")
CORPUS = SHARED / "corpus"
LEAST = 110
LEAST_MERGED = 74
UPRIGHT = 5e-3
"""A pitch so near to upright (rad) is turned fully upright by urdfdom."""

FOR_DRAKE = dict.fromkeys(
    ("Acrobot.urdf", "Acrobot_unicode.urdf", "acrobot.urdf"),
    "a joint to a world that is not there: urdfdom refuses the file, and Drake takes it",
)
"""Files that are converted for another consumer than urdfdom, and why."""

pytestmark = [
    pytest.mark.peers,
    pytest.mark.xdist_group("converted"),
    pytest.mark.skipif(not CORPUS.is_dir(), reason="the files to convert are not here"),
]


class Converted(NamedTuple):
    source: Path
    results: dict[str, Path]
    """Version → what was written; "merged": 1.9, with fixed joints merged."""
    codes: dict[str, frozenset[str]]
    """The codes of what was reported."""
    has_empty_shapes: bool
    """Were shapes of size 0 left out?"""


def sources() -> list[Path]:
    files = (
        file for file in sorted(CORPUS.rglob("*")) if file.suffix in {".urdf", ".xml"} and file.is_file()
    )
    return [file for file in files if sniff(file.read_bytes(), file) is Kind.URDF]


def convert(source: Path, folder: Path, version: str, *options: str) -> tuple[Path, dict[str, list[str]]]:
    """The written text, and the reports: code → messages."""
    result, report = folder / f"{version}{''.join(options)}.sdf", folder / "report.json"
    arguments = [str(source), "-o", str(result), "--sdf-version", version, "--isolated", "--quiet", *options]
    code = main(["convert", "urdf-to-sdf", *arguments, "--output-format", f"json={report}"])
    assert result.exists() is (code == 0)
    reported: dict[str, list[str]] = {}
    for one in json.loads(report.read_text())["diagnostics"]:
        reported.setdefault(one["code"], []).append(one["message"])
    return result, reported


@pytest.fixture(scope="module")
def converted(tmp_path_factory: pytest.TempPathFactory, stride: Callable[[int], int]) -> list[Converted]:
    made = []
    for number, source in enumerate(sources()[:: stride(8)]):
        folder = tmp_path_factory.mktemp(f"robot{number}_")
        done = {version: convert(source, folder, version) for version in VERSIONS}
        done["merged"] = convert(source, folder, "1.9", "--fixed-joints", "merge")
        results = {name: result for name, (result, _) in done.items() if result.exists()}
        codes = {name: frozenset(reported) for name, (_, reported) in done.items()}
        losses = done["merged"][1].get("CNV008", ())
        made.append(Converted(source, results, codes, any("size 0" in message for message in losses)))
    return made


def test_only_values_that_urdfdom_reads_convert(
    converted: list[Converted], stride: Callable[[int], int]
) -> None:
    if shutil.which("check_urdf") is None:
        pytest.skip("check_urdf is not installed")
    wrong, read_by_it = [], 0
    for one in converted:
        child = subprocess.run(["check_urdf", one.source], capture_output=True, check=False)
        read_by_it += child.returncode == 0
        is_wanted = child.returncode == 0 or one.source.name in FOR_DRAKE
        if len(one.results) != (len(VERSIONS) + 1 if is_wanted else 0):
            wrong.append(
                f"{one.source}: urdfdom ends with {child.returncode}, {sorted(one.results)} are written"
            )
    assert not wrong, "\n".join(wrong)
    assert read_by_it >= LEAST // stride(8)


def test_libsdformat_accepts_the_results(converted: list[Converted], stride: Callable[[int], int]) -> None:
    """All but those whose source has an inertia that no body has: it is carried over, and libsdformat refuses it."""
    if libsdformat.library() is None:
        pytest.skip("libsdformat is not installed")
    wrong, accepted = [], 0
    for one in converted:
        for name in set(one.results) - {"1.12"}:  # newer than some libsdformat
            opinion = cmdcheck.check(one.results[name])
            accepted += opinion.accepted is True
            excused = "INR003" in one.codes[name] and all(
                "invalid inertia" in message for message in opinion.messages if "Error" in message
            )
            if not opinion.accepted and not excused:
                wrong.append(f"{one.source} as {name}: {opinion.messages[:3]}")
    assert not wrong, "\n".join(wrong)
    assert accepted >= (3 * LEAST - 15) // stride(8)


# Drake

NOT_SDFORMAT = {"valkyrie.urdf"}
"""Robots whose <gazebo> blocks have elements that are not SDFormat's, where Drake requires only those."""
WEIGHTY_WORLD = {"Pendulum.urdf"}
"""Robots whose link `world` has a mass: for Drake it is the world anyway."""


@pytest.mark.skipif(not drake_poses.is_installed(), reason="Drake is not installed")
def test_drake_weighs_each_link_the_same(converted: list[Converted], stride: Callable[[int], int]) -> None:
    pairs = {one.source: one.results["1.12"] for one in converted if one.results}
    before, after = drake_poses.bodies(list(pairs)), drake_poses.bodies(list(pairs.values()))
    wrong, compared = [], 0
    for source, result in pairs.items():
        if source not in before:
            continue
        if result not in after:
            wrong += [f"{source}: the result is not loaded"] * (source.name not in NOT_SDFORMAT)
            continue
        compared += 1
        wrong += [f"{source}: {text}" for text in unequal(source, before[source], after[result])]
    assert not wrong, "\n".join(wrong)
    assert compared >= (LEAST - 5) // stride(8)


SMALL = [1e-3]
"""The mass (kg) that a link without any is given."""


def unequal(source: Path, before: drake_poses.Bodies, after: drake_poses.Bodies) -> Iterator[str]:
    """In what two readings differ, apart from links without mass, which SDFormat does not have.

    To a link that has moments and no mass Drake gives 1 kg, and what has become part of another link
    adds its moments there.
    """
    if links_with_moments_only(source) or source.name in WEIGHTY_WORLD:
        return
    for name, body in before.items():
        if body[0][0] > 0 and name in after and not same(body, after[name]):
            yield f"{name} was {body} and is {after[name]}"
    given = [
        name for name, body in after.items() if body[0] == SMALL and before.get(name, [[0.0]])[0] == [0.0]
    ]
    expected = sum(body[0][0] for body in before.values())
    total = sum(body[0][0] for name, body in after.items() if name not in given)
    if not math.isclose(total, expected, rel_tol=1e-9, abs_tol=1e-12):
        yield f"it weighed {expected} kg and weighs {total} kg"


def same(before: list[list[float]], after: list[list[float]]) -> bool:
    return all(np.allclose(*rows, rtol=1e-9, atol=1e-12) for rows in zip(before, after, strict=True))


def links_with_moments_only(source: Path) -> list[str]:
    tree = etree.parse(source, etree.XMLParser(recover=True))
    found = []
    for link in tree.iter("link"):
        mass, inertia = link.find("inertial/mass"), link.find("inertial/inertia")
        if mass is not None and inertia is not None and float(mass.get("value", "0")) == 0:
            found += [link.get("name", "")] * any(float(value) != 0 for value in inertia.attrib.values())
    return found


# libsdformat's own reduction of fixed joints


def test_merging_is_libsdformats_reduction(converted: list[Converted], stride: Callable[[int], int]) -> None:
    if libsdformat.library() is None:
        pytest.skip("libsdformat is not installed")
    equal, wrong = 0, []
    for one in converted:
        if not one.results or excuse(one):
            continue
        text = cmdprint.printed([cmdprint.Job(Path(one.source))])[0]
        theirs, ours = robot(text), robot(one.results["merged"].read_text())
        differences = [f"links {sorted(set(ours.links) ^ set(theirs.links))}"] * (
            set(ours.links) != set(theirs.links)
        )
        differences += [f"joints {sorted(set(ours.joints) ^ set(theirs.joints))}"] * (
            set(ours.joints) != set(theirs.joints)
        )
        proof = verify(theirs, ours, Correspondence(), tolerance=1e-6)
        if {d.what for d in proof.differences} <= {"visual", "collision", "inertia"}:
            proof = verify(theirs, ours, Correspondence(), tolerance=UPRIGHT)
        differences += [f"{d.what} of {d.name} {d.text}" for d in proof.differences]
        if differences:
            wrong.append(f"{one.source}: {differences[:4]}")
        equal += not differences
    assert not wrong, "\n".join(wrong)
    assert equal >= LEAST_MERGED // stride(8)


def excuse(one: Converted) -> str:
    """Why libsdformat's result is another one, empty if it must be equal."""
    if reason := FOR_DRAKE.get(one.source.name):
        return reason
    if one.has_empty_shapes:
        return "it makes a shape of size 0 one of 1 m, which is left out here"
    if "CNV014" in one.codes["merged"]:
        return "it drops links without mass, and all that they carry"
    if "CNV011" in one.codes["merged"]:
        return "it does not rename what has one name in URDF"
    fixed = etree.fromstring(one.results["merged"].read_bytes()).iterfind(".//joint[@type='fixed']")
    if any(joint.findtext("parent") != "world" for joint in fixed):
        return "it merges what has a sensor or asks for feedback, too, and drops that"
    return ""


def robot(text: str) -> Mechanism:
    try:
        return mechanism_of(root_of(read(text.encode(), Path("r.sdf"), Kind.SDF)).models[0])
    except DescriptionError as error:
        pytest.fail(str(error))
