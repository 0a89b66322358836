from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Edit,
    Good,
    Rule,
    Severity,
    accepts,
    make_fix,
    problems,
)

_ARM = '<link name="arm"/>'


class UnknownJointEnd(Rule):
    """The parent or child of a joint names nothing that its model has.

    libsdformat, Drake and urdfdom refuse the file; libsdformat overlooks the parents of joints in
    nested models. In SDFormat a joint may end at a link, frame, joint or nested model
    of its own model, and by `A::b` at what is in nested models. Nothing reaches outwards,
    but `world` can be a parent everywhere; in URDF only Drake knows it.
    """

    code = "JNT001"
    name = "unknown-joint-end"
    severity = Severity.ERROR
    affects = dict.fromkeys(Consumer, REFUSES)
    explains = (problems.UnknownJointEnd,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            f'{_ARM}<joint name="j" type="fixed"><parent>«bsae»</parent><child>arm</child></joint>',
            fixed=f'{_ARM}<joint name="j" type="fixed"><parent>base</parent><child>arm</child></joint>',
            unsafe=True,
            says="parent `bsae` of joint `j` does not exist; did you mean `base`?",
        ),
        Bad(
            f'{_ARM}<joint name="j" type="fixed"><parent>base</parent><child>«Arm»</child></joint>',
            fixed=f'{_ARM}<joint name="j" type="fixed"><parent>base</parent><child>arm</child></joint>',
            unsafe=True,
            says="did you mean `arm`?",
        ),
        Bad(
            '<joint name="j" type="fixed"><parent>base</parent><child>«j»</child></joint>',
            says="joint `j` names itself as its child",
        ),
        Bad(
            '<model name="n"><link name="l"/>'
            '<joint name="j" type="fixed"><parent>«base»</parent><child>l</child></joint></model>',
            says="parent `base` of joint `j` is outside, out of reach",
        ),
        Bad(
            '<model name="n"><link name="l"/></model>'
            '<joint name="j" type="fixed"><parent>base</parent><child>«l»</child></joint>',
            fixed='<model name="n"><link name="l"/></model>'
            '<joint name="j" type="fixed"><parent>base</parent><child>n::l</child></joint>',
            unsafe=True,
            says="in a nested model there is `n::l`",
        ),
        Bad(
            '<joint name="j" type="fixed"><parent link="base"/><child link="«arm»"/></joint>',
            scaffold=IN_ROBOT,
            says="child `arm` of joint `j` does not exist",
        ),
    )
    good = (
        Good('<joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>'),
        Good(
            '<frame name="f"/><link name="arm"/>'
            '<joint name="j" type="fixed"><parent>f</parent><child>arm</child></joint>',
            why="a joint may end at a frame",
        ),
        Good(
            "<include><uri>model://not_here</uri><name>n</name></include>"
            '<joint name="j" type="fixed"><parent>base</parent><child>n::l</child></joint>',
            why="what could not be read may hold it",
        ),
    )

    def check(self, problem: problems.UnknownJointEnd) -> Iterator[Diagnostic]:
        value, joint, meant = problem.value, problem.joint, problem.suggestion
        name = value.text.strip()
        if name == joint.attributes.get("name", "").strip() and joint.document.root is not joint.parent:
            yield self.diagnostic(value, f"{joint.title} names itself as its {problem.role}")
            return
        message = f"{problem.role} `{name}` of {joint.title}"
        if problem.outside is not None:
            labels = {problem.outside: f"`{name}` is defined here"}
            yield self.diagnostic(value, f"{message} is outside, out of reach", labels=labels)
            return
        message += " does not exist"
        if problem.others:
            message += f" (named {1 + len(problem.others)} times)"
        if meant is None:
            advice = "only Drake takes `world` for granted, others want a link of that name"
            known = {Consumer.DRAKE: accepts("takes it for granted")} if name == "world" else {}
            yield self.diagnostic(value, message, help=advice if known else None, affects=known)
            return
        is_deeper = meant.endswith(f"::{name}")
        message += f"; in a nested model there is `{meant}`" if is_deeper else f"; did you mean `{meant}`?"
        edits = tuple(Edit(end.span, meant) for end in (value, *problem.others))
        yield self.diagnostic(value, message, fix=make_fix(f"write `{meant}`", edits, unsafe=True))
