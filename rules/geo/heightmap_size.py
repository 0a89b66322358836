from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Link, Rule, Severity, Shape

GROUND = (
    '<{0} name="{0}"><geometry><heightmap><uri>{1}</uri><size>10 10 1</size></heightmap></geometry></{0}>'
)


def picture(width: int, height: int) -> str:
    """A gray picture as text, in the format PGM."""
    return f"P2 {width} {height} 255\n" + "0 " * width * height


class HeightmapSize(Rule):
    """The picture of a heightmap has a size of which Gazebo makes no ground.

    It has to be square, with 2ⁿ + 1 pixels on each side: 129, 257, 513, 1025. Gazebo Classic ends with an exception
    otherwise. Of the new Gazebo's renderers Ogre 2 takes 2ⁿ as well, and both show nothing for any other size.
    """

    code = "GEO022"
    name = "heightmap-size"
    severity = Severity.WARNING
    remedy = """Change the picture to 2ⁿ + 1 pixels on each side.

    With ImageMagick: `magick ground.png -resize '513x513!' ground_513.png`. The `size` of the heightmap says how many
    meters it covers, so a picture that is not square is scaled to a square one, and `size` keeps its proportions.
    """
    looks_at = (Link,)
    needs = ("<heightmap",)
    scaffold = IN_LINK

    bad = (
        Bad(
            GROUND.format("collision", "«g.pgm»") + GROUND.format("visual", "g.pgm"),
            files={"g.pgm": picture(10, 10)},
            says="the picture `g.pgm` has 10 x 10 pixels; Gazebo makes ground of 17 x 17",
        ),
        Bad(
            GROUND.format("collision", "«g.pgm»"),
            files={"g.pgm": picture(17, 9)},
            says="makes ground of 17 x 17",
        ),
    )
    good = (
        Good(GROUND.format("collision", "g.pgm"), files={"g.pgm": picture(17, 17)}),
        Good(GROUND.format("collision", "g.pgm"), files={"g.pgm": picture(16, 16)}, why="Ogre 2 takes 2ⁿ"),
        Good(GROUND.format("collision", "g.tif"), files={"g.tif": ""}, why="elevations are scaled"),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return bool(unfit(link))

    def check(self, link: Link) -> Iterator[Diagnostic]:
        for shape, (width, height) in unfit(link).values():
            side = 2 ** (max(width, height) - 2).bit_length() + 1
            name = shape.geometry.uri.rpartition("/")[2]
            yield self.diagnostic(
                shape.geometry.uri_value or shape,
                f"the picture `{name}` has {width} x {height} pixels; Gazebo makes ground of {side} x {side}",
            )


def unfit(link: Link) -> dict[str, tuple[Shape, tuple[int, int]]]:
    """Address of a picture that is not square, or has neither 2ⁿ nor 2ⁿ + 1 pixels → its first shape, its size."""
    found: dict[str, tuple[Shape, tuple[int, int]]] = {}
    for shape in (*link.collisions, *link.visuals):
        pixels = shape.geometry.pixels
        if pixels is not None and not fits(*pixels):
            found.setdefault(shape.geometry.uri, (shape, pixels))
    return found


def fits(width: int, height: int) -> bool:
    """Can Gazebo make ground of a picture of this size?"""
    return width == height and width > 2 and any((width - more).bit_count() == 1 for more in (0, 1))
