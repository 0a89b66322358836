from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Consumer, Diagnostic, Good, Name, Reaction, Root, Rule, Severity, accepts
from sdfcheck_rules.nam.taken import is_free

LEFT_OUT = (
    '<robot name="r"><link name="a"><inertial><mass value="1"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="b"/>'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    '<gazebo><joint name="j" type="fixed"><parent>world</parent><child>a</child></joint></gazebo></robot>'
)

UNAWARE = (Consumer.DRAKE, Consumer.URDFDOM, Consumer.MUJOCO)
"""The consumers that do not read `<gazebo>` blocks."""


class DuplicateName(Rule):
    """Two siblings of one kind have the same name.

    Nothing can tell them apart: libsdformat refuses the document, and of two joints or
    links only the first would ever be found. Names are unique in their model or world;
    another model may use them again.
    """

    code = "NAM001"
    name = "duplicate-name"
    severity = Severity.ERROR
    remedy = """Rename one of them and the references that mean it, or remove one of two that are alike.

    Editors with the language server of sdfcheck rename both at once. For two copies of a part use a prefix
    in a macro of xacro, or a nested model for each, which has a scope of its own.
    """
    looks_at = (Root,)
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
        Good(
            LEFT_OUT, why="libsdformat leaves the joint out with its child, which has no mass", scaffold="{}"
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(
            first.kind == later.kind and not is_free(first, later, root) for first, later in root.names.shared
        )

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for first, later in root.names.shared:
            if first.kind != later.kind or is_free(first, later, root):
                continue
            where = "the file" if later.parent.name == "sdf" else later.parent.title
            yield self.diagnostic(
                later.value,
                f"there is another {later.kind} `{later.name}` in {where}",
                labels={first.value: "the first one"},
                affects=_affects(later),
            )


def _affects(later: Name) -> dict[Consumer, Reaction]:
    if later.is_extension:
        return dict.fromkeys(UNAWARE, accepts("does not read it"))
    return {} if later.kind == "link" else {Consumer.MUJOCO: accepts("takes both")}
