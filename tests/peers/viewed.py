"""Robots as `sdfcheck view` shows them, in Chromium."""

from __future__ import annotations

from pathlib import Path

from sdfcheck.cli.main import main
from tests.peers import chromium


def show(tab: chromium.Tab, tmp_path: Path, *arguments: str | Path) -> None:
    """Makes the page of a robot and opens it."""
    out = tmp_path / "out.html"
    assert main(["view", *map(str, arguments), "-o", str(out), "--isolated"]) == 0
    tab.open(out)
    tab.page.wait_for_selector("html[data-ready]", timeout=60_000)


def panel(tab: chromium.Tab) -> str:
    return str(tab.run("document.getElementById('panel').textContent"))


def sdf(tmp_path: Path, *parts: str) -> Path:
    """A file with one model."""
    file = tmp_path / "model.sdf"
    file.write_text(f'<sdf version="1.12"><model name="m">{"".join(parts)}</model></sdf>')
    return file


def with_meshes(tmp_path: Path, *uris: str) -> Path:
    """A file with a link for each mesh."""
    visual = (
        "<link name='l{}'><visual name='v'><geometry><mesh><uri>{}</uri></mesh></geometry></visual></link>"
    )
    return sdf(tmp_path, *(visual.format(number, uri) for number, uri in enumerate(uris)))
