from collections.abc import Iterator

from sdfcheck import IN_JOINT, IN_LINK, Bad, Diagnostic, Good, Rule, Severity, named, problems, used


class RemovedElement(Rule):
    """An element or attribute is no longer part of the version that the file declares.

    Consumers convert the elements of older versions on loading, but only in files that declare
    the older version. Under a newer one the element is unknown, and ignored: gravity inside
    physics, the frame of a sensor, an axis' `use_parent_model_frame`.
    """

    code = "SCH008"
    name = "removed-element"
    severity = Severity.WARNING
    remedy = """Write its successor, or declare the version that the file was written in.

    `sdfcheck convert sdf-to-sdf` translates a file of an older version as a whole: declare the version that
    the file was written in first, then convert.
    """
    explains = (problems.RemovedElement,)
    scaffold = IN_JOINT.replace("1.12", "1.7")

    bad = (
        Bad(
            "<axis><xyz>0 0 1</xyz><«use_parent_model_frame»>true</use_parent_model_frame></axis>",
            says="went out of the format after version 1.6; use `axis/xyz/@expressed_in`",
        ),
        Bad(
            '<pose «frame»="m">0 0 1 0 0 0</pose>',
            scaffold=IN_LINK.replace("1.12", "1.7"),
            says="`frame` of `pose` went out",
        ),
    )
    good = (
        Good(
            '<sdf version="1.6"><model name="m"><link name="base"/><link name="arm">'
            '<pose frame="base">0 0 1 0 0 0</pose></link></model></sdf>',
            why="consumers turn it into relative_to",
            scaffold="",
        ),
        Good("<axis><xyz>0 0 1</xyz></axis>"),
    )

    def check(self, problem: problems.RemovedElement) -> Iterator[Diagnostic]:
        element, attribute = problem.element, problem.attribute
        what, target = f"`{element.name}` in {problem.parent.title}", element.span
        if attribute is not None:
            what = f"`{attribute}` of {element.title}"
            target = element.document.spans.attribute_name(element, attribute)
        times = used(1 + len(problem.others))
        message = f"{what}{times} went out of the format after version {problem.until}"
        if problem.successor is not None:
            message += f"; use {named(problem.successor.split(', '))}"
        yield self.diagnostic(target, message)
