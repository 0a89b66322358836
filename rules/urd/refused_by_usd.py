from collections.abc import Iterator

from sdfcheck import (
    Bad,
    Diagnostic,
    Element,
    Good,
    PrefixDeclaration,
    Root,
    Rule,
    Severity,
    Value,
    named,
    used,
)

OF_SHAPE = frozenset(("geometry", "material", "origin"))
ROBOT = '<robot name="r" xmlns:p="https://example.org/p"><link name="base">{}</link></robot>'
SHAPE = '<geometry><sphere radius="1"/></geometry>'


class RefusedByUsd(Rule):
    """An attribute has a name that there cannot be in USD, for which Isaac Sim's converter refuses the file.

    It keeps the attributes that URDF does not know: those of the robot, of links, shapes and materials, and all that
    is in elements of others, `<gazebo>` among them. A name in USD is letters, digits and `_`, so that one with a
    prefix, a hyphen or a dot is refused, and nothing is converted. In joints, geometries and origins it ignores them.
    An `xmlns="…"` of the robot is refused as well: in a namespace the converter finds no element `robot`.
    """

    code = "URD033"
    name = "refused-by-usd"
    severity = Severity.WARNING
    remedy = """Leave the attribute out of the file that is given to the converter.

    A `gz:expressed_in` in `<gazebo>` is for Gazebo alone: an argument of xacro can leave out the blocks for it.
    """
    default = False
    looks_at = (PrefixDeclaration, Root)
    scaffold = ROBOT
    sources = ("https://github.com/newton-physics/urdf-usd-converter",)

    bad = (
        Bad(
            '<robot name="r" xmlns:gz="http://gazebosim.org/schema"><link name="base"/><gazebo reference="base">'
            '<fdir1 «gz:expressed_in»="base">1 0 0</fdir1></gazebo></robot>',
            scaffold="",
            says="attribute `gz:expressed_in` has a name that USD refuses, and its converter the file",
        ),
        Bad(
            f'<visual «p:lod»="1">{SHAPE}</visual><visual p:lod="1">{SHAPE}</visual>',
            says="attribute `p:lod` (used 2 times) has a name that USD refuses",
        ),
        Bad('<p:note «a-b»="1"/>', says="attribute `a-b` has a name"),
        Bad(
            '<robot name="r" «xmlns»="https://example.org/p"><link name="base"/></robot>',
            scaffold="",
            says="`xmlns` puts the robot into a namespace, where the converter to USD does not find it",
        ),
    )
    good = (
        Good(f'<visual group="2">{SHAPE}</visual>', why="a name that USD takes"),
        Good('<visual><geometry><sphere p:lod="1" radius="1"/></geometry></visual>', why="not kept"),
    )

    @staticmethod
    def applies(found: PrefixDeclaration | Root) -> bool:
        if isinstance(found, Root):
            return found.is_urdf and any(unfit_names(found))
        is_default = found.name == "xmlns" and found.is_on_root and bool(found.namespace)
        return is_default and found.document.kind.value == "urdf"

    def check(self, found: PrefixDeclaration | Root) -> Iterator[Diagnostic]:
        if isinstance(found, PrefixDeclaration):
            says = "`xmlns` puts the robot into a namespace, where the converter to USD does not find it"
            yield self.diagnostic(found, says)
            return
        names = list(unfit_names(found))
        distinct = dict.fromkeys(value.attribute or "" for value in names)
        which = f"attribute {named(distinct, most=3)}{used(len(names))}"
        message = f"{which} has a name that USD refuses, and its converter the file"
        yield self.diagnostic(names[0].name_span, message)


def unfit_names(root: Root) -> Iterator[Value]:
    """The attributes that the converter keeps, and that have a name which USD refuses."""
    for element in kept(root.document.root):
        for name in element.attributes:
            value = None if name.isidentifier() else element.attribute(name)
            if value is not None:
                yield value


def kept(robot: Element | None) -> Iterator[Element]:
    """The elements of which the converter keeps the attributes that it does not know."""
    if robot is None:
        return
    yield robot
    for child in robot.children():
        if child.name == "link":
            yield child
            for part in child.children():
                if part.name in {"collision", "visual"}:
                    yield part
                    yield from others(part, OF_SHAPE)
            yield from others(child, frozenset(("collision", "inertial", "visual")))
        elif child.name == "material":
            yield child
    yield from others(robot, frozenset(("joint", "link", "material")))


def others(parent: Element, known: frozenset[str]) -> Iterator[Element]:
    """The children that the converter does not know, and what is in them."""
    for child in parent.children():
        if child.name not in known:
            yield child
            yield from child.below
