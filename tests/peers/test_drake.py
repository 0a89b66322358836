"""The verdicts about Drake's elements against Drake itself, and against files that it loads in silence."""

from __future__ import annotations

import json
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from sdfcheck.consumers.engines import Engine, is_installed
from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.config.settings import UNSET
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.session import Options, run
from sdfcheck.source.document import read
from tests.peers.consumers import loads
from tests.peers.findings import SHARED
from tests.vendor_documents import FILES, Case, cases
from tests.vendor_rules import reported

pytestmark = pytest.mark.peers

EVERY = 6
"""Every so many documents: all of them take most of a minute (``python -m tests.peers.test_drake``)."""

SHAPELESS = ("drake:capsule", "drake:ellipsoid")
"""Misspelled in URDF, these leave a geometry without shape: that is reported as such."""

ARGUED = {
    "hydroelastic.sdf": {"DRK005"},
    "arm.urdf": {"DRK010"},
    "atlas_with_fixed_joints.urdf": {"DRK010"},
    "duplicate_but_same_materials_with_texture.urdf": {"DRK010", "DRK013"},
    "kuka_iiwa_robot.urdf": {"DRK010"},
}
"""File → rules that rightly speak up: Drake warns, makes no actuator, or holds a limit that others do not."""

LATER = {"massless-leaf", "unsupported-mesh-format"}
"""Failures only in the simulation, or where there is a scene graph: the verdicts are about loading."""


def disagreements(chosen: list[Case], folder: Path) -> list[str]:
    """The cases of which we say that Drake refuses them and it does not, or the reverse."""
    for name, text in FILES.items():
        (folder / name).write_text(text)
    paths = [folder / f"{number}.{case.dialect}" for number, case in enumerate(chosen)]
    for path, case in zip(paths, chosen, strict=True):
        path.write_text(case.text)
    verdicts = loads(Engine.DRAKE, paths)
    found = []
    for path, case in zip(paths, chosen, strict=True):
        tags = reported(read(path.read_bytes(), path))
        is_new = any(diagnostic.name == "too-new-drake-tag" for diagnostic in tags)
        shapeless = (
            case.name.startswith(tuple(f"urdf {tag} " for tag in SHAPELESS)) and "misspelt" in case.name
        )
        if is_new or shapeless:
            continue
        reactions = [dict(diagnostic.affects)[Consumer.DRAKE.value] for diagnostic in tags]
        if any(reaction.verdict is Verdict.REJECT for reaction in reactions) == verdicts[path]:
            found.append(f"{case.name}: Drake {'loads' if verdicts[path] else 'refuses'} it")
    return found


@pytest.mark.skipif(not is_installed(Engine.DRAKE), reason="pydrake is not installed")
def test_drake_refuses_what_we_say_it_does(tmp_path: Path) -> None:
    assert disagreements(cases()[::EVERY], tmp_path) == []


def silent_files() -> list[Path]:
    """The files of Drake's own project that Drake loads."""
    entries = json.loads((SHARED / "corpus" / "verdicts.json").read_text(encoding="utf-8"))
    return [
        SHARED / "corpus" / entry["file"]
        for entry in entries
        if entry["file"].startswith("drake/") and entry.get("drake", {}).get("ok")
    ]


@pytest.mark.skipif(not SHARED.is_dir(), reason="the files to compare on are not here")
@pytest.mark.parametrize("target", [None, ("drake",)], ids=["default", "for Drake"])
def test_files_that_drake_loads_are_left_alone(target: tuple[str, ...] | None) -> None:
    paths = silent_files()
    assert paths
    done = run(paths, Options(Configuration(isolated=True, given=UNSET._replace(target=target))))
    found = [
        f"{d.span.source.path.name}:{d.span.begin.line}: {d.code} {d.message}"
        for d in done.diagnostics
        if d.code.startswith("DRK")
        and d.severity >= Severity.WARNING
        and d.name not in LATER
        and d.code not in ARGUED.get(d.span.source.path.name, ())
    ]
    assert found == []


if __name__ == "__main__":
    with TemporaryDirectory() as folder:
        print(*disagreements(cases(), Path(folder)), sep="\n")
