"""Total masses agree with Drake's, and moments are impossible where libsdformat says so."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sdfcheck.files.library import Library
from sdfcheck.robot.motion.mass_report import ModelMass, mass_report
from sdfcheck.robot.root import root_of
from sdfcheck.robot.solids import Moments
from tests.peers import libsdformat

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


def at_the_edge(count: int) -> list[Moments]:
    """Thin rods and discs in any position, moments that break the triangle inequality by little, all of any size."""
    drawn = np.random.default_rng(4_711)
    found = []
    for number in range(count):
        turn, _ = np.linalg.qr(drawn.normal(size=(3, 3)))
        thin = 10 ** drawn.uniform(-9, -3)
        moments = [(1, 1, 0), (1, 1, thin), (1, 0.5, 0.5), (1, 0.7, 0.3), (1, 1 - thin, 0.999 * thin)][
            number % 5
        ]
        tensor = turn @ np.diag(np.array(moments) * 10 ** drawn.uniform(-9, 2)) @ turn.T
        digits = int(drawn.choice([6, 9, 12, 15, 17]))
        rows, columns = [0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]
        found.append(Moments(*(float(f"{value:.{digits}g}") for value in tensor[rows, columns])))
    return found


def test_libsdformat_refuses_the_same_moments(tmp_path: Path) -> None:
    if libsdformat.library() is None:
        pytest.skip("libsdformat is not installed")
    tensors = at_the_edge(300)
    links = "".join(
        f'<link name="l{number}"><inertial><mass>1</mass><inertia>'
        + "".join(f"<{name}>{value!r}</{name}>" for name, value in zip(Moments._fields, tensor, strict=True))
        + "</inertia></inertial></link>"
        for number, tensor in enumerate(tensors)
    )
    path = tmp_path / "edge.sdf"
    path.write_text(f'<sdf version="1.9"><model name="m">{links}</model></sdf>')
    answer = libsdformat.ask("cmdCheck", path)
    refused = {
        int(name) for name in re.findall(r"link named l(\d+) has invalid", answer.output + answer.errors)
    }
    ours = {number for number, each in enumerate(tensors) if each.is_impossible}
    assert 50 < len(refused) < 250
    # It also asks whether determinants are negative, which rounding decides where one should be 0.
    assert len(ours ^ refused) <= 3


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
