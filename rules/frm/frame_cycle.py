from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Root, Rule, Severity

_SHOWN = 6


class FrameCycle(Rule):
    """Frames are attached to, or placed relative to, each other in a ring.

    None of them leads to a link or to the model's own frame, so where they are and what
    they move with is undefined. A joint counts too: it is placed at its child. libsdformat
    refuses the file with one error for every member of the ring; here it is one for the ring.
    """

    code = "FRM002"
    name = "frame-cycle"
    severity = Severity.ERROR
    remedy = """Let one member of the ring refer to a link outside of it, or to nothing.

    A frame without `attached_to`, and a pose without `relative_to`, belong to the frame of the model, which
    ends each ring. Of the members, take the one whose place is known best: mostly the base link, or the
    link that was there before the frames were added. Joints count as members, because each is placed at its
    child: a link that is placed relative to its own joint needs the joint to be placed relative to the
    parent.
    """
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad('<frame name="a" attached_to="«a»"/>', says="`a` is attached to itself"),
        Bad('<link name="arm"><pose relative_to="«arm»"/></link>', says="`arm` is placed relative to itself"),
        Bad(
            '<frame name="a" attached_to="«b»"/><frame name="b" attached_to="c"/>'
            '<frame name="c" attached_to="a"/>',
            says="attached to each other in a ring: `a` → `b` → `c` → `a`",
        ),
        Bad(
            '<link name="arm"><pose relative_to="«elbow»">0 0 1 0 0 0</pose></link>'
            '<joint name="elbow" type="fixed"><parent>base</parent><child>arm</child></joint>',
            says="placed relative to each other in a ring: `arm` → `elbow` → `arm`",
        ),
        Bad(
            '<link name="arm"/><joint name="elbow" type="fixed"><pose relative_to="«elbow»">0 0 1 0 0 0</pose>'
            "<parent>base</parent><child>arm</child></joint>",
            says="`elbow` is placed relative to itself",
        ),
        Bad(
            '<model name="n"><pose relative_to="«n::l»"/><link name="l"/></model>',
            says="`n` is placed relative to itself",
        ),
    )
    good = (
        Good(
            '<frame name="a" attached_to="b"/><frame name="b" attached_to="base"/>',
            why="frames may be defined in any order",
        ),
        Good(
            '<link name="arm"/><joint name="elbow" type="fixed"><pose relative_to="base"/>'
            "<parent>base</parent><child>arm</child></joint>"
            '<frame name="f"><pose relative_to="elbow"/></frame>'
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(root.rings)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for ring in root.rings:
            first, *others = ring.members
            names = ring.names
            tied = "attached to" if ring.role == "attached_to" else "placed relative to"
            if not others:
                yield self.diagnostic(first, f"`{names[0]}` is {tied} itself", cause=ring.cause)
                continue
            shown = [f"`{name}`" for name in names[:_SHOWN]]
            more = ["…"] if len(names) > _SHOWN else []
            way = " → ".join((*shown, *more, f"`{names[0]}`"))
            message = f"{len(names)} frames are {tied} each other in a ring: {way}"
            labels = {
                value: f"leads on from `{name}`"
                for value, name in zip(others[: _SHOWN - 1], names[1:], strict=False)
            }
            yield self.diagnostic(first, message, labels=labels, cause=ring.cause)
