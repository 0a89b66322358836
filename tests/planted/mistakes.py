"""Mistakes that people make: each function finds the places in a page where it can be made."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

from sdfcheck.formats.plugins import known
from sdfcheck.source.document import Element, Value
from sdfcheck.source.sniff import Kind
from tests.planted.page import Change, Page, around, is_number, literal, words, write
from tests.planted.typing_errors import TYPING_ERRORS, misspelled

Mistake = Callable[[Page], Iterator[Change]]

TYPED = {"joint", "light"}


NEEDED = {
    *(("joint", "parent"), ("joint", "child"), ("collision", "geometry"), ("visual", "geometry")),
    *(("inertia", "ixx"), ("cylinder", "radius"), ("sphere", "radius"), ("box", "size"), ("mesh", "uri")),
    *(("plugin", "filename"), ("include", "uri")),
}  # fmt: skip
REFERENCES = {"parent", "child", "mimic", "attached_to", "relative_to", "expressed_in"}


def wrong_version(page: Page) -> Iterator[Change]:
    for each in page.named("sdf"):
        if version := each.attribute("version"):
            yield write(version, f"{version.text}5")


def misspelled_type(page: Page) -> Iterator[Change]:
    for each in page.named(*TYPED):
        if literal(kind := each.attribute("type")) and kind is not None:
            yield write(kind, misspelled(kind.text))


def flag_in_words(page: Page) -> Iterator[Change]:
    for each in page.known:
        if not each.nodes and each.content in {"true", "false"} and page.is_robot:
            yield write(each.own_value, "yes" if each.content == "true" else "no")


def unknown_reference(page: Page) -> Iterator[Change]:
    for value in _references(page):
        if value.text != "world":
            yield write(value, f"{value.text}_x")


def doubled_name(page: Page) -> Iterator[Change]:
    for kind in ("link", "joint", "model"):
        for each in page.named(kind) if page.is_robot else ():
            other, own = each.next(kind), each.attribute("name")
            name = None if other is None else other.attribute("name")
            if own is not None and name is not None and name.text != own.text:
                yield write(name, own.text)


def ring_of_joints(page: Page) -> Iterator[Change]:
    """The parent of a joint is the link below its child: either of the two joints may be the wrong one."""
    if not page.is_robot:
        return
    joints = [(each, _end(each, "parent"), _end(each, "child")) for each in page.named("joint")]
    below = {p.text: c.text for _, p, c in joints if p is not None and c is not None}
    for _, parent, child in joints:
        if parent is not None and child is not None and (target := below.get(child.text)):
            yield write(parent, target)._replace(at=child.span.start)


def swapped_limits(page: Page) -> Iterator[Change]:
    for each in page.named("limit"):
        if _type_of_joint(each) not in {"revolute", "prismatic"}:
            continue
        lower, upper = each.value("lower"), each.value("upper")
        if lower is not None and upper is not None and lower.number < upper.number < 1e15:
            first, second = sorted((lower.span, upper.span), key=lambda span: span.start)
            edits = ((first.start, first.end, second.text), (second.start, second.end, first.text))
            yield Change(edits, lower.span.start)


def negative_mass(page: Page) -> Iterator[Change]:
    for each in _of_moving_models(page, "mass"):
        value = each.attribute("value") or each.own_value
        if value.number > 0:
            yield write(value, f"-{value.text.strip()}")


def impossible_inertia(page: Page) -> Iterator[Change]:
    """One moment is far above the sum of the others."""
    for each in _of_moving_models(page, "inertia"):
        x, y, z = each.value("ixx"), each.value("iyy"), each.value("izz")
        if x is None or y is None or z is None or each.parent is None or not _mass(each.parent) > 0:
            continue
        if min(x.number, y.number, z.number) > 1e-5:
            yield write(x, f"{4 * (y.number + z.number):.6g}")


def degrees(page: Page) -> Iterator[Change]:
    """The angles of a pose in degrees, where the format has radians."""
    for each in page.named("pose", "origin"):
        value = each.attribute("rpy") if each.name == "origin" else each.own_value
        if value is None or not literal(value) or {"degrees", "rotation_format"} & each.attributes.keys():
            continue
        parts = words(value)[-3:]
        if len(words(value)) in {3, 6} and all(is_number(text) for _, _, text in parts):
            turned = [round(math.degrees(float(text))) for _, _, text in parts]
            if any(abs(angle) > 29 for angle in turned):
                yield Change(((parts[0][0], parts[-1][1], " ".join(map(str, turned))),), parts[0][0])


def missing_child(page: Page) -> Iterator[Change]:
    for each in page.all if page.is_robot else ():
        parent = each.parent
        is_needed = parent is not None and (parent.name, each.name) in NEEDED
        if is_needed and parent is not None and len(list(parent.children(each.name))) == 1:
            place = page.place(each)
            yield Change(((place.start, place.close_end, ""),), parent.span.start)


def missing_attribute(page: Page) -> Iterator[Change]:
    for each in page.known if page.is_robot else ():
        wanted = {"name", "type"} if each.name in {"joint", "sensor"} else {"name"}
        if each.name in {"link", "joint", "sensor", "model", "world"}:
            for name in wanted.intersection(each.attributes):
                span = page.document.spans.attribute_whole(each, name)
                yield Change(((span.start, span.end, ""),), each.span.start)


def empty_name(page: Page) -> Iterator[Change]:
    for each in page.named("link", "joint", "model", "sensor"):
        if page.is_robot and (name := each.attribute("name")) and name.text:
            yield write(name, "")


def zero_axis(page: Page) -> Iterator[Change]:
    for each in page.named("axis"):
        moves = _type_of_joint(each) in {"revolute", "continuous", "prismatic"}
        if moves and (xyz := each.value("xyz")) and literal(xyz).strip("0 "):
            yield write(xyz, "0 0 0")


def missing_mesh(page: Page) -> Iterator[Change]:
    for each in page.named("mesh"):
        if page.is_robot and (uri := each.value("filename") or each.value("uri")) is not None:
            head, slash, name = uri.text.strip().rpartition("/")
            if "." in name:
                yield write(uri, f"{head}{slash}x_{name}")


def wrong_extension_reference(page: Page) -> Iterator[Change]:
    for each in page.all:
        if page.is_robot and each.name == "gazebo" and (value := each.attribute("reference")):
            yield write(value, f"{value.text}_x")


def undefined_material(page: Page) -> Iterator[Change]:
    for each in page.named("material"):
        if page.document.kind is Kind.URDF and not each.nodes and (name := each.attribute("name")):
            yield write(name, f"{name.text}_x")


def wrong_name_in_plugin(page: Page) -> Iterator[Change]:
    """Of plugins of Gazebo, the parameters of which are known."""
    names = {each.get("name", str) for each in page.named("joint", "link")}
    for each in page.all if page.is_robot else ():
        plugin = each.parent
        if plugin is None or plugin.name != "plugin" or each.content not in names or each.nodes:
            continue
        if each.name in {one.path for facts in known(plugin.get("filename") or "") for one in facts.namings}:
            yield write(each.own_value, f"{each.content}_x")


MISTAKES: tuple[Mistake, ...] = (
    *(wrong_version, misspelled_type, flag_in_words, unknown_reference, doubled_name, ring_of_joints),
    *(swapped_limits, negative_mass, impossible_inertia, degrees, missing_child, missing_attribute),
    *(empty_name, zero_axis, missing_mesh, wrong_extension_reference, undefined_material),
    *(wrong_name_in_plugin, *TYPING_ERRORS),
)


def _end(joint: Element, name: str) -> Value | None:
    found = joint.find(name)
    if found is None:
        return None
    value = found.attribute("link") or found.own_value
    return value if literal(value) else None


def _type_of_joint(part: Element) -> str:
    """The type of the joint that an axis or limit is of; empty where it is of none."""
    joint = next((each for each in around(part) if each.name == "joint"), None)
    return "" if joint is None else joint.attributes.get("type", "")


def _mass(inertial: Element) -> float:
    mass = inertial.find("mass")
    return math.nan if mass is None else (mass.attribute("value") or mass.own_value).number


def _of_moving_models(page: Page, name: str) -> Iterator[Element]:
    static = {each.parent for each in page.named("static") if each.content in {"1", "true"}}
    return (each for each in page.named(name) if static.isdisjoint(each.around))


def _references(page: Page) -> Iterator[Value]:
    for each in page.known if page.is_robot else ():
        if each.name in REFERENCES and each.parent is not None and each.parent.name in {"joint", "axis"}:
            value = each.attribute("link") or each.attribute("joint") or each.own_value
            if literal(value):
                yield value
        found = [each.attribute(name) for name in REFERENCES.intersection(each.attributes)]
        yield from (value for value in found if value is not None and literal(value))
