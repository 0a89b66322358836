"""Which elements and attributes can be written at a place."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from sdfcheck.files.packages import Packages
from sdfcheck.formats import plugins, srdf
from sdfcheck.formats.describe import Spot, spot
from sdfcheck.formats.schema import Definition, RowInVersion
from sdfcheck.formats.vendor.definitions import Place, Slot, Vendor
from sdfcheck.formats.version import Version
from sdfcheck.lsp.completion.context import Context
from sdfcheck.lsp.completion.item import Item, Snippet, Sort, plain
from sdfcheck.xacro.language import KEYWORDS, OPTIONAL, REQUIRED, Parameter, is_literal, parameters
from sdfcheck.xacro.static.definitions import Definitions
from sdfcheck.xacro.static.project import FILE_LIMIT, text_of

_MACRO = re.compile(r"<xacro:macro\b[^<>]*?\sname\s*=\s*[\"']([\w.-]+)[\"'](?:[^<>\"']|\"[^\"]*\"|'[^']*')*>")
_PARAMETERS = re.compile(r"\sparams\s*=\s*([\"'])(.*?)\1", re.DOTALL)
_DECLARED = re.compile(r"<xacro:arg\b[^<>]*?\sname\s*=\s*[\"']([\w.-]+)[\"']")
_INCLUDED = re.compile(r"<xacro:include\b[^<>]*?\sfilename\s*=\s*[\"']([^\"'<>]+)[\"']")
_FILENAME = re.compile(r"filename\s*=\s*[\"']([^\"']+)[\"']")


def element_items(around: tuple[str, ...], version: Version, vendors: Sequence[Vendor]) -> Iterator[Item]:
    """The elements that the format allows in the innermost open one."""
    if not around:
        for name in ("sdf", "robot"):
            yield _item(name, spot([name], version), 1)
        return
    place = spot(around, version)
    if place is not None:
        yield from _children(place, version)
    yield from _custom(around, vendors)


def _children(place: Spot, version: Version) -> Iterator[Item]:
    for name, child in place.definition.children.items():
        is_old = child.deprecated or child.multiplicity == "-1"
        detail = f"read by {', '.join(child.consumers)}" if child.consumers else _detail(child)
        is_required = name in place.definition.required_children
        rank = 1 if is_required else 8 if is_old else 6 if child.consumers else 3
        found = _item(name, Spot(child, place.definition), rank, detail, is_old)
        yield found._replace(is_repeatable=not child.single)
    for name in ("plugin", "sensor", "light") if place.is_block else ():
        yield _item(name, spot(["robot", "gazebo", name], version), 2)


def _attributes(element: Definition, given: set[str], detail: str = "") -> Iterator[Item]:
    for name, attribute in element.attributes.items():
        if name not in given:
            snippet = Snippet().attribute(name, attribute.listed)
            rank = 1 if attribute.required else 3
            yield Item(name, Sort.ATTRIBUTE, plain(snippet), snippet, detail or _detail(attribute), rank)


def _detail(place: RowInVersion) -> str:
    return " ".join(filter(None, (place.type or "", " | ".join(place.units))))


def _item(name: str, place: Spot | None, rank: int, detail: str = "", is_old: bool = False) -> Item:
    snippet = Snippet().element(name, place.definition if place is not None else None)
    return Item(name, Sort.ELEMENT, plain(snippet), snippet, detail, rank, is_old)


def _custom(around: tuple[str, ...], vendors: Sequence[Vendor]) -> Iterator[Item]:
    """The tags of vendors' tables in the innermost open element."""
    for table in vendors:
        for tag in table.tags.values():
            place = next((p for p in tag.places if p.carrier != "attribute" and _fits(p, around)), None)
            if place is None:
                continue
            snippet = Snippet()
            inner = "".join(
                f" {snippet.attribute(each, slot.choices, slot.default)}"
                for each, slot in tag.attributes.items()
                if slot.required
            )
            slot = place.slot
            if place.carrier.startswith("@"):
                inner += " " + snippet.attribute(place.carrier[1:])
                text = f"{tag.name}{inner}/>"
            else:
                text = f"{tag.name}{inner}>{snippet._stop(slot.choices if slot else (), '')}</{tag.name}>"
            detail = " ".join(
                filter(None, (table.name, slot.type if slot else "", slot.unit if slot else ""))
            )
            yield Item(tag.name, Sort.ELEMENT, plain(text), text, detail, 2 if place.needed else 7)


def slots_at(tag: str, attribute: str, vendors: Sequence[Vendor]) -> Iterator[Slot]:
    """The entries of tables for the value of an attribute, or of an element where ``attribute`` is empty."""
    carrier = f"@{attribute}" if attribute else "text"
    for table in vendors:
        for name, kinds in ((attribute, {"attribute"}), (tag, {carrier})):
            known = table.tags.get(name)
            if known is not None:
                slots = [place.slot for place in known.places if place.carrier in kinds]
                slots.append(known.attributes.get(attribute))
                yield from filter(None, slots)


def _fits(place: Place, around: tuple[str, ...]) -> bool:
    names = tuple(step.name for step in reversed(place.path))
    return around[-len(names) :] == names


def attribute_items(context: Context, version: Version, vendors: Sequence[Vendor]) -> Iterator[Item]:
    """The attributes that the format allows in a tag, and that it has not."""
    around = (*context.around, context.tag)
    given = {name for name, _ in context.given}
    place = spot(around, version)
    if place is not None:
        yield from _attributes(place.definition, given)
    if ":" in context.tag and not context.tag.startswith("xacro:"):
        yield from _custom_attributes(context.tag, given, vendors)
    yield from _carried(around, given, vendors)


def _custom_attributes(tag: str, given: set[str], vendors: Sequence[Vendor]) -> Iterator[Item]:
    for table in vendors:
        known = table.tags.get(tag)
        if known is None:
            continue
        slots = {name: slot.choices for name, slot in known.attributes.items()}
        slots |= {place.carrier[1:]: () for place in known.places if place.carrier.startswith("@")}
        for name, choices in slots.items():
            if name not in given:
                snippet = Snippet().attribute(name, choices)
                yield Item(name, Sort.ATTRIBUTE, plain(snippet), snippet, rank=2)


def _carried(around: tuple[str, ...], given: set[str], vendors: Sequence[Vendor]) -> Iterator[Item]:
    """Vendors' tags that are attributes of standard elements."""
    for table in vendors:
        for tag in table.tags.values():
            places = [place for place in tag.places if place.carrier == "attribute"]
            if tag.name not in given and any(_fits(place, around) for place in places):
                snippet = Snippet().attribute(tag.name)
                yield Item(tag.name, Sort.ATTRIBUTE, plain(snippet), snippet, table.name, 7)


def parameter_items(text: str, around: tuple[str, ...], offset: int) -> Iterator[Item]:
    """The parameters of the plugin that is around a place, in all generations of Gazebo."""
    if not around or around[-1] != "plugin":
        return
    opening = text.rfind("<plugin", 0, offset)
    name = _FILENAME.search(text, opening, text.find(">", opening, offset) + 1 or offset)
    for facts in plugins.known(name[1]) if name is not None else ():
        for parameter in sorted(facts.parameters):
            snippet = f"{parameter}>$1</{parameter}>"
            rank = 1 if parameter in facts.required else 3
            item = Item(parameter, Sort.ELEMENT, plain(snippet), snippet, facts.generation, rank)
            yield item._replace(is_repeatable=parameter in facts.repeatable)


def seen_items(names: Iterable[str], detail: str) -> Iterator[Item]:
    """Elements that are written elsewhere in the same element, whatever they mean."""
    for name in names:
        snippet = f"{name}>$1</{name}>"
        yield Item(name, Sort.ELEMENT, plain(snippet), snippet, detail, 7)


def seen_attributes(names: Iterable[str], context: Context) -> Iterator[Item]:
    """Attributes that the text has elsewhere in the same element, whatever they mean."""
    given = {name for name, _ in context.given}
    for name in names:
        if name not in given and not name.startswith("xmlns"):
            yield Item(name, Sort.ATTRIBUTE, f'{name}=""', f'{name}="$1"', "in this file", 7)


def semantic_elements(around: tuple[str, ...]) -> Iterator[Item]:
    """The elements of SRDF."""
    place = srdf.at(around)
    for name, child in place.children.items() if place is not None else ():
        yield _item(name, Spot(child), 3, "SRDF")._replace(is_repeatable=not child.single)


def semantic_attributes(context: Context) -> Iterator[Item]:
    """The attributes of SRDF."""
    place = srdf.at((*context.around, context.tag))
    if place is not None:
        yield from _attributes(place, {name for name, _ in context.given}, "SRDF")


Macros = Mapping[str, tuple[Parameter, ...]]
"""Name → the parameters of a macro."""


class Project:
    """The macros and arguments that the xacro files of a project define, by their texts alone."""

    def __init__(self, packages: Packages) -> None:
        self.by_file: dict[str, dict[str, tuple[Parameter, ...]]] = {}
        """Name of a file → its macros."""
        found: set[str] = set()
        for path in packages.files(".xacro", FILE_LIMIT):
            text = text_of(path)
            for match in _MACRO.finditer(text):
                given = _PARAMETERS.search(match[0])
                own = parameters(given[2]) if given is not None else ()
                self.by_file.setdefault(path.name, {}).setdefault(match[1], tuple(own))
            found.update(_DECLARED.findall(text))
        self.arguments = frozenset(found)

    def included(self, text: str) -> Macros:
        """The macros in files with the names of those that a text includes, wherever these are."""
        names = dict.fromkeys(found.rpartition("/")[2] for found in _INCLUDED.findall(text))
        return {name: own for file in names for name, own in self.by_file.get(file, {}).items()}

    @property
    def macros(self) -> Macros:
        """All of them."""
        return {name: own for macros in self.by_file.values() for name, own in macros.items()}


def xacro_elements(macros: Macros) -> Iterator[Item]:
    """The elements of xacro, and calls of macros."""
    for name in sorted(KEYWORDS):
        snippet = Snippet()
        head = f"xacro:{name}" + "".join(f" {snippet.attribute(each)}" for each in REQUIRED.get(name, ()))
        has_body = name in {"macro", "if", "unless", "call", "element"}
        text = f"{head}>\n\t$0\n</xacro:{name}>" if has_body else f"{head}/>"
        item = Item(f"xacro:{name}", Sort.ELEMENT, plain(text), text, "xacro", 6)
        yield item._replace(is_repeatable=True)
    for name, own in sorted(macros.items()):
        snippet = Snippet()
        given = [p.name for p in own if not p.is_block and not p.is_optional]
        head = f"xacro:{name}" + "".join(f" {snippet.attribute(each)}" for each in given)
        has_blocks = any(p.is_block for p in own)
        text = f"{head}>\n\t$0\n</xacro:{name}>" if has_blocks else f"{head}/>"
        detail = " ".join(p.name for p in own)
        item = Item(f"xacro:{name}", Sort.MACRO, plain(text).replace("$0", ""), text, detail, 4)
        yield item._replace(is_repeatable=True)


def block_items(call: str, macros: Macros) -> Iterator[Item]:
    """The elements that a call takes as blocks; of a macro that is not known the usual one."""
    known = macros.get(call.removeprefix("xacro:"))
    names = ["*origin"] if known is None else [each.name for each in known if each.is_block]
    for name in names:
        if (child := spot(["robot", "joint", name.lstrip("*")])) is not None:
            yield _item(name.lstrip("*"), child, 1)


def macros_in(visible: Iterable[Definitions]) -> Macros:
    """The macros that a file can see."""
    found: dict[str, tuple[Parameter, ...]] = {}
    for each in visible:
        for name, macros in each.macros.items():
            if is_literal(name):
                found.setdefault(name, macros[0].parameters)
    return found


def xacro_attributes(context: Context, macros: Macros) -> Iterator[Item]:
    """The attributes of an element of xacro, or the parameters of a macro that is called."""
    given = {name for name, _ in context.given}
    name = context.tag.removeprefix("xacro:")
    if name in KEYWORDS:
        names: Iterable[tuple[str, int]] = [(each, 1) for each in REQUIRED.get(name, ())]
        names = [*names, *((each, 4) for each in OPTIONAL.get(name, ()))]
    else:
        known = macros.get(name) or macros.get(name.rpartition(".")[2]) or ()
        names = [(p.name, 3 if p.is_optional else 1) for p in known if not p.is_block]
    for each, rank in names:
        if each not in given:
            snippet = Snippet().attribute(each)
            yield Item(each, Sort.ATTRIBUTE, plain(snippet), snippet, "xacro", rank)
