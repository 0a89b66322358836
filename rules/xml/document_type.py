from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, accepts, named, problems


class DocumentType(Rule):
    """The file has a document type declaration.

    Neither SDFormat nor URDF has one. Drake and MuJoCo skip it, and so does libsdformat in SDFormat; in URDF
    urdfdom before version 4, and libsdformat with it, refuses the file if it declares entities. These are
    not known: a reference to one of them stays in the text as it is written.
    sdfcheck does the same; it expands no entity and loads no file that one names.
    """

    code = "XML007"
    name = "document-type"
    severity = Severity.WARNING
    remedy = """Remove the declaration, and write out the text of its entities.

    Values that are used often are properties of xacro, or an `<include>` in SDFormat.
    """
    explains = (problems.DocumentType,)

    bad = (
        Bad(
            '«<!DOCTYPE» sdf SYSTEM "sdf.dtd">\n<sdf version="1.12"><world name="w"/></sdf>',
            says="simulators ignore",
        ),
        Bad(
            '«<!DOCTYPE» robot [<!ENTITY pi "3.14">]>\n<robot name="r"><link name="base&pi;"/></robot>',
            says="its entity `pi` stays unresolved",
        ),
    )
    good = (Good('<sdf version="1.12"><!-- <!DOCTYPE sdf> --><world name="w"/></sdf>', why="a comment"),)

    def check(self, problem: problems.DocumentType) -> Iterator[Diagnostic]:
        message = "a document type, which simulators ignore"
        if len(problem.entities) == 1:
            message += f"; its entity `{problem.entities[0]}` stays unresolved"
        elif problem.entities:
            message += f"; its entities {named(problem.entities, most=3)} stay unresolved"
        affects = {} if problem.entities else dict.fromkeys(Consumer, accepts("ignores it"))
        yield self.diagnostic(problem.span, message, affects=affects)
