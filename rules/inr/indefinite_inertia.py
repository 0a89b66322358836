from collections.abc import Iterator

from sdfcheck import IN_LINK, REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns


class IndefiniteInertia(Rule):
    """An inertia tensor is not positive definite, so the body would gain energy from turning.

    libsdformat refuses the model, Drake and MuJoCo too. Common causes are a sign lost on
    the way from a CAD program, and products of inertia that are larger than the moments.
    """

    code = "INR002"
    name = "indefinite-inertia"
    severity = Severity.ERROR
    explains = (problems.IndefiniteInertia,)
    affects = {
        Consumer.GAZEBO: REFUSES,
        Consumer.DRAKE: warns("takes a solid sphere in its place"),
        Consumer.MUJOCO: REFUSES,
    }
    scaffold = IN_LINK

    bad = (
        Bad(
            "<inertial><mass>1</mass><inertia><ixx>«-0.1»</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>",
            says="ixx -0.1 is negative",
        ),
        Bad(
            "<inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz><ixy>«0.5»</ixy>"
            "</inertia></inertial>",
            says="ixy 0.5 is too large beside ixx and iyy",
        ),
        Bad(
            "<inertial><mass>1</mass><«inertia»><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz><ixy>0.09</ixy>"
            "<ixz>0.09</ixz><iyz>-0.09</iyz></inertia></inertial>",
            says="smallest principal moment is -0.08",
        ),
    )
    good = (
        Good(
            "<inertial><mass>1</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz><ixy>-0.01</ixy>"
            "</inertia></inertial>",
            why="products may be negative",
        ),
    )

    def check(self, problem: problems.IndefiniteInertia) -> Iterator[Diagnostic]:
        labels = {problem.link: "the inertia of this link"}
        if problem.value is not None:
            name = problem.value.attribute or problem.value.element.name
            reason = "negative" if problem.value.number < 0 and name[1] == name[2] else _too_large(name)
            message = f"{name} {problem.value.text} is {reason}: the inertia is not positive definite"
            yield self.diagnostic(problem.value, message, labels=labels)
            return
        message = (
            f"the inertia is not positive definite: its smallest principal moment is {problem.smallest:.6g}"
        )
        yield self.diagnostic(problem.inertia, message, labels=labels)


def _too_large(name: str) -> str:
    return f"too large beside {name[0]}{name[1] * 2} and {name[0]}{name[2] * 2}"
