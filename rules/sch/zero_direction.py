from collections.abc import Iterator

from sdfcheck import IN_COLLISION, IN_WORLD, Bad, Diagnostic, Good, Root, Rule, Severity, Value

PLANE = "<geometry><plane><normal>{}</normal><size>1 1</size></plane></geometry>"


class ZeroDirection(Rule):
    """The normal of a plane or the direction of a light has no length.

    `0 0 0` points nowhere: what simulators make of it is up to their mathematics.
    """

    code = "SCH022"
    name = "zero-direction"
    severity = Severity.WARNING
    remedy = """Write a direction: `0 0 1` for a floor, `0 0 -1` for a light from above.

    Its length does not matter, as long as it is not 0.
    """
    looks_at = (Root,)
    needs = ("<normal", "<direction")
    scaffold = IN_COLLISION

    bad = (
        Bad(PLANE.format("«0 0 0»"), says="`normal` has no length"),
        Bad(
            '<light name="sun" type="directional"><direction>«0 0 0.0»</direction></light>',
            scaffold=IN_WORLD,
            says="`direction` has no length",
        ),
    )
    good = (
        Good(PLANE.format("0 0 5"), why="of any length"),
        Good(
            '<light name="lamp" type="point"><direction>0 0 0</direction></light>',
            scaffold=IN_WORLD,
            why="shines everywhere",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(True for _ in zero_directions(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for value in zero_directions(root):
            yield self.diagnostic(value, f"`{value.element.name}` has no length")


def zero_directions(root: Root) -> Iterator[Value]:
    """The directions that are written as zero; a point light needs none."""
    for element in (*root.elements.get("normal", ()), *root.elements.get("direction", ())):
        holder = element.parent
        if holder is None or holder.name not in {"plane", "light"}:
            continue
        if holder.name == "light" and holder.text_of("type", "point").strip() == "point":
            continue
        words = element.content.split()
        if len(words) == 3 and all(word.strip("0.+-") == "" and "0" in word for word in words):
            yield element.own_value
