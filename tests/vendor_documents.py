"""Documents made from a vendor's table: each tag in each of its places, right and in each wrong use."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from sdfcheck.formats.vendor import BUILT_IN
from sdfcheck.formats.vendor.definitions import Place, Slot, Step, Tag, Vendor
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.formats.vendor.values import out_of_range
from tests import vendor_rules as rules
from tests.vendor_surroundings import BOX, PARTS, TOPS

FILES = {
    "dummy.png": "not looked into",
    "dummy.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
    "dummy.vtk": (
        "# vtk DataFile Version 3.0\none tetrahedron\nASCII\nDATASET UNSTRUCTURED_GRID\n"
        "POINTS 4 double\n0 0 0\n1 0 0\n0 1 0\n0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
    ),
}
"""The files that the documents refer to."""

WRONG = {
    "double": "low",
    "vector3": "1 2",
    "bool": "off",
    "truth": "off",
    "word": "nonsense",
    "name": "nowhere",
}
RANGED = ("-1", "0", "1e9", "-1 0 0", "0 0 0", "inf", "-inf")


class Case(NamedTuple):
    """A document, what it is made for, and the code of the rule that reports it (empty: none)."""

    name: str
    dialect: str
    text: str
    code: str


def cases() -> list[Case]:
    """Every case of the built-in tables."""
    return [
        case
        for path in BUILT_IN.values()
        for dialect in ("sdf", "urdf")
        for case in _Maker(vendor(path, dialect), dialect).all()
    ]


class _Maker:
    def __init__(self, table: Vendor, dialect: str) -> None:
        self.table = table
        self.dialect = dialect
        self.is_sdf = dialect == "sdf"

    def all(self) -> Iterator[Case]:
        for tag in self.table.tags.values():
            if tag.keys.text("gone"):
                continue
            if not tag.places:
                text = self.around((_step(self.top),), f"<{tag.name}/>")
                yield self.case(tag, "of the other format", rules.MISPLACED, text)
            for place in tag.places:
                yield from self.uses(tag, place)

    def uses(self, tag: Tag, place: Place) -> Iterator[Case]:
        where = place.text.replace("/", ".")
        if tag.keys.text("mirror"):
            return  # given by examples
        right = self.element(tag, place)
        yield self.case(tag, where, "", self.in_place(place, right))
        misspelt = right.replace(f"{tag.name}=", f"{tag.name}qq=", 1)
        misspelt = misspelt.replace(f"<{tag.name}", f"<{tag.name}qq", 1)
        misspelt = misspelt.replace(f"</{tag.name}>", f"</{tag.name}qq>")
        yield self.case(tag, f"{where} misspelled", rules.UNKNOWN, self.in_place(place, misspelt))
        elsewhere = "link" if len(place.path) == 1 else ""
        if place.carrier != "attribute":
            path = (*((_step(elsewhere),) if elsewhere else ()), _step(self.top))
            yield self.case(tag, f"{where} misplaced", rules.MISPLACED, self.around(path, right))
            if place.single:
                yield self.case(tag, f"{where} twice", rules.REPEATED, self.in_place(place, right + right))
        yield from self.contents(tag, place, where)

    def contents(self, tag: Tag, place: Place, where: str) -> Iterator[Case]:
        """Wrong values, and what is needed left out."""
        if place.slot is not None:
            yield from self.values(tag, place, place.slot, place.carrier)
        for sigil, slots in (("@", tag.attributes), ("/", tag.parts)):
            for name, slot in slots.items():
                if place.path[0].values and name == "type":
                    continue
                yield from self.values(tag, place, slot, sigil + name)
                if slot.required:
                    text = self.element(tag, place, {sigil + name: None})
                    yield self.case(
                        tag, f"{where} without {name}", rules.MISSING_VALUE, self.in_place(place, text)
                    )
        for child in self.needed(tag):
            text = self.element(tag, place, {child.name: None})
            yield self.case(
                tag, f"{where} without {child.name}", rules.MISSING_CHILD, self.in_place(place, text)
            )

    def values(self, tag: Tag, place: Place, slot: Slot, carrier: str) -> Iterator[Case]:
        where = f"{place.text.replace('/', '.')} {carrier}"
        if tag.name == "drake:joint" and carrier == "@type":
            yield self.wrong(
                tag, place, carrier, "nonsense", f"{where} nonsense", rules.UNKNOWN_TYPE_OF_JOINT
            )
            return
        if slot.type in WRONG:
            code = rules.UNKNOWN_REFERENCE if slot.type == "name" else rules.MALFORMED
            if slot.type != "name" or slot.references:
                yield self.wrong(tag, place, carrier, WRONG[slot.type], f"{where} nonsense", code)
        if slot.plain is not None:
            yield self.wrong(tag, place, carrier, "x::y", f"{where} scoped", rules.SCOPED_DEFINITION)
        if not tag.keys.text("range-with"):
            count = 3 if slot.type == "vector3" else 1
            for text in RANGED:
                finite = "inf" not in text or self.table.is_lenient
                if (
                    finite
                    and len(text.split()) == count
                    and slot.type in {"double", "vector3"}
                    and out_of_range(slot, text)
                ):
                    yield self.wrong(tag, place, carrier, text, f"{where} {text}", rules.OUT_OF_RANGE)
        if carrier == "@value":
            text = f"<{tag.name}>{self.value(tag, slot)}</{tag.name}>"
            yield self.case(tag, f"{where} as text", rules.MALFORMED, self.in_place(place, text))
        if carrier == "text" and slot.type in {"double", "vector3"}:
            text = f'<{tag.name} value="{self.value(tag, slot)}"/>'
            yield self.case(tag, f"{where} as attribute", rules.MALFORMED, self.in_place(place, text))

    def wrong(self, tag: Tag, place: Place, carrier: str, text: str, where: str, code: str) -> Case:
        return self.case(tag, where, code, self.in_place(place, self.element(tag, place, {carrier: text})))

    def case(self, tag: Tag, what: str, code: str, text: str) -> Case:
        return Case(f"{self.dialect} {tag.name} {what}".strip(), self.dialect, text, code)

    # One tag

    @property
    def top(self) -> str:
        return "model" if self.is_sdf else "robot"

    def needed(self, tag: Tag) -> list[Tag]:
        """The tags that must are in this one."""
        found = [
            other
            for other in self.table.tags.values()
            if any(p.needed and p.path[0].name == tag.name and not p.path[0].values for p in other.places)
        ]
        return found + [
            self.table.tags[name] for name in tag.keys.words("any")[:1] if name in self.table.tags
        ]

    def element(self, tag: Tag, place: Place, changes: dict[str, str | None] | None = None) -> str:
        """The tag with right values, but for the changes (None: left out)."""
        given = changes or {}
        if place.carrier == "attribute":
            assert place.slot is not None
            return f'{tag.name}="{given.get("attribute", self.value(tag, place.slot))}"'
        attributes, inner = "", ""
        slots = {
            f"@{name}": slot for name, slot in tag.attributes.items() if slot.required or f"@{name}" in given
        }
        slots |= {f"/{name}": slot for name, slot in tag.parts.items()}
        if place.slot is not None:
            slots[place.carrier] = place.slot
        for carrier, slot in slots.items():
            text = given.get(carrier, self.value(tag, slot, carrier))
            if text is None:
                continue
            if carrier == "text":
                inner += text
            elif carrier[0] == "@":
                attributes += f' {carrier[1:]}="{text}"'
            else:
                inner += f"<{carrier[1:]}>{text}</{carrier[1:]}>"
        if tag.name == "drake:joint":
            inner += self.joint(given)
        else:
            inner += "".join(
                self.element(child, self.place_in(child, tag))
                for child in self.needed(tag)
                if child.name not in given
            )
        return f"<{tag.name}{attributes}>{inner}</{tag.name}>" if inner else f"<{tag.name}{attributes}/>"

    def joint(self, given: dict[str, str | None], kind: str = "planar", inner: str = "") -> str:
        """The elements that a joint of Drake's own types needs."""
        if not self.is_sdf:
            ends = '<parent link="a"/><child link="b"/>'
        else:
            ends = "".join(
                f"<drake:{end}>{link}</drake:{end}>"
                for end, link in (("parent", "a"), ("child", "b"))
                if f"drake:{end}" not in given and f"<drake:{end}>" not in inner
            )
            if kind == "planar" and "<drake:damping" not in inner and "drake:damping" not in given:
                ends += "<drake:damping>0 0 0</drake:damping>"
        if kind == "curvilinear" and "drake:curves" not in inner:
            ends += f"<drake:curves>{self.element(*self.named('drake:line_segment'))}</drake:curves>"
        return ends + inner

    def named(self, name: str) -> tuple[Tag, Place]:
        tag = self.table.tags[name]
        return tag, tag.places[0]

    def place_in(self, child: Tag, parent: Tag) -> Place:
        return next(place for place in child.places if place.path[0].name == parent.name)

    def value(self, tag: Tag, slot: Slot, carrier: str = "") -> str:
        if slot.references:
            if "joint" in slot.references:
                return "k"
            if any("group" in kind for kind in slot.references):
                return "g"
            return "a" if tag.name.endswith(("A", "parent", "member")) else "b"
        if slot.choices:
            return slot.choices[0]
        if slot.type == "file":
            return "dummy.png"
        if tag.name.endswith("lower_limit"):
            return "-0.4"
        fixed = {"bool": "true", "truth": "true", "vector3": slot.default or "0 0 1", "double": "0.4"}
        return fixed.get(slot.type, "g" if carrier == "@name" else "x")

    # SearchContext it

    def in_place(self, place: Place, text: str) -> str:
        return self.around(place.path, text)

    def around(self, path: tuple[Step, ...], text: str) -> str:
        for step in path:
            text = self.wrap(step, text)
        if not text.startswith(("<sdf", "<robot")):
            for name in ("link", self.top):
                text = self.wrap(_step(name), text)
        return text

    def wrap(self, step: Step, inner: str) -> str:
        name = step.name
        if name == "drake:joint":
            kind = step.values[0] if step.values else "planar"
            return f'<drake:joint name="j" type="{kind}">{self.joint({}, kind, inner)}</drake:joint>'
        if name.startswith("drake:"):
            return self.vendor_wrap(name, inner)
        if name in TOPS:
            return TOPS[name](inner)
        if name in PARTS:
            return PARTS[name](step, inner, self.is_sdf)
        return self.plain_wrap(name, inner)

    def plain_wrap(self, name: str, inner: str) -> str:
        if inner.startswith("drake:"):
            return f'<{name} lower="-1" upper="1" effort="5" velocity="2" {inner}/>'
        head, attributes = "", ""
        if name in {"visual", "collision"}:
            attributes = f' name="{name[0]}"'
            head = "" if inner.startswith("<geometry") else BOX[self.dialect]
        elif name == "mesh":
            head, attributes = ("<uri>dummy.obj</uri>", "") if self.is_sdf else ("", ' filename="dummy.obj"')
        elif name == "transmission":
            head = '<type>SimpleTransmission</type><joint name="k"/>'
        elif name == "actuator":
            attributes = ' name="m"'
        elif name == "axis":
            head = "<xyz>0 0 1</xyz>"
        return f"<{name}{attributes}>{head}{inner}</{name}>"

    def vendor_wrap(self, name: str, inner: str) -> str:
        tag = self.table.tags[name]
        if name == "drake:proximity_properties" and "<drake:compliant_hydroelastic" in inner:
            inner += self.element(*self.named("drake:hydroelastic_modulus"))
        if name == "drake:visual":
            inner = f"<drake:geometry><drake:sphere/></drake:geometry>{inner}"
        text = self.element(tag, tag.places[0])
        for child in self.needed(tag):
            if f"<{child.name}" in inner:
                text = text.replace(self.element(child, self.place_in(child, tag)), "", 1)
        for choice in tag.keys.words("any"):
            if f"<{choice}" in inner and choice in self.table.tags:
                text = text.replace(self.element(*self.named(tag.keys.words("any")[0])), "", 1)
                break
        if text.endswith("/>"):
            return f"{text[:-2]}>{inner}</{name}>"
        end = f"</{name}>"
        return text.removesuffix(end) + inner + end


def _step(name: str) -> Step:
    return Step(name)
