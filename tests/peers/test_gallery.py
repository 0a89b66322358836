"""The pictures of the gallery show what the page shows now."""

from __future__ import annotations

import base64
from collections.abc import Iterator

import pytest

from tests.peers import chromium
from tests.peers.gallery import GALLERY, HEIGHT, PICTURES, WIDTH, Picture, draw

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(chromium.missing() is not None, reason=chromium.missing() or ""),
]
SMALL = 150_000
"""Bytes that a picture may have."""
ALIKE = 1.0
"""Of 255: the mean difference that fonts and graphics drivers may make."""

_APART = """async ([a, b]) => {
    const pixels = async (data) => {
        const image = new Image();
        image.src = `data:image/png;base64,${data}`;
        await image.decode();
        const canvas = Object.assign(document.createElement('canvas'), {width: 160, height: 90});
        const pen = canvas.getContext('2d');
        pen.drawImage(image, 0, 0, 250, 90);
        return pen.getImageData(0, 0, 160, 90).data;
    };
    const [one, two] = [await pixels(a), await pixels(b)];
    return one.reduce((sum, value, index) => sum + Math.abs(value - two[index]), 0) / one.length;
}"""
"""The mean difference of two pictures, in the part that holds the robot."""


@pytest.fixture(scope="module")
def tab() -> Iterator[chromium.Tab]:
    with chromium.tab(width=WIDTH, height=HEIGHT) as opened:
        yield opened


@pytest.mark.parametrize("picture", GALLERY, ids=lambda picture: picture.name)
def test_pictures_are_up_to_date(picture: Picture, tab: chromium.Tab) -> None:
    committed = (PICTURES / f"{picture.name}.png").read_bytes()
    assert len(committed) < SMALL
    drawn = draw(tab, picture)
    assert tab.errors == []
    tab.page.goto("about:blank")
    both = [base64.b64encode(data).decode() for data in (committed, drawn)]
    assert tab.run(_APART, both) < ALIKE, "run `make gallery`"


def test_pictures_of_other_robots_differ(tab: chromium.Tab) -> None:
    """Else the comparison would prove nothing."""
    first, second = (
        base64.b64encode((PICTURES / f"{one.name}.png").read_bytes()).decode() for one in GALLERY[:2]
    )
    tab.page.goto("about:blank")
    assert tab.run(_APART, [first, second]) > ALIKE
