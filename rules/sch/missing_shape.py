from collections.abc import Iterator

from sdfcheck import IN_COLLISION, IN_LINK, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns


class MissingShape(Rule):
    """A geometry has no shape, or a visual or collision no geometry.

    libsdformat makes an empty geometry of it and says nothing: nothing is seen and
    nothing is touched. If that is what is wanted, `<empty/>` says so.
    """

    code = "SCH016"
    name = "missing-shape"
    severity = Severity.ERROR
    affects = {
        Consumer.GAZEBO: warns("shows and collides with nothing"),
        Consumer.DRAKE: warns("leaves it out"),
    }
    explains = (problems.MissingShape,)
    scaffold = IN_COLLISION

    bad = (
        Bad("<«geometry»/>", says="`geometry` has no shape"),
        Bad('<«collision» name="c"/>', scaffold=IN_LINK, says="collision `c` has no `geometry`"),
    )
    good = (
        Good("<geometry><empty/></geometry>", why="empty on purpose"),
        Good(
            '<geometry><p:torus xmlns:p="https://example.org/p"/></geometry>',
            why="a shape of one's own",
        ),
    )

    def check(self, problem: problems.MissingShape) -> Iterator[Diagnostic]:
        element = problem.element
        what = "shape" if element.name == "geometry" else "`geometry`"
        yield self.diagnostic(element, f"{element.title} has no {what}")
