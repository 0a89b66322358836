from collections.abc import Iterator

from sdfcheck import (
    IN_MODEL,
    IN_ROBOT,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Joint,
    Model,
    Reaction,
    Rule,
    Severity,
    TextEdit,
    Value,
    accepts,
    make_fix,
    refuses,
)

_ARM = '<link name="arm"/>'
TIP = (
    '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="tip"/>'
    '<joint name="j" type="fixed"><parent link="«hand»"/><child link="tip"/></joint></robot>'
)


class UnknownJointEnd(Rule):
    """The parent or child of a joint names nothing that its model has.

    libsdformat, Drake and urdfdom refuse the file; libsdformat overlooks the parents of joints in
    nested models. In SDFormat a joint may end at a link, frame, joint or nested model
    of its own model, and by `A::b` at what is in nested models. Nothing reaches outwards,
    but `world` can be a parent everywhere; in URDF only Drake knows it, and a robot that is made
    for it gets a warning. So does a xacro file that a robot of the same name in another file
    could hold, as one of its parts.
    """

    code = "JNT001"
    name = "unknown-joint-end"
    severity = Severity.ERROR
    remedy = """Name a link of this model as the end of the joint, as it is spelled there.

    In SDFormat a frame, a joint or a nested model can be named too, and `arm::hand` for a link in a nested
    model; `world` can be the parent. Links around the model cannot be reached: write the joint into the
    outer model instead. In URDF a link `world` has to be there for a joint to name it.
    """
    looks_at = (Joint,)
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
            says="`arm` differs in case only",
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
        Bad(
            '<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="arm"><collision><geometry>'
            '<sphere radius="1"/></geometry><drake:proximity_properties/></collision></link>'
            '<joint name="j" type="fixed"><parent link="«world»"/><child link="arm"/></joint></robot>',
            scaffold="{}",
            says="parent `world` of joint `j` does not exist",
        ),
        Bad(
            TIP,
            scaffold="{}",
            file="tip.xacro",
            files={"arm.urdf.xacro": '<robot name="r"><link name="hand"/></robot>'},
            says="parent `hand` of joint `j` does not exist",
        ),
    )
    good = (
        Good(
            '<joint name="j" type="fixed"><parent>base</parent></joint>', why="missing-element owns this one"
        ),
        Good('<joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>'),
        Good(
            '<frame name="f"/><link name="arm"/>'
            '<joint name="j" type="fixed"><parent>f</parent><child>arm</child></joint>',
            why="a joint may end at a frame",
        ),
        Good(
            "<include><uri>model://not_here</uri><name>n</name></include>"
            '<joint name="j" type="fixed"><parent>base</parent><child>n::l</child></joint>',
            why="an include that could not be read may have it",
        ),
        Good(
            '<link name="arm"/><joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint>',
            scaffold=IN_ROBOT,
        ),
        Good(
            '<robot name="r"><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>',
            scaffold="{}",
            file="arm.urdf",
            why="missing-element reports a robot without links",
        ),
    )

    @staticmethod
    def applies(joint: Joint) -> bool:
        # A robot without links is an error of its own.
        return bool(_unknown_ends(joint)) and not (
            joint.is_urdf and joint.model is not None and not joint.model.links
        )

    def check(self, joint: Joint) -> Iterator[Diagnostic]:
        for value, others in _unknown_ends(joint):
            if value.text == joint.name and not joint.is_urdf:
                yield self.diagnostic(value, f"{joint.title} names itself as its {value.element.name}")
            else:
                yield self._unknown(joint, value, others)

    def _unknown(self, joint: Joint, value: Value, others: list[Value]) -> Diagnostic:
        name = value.text.strip()
        message = f"{value.element.name} `{name}` of {joint.title}"
        is_urdf = joint.is_urdf
        but = (joint.parent_name, joint.child_name, *(() if is_urdf else (joint.name,)))
        meant, outside = joint.scope.guess(value.text, but=but, kind="link" if is_urdf else "")
        if outside is not None:
            labels = {outside: f"`{name}` is defined here"}
            message += " is outside, out of reach"
            return self.diagnostic(value, message, labels=labels, affects=_affects(joint, value))
        message, cause = f"{message} does not exist", joint.scope.fault_of(value.text)
        if others:
            message += f" (named {1 + len(others)} times)"
        if meant is None:
            return self._absent(joint, value, message)._replace(
                cause=cause, repeats=tuple(end.span for end in others)
            )
        is_deeper = meant.endswith(f"::{name}")
        message += f"; in a nested model there is `{meant}`" if is_deeper else ""
        edits = tuple(TextEdit(end.span, meant) for end in (value, *others))
        fix = make_fix(f"write `{meant}`", edits, unsafe=True)
        question = None if is_deeper else meant
        affects = _affects(joint, value)
        return self.diagnostic(
            value, message, meant=question, fix=fix, affects=affects, cause=cause, repeats=others
        )

    def _absent(self, joint: Joint, value: Value, message: str) -> Diagnostic:
        affects, advice, is_meant = _affects(joint, value), None, False
        if value.text.strip() == "world":
            advice = "only Drake takes `world` for granted, others want a link of that name"
            affects[Consumer.DRAKE] = accepts("takes it for granted")
        elif joint.is_in_namesake(value.text.strip()):
            advice, is_meant = (
                f"another file of robot `{joint.scope.name}` has it: include this one there",
                True,
            )
        severity = Severity.WARNING if is_meant else None
        return self.diagnostic(value, message, help=advice, severity=severity, affects=affects)


def _affects(joint: Joint, end: Value) -> dict[Consumer, Reaction]:
    """libsdformat overlooks parents in nested models, and the joint cannot be made."""
    is_nested = joint.model is not None and isinstance(joint.model.holder, Model)
    is_overlooked = not joint.is_urdf and end.element.name == "parent" and is_nested
    return {Consumer.GAZEBO: refuses("refuses to make the joint")} if is_overlooked else {}


def _unknown_ends(joint: Joint) -> list[tuple[Value, list[Value]]]:
    """The ends that name nothing, with those of other joints of that name; each name once, where it is first."""
    if joint.parent is not None and joint.child is not None:
        return []
    parent, child = joint.parent_value, joint.child_value
    unknown = [parent] if parent is not None and joint.parent is None else []
    unknown += [child] if child is not None and joint.child is None else []
    if not unknown:
        return []
    scope = joint.scope
    found: list[tuple[Value, list[Value]]] = []
    for value in unknown:
        ends = scope.unresolved.get(value.text)
        if ends is None or value.text in scope.lost_names or (joint.is_urdf and not value.text.strip()):
            continue
        if not joint.is_urdf:
            if value.text == joint.name:
                found.append((value, []))
                continue
            ends = [end for end in ends if _joint_name(end) != value.text]
        if ends[0].element is value.element:
            found.append((value, ends[1:]))
    return found


def _joint_name(end: Value) -> str:
    """The name of the joint of which it is an end."""
    joint = end.element.parent
    return "" if joint is None else joint.attributes.get("name", "").strip()
