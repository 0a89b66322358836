from collections.abc import Iterator

from sdfcheck import IN_COLLISION, IN_LINK, Bad, Diagnostic, Element, Good, Root, Rule, Severity


class MissingShape(Rule):
    """A geometry has no shape, or a visual or collision no geometry.

    libsdformat makes an empty geometry of it and says nothing: nothing is seen and nothing is
    touched.
    """

    code = "SCH016"
    name = "missing-shape"
    severity = Severity.ERROR
    remedy = """Give it a geometry with a shape, or `<empty/>` if nothing is to be seen or touched.

    The shape is one of box, capsule, cone, cylinder, ellipsoid, sphere, plane, mesh, heightmap and
    polyline. A collision that is not wanted can be removed.
    """
    looks_at = (Root,)
    scaffold = IN_COLLISION

    bad = (
        Bad("<«geometry»/>", says="`geometry` has no shape"),
        Bad('<«collision» name="c"/>', scaffold=IN_LINK, says="collision `c` has no `geometry`"),
    )
    good = (
        Good("<geometry><empty/></geometry>", why="empty on purpose"),
        Good('<geometry><p:torus xmlns:p="https://example.org/p"/></geometry>', why="a shape of one's own"),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(True for _ in without_shape(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for element in without_shape(root):
            what = "shape" if element.name == "geometry" else "`geometry`"
            cause = root.part_of(element).misnamed("geometry")
            yield self.diagnostic(element, f"{element.title} has no {what}", cause=cause)


def without_shape(root: Root) -> Iterator[Element]:
    """Geometries without shape; visuals and collisions of links without geometry. URDF has rules of its own."""
    if root.is_urdf:
        return
    geometries = root.elements.get("geometry", ())
    shaped = {geometry.parent for geometry in geometries}
    for kind in ("visual", "collision"):
        for element in root.elements.get(kind, ()):
            if element not in shaped and is_of_link(element):
                yield element
    for geometry in geometries:
        is_empty = next(geometry.children(), None) is None
        # In a sonar it is the name of a shape.
        if is_empty and geometry.parent is not None and geometry.parent.name != "sonar":
            yield geometry


def is_of_link(element: Element) -> bool:
    """Elsewhere a collision is a reference, which holds its name; up to 1.11 states go by the names of parts, too."""
    if element.parent is None or element.parent.name != "link":
        return False
    return not any(ancestor.name == "state" for ancestor in element.around)
