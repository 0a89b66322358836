"""SDFormat as a schema for other tools: RELAX NG and XML Schema."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf

from sdfcheck.formats.history import in_version
from sdfcheck.formats.schema import AttributeDefinition, Definition, Schema
from sdfcheck.formats.sdf.findings import REPEATABLE
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.table import Range
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.source.record import NamedTuple

# How values may be written, in the terms that schema languages share: patterns, words, bounds.
#
# They let pass what consumers take as written. Conditions that the schema languages cannot express (a
# quaternion's length, infinity only here and there) are left to the linter.

_NUMBER = r"[+\-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+\-]?[0-9]+)?"
_INFINITE = r"[+\-]?[iI][nN][fF]([iI][nN][iI][tT][yY])?"
_WHOLE = r"[+\-]?[0-9]+(\.0*)?"
_HEXADECIMAL = "0[xX][0-9a-fA-F]+"
_PATTERNS = {
    "bool": "[tT][rR][uU][eE]|[fF][aA][lL][sS][eE]|1|0",
    "char": ".",
    "double": _NUMBER,
    "float": _NUMBER,
    "int": _WHOLE,
    "unsigned int": r"\+?[0-9]+(\.0*)?",
}
_PARTS = {
    "color": (_NUMBER, "{2,3}"),
    "pose": (_NUMBER, "{5,6}"),
    "quaternion": (_NUMBER, "{2,3}"),
    "time": (_WHOLE, "{1}"),
    "vector2d": (_NUMBER, "{1}"),
    "vector2i": (_WHOLE, "{1}"),
    "vector3": (_NUMBER, "{2}"),
}
_NUMBERS = frozenset(("double", "float", "int", "unsigned int"))


class Form(NamedTuple):
    """The texts of one place: those of any of its parts."""

    patterns: tuple[str, ...] = ()
    """Regular expressions as XML Schema writes them."""
    words: tuple[str, ...] = ()
    bounds: Range | None = None
    """A number in this range."""
    empty: bool = True
    """An empty text, which means the default."""

    @property
    def is_free(self) -> bool:
        """Any text at all, though maybe none that is empty."""
        return not self.patterns and not self.words and self.bounds is None


def form(place: Definition | AttributeDefinition) -> Form:
    """The form of an element's text or an attribute's value."""
    needed = place.needs_value if isinstance(place, Definition) else place.required
    kind = place.type or "string"
    if place.place == "root:sdf/@version":
        return Form(words=(str(place.version),), empty=False)
    if place.choices is not None:
        return _words(place, needed)
    if kind in _PARTS:
        part, more = _PARTS[kind]
        return Form((_padded(rf"({part})(\s+({part})){more}"),), empty=not needed)
    if kind not in _PATTERNS:
        return Form(empty=not needed)
    others = (_HEXADECIMAL,) if kind in {"int", "unsigned int"} else ()
    if place.may_be_infinite and kind in {"double", "float"}:
        others = (_INFINITE,)
    if place.range is not None and kind in _NUMBERS:
        return Form(tuple(map(_padded, others)), bounds=place.range, empty=not needed)
    return Form(tuple(map(_padded, (_PATTERNS[kind], *others))), empty=not needed)


def _padded(pattern: str) -> str:
    """With spaces around: not all validators take them away."""
    return rf"\s*({pattern})\s*"


def _words(place: Definition | AttributeDefinition, needed: bool) -> Form:
    choices = place.choices
    assert choices is not None
    words = {*choices.listed, *choices.library, *choices.aliases, *_later(place)}
    if place.default and place.default != "__default__":
        words.add(place.default)
    listed = tuple(sorted(words - {""}))
    if choices.ignores_case:
        return Form(tuple(_padded(_any_case(word)) for word in listed), empty=not needed)
    return Form(words=listed, empty=not needed)


def _later(place: Definition | AttributeDefinition) -> tuple[str, ...]:
    """Values that newer versions list: consumers take them in older documents as well."""
    if isinstance(place, Definition):
        newer = in_version(place, NEWEST)
        return newer.choices.listed if newer is not None and newer.choices else ()
    stem, _, name = place.place.rpartition("/@")
    owner = schema(NEWEST).at(stem)
    attribute = owner.attributes.get(name) if owner is not None else None
    return attribute.choices.listed if attribute is not None and attribute.choices else ()


def _any_case(word: str) -> str:
    return "".join(f"[{letter.lower()}{letter.upper()}]" if letter.isalpha() else letter for letter in word)


def definitions(format: Schema) -> dict[str, Definition]:
    """Every kind of element of a version, under a name that is its own; sorted by that name."""
    found: dict[str, Definition] = {}
    waiting = [format.root]
    while waiting:
        definition = waiting.pop()
        key = name_of(definition)
        if key not in found:
            found[key] = definition
            waiting += definition.children.values()
    return dict(sorted(found.items()))


def name_of(definition: Definition) -> str:
    """``joint.axis.limit`` for what is at ``joint:joint/axis/limit``."""
    stem, _, path = definition.place.partition(":")
    _, *inner = path.split("/")
    required = ".required" if definition.needs_value and inner == [] else ""
    return ".".join((stem, *inner)) + required


def facets(bounds: Range) -> Iterator[tuple[str, str]]:
    """A range as the facets of XML Schema."""
    if bounds.low > -inf:
        yield ("minExclusive" if bounds.low_open else "minInclusive"), f"{bounds.low:.16g}"
    if bounds.high < inf:
        yield ("maxExclusive" if bounds.high_open else "maxInclusive"), f"{bounds.high:.16g}"


def documentation(place: Definition | AttributeDefinition) -> str:
    """Notes that a schema cannot check and an editor may show: default, unit, deprecation."""
    from sdfcheck.formats import history

    parts = []
    if place.default and place.default != "__default__":
        parts.append(f"default: {place.default}")
    if isinstance(place, Definition):
        if place.units:
            parts.append(f"unit: {place.units[0]}")
        if place.deprecated:
            successor = history.deprecation(place).successor
            parts.append("deprecated" + (f", use {successor}" if successor else ""))
    return "; ".join(parts)


def escaped(text: str) -> str:
    """A text as XML writes it."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")


# A version of SDFormat as a RELAX NG schema.
#
# Children come in any order (``interleave``), as often as they may; elements and
# attributes with a prefix are free. Elements that consumers add themselves may be missing.

_HEAD = """\
<?xml version="1.0" encoding="UTF-8"?>
<!-- SDFormat {version}, generated by sdfcheck. -->
<grammar xmlns="http://relaxng.org/ns/structure/1.0" xmlns:a="http://relaxng.org/ns/compatibility/annotations/1.0"
         datatypeLibrary="http://www.w3.org/2001/XMLSchema-datatypes">
  <start><element name="sdf"><ref name="{root}"/></element></start>
"""
_TAIL = """\
  <define name="custom-attributes">
    <zeroOrMore><attribute><anyName><except><nsName ns=""/></except></anyName></attribute></zeroOrMore>
  </define>
  <define name="custom-elements">
    <zeroOrMore>
      <element><anyName><except><nsName ns=""/></except></anyName><ref name="anything"/></element>
    </zeroOrMore>
  </define>
  <define name="anything">
    <zeroOrMore>
      <choice>
        <attribute><anyName/></attribute>
        <text/>
        <element><anyName/><ref name="anything"/></element>
      </choice>
    </zeroOrMore>
  </define>
</grammar>
"""


def rng(version: Version) -> str:
    """The schema as a text."""
    known = schema(version)
    parts = [_HEAD.format(version=version, root=name_of(known.root))]
    for name, definition in definitions(known).items():
        parts += [f"{line}\n" for line in _define(name, definition)]
    return "".join((*parts, _TAIL))


def _define(name: str, definition: Definition) -> Iterator[str]:
    yield f'  <define name="{name}">'
    yield from _documentation(definition, "    ")
    if definition.open:
        yield from _open(definition)
    else:
        for attribute in definition.attributes.values():
            yield from _attribute(attribute)
        yield '    <ref name="custom-attributes"/>'
        if definition.type is not None:
            yield from _value(form(definition), "    ")
        else:
            yield "    <interleave>"
            for child in definition.children.values():
                yield from _child(definition, child)
            yield '      <ref name="custom-elements"/>'
            yield "    </interleave>"
    yield "  </define>"


def _open(definition: Definition) -> Iterator[str]:
    """An element whose own attributes are known, and nothing else."""
    names = "".join(f"<name>{name}</name>" for name in definition.attributes)
    for attribute in definition.attributes.values():
        yield from _attribute(attribute)
    yield "    <zeroOrMore>"
    yield f"      <attribute><anyName><except>{names}</except></anyName></attribute>"
    yield "    </zeroOrMore>"
    yield "    <zeroOrMore>"
    yield '      <choice><text/><element><anyName/><ref name="anything"/></element></choice>'
    yield "    </zeroOrMore>"


def _child(parent: Definition, child: Definition) -> Iterator[str]:
    needed = child.name in parent.needed_children
    once = child.single and f"{parent.name}/{child.name}" not in REPEATABLE
    often = ("" if needed else "optional") if once else "oneOrMore" if needed else "zeroOrMore"
    element = f'<element name="{child.name}"><ref name="{name_of(child)}"/></element>'
    yield f"      <{often}>{element}</{often}>" if often else f"      {element}"


def _attribute(attribute: AttributeDefinition) -> Iterator[str]:
    if not attribute.required:
        yield "    <optional>"
    yield f'    <attribute name="{attribute.name}">'
    yield from _documentation(attribute, "      ")
    yield from _value(form(attribute), "      ")
    yield "    </attribute>"
    if not attribute.required:
        yield "    </optional>"


def _value(value: Form, indent: str) -> Iterator[str]:
    if value.is_free:
        yield f"{indent}<text/>" if value.empty else f"{indent}{_data('token', ('minLength', '1'))}"
        return
    yield f"{indent}<choice>"
    for word in value.words:
        yield f'{indent}  <value type="token">{word}</value>'
    for pattern in value.patterns:
        yield f"{indent}  {_data('token', ('pattern', pattern))}"
    if value.bounds is not None:
        yield f"{indent}  {_data('double', *facets(value.bounds))}"
    if value.empty:
        yield f'{indent}  <value type="token"/>'
    yield f"{indent}</choice>"


def _data(kind: str, *parameters: tuple[str, str]) -> str:
    inside = "".join(f'<param name="{name}">{text}</param>' for name, text in parameters)
    return f'<data type="{kind}">{inside}</data>'


def _documentation(place: Definition | AttributeDefinition, indent: str) -> Iterator[str]:
    if text := documentation(place):
        yield f"{indent}<a:documentation>{escaped(text)}</a:documentation>"


# A version of SDFormat as a W3C XML Schema (1.0).
#
# Children come in any order and may be repeated, which this language can say by a choice
# without bounds only; so it cannot say what is required or may be once. Elements and
# attributes with a prefix are free.

_XSD_HEAD = """\
<?xml version="1.0" encoding="UTF-8"?>
<!-- SDFormat {version}, generated by sdfcheck. -->
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema" version="{version}">
  <xs:element name="sdf" type="{root}"/>
"""
_CUSTOM_ATTRIBUTE = '    <xs:anyAttribute namespace="##other" processContents="lax"/>'


def xsd(version: Version) -> str:
    """The schema as a text."""
    known = schema(version)
    parts = [_XSD_HEAD.format(version=version, root=name_of(known.root))]
    for name, definition in definitions(known).items():
        parts += [f"{line}\n" for line in _type(name, definition)]
    return "".join((*parts, "</xs:schema>\n"))


def _type(name: str, definition: Definition) -> Iterator[str]:
    if definition.type is not None:
        yield from _leaf(name, definition)
        return
    mixed = ' mixed="true"' if definition.open else ""
    yield f'  <xs:complexType name="{name}"{mixed}>'
    yield from _xsd_documentation(definition, "    ")
    yield '    <xs:choice minOccurs="0" maxOccurs="unbounded">'
    if definition.open:
        yield '      <xs:any processContents="skip"/>'
    else:
        for child in definition.children.values():
            yield f'      <xs:element name="{child.name}" type="{name_of(child)}"/>'
        yield '      <xs:any namespace="##other" processContents="lax"/>'
    yield "    </xs:choice>"
    for attribute in definition.attributes.values():
        yield from _xsd_attribute(attribute)
    if definition.open:
        yield '    <xs:anyAttribute processContents="skip"/>'
    else:
        yield _CUSTOM_ATTRIBUTE
    yield "  </xs:complexType>"


def _leaf(name: str, definition: Definition) -> Iterator[str]:
    yield f'  <xs:simpleType name="{name}.text">'
    yield from _simple(form(definition), "    ")
    yield "  </xs:simpleType>"
    yield f'  <xs:complexType name="{name}">'
    yield from _xsd_documentation(definition, "    ")
    yield f'    <xs:simpleContent><xs:extension base="{name}.text">'
    for attribute in definition.attributes.values():
        yield from _xsd_attribute(attribute)
    yield _CUSTOM_ATTRIBUTE
    yield "    </xs:extension></xs:simpleContent>"
    yield "  </xs:complexType>"


def _xsd_attribute(attribute: AttributeDefinition) -> Iterator[str]:
    use = ' use="required"' if attribute.required else ""
    yield f'    <xs:attribute name="{attribute.name}"{use}>'
    yield from _xsd_documentation(attribute, "      ")
    yield "      <xs:simpleType>"
    yield from _simple(form(attribute), "        ")
    yield "      </xs:simpleType>"
    yield "    </xs:attribute>"


def _simple(value: Form, indent: str) -> Iterator[str]:
    """The inside of a simple type: one restriction, or a union where a range has alternatives."""
    if value.is_free:
        least = "" if value.empty else '<xs:minLength value="1"/>'
        yield f'{indent}<xs:restriction base="xs:token">{least}</xs:restriction>'
    elif value.bounds is None:
        yield from _listed(value, indent)
    else:
        limits = "".join(f'<xs:{facet} value="{limit}"/>' for facet, limit in facets(value.bounds))
        numbers = f'<xs:restriction base="xs:double">{limits}</xs:restriction>'
        if not value.patterns and not value.empty:
            yield f"{indent}{numbers}"
            return
        yield f"{indent}<xs:union>"
        yield f"{indent}  <xs:simpleType>{numbers}</xs:simpleType>"
        yield f"{indent}  <xs:simpleType>"
        yield from _listed(value, f"{indent}    ")
        yield f"{indent}  </xs:simpleType>"
        yield f"{indent}</xs:union>"


def _listed(value: Form, indent: str) -> Iterator[str]:
    yield f'{indent}<xs:restriction base="xs:token">'
    words = (*value.words, "") if value.empty and value.words else value.words
    for word in words:
        yield f'{indent}  <xs:enumeration value="{word}"/>'
    if not value.words:
        for pattern in (*value.patterns, "") if value.empty else value.patterns:
            yield f'{indent}  <xs:pattern value="{pattern}"/>'
    yield f"{indent}</xs:restriction>"


def _xsd_documentation(place: Definition | AttributeDefinition, indent: str) -> Iterator[str]:
    if text := documentation(place):
        note = f"<xs:documentation>{escaped(text)}</xs:documentation>"
        yield f"{indent}<xs:annotation>{note}</xs:annotation>"
