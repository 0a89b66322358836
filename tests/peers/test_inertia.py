"""Total masses agree with Drake's, on models that it can load."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sdfcheck.files.library import Library
from sdfcheck.robot.motion.mass_report import ModelMass, mass_report
from sdfcheck.robot.root import root_of

pytestmark = pytest.mark.peers
ROOT = Path(__file__).parents[2]
ROBOTS = ROOT / "fixtures" / "robots"


def files() -> list[Path]:
    """Sound sample robots, and whatever is below the folder that is named in the environment."""
    found = [path for path in ROBOTS.rglob("*.sdf") if "with_mistakes" not in path.parts]
    extra = os.environ.get("SDFCHECK_PEER_MODELS")
    return sorted(found + (list(Path(extra).rglob("*.sdf")) if extra else []))


def top_model(path: Path) -> ModelMass | None:
    """The model of a file that holds one, without nested ones, and all of it known."""
    document = Library().document(path)
    if document is None or document.root is None or document.root.name != "sdf":
        return None
    if "drake:deformable_properties" in document.source.text:
        return None  # no rigid body to Drake
    report = mass_report(root_of(document).scopes)
    sound = len(report.models) == 1 and document.root.has("model") and report.is_complete
    return report.models[0] if sound and not report.models[0].models else None


def drake_total(path: Path) -> dict[str, Any] | None:
    """Mass, center of mass and moments by Drake; None if it does not load the file."""
    child = subprocess.run(
        [sys.executable, "-m", "tests.peers.test_inertia", str(path)],
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
        cwd=ROOT,
    )
    lines = child.stdout.splitlines()
    return json.loads(lines[-1]) if child.returncode == 0 and lines else None


@pytest.mark.parametrize("path", files(), ids=lambda path: f"{path.parent.name}/{path.name}")
def test_drake_finds_the_same_total(path: Path) -> None:
    pytest.importorskip("pydrake")
    model = top_model(path)
    if model is None or model.total is None:
        pytest.skip("not one plain model")
    theirs = drake_total(path)
    if theirs is None:
        pytest.skip("Drake does not load it")
    assert model.total.mass == pytest.approx(theirs["mass"], rel=1e-9)
    assert model.total.center == pytest.approx(np.array(theirs["center"]), abs=1e-9)
    scale = float(np.abs(model.total.moments).max())
    assert model.total.moments == pytest.approx(np.array(theirs["moments"]), abs=1e-9 * max(scale, 1.0))


def _ask(path: str) -> None:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    plant: Any = MultibodyPlant(0.0)
    (model,) = Parser(plant).AddModels(Path(path))
    plant.Finalize()
    context = plant.CreateDefaultContext()
    frame = plant.GetFrameByName("__model__", model)
    bodies = plant.GetBodyIndices(model)
    inertia = plant.CalcSpatialInertia(context, frame, bodies)
    about = inertia.Shift(inertia.get_com()).CalcRotationalInertia()
    answer = {
        "mass": inertia.get_mass(),
        "center": list(inertia.get_com()),
        "moments": about.CopyToFullMatrix3().tolist(),
    }
    print(json.dumps(answer))


if __name__ == "__main__":
    _ask(sys.argv[1])
