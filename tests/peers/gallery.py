"""The pictures of docs/gallery.md: robots with a mistake, as sdfcheck shows them in Chromium.

``python -m tests.peers.gallery`` (``make gallery``) draws them anew; ``"NAME=FILE ARG:=VALUE"`` adds one of others.
"""

from __future__ import annotations

import struct
import sys
from collections.abc import Callable, Sequence
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from sdfcheck.cli.main import main
from tests.peers import chromium
from tests.peers.editor import editor

ROOT = Path(__file__).parents[2]
PICTURES = ROOT / "docs" / "gallery"
ROBOTS = ROOT / "fixtures" / "robots"
ARM, ROVER = ROBOTS / "desk_arm" / "desk_arm.urdf", ROBOTS / "diff_drive" / "model.sdf"
LINKS = ROBOTS / "two_link_arm" / "model.sdf"
WIDTH, HEIGHT = 1000, 560


class Picture(NamedTuple):
    """A robot with a mistake: how to make the command that shows it, and what to click on the page."""

    name: str
    command: Callable[[Path], list[str]]
    clicks: Sequence[str] = ()


def wrong_inertia(folder: Path) -> list[str]:
    """Moments of the forearm in kg·dm²."""
    moments = ("0.0001333", "0.01333"), ("0.0017333", "0.17333")
    return ["view", str(changed(ARM, folder, *moments))]


def swapped_axis(folder: Path) -> list[str]:
    """A wheel that turns about the vertical."""
    text = ROVER.read_text(encoding="utf-8")
    at = text.index("<xyz>0 0 1</xyz>", text.index('name="right_wheel_joint"'))
    file = folder / "model.sdf"
    file.write_text(text[:at] + text[at:].replace("0 0 1", "0 1 0", 1), encoding="utf-8")
    return ["view", str(file)]


def mesh_in_millimeters(folder: Path) -> list[str]:
    """A mesh in mm, without a scale."""
    (folder / "upper_arm.stl").write_bytes(block(300, 60, 60))
    shape = '<box size="0.3 0.06 0.06"/>'
    return ["view", str(changed(ARM, folder, (shape, '<mesh filename="upper_arm.stl"/>')))]


def lost_collision(folder: Path) -> list[str]:
    """A collision that URDF cannot say."""
    text = LINKS.read_text(encoding="utf-8").replace('version="1.6"', 'version="1.12"')
    at = text.index("<cylinder>", text.index('<link name="fore">'))
    end = text.index("</cylinder>", at) + len("</cylinder>")
    file = folder / "arm.sdf"
    cone = "<cone><radius>0.06</radius><length>0.24</length></cone>"
    file.write_text(text[:at] + cone + text[end:], encoding="utf-8")
    return ["convert", "sdf-to-urdf", str(file), "-o", str(folder / "arm.urdf")]


def beside_its_text(folder: Path) -> list[str]:
    """A robot that follows its text, with a mistake in the mass of the forearm."""
    text = ARM.read_text(encoding="utf-8")
    at = text.index('<mass value="', text.index('<link name="forearm"')) + len('<mass value="')
    file = folder / ARM.name
    file.write_text(f"{text[:at]}-{text[at:]}", encoding="utf-8")
    return [FOLLOWED, str(file)]


def as_it_is(folder: Path) -> list[str]:
    """A robot without a mistake."""
    return ["view", str(ARM)]


FOLLOWED = "server"
"""In place of a command: the page is that of the language server."""
GALLERY = (
    Picture("wrong-inertia", wrong_inertia, ("#tree [data-part=forearm]", "button:text-is('Fit')")),
    Picture("swapped-axis", swapped_axis, ("#show-axes", "#tree [data-part=right_wheel]")),
    Picture("mesh-in-millimeters", mesh_in_millimeters, ("#tree [data-part=upper_arm]",)),
    Picture("lost-collision", lost_collision),
    Picture("inspector", as_it_is, ("#tree [data-part=forearm]",)),
    Picture("beside", beside_its_text, ("#tree [data-part=forearm]",)),
)


def changed(robot: Path, folder: Path, *changes: tuple[str, str]) -> Path:
    """A copy of a robot with another text here and there."""
    text = robot.read_text(encoding="utf-8")
    for before, after in changes:
        if before not in text:
            raise ValueError(f"{robot} does not contain {before!r}")
        text = text.replace(before, after)
    file = folder / robot.name
    file.write_text(text, encoding="utf-8")
    return file


def block(x: float, y: float, z: float) -> bytes:
    """A box around the origin as binary STL."""
    faces = []
    for axis, side in product(range(3), (-1, 1)):
        one, two = (axis + 1) % 3, (axis + 2) % 3
        corners = []
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))[::side]:
            corner = [0.0, 0.0, 0.0]
            corner[axis], corner[one], corner[two] = side, a, b
            corners.append([at * size / 2 for at, size in zip(corner, (x, y, z), strict=True)])
        faces += [(corners[0], corners[1], corners[2]), (corners[0], corners[2], corners[3])]
    triangles = (
        struct.pack("<12f", 0, 0, 0, *(at for corner in face for at in corner)) + b"\0\0" for face in faces
    )
    return bytes(80) + struct.pack("<I", len(faces)) + b"".join(triangles)


def draw(tab: chromium.Tab, picture: Picture) -> bytes:
    """The picture as PNG."""
    with TemporaryDirectory() as made:
        folder = Path(made)
        command = picture.command(folder)
        if command[0] == FOLLOWED:
            with editor(folder) as session:
                file = Path(command[1])
                session.open(file, file.read_text(encoding="utf-8"))
                tab.server = session.command("sdfcheck.showRobot", file, open=False)
                tab.page.goto(tab.server)
                drawn = _drawn(tab, picture)
                tab.page.goto("about:blank")
                return drawn
        page = folder / "page.html"
        output = "--report" if command[0] == "convert" else "-o"
        if main([*command, output, str(page), "--isolated"]) != 0:
            raise RuntimeError(f"{picture.name}: the command fails")
        tab.open(page)
        return _drawn(tab, picture)


def _drawn(tab: chromium.Tab, picture: Picture) -> bytes:
    """The page that is open, after the clicks."""
    tab.page.wait_for_selector("html[data-ready]")
    for selector in picture.clicks:
        if tab.page.locator(selector).count():
            tab.page.locator(selector).first.click()
    tab.page.wait_for_timeout(500)
    return bytes(tab.page.screenshot())


def of_others(named: str) -> Picture:
    """The picture of ``NAME=FILE``, which arguments of xacro may follow."""
    name, _, words = named.partition("=")
    return Picture(name, lambda folder: ["view", *words.split()])


def write(pictures: Sequence[Picture]) -> None:
    """Draws the pictures."""
    PICTURES.mkdir(exist_ok=True)
    with chromium.tab(width=WIDTH, height=HEIGHT) as tab:
        for picture in pictures:
            data = draw(tab, picture)
            (PICTURES / f"{picture.name}.png").write_bytes(data)
            print(f"{picture.name}: {len(data) / 1000:.0f} kB")


if __name__ == "__main__":
    write([of_others(named) for named in sys.argv[1:]] or GALLERY)
