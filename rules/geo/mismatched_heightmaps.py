from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Link, Rule, Severity, Value

NAMES = ("pos", "size")
GROUND = (
    '<{0} name="{0}"><geometry><heightmap><uri>https://example.org/h.png</uri><size>{1}</size><pos>{2}</pos>'
    "</heightmap></geometry></{0}>"
)


class MismatchedHeightmaps(Rule):
    """The heightmap of a collision is not where, or not as large as, that of the visual.

    Both are made of one image: robots drive above the ground that is seen, or in it.
    """

    code = "GEO014"
    name = "mismatched-heightmaps"
    severity = Severity.WARNING
    remedy = """Write the same `pos`, `size` and image in the heightmap of the visual and of the collision.

    Sizes and positions are in meters, and z of the size is the height between the darkest and the brightest
    pixel. Copy the ones of the visual if the ground looks right.
    """
    looks_at = (Link,)
    needs = ("<heightmap",)
    scaffold = IN_LINK

    bad = (
        Bad(
            GROUND.format("collision", "10 10 1", "«0 0 -311»")
            + GROUND.format("visual", "10 10 1", "0 0 -300"),
            says="`pos` of the heightmap is 0 0 -311 in the collision, and 0 0 -300 in the visual",
        ),
    )
    good = (
        Good(GROUND.format("collision", "10 10 1", "0 0 0") + GROUND.format("visual", "10 10 1", "0 0 0.0")),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return any(True for _ in pairs(link))

    def check(self, link: Link) -> Iterator[Diagnostic]:
        for name, own, other in pairs(link):
            yield self.diagnostic(
                own,
                f"`{name}` of the heightmap is {own.text.strip()} in the collision, and {other.text.strip()} in the"
                " visual",
                labels={other: "the visual"},
            )


def pairs(link: Link) -> Iterator[tuple[str, Value, Value]]:
    """The measures of a link's heightmaps of one image that differ: name, that of the collision, that of the visual."""
    seen = {
        shape.geometry.uri: shape.geometry.shape_element
        for shape in link.visuals
        if shape.geometry.shape == "heightmap"
    }
    for shape in link.collisions:
        own, other = shape.geometry.shape_element, seen.get(shape.geometry.uri)
        if own is None or other is None or shape.geometry.shape != "heightmap":
            continue
        for name in NAMES:
            first, second = own.value(name), other.value(name)
            if first is not None and second is not None and numbers(first) != numbers(second):
                yield name, first, second


def numbers(value: Value) -> list[float] | None:
    """The numbers of a text; None where it has others."""
    try:
        return [float(word) for word in value.text.split()]
    except ValueError:
        return None
