from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Document,
    Element,
    Good,
    Inertial,
    Reaction,
    Root,
    Rule,
    Severity,
    accepts,
    problems,
)

INERTIAL = (
    '<sdf version="1.12"><model name="m"><link name="base"><inertial>{}</inertial></link></model></sdf>'
)
IMAGE = (
    '<sdf version="1.12"><model name="m"><link name="base"><sensor name="s" type="camera">'
    "<camera>{}</camera></sensor></link></model></sdf>"
)
# After a number, these do not change what it was meant to be.
TRAILERS = ".,;:\"'`+-)]"


class MisreadValue(Rule):
    """A value is accepted and read as something else than is written.

    libsdformat takes the longest number from the front of a text and forgets the rest: a
    decimal comma cuts the fraction off, a unit is not looked at, and of two numbers one counts.
    A value also ends at a comment. Values that are read as intended anyway (a comma or other
    sign after a number, a hexadecimal number) get a warning, and so does the fraction of a whole number.
    """

    code = "SCH012"
    name = "misread-value"
    severity = Severity.ERROR
    remedy = """Write one plain number: with a decimal point, without unit, and with no comment in it.

    The units are fixed: meters, kilograms, seconds, radians. Convert the number and drop the unit; put a
    comment before or after the element.
    """
    explains = (problems.MisreadValue, problems.CutText)
    scaffold = INERTIAL

    bad = (
        Bad("<mass>«1,5»</mass>", says="`1,5` is read as 1"),
        Bad("<mass>«1.5kg»</mass>", says="`1.5kg` is read as 1.5"),
        Bad("<mass>1 «2»</mass>", says="`mass` is read as 1: a second number is ignored"),
        Bad("<mass>«true»</mass>", says="`true` is read as 1"),
        Bad("<pose>0 0 1 0 0 «90deg»</pose>", scaffold=IN_LINK, says="`90deg` is read as 90"),
        Bad("<pose>0 0 1 <!-- rpy --> «0 0 0»</pose>", scaffold=IN_LINK, says="`pose` ends at the comment"),
        Bad("<visibility_mask>«-1»</visibility_mask>", scaffold=IMAGE, says="`-1` is read as 4294967295"),
        Bad(
            "<visibility_mask>«7.5»</visibility_mask>",
            scaffold=IMAGE,
            says="`7.5` is read as 7: `visibility_mask` is a whole number",
        ),
        Bad("<mass>«1.5.»</mass>", says="`1.5.` is read as 1.5"),
        Bad(
            "<mass>1</mass><inertia><ixx>«1,5»</ixx><iyy>3</iyy><izz>1.6</izz></inertia>",
            says="`1,5` is read as 1",
        ),
    )
    good = (
        Good("<mass>1.5 <!-- kg --></mass>", why="nothing is after the comment"),
        Good("<mass>1e-3</mass>"),
        Good(
            "<image><width>320.0</width><height>240</height></image>",
            why="read as it is meant",
            scaffold=IMAGE,
        ),
        Good(
            "<image><width>220.00000000000003</width><height>240</height></image>",
            why="a computed whole number",
            scaffold=IMAGE,
        ),
    )

    def check(self, problem: problems.MisreadValue | problems.CutText) -> Iterator[Diagnostic]:
        name = problem.value.attribute or problem.value.element.name
        if isinstance(problem, problems.CutText):
            message = f"`{name}` ends at the comment: what follows it is not read"
            words = len(problem.value.element.content.split())
            is_short = name == "pose" and words not in (0, 6, 7)
            affects = dict.fromkeys((Consumer.GAZEBO, Consumer.DRAKE), REFUSES) if is_short else {}
            yield self.diagnostic(problem.rest, message, affects=affects)
            return
        reading, part = problem.reading, problem.span.text
        affects = dict.fromkeys(Consumer, REFUSES) if reading.refused else spoiled(problem)
        cause = reading.cause.name if reading.cause else ""
        if cause == "EXTRA":
            is_repeated = all(is_same(word, reading.read_as) for word in part.split())
            yield self.diagnostic(
                problem.span,
                f"`{name}` is read as {reading.read_as}: a second number is ignored",
                severity=Severity.WARNING if is_repeated else None,
                affects=affects,
            )
            return
        as_meant = cause == "HEXADECIMAL" or is_same(part.rstrip(TRAILERS), reading.read_as)
        if as_meant and not affects:
            affects = dict.fromkeys((Consumer.GAZEBO, Consumer.DRAKE), accepts("reads what was meant"))
        message = f"`{part}` is read as {reading.read_as}"
        is_fraction = cause == "FRACTION"
        yield self.diagnostic(
            problem.span,
            message + f": `{name}` is a whole number" * is_fraction,
            severity=Severity.WARNING if as_meant or is_fraction else None,
            affects=affects,
        )


def bodies(document: Document) -> dict[Element, Inertial]:
    """Element with a mass or with moments → the body that it is about."""
    found = {}
    for each in document.view(Root).each(Inertial):
        found[each.element] = each
        if each.inertia is not None:
            found[each.inertia] = each
    return found


def spoiled(problem: problems.MisreadValue) -> dict[Consumer, Reaction]:
    """The reaction of libsdformat to a mass or moments of SDFormat that are impossible as it reads them."""
    element = problem.value.element
    around = element.parent
    if around is None or around.name not in {"inertial", "inertia"}:
        return {}
    body = element.document.view(bodies).get(around)
    is_refused = body is not None and (
        body.mass < 0 or body.tensor.is_indefinite or body.tensor.is_impossible
    )
    return {Consumer.GAZEBO: REFUSES} if is_refused else {}


def is_same(written: str, read: str) -> bool:
    """Whether two texts are the same text or number, such as `.5` and `0.5`."""
    try:
        return written == read or float(written) == float(read)
    except ValueError:
        return False
