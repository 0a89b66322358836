from collections.abc import Iterator

from sdfcheck import IN_COLLISION, IN_URDF_LINK, Bad, Diagnostic, Good, Rule, Severity, problems, recurring

POLYLINE = "<polyline><height>1</height><point>0 0</point><point>0 1</point><point>1 1</point></polyline>"


class SeveralShapes(Rule):
    """A geometry has more than one shape.

    libsdformat takes one of them, not the first in the file but the first in an order of its
    own (box, capsule, cone, cylinder, ellipsoid, plane, sphere, mesh, heightmap, polyline),
    and drops the others in silence. MuJoCo refuses a URDF collision with two shapes of one kind.
    """

    code = "SCH020"
    name = "several-shapes"
    severity = Severity.ERROR
    remedy = """Give each shape a visual or collision of its own.

    A link may have any number of both; names differ, and each has its own `<pose>`.
    """
    explains = (problems.SeveralShapes,)
    scaffold = IN_COLLISION

    bad = (
        Bad(
            "<geometry><«sphere»><radius>1</radius></sphere><box><size>1 1 1</size></box></geometry>",
            says="`sphere` is dropped, because the geometry has a `box`",
        ),
        Bad(
            '<visual><geometry><box size="1 1 1"/><«sphere» radius="1"/></geometry></visual>',
            scaffold=IN_URDF_LINK,
            says="`sphere` is dropped, because the geometry has a `box`",
        ),
        Bad(
            '<collision><geometry><box size="1 1 1"/><«box» size="2 1 1"/></geometry></collision>',
            scaffold=IN_URDF_LINK,
            says="`box` is dropped, because the geometry has a `box`",
        ),
    )
    good = (
        Good(f"<geometry>{POLYLINE}{POLYLINE}</geometry>", why="polylines make one shape together"),
        Good('<visual><geometry><box size="1 1 1"/></geometry></visual>', scaffold=IN_URDF_LINK),
    )

    def check(self, problem: problems.SeveralShapes) -> Iterator[Diagnostic]:
        element, first = problem.element, problem.first
        yield self.diagnostic(
            element,
            f"`{element.name}` is dropped, because the geometry has a `{first.name}`",
            labels={first: "the shape that is taken"},
            affects=recurring(element) if element.name == first.name else {},
        )
