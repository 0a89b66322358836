from collections.abc import Iterator

from sdfcheck import (
    IN_WORLD,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Good,
    Include,
    Missing,
    MissingKind,
    Obstacle,
    Rule,
    Severity,
    warns,
)

EMPTY = "remove the element, or give it a value"
CURES: dict[Obstacle | None, str] = {
    Obstacle.POINTER: "fetch the file with `git lfs pull`",
    Obstacle.XACRO: "expand it with `sdfcheck expand`",
}
SETTINGS = ("name", "static", "placement_frame")
ARM = {"arm.sdf": '<sdf version="1.12"><model name="arm"><link name="l"/></model></sdf>'}


class UnusableInclude(Rule):
    """An include leads to a file that holds nothing to include, or cannot be carried out.

    The file has to be SDFormat with a model, actor or light at its top, or a URDF. A
    world cannot be included, and a xacro file has to be expanded first. libsdformat
    refuses the including document; an empty `<name>`, `<static>` or `<placement_frame>`
    ends its process. A pointer of Git LFS is a warning: another copy may have the file.
    """

    code = "RES012"
    name = "unusable-include"
    severity = Severity.ERROR
    remedy = """Include a file that holds one model, light or actor, and is SDFormat or URDF.

    Expand a xacro file first (`sdfcheck expand arm.urdf.xacro -o arm.urdf`). To use the models of a world,
    move each of them to a file of its own. A mesh is named by the `<mesh>` of a visual, not by an include.
    An empty `<name>` is best removed.
    """
    looks_at = (Include,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            "<include><uri>«yard.sdf»</uri></include>",
            files={"yard.sdf": '<sdf version="1.12"><world name="yard"/></sdf>'},
            says="a world cannot be included",
        ),
        Bad(
            "<include><uri>«none.sdf»</uri></include>",
            files={"none.sdf": '<sdf version="1.12"/>'},
            says="holds no model, actor or light",
        ),
        Bad(
            "<include><uri>«arm.dae»</uri></include>",
            files={"arm.dae": "<COLLADA/>"},
            says="its root element is `COLLADA`",
        ),
        Bad(
            "<include><uri>«notes.txt»</uri></include>",
            files={"notes.txt": "not for everybody"},
            says="`notes.txt` is neither SDFormat nor URDF",
        ),
        Bad(
            "<include><uri>«arm.sdf»</uri></include>",
            files={"arm.sdf": "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 84\n"},
            says="only a pointer of Git LFS to `arm.sdf` is here",
        ),
        Bad(
            "<include><uri>«arm.urdf»</uri></include>",
            files={"arm.urdf": '<robot name="r"><xacro:leg/></robot>'},
            says="has to be expanded",
        ),
        Bad(
            "<include><uri>arm.sdf</uri><«name»/></include>",
            files=ARM,
            says="`name` of this include is empty",
        ),
    )
    good = (
        Good("<include><uri>arm.sdf</uri><name>left</name></include>", files=ARM),
        Good(
            "<include><uri>arm.sdf</uri></include>",
            files={"arm.sdf": '<gazebo version="1.2"><model name="arm"><link name="l"/></model></gazebo>'},
            why="missing-root reports the file itself",
        ),
        Good(
            "<include><uri>arm.urdf</uri></include>",
            files={"arm.urdf": '<robot name="r"><link name="l"/></robot>'},
        ),
    )

    @staticmethod
    def applies(include: Include) -> bool:
        return include.is_read_in_vain or any(True for _ in empty_settings(include))

    def check(self, include: Include) -> Iterator[Diagnostic]:
        for setting in empty_settings(include):
            yield self.diagnostic(setting, f"`{setting.name}` of this include is empty", help=EMPTY)
        if include.is_read_in_vain and include.uri_value is not None:
            is_pointer = include.obstacle is Obstacle.POINTER
            is_foreign = is_pointer or include.obstacle is Obstacle.FOREIGN
            yield self.diagnostic(
                include.uri_value,
                self.reason(include),
                severity=Severity.WARNING if is_pointer else self.severity,
                affects={Consumer.DRAKE: warns("loads nothing in its place")} if is_foreign else {},
                help=CURES.get(include.obstacle),
                missing=Missing(MissingKind.LFS, include.uri) if is_pointer else None,
            )

    def reason(self, include: Include) -> str:
        file, document = include.found.file, include.found.document
        name = f"`{file.name}`" if file is not None else "it"
        root = document.root if document is not None else None
        if include.obstacle is Obstacle.XACRO:
            return f"{name} is xacro, which has to be expanded before it can be included"
        if include.obstacle is Obstacle.POINTER:
            return f"only a pointer of Git LFS to {name} is here"
        if include.obstacle is Obstacle.FOREIGN:
            element = f": its root element is `{root.name}`" if root is not None else ""
            return f"{name} is neither SDFormat nor URDF{element}"
        if root is None:
            return f"{name} cannot be read"
        if root.has("world"):
            return f"{name} holds no model but a world, and a world cannot be included"
        return f"{name} holds no model, actor or light"


def empty_settings(include: Include) -> Iterator[Element]:
    """Settings that libsdformat does not survive."""
    return (setting for name in SETTINGS for setting in include.children(name) if not setting.content)
