from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    Bad,
    Diagnostic,
    Fix,
    Good,
    Rule,
    Severity,
    TextEdit,
    lacking,
    make_fix,
    named,
    problems,
    used,
)


class UnknownUrdfAttribute(Rule):
    """An attribute that no consumer of URDF looks for is given.

    All of them ignore it in silence and take the default of what was meant, if there
    is one. Attributes with a prefix are free. Where the misspelling leaves something out that is
    required, this is an error.
    """

    code = "URD002"
    name = "unknown-urdf-attribute"
    severity = Severity.WARNING
    remedy = """Write the attribute as URDF knows it, remove it, or give it a prefix.

    `sdfcheck describe urdf:joint/limit` and the like list the attributes. Notes belong in comments.
    """
    explains = (problems.UnknownUrdfAttribute,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            '<visual><origin «xzy»="0 0 1"/><geometry><sphere radius="1"/></geometry></visual>',
            fixed='<visual><origin xyz="0 0 1"/><geometry><sphere radius="1"/></geometry></visual>',
            unsafe=True,
            says="unknown attribute `xzy` of `origin`; did you mean `xyz`?",
        ),
        Bad(
            '<visual><geometry><sphere «raduis»="1"/></geometry></visual>',
            fixed='<visual><geometry><sphere radius="1"/></geometry></visual>',
            unsafe=True,
            says="did you mean `radius`?",
        ),
        Bad('<visual><geometry «lod»="1"><sphere radius="1"/></geometry></visual>'),
        Bad(
            '<visual><geometry «lod»="1" part="2"><sphere radius="1"/></geometry></visual>',
            says="unknown attributes `lod` and `part` of `geometry`",
        ),
    )
    good = (
        Good(
            '<visual p:lod="1"><geometry><sphere radius="1"/></geometry></visual>',
            why="a prefix makes it free",
        ),
        Good(
            '<collision group="feet"><geometry><sphere radius="1"/></geometry></collision>',
            why="PyBullet reads it",
        ),
    )

    def check(self, problem: problems.UnknownUrdfAttribute) -> Iterator[Diagnostic]:
        value, near = problem.value, problem.suggestion
        names = [value.attribute or "", *(other.attribute or "" for other in problem.others)]
        noun = "attributes" if problem.others else "attribute"
        message = f"unknown {noun} {named(names)} of {value.element.title}"
        if problem.more > len(problem.others):
            message += f", and {problem.more - len(problem.others)} more"
        if near is not None:
            message += f"; did you mean `{near}`?"
        severity = Severity.ERROR if problem.needed else None
        is_axis = (value.element.name, near) == ("axis", "xyz")
        affects = lacking(value.element, near or "") if problem.needed or is_axis else {}
        yield self.diagnostic(
            value.name_span,
            message + used(len(problem.uses)),
            severity=severity,
            fix=rename(problem),
            affects=affects,
            repeats=[use.name_span for use in problem.uses[1:]],
        )


def rename(problem: problems.UnknownUrdfAttribute) -> Fix | None:
    near = problem.suggestion
    # Somewhere else both may be given.
    if near is None or any(near in use.element.attributes for use in problem.uses):
        return None
    return make_fix(
        f"rename it to `{near}`", tuple(TextEdit(use.name_span, near) for use in problem.uses), unsafe=True
    )
