from collections.abc import Iterator

from sdfcheck import IN_MODEL, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, accepts, problems


class DuplicateName(Rule):
    """Two siblings of one kind have the same name.

    Nothing can tell them apart: libsdformat refuses the document, and of two joints or
    links only the first would ever be found. Names are unique in their model or world;
    another model may use them again.
    """

    code = "NAM001"
    name = "duplicate-name"
    severity = Severity.ERROR
    affects = dict.fromkeys(Consumer, REFUSES)
    explains = (problems.DuplicateName,)
    scaffold = IN_MODEL

    bad = (
        Bad('<link name="«base»"/>', says="there is another link `base` in model `m`"),
        Bad(
            '<world name="w"><include><uri>https://fuel.gazebosim.org/1.0/openrobotics/models/a</uri><name>a</name></include>'
            "<include><uri>https://fuel.gazebosim.org/1.0/openrobotics/models/b</uri><name>«a»</name></include></world>",
            scaffold='<sdf version="1.12">{}</sdf>',
            says="there is another model `a` in world `w`",
        ),
        Bad('<world name="a"/><world name="«a»"/>', scaffold='<sdf version="1.12">{}</sdf>'),
    )
    good = (
        Good('<model name="n"><link name="base"/></model>', why="another model is another scope"),
        Good(
            '<plugin name="p" filename="a"/><plugin name="p" filename="b"/>',
            why="the names of plugins are free",
        ),
    )

    def check(self, problem: problems.DuplicateName) -> Iterator[Diagnostic]:
        where = "the file" if problem.parent.name == "sdf" else problem.parent.title
        yield self.diagnostic(
            problem.value,
            f"there is another {problem.kind} `{problem.name}` in {where}",
            labels={problem.first: "the first one"},
            affects={} if problem.kind == "link" else {Consumer.MUJOCO: accepts("takes both")},
        )
