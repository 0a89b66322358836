"""The page of a robot in headless Chromium: no errors, no foreign script, links where our kinematics has them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from tests.peers import chromium

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(chromium.missing() is not None, reason=chromium.missing() or ""),
]

ROOT = Path(__file__).parents[2]
FIXTURES = ROOT / "fixtures"
WHOLE = sorted(
    file
    for pattern in ("robots/**/*.*", "api/*.*", "tutorial/*.urdf")
    for file in FIXTURES.glob(pattern)
    if file.suffix in {".sdf", ".urdf", ".world", ".xacro"}
    and "macros" not in file.parts
    and file.name != "gripper.urdf.xacro"  # cannot be expanded
)
ROBOTS = [*WHOLE, *sorted(FIXTURES.glob("convert/*/*/input.*f"))[::6]]


@pytest.fixture(scope="module")
def tab() -> Iterator[chromium.Tab]:
    with chromium.tab() as opened:
        yield opened


def show(tab: chromium.Tab, tmp_path: Path, *arguments: str | Path) -> Path:
    """Makes the page of a robot and opens it."""
    out = tmp_path / "out.html"
    assert main(["view", *map(str, arguments), "-o", str(out), "--isolated"]) == 0
    tab.open(out)
    tab.page.wait_for_selector("html[data-ready]", timeout=60_000)
    return out


def test_robots_and_worlds_without_an_error(tab: chromium.Tab, tmp_path: Path) -> None:
    assert len(ROBOTS) >= 20
    errors = {}
    for file in ROBOTS:
        show(tab, tmp_path, file)
        if tab.errors:
            errors[str(file.relative_to(FIXTURES))] = list(tab.errors)
    assert not errors


@pytest.mark.skipif(chromium.missing_axe() is not None, reason=chromium.missing_axe() or "")
def test_accessible(tab: chromium.Tab, tmp_path: Path) -> None:
    show(tab, tmp_path, FIXTURES / "robots" / "with_mistakes" / "crane.urdf")
    assert tab.faults() == []


def test_names_bring_no_script(tab: chromium.Tab, tmp_path: Path) -> None:
    name = (
        "&lt;/script>&lt;img src=x onerror=alert(1)>&lt;svg onload=alert(2)>&lt;script>alert(3)&lt;/script>"
    )
    file = tmp_path / "evil.sdf"
    file.write_text(
        f'<sdf version="1.12"><model name="{name}"><link name="{name}"><visual name="{name}"><geometry>'
        f'<mesh><uri>{name}.stl</uri></mesh></geometry></visual></link><link name="b"/><joint name="{name}_" '
        f'type="revolute"><parent>b</parent><child>{name}</child><axis><xyz>0 0 1</xyz></axis></joint></model></sdf>'
    )
    show(tab, tmp_path, file)
    assert tab.dialogs == []
    assert tab.errors == []
    assert tab.run("document.querySelectorAll('img, svg').length") == 0
    assert "onerror=alert(1)" in tab.run("document.getElementById('panel').textContent")
