"""Completion: what can be typed at a place."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.files.packages import Packages
from sdfcheck.formats import near_names as usual
from sdfcheck.formats import plugins, srdf
from sdfcheck.formats.describe import Spot, spot
from sdfcheck.formats.schema import Definition, RowInVersion
from sdfcheck.formats.vendor.definitions import Place, Slot, Vendor
from sdfcheck.formats.vendor.table import vendors
from sdfcheck.formats.version import NEWEST, VERSIONS, Version
from sdfcheck.lsp.context import (
    MARKUP,
    Context,
    Item,
    Snippet,
    Sort,
    Usage,
    Where,
    context,
    without_conditions,
    without_stops,
    words_in,
)
from sdfcheck.lsp.cursor import elements
from sdfcheck.lsp.names import (
    MOST_ASSISTANTS,
    Expanded,
    as_written,
    expansions,
    is_made,
    occurrences,
    robots_about,
    roots_of,
)
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.robot.graph import Model
from sdfcheck.robot.naming.occurrences import Occurrence
from sdfcheck.robot.part import Namespace
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.language import KEYWORDS, OPTIONAL, REQUIRED, Parameter, is_literal, parameters
from sdfcheck.xacro.static.definitions import Definitions, visible_definitions
from sdfcheck.xacro.static.launches import launched_names
from sdfcheck.xacro.static.project import FILE_LIMIT, text_of

# Values that the formats and their consumers know.


_SENSED = tuple(
    f"{quantity}.{axis}"
    for quantity in ("force", "torque", "position", "orientation", "angular_velocity", "linear_acceleration")
    for axis in ("xyzw" if quantity == "orientation" else "xyz")
)
_HARDWARE = {
    "gz_ros2_control/GazeboSimSystem": "Gazebo",
    "ign_ros2_control/IgnitionSystem": "Gazebo Fortress",
    "gazebo_ros2_control/GazeboSystem": "Gazebo classic",
    "mock_components/GenericSystem": "no hardware, for tests",
    "mujoco_ros2_control/MujocoSystem": "MuJoCo",
    "topic_based_ros2_control/TopicBasedSystem": "topics",
}
_XACRO_COMMANDS = ("arg ", "find ", "env ", "optenv ", "eval ", "dirname", "cwd", "anon ")


def value_items(context: Context, version: Version, vendors: Sequence[Vendor]) -> Iterator[Item]:
    """The values of an attribute or text, where they are a closed list or well known."""
    tag, attribute = context.tag, context.attribute
    if tag == "plugin" and attribute == "filename":
        yield from (Item(name, Sort.FILE, name, detail="Gazebo") for name in plugins.systems())
        files = (f"lib{name}.so" for name in plugins.ros_files())
        yield from (Item(name, Sort.FILE, name, detail="Gazebo Classic", rank=6) for name in files)
        return
    if tag == "sdf" and attribute == "version":
        newest_first = map(str, reversed(VERSIONS))
        yield from (Item(each, Sort.CHOICE, each, rank=8 + n) for n, each in enumerate(newest_first))
        return
    yield from (_of_control(context) if "ros2_control" in context.around else ()) or _of_format(
        context, version
    )
    if ":" in tag or ":" in attribute:
        slots = slots_at(tag, attribute, vendors)
        for choice in dict.fromkeys(choice for slot in slots for choice in slot.choices):
            yield Item(choice, Sort.CHOICE, choice, rank=2)


def _of_control(context: Context) -> list[Item]:
    """Values in a block of ``ros2_control`` that depend on more than the place."""
    tag, attribute = context.tag, context.attribute
    if tag == "state_interface" and attribute == "name" and "sensor" in context.around:
        return [Item(name, Sort.CHOICE, name, rank=2) for name in _SENSED]
    if tag == "plugin" and context.where is Where.TEXT:
        return [Item(name, Sort.CHOICE, name, detail=what, rank=2) for name, what in _HARDWARE.items()]
    return []


def _of_format(context: Context, version: Version) -> Iterator[Item]:
    around = context.around if context.where is Where.TEXT else (*context.around, context.tag)
    place = spot(around, version)
    if place is None:
        return
    own = place.definition.attributes.get(context.attribute) if context.attribute else place.definition
    if own is None:
        return
    choices, default = own.listed or own.usual, own.given_default
    yield from (Item(choice, Sort.CHOICE, choice, rank=2) for choice in choices if choice)
    if own.type == "bool" and not choices:
        yield from (Item(word, Sort.CHOICE, word, rank=2) for word in ("true", "false"))
    if default and not choices and own.type != "bool":
        yield Item(default, Sort.CHOICE, default, detail="default", rank=7)


def semantic_values(context: Context) -> Iterator[Item]:
    """The values of SRDF that are a closed list."""
    place = srdf.at((*context.around, context.tag))
    own = place.attributes.get(context.attribute) if place is not None else None
    for choice in own.listed if own is not None else ():
        yield Item(choice, Sort.CHOICE, choice, detail="SRDF", rank=2)


def command_items() -> Iterator[Item]:
    """The beginnings of a substitution of xacro."""
    yield from (
        Item(f"$({word.strip()} …)", Sort.WORD, f"$({word}", detail="xacro") for word in _XACRO_COMMANDS
    )


# Which elements and attributes can be written at a place.


_MACRO_TAG = re.compile(
    r"<xacro:macro\b[^<>]*?\sname\s*=\s*[\"']([\w.-]+)[\"'](?:[^<>\"']|\"[^\"]*\"|'[^']*')*>"
)


_VERSION = re.compile(r"<sdf\b[^<>]*?\bversion\s*=\s*[\"']([^\"']*)[\"']")
_PARAMETERS = re.compile(r"\sparams\s*=\s*([\"'])(.*?)\1", re.DOTALL)
_FOUND = re.compile(r"\$\(find\s+([^\s()$]+)\)")
_DECLARED = re.compile(r"<xacro:arg\b[^<>]*?\sname\s*=\s*[\"']([\w.-]+)[\"']")
_INCLUDED = re.compile(r"<xacro:include\b[^<>]*?\sfilename\s*=\s*[\"']([^\"'<>]+)[\"']")
_PLUGIN = re.compile(r"<plugin\b([^<>]*[^<>/])>(.*?)</plugin", re.DOTALL)
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
        yield _item(name, spot(["robot", "gazebo", name], version), 2)._replace(is_repeatable=True)


def _attributes(element: Definition, given: set[str], detail: str = "") -> Iterator[Item]:
    for name, attribute in element.attributes.items():
        if name not in given:
            snippet = Snippet().attribute(name, attribute.listed)
            rank = 1 if attribute.required else 3
            yield Item(
                name, Sort.ATTRIBUTE, without_stops(snippet), snippet, detail or _detail(attribute), rank
            )


def _detail(place: RowInVersion) -> str:
    return " ".join(filter(None, (place.type or "", " | ".join(place.units))))


def _item(name: str, place: Spot | None, rank: int, detail: str = "", is_old: bool = False) -> Item:
    snippet = Snippet().element(name, place.definition if place is not None else None)
    return Item(name, Sort.ELEMENT, without_stops(snippet), snippet, detail, rank, is_old)


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
            yield Item(tag.name, Sort.ELEMENT, without_stops(text), text, detail, 2 if place.needed else 7)


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
                yield Item(name, Sort.ATTRIBUTE, without_stops(snippet), snippet, rank=2)


def _carried(around: tuple[str, ...], given: set[str], vendors: Sequence[Vendor]) -> Iterator[Item]:
    """Vendors' tags that are attributes of standard elements."""
    for table in vendors:
        for tag in table.tags.values():
            places = [place for place in tag.places if place.carrier == "attribute"]
            if tag.name not in given and any(_fits(place, around) for place in places):
                snippet = Snippet().attribute(tag.name)
                yield Item(tag.name, Sort.ATTRIBUTE, without_stops(snippet), snippet, table.name, 7)


class Habits:
    """The plugins in the files of a project, with the elements that they hold, and the versions of SDFormat."""

    def __init__(self, packages: Packages) -> None:
        self._by_file: dict[str, list[tuple[Path, tuple[str, ...]]]] = {}
        self._written: dict[str, str] = {}
        """A file, as it is written somewhere."""
        self._versions: list[tuple[Path, str]] = []
        for suffix in (".sdf", ".world", ".urdf", ".xacro"):
            for path in packages.files(suffix, FILE_LIMIT):
                text = text_of(path)
                version = _VERSION.search(text, 0, 4096)
                self._versions += [(path, version[1])] if version else []
                for file, names in _held(text):
                    self._written.setdefault(plugins.stem(file), file)
                    self._by_file.setdefault(plugins.stem(file), []).append((path, names))

    def versions(self, path: Path) -> list[str]:
        """The versions of SDFormat that other files declare, the most usual first."""
        found = Counter(version for other, version in self._versions if other != path)
        return [version for version, _ in found.most_common()]

    def others(self, path: Path) -> Iterator[str]:
        """The files of plugins that other descriptions of the project name."""
        for file, held in self._by_file.items():
            if any(other != path for other, _ in held) and "$" not in file:
                yield self._written[file]

    def shares(self, file: str, path: Path, text: str, offset: int) -> dict[str, float]:
        """In how many of the plugins of a file each element is; in an open text all but the one around a place."""
        around = (
            text[: text.rfind("<plugin", 0, offset)],
            text[max(text.find("</plugin", offset), offset) :],
        )
        own = [names for part in around for each, names in _held(part) if plugins.stem(each) == file]
        held = [*own, *(names for other, names in self._by_file.get(file, ()) if other != path)]
        counts = Counter(name for names in held for name in set(names))
        return {name: number / len(held) for name, number in counts.items()}


def _held(text: str) -> Iterator[tuple[str, tuple[str, ...]]]:
    """The file of each plugin in a text, and the names of its child elements."""
    for found in _PLUGIN.finditer(text):
        file, names, depth = _FILENAME.search(found[1]), [], 0
        for tag in MARKUP.finditer(found[2]):
            if depth == 0 and tag["start"]:
                names.append(tag["start"])
            depth += bool(tag["start"] and not tag["empty"]) - bool(tag["end"])
        if file is not None:
            yield file[1], tuple(names)


def plugin_around(text: str, around: tuple[str, ...], offset: int) -> str:
    """The file of the plugin that is around a place, empty if there is none."""
    if not around or around[-1] != "plugin":
        return ""
    opening = text.rfind("<plugin", 0, offset)
    found = _FILENAME.search(text, opening, text.find(">", opening, offset) + 1 or offset)
    return "" if found is None else plugins.stem(found[1])


def parameter_items(file: str, seen: Iterable[str]) -> Iterator[Item]:
    """The parameters of a plugin, in all generations of Gazebo, and those that it has elsewhere."""
    for facts in plugins.known(file):
        for parameter in sorted(facts.parameters):
            snippet = f"{parameter}>$1</{parameter}>"
            rank = 1 if parameter in facts.required else 3
            item = Item(parameter, Sort.ELEMENT, without_stops(snippet), snippet, facts.generation, rank)
            yield item._replace(is_repeatable=parameter in facts.repeatable)
    yield from seen_items(seen, "in this project")


def seen_items(names: Iterable[str], detail: str) -> Iterator[Item]:
    """Elements that are written elsewhere in the same element, whatever they mean."""
    for name in names:
        snippet = f"{name}>$1</{name}>"
        yield Item(name, Sort.ELEMENT, without_stops(snippet), snippet, detail, 7)


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
        self._found: list[tuple[Path, frozenset[str]]] = []
        found: set[str] = set()
        for path in packages.files(".xacro", FILE_LIMIT):
            text = text_of(path)
            for match in _MACRO_TAG.finditer(text):
                given = _PARAMETERS.search(match[0])
                own = parameters(given[2]) if given is not None else ()
                self.by_file.setdefault(path.name, {}).setdefault(match[1], tuple(own))
            found.update(_DECLARED.findall(text))
            self._found.append((path, frozenset(_FOUND.findall(text))))
        self.arguments = frozenset(found)

    def found_by_others(self, path: Path) -> set[str]:
        """The packages that the other files look for, wherever these are."""
        return set[str]().union(*(names for other, names in self._found if other != path))

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
        item = Item(f"xacro:{name}", Sort.ELEMENT, without_stops(text), text, "xacro", 6)
        yield item._replace(is_repeatable=True)
    for name, own in sorted(macros.items()):
        snippet = Snippet()
        given = [p.name for p in own if not p.is_block and not p.is_optional]
        head = f"xacro:{name}" + "".join(f" {snippet.attribute(each)}" for each in given)
        has_blocks = any(p.is_block for p in own)
        text = f"{head}>\n\t$0\n</xacro:{name}>" if has_blocks else f"{head}/>"
        detail = " ".join(p.name for p in own)
        item = Item(f"xacro:{name}", Sort.MACRO, without_stops(text).replace("$0", ""), text, detail, 4)
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
        # Neighbors in calls are neighbors in the definition too.
        there = [n for n, (each, _) in enumerate(names) if each in given] or [0]
        order = sorted(range(len(names)), key=lambda n: min(abs(n - each) for each in there))
        names = [names[n] for n in order]
    for each, rank in names:
        if each not in given:
            snippet = Snippet().attribute(each)
            yield Item(each, Sort.ATTRIBUTE, without_stops(snippet), snippet, "xacro", rank)


# Files and folders that a URI can lead to.


_MOST = 500
_MESHES = (".dae", ".stl", ".obj", ".gltf", ".glb", ".ply")
_IMAGES = (".png", ".jpg", ".jpeg", ".tga", ".dds", ".tif")
_ENDINGS = {
    "mesh": _MESHES,
    "heightmap": (".png", ".tif", ".tiff", ".jpg"),
    "texture": _IMAGES,
    "albedo_map": _IMAGES,
    "normal_map": _IMAGES,
    "xacro:include": (".xacro", ".urdf", ".xml"),
    "include": (".sdf", ".world", ".urdf"),
}
_CLIMB = 6


def path_items(document: Document, typed: str, tag: str, around: tuple[str, ...]) -> Iterator[Item]:
    """The continuations of a URI that has been typed up to its last slash; each item is the whole URI."""
    if typed.startswith("file://$("):
        for item in path_items(document, typed.removeprefix("file://"), tag, around):
            yield item._replace(label=f"file://{item.label}", text=f"file://{item.text}")
        return
    holder = tag if tag in _ENDINGS else (around[-2] if len(around) > 1 else "")
    head, slash, _ = typed.rpartition("/")
    if "://" not in typed:
        for scheme in ("model://", "package://", "file://"):
            if tag != "xacro:include":
                yield Item(scheme, Sort.WORD, scheme, rank=6)
    if typed.startswith("$(find ") and ")" not in typed:
        yield from (
            Item(f"$(find {name})", Sort.FOLDER, f"$(find {name})/", rank=2) for name in _packages(document)
        )
        return
    if head.endswith(":/") or head in {"model:", "package:"}:
        names = _packages(document) if head.startswith("package") else _models(document)
        scheme = head.partition(":")[0]
        yield from (Item(f"{scheme}://{name}", Sort.FOLDER, f"{scheme}://{name}", rank=2) for name in names)
        return
    folder = _folder(document, head + slash)
    if folder is not None:
        yield from _listed(folder, head + slash, _ENDINGS.get(holder, ()))


def _listed(folder: Path, head: str, endings: tuple[str, ...]) -> Iterator[Item]:
    try:
        entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    except OSError:
        return
    for entry in entries[:_MOST]:
        if entry.name.startswith("."):
            continue
        if entry.is_dir():
            yield Item(f"{head}{entry.name}/", Sort.FOLDER, f"{head}{entry.name}/", rank=4)
        elif not endings or entry.name.lower().endswith(endings):
            yield Item(f"{head}{entry.name}", Sort.FILE, f"{head}{entry.name}", rank=3)


def _folder(document: Document, head: str) -> Path | None:
    """The folder that the beginning of a URI means."""
    beside = Path(os.path.abspath(document.path)).parent
    scheme, sign, rest = head.partition("://")
    if head.startswith("$(find "):
        name, _, inside = head[len("$(find ") :].partition(")")
        found = _package(document, name.strip())
        return None if found is None else found / inside.strip("/")
    if not sign:
        return beside / head
    if scheme == "file":
        return Path("/" + rest.lstrip("/"))
    name, _, inside = rest.partition("/")
    if scheme == "package":
        found = _package(document, name)
        return None if found is None else found / inside
    if scheme == "model":
        return next(
            (place / name / inside for place in _model_folders(document) if os.path.isdir(place / name)), None
        )
    return None


def _package(document: Document, name: str) -> Path | None:
    library = library_of(document)
    return None if library is None else library.packages(document.path).find(name, document.path)


def _packages(document: Document) -> list[str]:
    library = library_of(document)
    return [] if library is None else library.packages(document.path).names[:_MOST]


def _models(document: Document) -> list[str]:
    """The folders that hold a model."""
    found: dict[str, None] = {}
    for folder in _model_folders(document):
        try:
            names = sorted(os.listdir(folder))
        except OSError:
            continue
        found.update(
            dict.fromkeys(name for name in names[:_MOST] if os.path.isfile(folder / name / "model.config"))
        )
    return sorted(found)


def _model_folders(document: Document) -> Iterator[Path]:
    library = library_of(document)
    if library is not None:
        yield from map(Path, library.model_folders)
    folder = Path(os.path.abspath(document.path)).parent
    for above in (folder, *folder.parents)[:_CLIMB]:
        yield above
        yield above / "models"


# Which names of a robot are likely at a place of its SRDF: by its tree, by what is written already, by the
# order.


_ATTRIBUTE = re.compile(r"(?<![\w:])([\w:]+)\s*=\s*[\"']([^\"'<>]*)[\"']")
_PAIR = re.compile(r"\slink1\s*=\s*[\"']([^\"']*)[\"']\s+link2\s*=\s*[\"']([^\"']*)[\"']")
_PARTNERS = {"link1": "link2", "link2": "link1"}
_UNLIKELY = 3.0


class Tree:
    """The links and joints of the robots that SRDF is about."""

    def __init__(self, documents: Iterable[Document]) -> None:
        self.parents: dict[str, str] = {}
        self.fixed: set[str] = set()
        for document in documents:
            for model in root_of(document).scopes[:1]:
                for joint in model.joints if isinstance(model, Model) else ():
                    self.parents.setdefault(joint.child_name or "", joint.parent_name or "")
                    if joint.type == "fixed":
                        self.fixed.add(joint.name)

    def above(self, link: str) -> list[str]:
        """The links between one and the root, the nearest first."""
        found: list[str] = []
        while (link := self.parents.get(link, "")) and link not in found:
            found.append(link)
        return found


def semantic_scores(
    text: str, context: Context, offset: int, usage: Usage, names: Sequence[str], tree: Tree
) -> dict[str, float]:
    """How much more or less likely each name is for what SRDF says there."""
    start, end = text.rfind("<", 0, offset), text.find(">", offset)
    given = dict(_ATTRIBUTE.findall(text[start : end if end >= 0 else len(text)]))
    attribute = context.attribute
    if attribute in _PARTNERS:
        neighbors = [usage.neighbors(f"{context.tag}@{each}", offset) for each in _PARTNERS]
        return _paired(attribute, given, _PAIR.findall(text), neighbors, names, tree)
    if context.tag in {"joint", "passive_joint"}:
        return _joints(text, context, offset, names, tree)
    if attribute == "child_link":
        return {name: 2.0 * (name not in tree.parents and name in tree.parents.values()) for name in names}
    if attribute == "tip_link":
        below = {name: tree.above(name) for name in names}
        deepest = max(map(len, below.values()), default=0) or 1
        base = given.get("base_link", "")
        return {name: 2.0 * len(above) / deepest + (base in above) for name, above in below.items()}
    if attribute == "parent_link":
        tips = set(re.findall(r"\stip_link\s*=\s*[\"']([^\"']*)[\"']", text))
        return {name: 2.0 * (name in tips) + len(tree.above(name)) / 20 for name in names}
    return {}


def _paired(
    attribute: str,
    given: Mapping[str, str],
    pairs: Iterable[tuple[str, str]],
    neighbors: Iterable[tuple[list[str], list[str]]],
    names: Sequence[str],
    tree: Tree,
) -> dict[str, float]:
    """Links that are not paired with the other one yet; pairs come in the order of their names."""
    partner = given.get(_PARTNERS[attribute], "")
    used = {name for pair in pairs if partner in pair for name in pair} | {partner}
    scores = {name: -_UNLIKELY * (name in used) for name in names}
    for name in names if given.get("reason") == "Adjacent" and partner else ():
        above, below = tree.above(name)[:2], tree.above(partner)[:2]
        scores[name] += 0.5 * (partner in above or name in below)
        scores[name] += 1.5 * (partner in above[:1] or name in below[:1])
    free = sorted(name for name in names if name not in used)
    first, second = neighbors
    if attribute == "link1":
        low, high = "".join(first[0][:1]), "".join(first[1][:1])
        likely = [name for name in (low, high) if name in scores]
        likely += [name for name in free if low < name < (high or name + " ")]
    else:
        low = second[0][0] if first[0][:1] == [partner] and second[0] else partner
        high = second[1][0] if first[1][:1] == [partner] and second[1] else ""
        likely = [name for name in free if low < name and (not high or name < high)]
    for number, name in enumerate(dict.fromkeys(likely)):
        scores[name] += 2.0 / (1 + number / 4)
    return scores


def _joints(text: str, context: Context, offset: int, names: Sequence[str], tree: Tree) -> dict[str, float]:
    """Joints that move; in a state those of its group, in their order."""
    scores = {name: -2.0 * (name in tree.fixed) for name in names}
    start = text.rfind("<group_state", 0, offset)
    if context.around[-1:] != ("group_state",) or start < 0:
        return scores
    group = dict(_ATTRIBUTE.findall(text[start : text.find(">", start)])).get("group", "")
    opened = re.search(rf"<group\s+name\s*=\s*[\"']{re.escape(group)}[\"']\s*>", text)
    inside = text[opened.end() : text.find("</group>", opened.end())] if opened else ""
    for name in re.findall(r"<joint\s+name\s*=\s*[\"']([^\"']*)[\"']", inside):
        if name in scores:
            scores[name] = 1.5
    return scores


# The names that a reference can write where the cursor is.


_NODES = ("link", "joint", "frame", "model")
_SDF_VALUES = {
    ("pose", "relative_to"): _NODES,
    ("pose", "frame"): _NODES,
    ("frame", "attached_to"): _NODES,
    ("xyz", "expressed_in"): _NODES,
    ("model", "canonical_link"): ("link",),
    ("model", "placement_frame"): _NODES,
    ("mimic", "joint"): ("joint",),
}
_SDF_TEXTS = {
    "parent": _NODES,
    "child": _NODES,
    "gearbox_reference_body": ("link",),
    "gripper_link": ("link",),
    "palm_link": ("link",),
    "placement_frame": _NODES,
}
_URDF_VALUES = {
    ("parent", "link"): ("link",),
    ("child", "link"): ("link",),
    ("mimic", "joint"): ("joint",),
    ("gazebo", "reference"): ("link", "joint"),
    ("material", "name"): ("material",),
}
_OF_JOINTS = frozenset({"transmission", "ros2_control"})
_OWN_FRAMES = {"relative_to": "__model__", "attached_to": "__model__", "expressed_in": "__model__"}


def wanted(context: Context, dialect: str, vendors: Sequence[Vendor]) -> tuple[str, ...]:
    """The kinds of things that can be named; none where no name is expected."""
    tag, attribute = context.tag, context.attribute
    if dialect == "srdf":
        place = srdf.at((*context.around, tag)) if context.where is Where.VALUE else None
        own = place.attributes.get(attribute) if place is not None else None
        return tuple(filter(None, (srdf.named_by(own),))) if own is not None else ()
    is_urdf = dialect == "urdf"
    if context.where is Where.VALUE:
        if tag == "insert_block" or (tag == "xacro:insert_block" and attribute == "name"):
            return ("parameter",)
        is_joint = is_urdf and tag == "joint" and attribute == "name"
        if is_joint and _OF_JOINTS.intersection(context.around[-1:]):
            return ("joint",)
        table = _URDF_VALUES if is_urdf else _SDF_VALUES
        return table.get((tag, attribute)) or _of_vendors(tag, attribute, vendors)
    if (
        tag in _SDF_TEXTS
        and not is_urdf
        and (tag not in {"parent", "child"} or "joint" in context.around[-2:])
    ):
        return _SDF_TEXTS[tag]
    if "plugin" in context.around:
        return _of_parameter(tag)
    return _of_vendors(tag, "", vendors)


def _of_parameter(tag: str) -> tuple[str, ...]:
    words = tag.lower()
    if "joint" in words:
        return ("joint",)
    if "link" in words or "body" in words:
        return ("link",)
    return _NODES if "frame" in words else ()


def _of_vendors(tag: str, attribute: str, vendors: Sequence[Vendor]) -> tuple[str, ...]:
    """The parts that a vendor's own tag can name."""
    slots = slots_at(tag, attribute, vendors) if ":" in tag or ":" in attribute else ()
    return next((slot.references for slot in slots if slot.references), ())


def name_items(
    workspace: Workspace,
    document: Document,
    context: Context,
    offset: int,
    usage: Usage,
    kinds: tuple[str, ...],
) -> list[Item]:
    """The names of the kinds that are wanted, the likeliest first."""
    if document.root is None:
        return []
    made = _made(workspace, document)
    near = [value for values in usage.neighbors(place_of(context), offset) for value in values]
    # In a macro people write names with its parameters, unless they do not.
    is_written = "xacro:macro" in context.around and (not near or any("$" in value for value in near))
    items = list(_candidates(made, document, context, offset, kinds, is_written=is_written))
    order = Order(document.source.text, context, offset, usage, items, is_written=is_written)
    more: dict[str, float] = {}
    if document.kind is Kind.SRDF:
        names, tree = [item.label for item in items], Tree(one.document for one in made)
        more = semantic_scores(document.source.text, context, offset, usage, names, tree)
    return sorted(items, key=lambda item: (-order.score(item) - more.get(item.label, 0.0), item.rank))


def place_of(context: Context) -> str:
    """The element, with the attribute, that the cursor is in."""
    return f"{context.tag}@{context.attribute}" if context.attribute else context.tag


def _made(workspace: Workspace, document: Document) -> list[Expanded]:
    """The robots that SRDF is about, or that a file is expanded to or part of."""
    found: list[Expanded] = []
    if document.kind is Kind.XACRO:
        return expansions(workspace, roots_of(document)[:2], turned=False, lately=True)
    for robot in robots_about(workspace, document, lately=True) if document.kind is Kind.SRDF else ():
        made = expansions(workspace, roots_of(robot), turned=False) if is_made(robot) else [as_written(robot)]
        found += made[:MOST_ASSISTANTS]
    return found


def _candidates(
    made: Iterable[Expanded],
    document: Document,
    context: Context,
    offset: int,
    kinds: tuple[str, ...],
    *,
    is_written: bool,
) -> Iterator[Item]:
    if is_made(document) or document.kind is Kind.SRDF:
        is_last = is_written and document.kind is not Kind.SRDF
        expanded = {
            (name, kind): 2 if not is_last else 4 if all("$" in row.span.text for row in rows) else 3
            for one in made
            for (kind, name), rows in one.by_name.items()
            if kind in kinds
        }
        written = {
            (each.span.text.strip() if document.kind is Kind.SRDF else each.symbol.name, each.symbol.kind): 2
            for each in occurrences(document).all
            if each.symbol.kind in kinds and not _is_at(each, offset) and not _is_no_block(each)
        }
        ranks = {**written, **expanded, **written} if is_last else {**expanded, **written}
        yield from (
            Item(name, Sort.NAME, name, detail=kind, rank=rank) for (name, kind), rank in ranks.items()
        )
        return
    scope = _scope(document, context, offset)
    if scope is not None:
        yield from _in_scope(scope, kinds, context)
    yield from _tags(document, kinds)


def _is_no_block(occurrence: Occurrence) -> bool:
    """Is it a parameter that no block is given for? The others are written with a star."""
    span = occurrence.symbol.span
    return occurrence.symbol.kind == "parameter" and not span.source.text[: span.start].endswith("*")


def _is_at(occurrence: Occurrence, offset: int) -> bool:
    return occurrence.span.start <= offset <= occurrence.span.end


class Order:
    """Which of several names is likely at a place: what its neighbors name, what is defined nearby, what is alike."""

    def __init__(
        self,
        text: str,
        context: Context,
        offset: int,
        usage: Usage,
        items: Sequence[Item],
        *,
        is_written: bool,
    ) -> None:
        self.is_written = is_written
        self.offset = offset
        self.text = text
        place = place_of(context)
        self.before, self.after = usage.neighbors(place, offset)
        self.numbers = {item.label: number for number, item in enumerate(items)}
        self.alphabet = {name: number for number, name in enumerate(sorted(self.numbers))}
        is_top = "<group" in text and context.around == ("robot",)
        holder = [""] if is_top else _holder(text, context, offset)
        self.words = words_in(" ".join(holder))
        self.others, self.related = set(holder[1:]), set[str]()
        if place == "pose@relative_to":
            self.others, self.related = {holder[0]}, self.others | _joints_to(text, holder[0])
        self.place = place
        self.is_semantic = "<group" in text and place in _SEMANTIC
        self.is_once = place in _ONCE or context.attribute == "link2"
        block = _block(text, context, offset)
        self.used = set(self.before + self.after) if place in _ONCE else set()
        if place in _ONCE_IN_BLOCK:
            self.used = set(re.findall(r"<" + context.tag + r"\b[^<>]*?[\"']([^\"'<>]+)[\"']", block))
        self.children = (
            {a or b for a, b in _CHILD.findall(text)} if place in {"parent@link", "parent"} else set()
        )
        self.last_child = _CHILD.findall(text, 0, offset)[-1:] if place == "parent@link" else []
        self.places = {name: _nearest(text, name, offset) for name in self.numbers}
        distances = sorted(set(self.places.values()))
        self.ranks = {distance: number for number, distance in enumerate(distances)}

    def score(self, item: Item) -> float:
        """How likely a name is."""
        name = item.label
        score = 0.0 if item.rank <= 3 or name in (*self.before[:2], *self.after[:2]) else -2.0
        score -= 3 * (name in self.used or name in self.others)
        score -= _OF_LINKS.get(self.place, 0.0) * (item.detail == "joint")
        score += 0.6 * bool(self.children and name not in self.children)  # a root has many children
        score += (name, "") in self.last_child  # parts hang on one another
        score += name in self.related
        score -= 2 * ("$" in name and not self.is_written)
        if not self.is_semantic:
            score += 1.5 / (1 + self.ranks[self.places[name]])
        if not self.is_once:
            weight = 2.0 if self.is_semantic else 1.0
            score += weight * (name in self.before[:1]) + weight * (name in self.after[:1]) / 2
            score += (name in self.before[1:4]) / 4
        if self.before[:1] and self.before[0] in self.numbers:
            score += 0.8 / (1 + abs(self.numbers[name] - self.numbers[self.before[0]] - 1))
            score += 0.4 / (1 + abs(self.alphabet[name] - self.alphabet[self.before[0]] - 1))
        own = words_in(name)
        return score + 1.5 * len(own & self.words) / max(1, len(own | self.words))


_CHILD = re.compile(r"<child(?:\s+link\s*=\s*[\"']([^\"']+)[\"']|\s*>\s*([^<>\s]+))")
_JOINT = re.compile(
    r"<joint\s[^<>]*?\bname\s*=\s*[\"']([^\"'<>]+)[\"'](?:(?!</joint).)*?<child>\s*([^<>\s]+)", re.DOTALL
)
_OF_LINKS = {"parent": 3.0, "child": 3.0, "gazebo@reference": 1.0}
"""Where joints can be named, but hardly are."""
_ONCE = frozenset({"child@link", "child"})
"""Where each name is written once in a whole robot."""
_SEMANTIC = frozenset(f"{element}@{attribute}" for element, attribute in srdf.references())
_ONCE_IN_BLOCK = frozenset({"joint@name", "link@name"})
"""Where each is written once in a group, a state or a block of ``ros2_control``."""


def _holder(text: str, context: Context, offset: int) -> list[str]:
    """The names that the element around writes before the cursor, its own first."""
    name = context.around[-1] if context.around else ""
    if name in {context.tag, ""} and context.where is Where.TEXT:
        name = context.around[-2] if len(context.around) > 1 else ""
    start = max(text.rfind(f"<{name} ", 0, offset), text.rfind(f"<{name}>", 0, offset)) if name else -1
    if start < 0 or offset - start > 3000:
        start = text.rfind("<", 0, offset)
    own = text[start:offset] + text[offset : offset + 200].partition("</" + (name or "?"))[0]
    found = re.search(r"\sname\s*=\s*[\"']([^\"']*)[\"']", own)
    others = re.findall(r"(?:link\d?|reference)\s*=\s*[\"']([^\"']+)[\"']|<(?:parent|child)>([^<]+)<", own)
    return [found[1] if found else "", *(a or b.strip() for a, b in others)]


def _joints_to(text: str, link: str) -> set[str]:
    """The joints that move a link: it is often placed where they are."""
    return {joint for joint, child in _JOINT.findall(text) if child == link}


def _block(text: str, context: Context, offset: int) -> str:
    """The text of the element around."""
    name = context.around[-1] if context.around else ""
    start = text.rfind(f"<{name}", 0, offset)
    end = text.find(f"</{name}", offset)
    own = text.rfind("<", 0, offset)
    return text[start:own] + text[text.find(">", offset) : end if end >= 0 else len(text)]


def _nearest(text: str, name: str, offset: int) -> int:
    """How far it is to the nearest place where a name is given, before the cursor rather than after it."""
    given = f'name="{name}"'
    before = text.rfind(given, max(0, offset - _FAR), offset)
    after = text.find(given, offset, offset + _FAR)
    return min(offset - before if before >= 0 else _FAR, 2 * (after - offset) if after >= 0 else _FAR)


_FAR = 60_000


def _in_scope(scope: Namespace, kinds: tuple[str, ...], context: Context) -> Iterator[Item]:
    if isinstance(scope, Model) and scope.is_urdf:
        known: dict[str, Iterable[str]] = {
            "material": scope.material_names.defined,
            "link": scope.tree.links,
            "joint": scope.joints_by_name,
        }
        for kind, names in known.items():
            if kind in kinds:
                yield from (Item(name, Sort.NAME, name, detail=kind, rank=2) for name in names)
        return
    own = _own_name(scope, context)
    for name in scope.names():
        node = scope.resolve(name)
        if node is not None and node.kind in kinds and name != own and node.kind in _NODES:
            rank = 5 if name.startswith("_merged__") else 2 + name.count("::")  # libsdformat's own names
            yield Item(name, Sort.NAME, name, detail=node.kind, rank=rank)
    if context.attribute in _OWN_FRAMES and scope.kind == "model":
        yield Item("__model__", Sort.NAME, "__model__", detail="the model's own frame", rank=4)
    if context.tag in {"parent", "child"} or scope.kind == "world":
        yield Item("world", Sort.NAME, "world", detail="world", rank=4)


def _own_name(scope: Namespace, context: Context) -> str:
    """Parts that cannot refer to themselves."""
    return dict(context.given).get("name", "") if context.where is Where.VALUE else ""


def _scope(document: Document, context: Context, offset: int) -> Namespace | None:
    """The world or model in which a name that is written at a place is looked up."""
    root = root_of(document)
    if root.is_urdf:
        return root.scopes[0]
    element = elements(document).around(offset)
    if element is None:
        element = elements(document).around(max(0, offset - 1))
    if element is None:
        return root.scopes[0] if root.scopes else None
    part = root.part_of(element)
    is_own = isinstance(part, Namespace) and context.attribute in {"canonical_link", "placement_frame"}
    if is_own and isinstance(part, Namespace):
        return part
    found = root.scope_of(element) or (part if isinstance(part, Namespace) else None)
    holder = element.parent
    if found is not None and element.name == "pose" and holder is not None and root.part_of(holder) is found:
        outer = found.holder  # the pose of a model is written where the model is
        return outer if isinstance(outer, Namespace) else found
    return found


def _tags(document: Document, kinds: tuple[str, ...]) -> Iterator[Item]:
    """The names of vendors' own elements."""
    own = {kind for kind in kinds if ":" in kind}
    if not own:
        return
    for element in elements(document).all:
        name = element.attributes.get("name", "")
        if name and element.name in own:
            yield Item(name, Sort.NAME, name, detail=element.name, rank=2)


# The names and values that can be typed at a place.


_EXPRESSION = re.compile(r"\$\{[^}]*?([^\W\d]\w*)?\Z")
_SUBSTITUTION = re.compile(r"\$\((?:(arg|find)\s+)?([^\s)]*)\Z")
_ASKED = re.compile(r"\$\(arg\s+([^\s()$]+)\)")
_NAME = re.compile(r"\sname\s*=\s*([\"'])(.*?)\1")
_MACRO = re.compile(r"<xacro:macro\b(?P<inside>(?:[^<>\"']|\"[^\"]*\"|'[^']*')*)|</xacro:macro")
_FILES = frozenset({"uri", "filename", "albedo_map", "normal_map", "metalness_map", "roughness_map"})
_KINDS = frozenset({Kind.SDF, Kind.URDF, Kind.XACRO, Kind.SRDF, Kind.BROKEN_XML, Kind.EMPTY})
_KEYWORDS = {
    "xacro:if": 0.15,
    "xacro:property": 0.13,
    "xacro:unless": 0.11,
    "xacro:insert_block": 0.1,
    "xacro:include": 0.1,
}
"""The elements that can be written next to calls anywhere, and how likely that is."""
MANY = 8
"""Of so many words one often follows the one before it."""
_BEFORE_END = 5
"""So many elements are suggested before the end of the one around."""


class Completion(NamedTuple):
    """The items that are offered in place of the text from ``start`` to ``end``, the likeliest first."""

    items: tuple[Item, ...]
    start: int
    end: int


def complete(workspace: Workspace, buffer: Buffer, offset: int) -> Completion:
    """The items at a place of an open text; none in a text that is not a description."""
    where = context(buffer.source.text, offset, buffer.checkpoints)
    if buffer.kind not in _KINDS and where.around:
        return Completion((), offset, offset)
    return _Completer(workspace, buffer, where, offset).run()


class _Completer:
    def __init__(self, workspace: Workspace, buffer: Buffer, where: Context, offset: int) -> None:
        self.workspace = workspace
        self.buffer = buffer
        self.where = where._replace(around=without_conditions(where.around))
        self.written = where.around
        self.offset = offset
        is_robot = where.around[:1] == ("robot",) or where.tag == "robot"
        is_robot = is_robot or (buffer.kind is Kind.XACRO and where.around[:1] not in {(), ("sdf",)})
        self.is_srdf = buffer.kind is Kind.SRDF and is_robot
        self.is_urdf = is_robot and not self.is_srdf
        self.is_xacro = buffer.kind is Kind.XACRO or "xmlns:xacro" in buffer.source.text[:4096]
        self.dialect = "srdf" if self.is_srdf else "urdf" if self.is_urdf else "sdf"
        version = _VERSION.search(buffer.source.text, 0, 4096)
        self.version = (Version.parse(version[1]) if version else None) or NEWEST
        self.parameters: list[Item] = []
        """Those of the plugin around the place."""
        self.held: Mapping[str, float] = {}
        """How often such plugins have each of them."""
        self._usage: Usage | None = None

    @property
    def vendors(self) -> Sequence[Vendor]:
        """The tables of vendors' own elements."""
        return vendors(self.workspace.library(self.buffer.path), "urdf" if self.is_urdf else "sdf")

    @property
    def usage(self) -> Usage:
        """The habits of the text around the place."""
        if self._usage is None:
            is_choice = self.written[-1:] != self.where.around[-1:]
            self._usage = Usage(self.buffer.source.text, self.where, self.offset, is_choice=is_choice)
        return self._usage

    def run(self) -> Completion:
        where = self.where
        if where.where is Where.NOWHERE:
            return Completion((), self.offset, self.offset)
        if where.where is Where.END:
            return self._of(map(_end, self.written[-1:]))
        if where.where is Where.TAG:
            return self._of(self._elements())
        if where.where is Where.ATTRIBUTE:
            return self._of(self._attributes())
        if self.is_xacro and (found := self._in_expression()) is not None:
            return found
        if where.where is Where.VALUE:
            return self._of(self._values())
        return self._in_text()

    def _of(self, items: Iterable[Item], start: int | None = None) -> Completion:
        unique: dict[str, Item] = {}
        for item in items:
            unique.setdefault(item.label, item)
        typed = self.where.typed if start is None else self.buffer.source.text[start : self.offset]
        order = sorted(unique.values(), key=lambda item: not item.label.startswith(typed))
        return Completion(tuple(order), self.where.start if start is None else start, self.offset)

    @property
    def visible(self) -> list[Definitions]:
        """The definitions that a xacro file can see, itself and in the robots that include it."""
        document = self._document
        return [visible_definitions(each) for each in (document, *roots_of(document))]

    @property
    def _document(self) -> Document:
        document = self.workspace.document(self.buffer.path)
        assert document is not None
        return document

    @property
    def project(self) -> Project:
        """The words of the xacro files of the project."""
        return self.workspace.library(self.buffer.path).of_project(self.buffer.path, Project)

    @property
    def habits(self) -> Habits:
        """The plugins and versions in the other files of the project."""
        return self.workspace.library(self.buffer.path).of_project(self.buffer.path, Habits)

    @property
    def macros(self) -> Macros:
        """The macros that a file can see, or could if packages were found."""
        return {**self.project.included(self.buffer.source.text), **macros_in(self.visible)}

    def _elements(self) -> list[Item]:
        around = self.where.around
        found: list[Item] = []
        if self.is_srdf:
            found += semantic_elements(around)
        else:
            found += element_items(around, self.version, self.vendors)
        plugin = plugin_around(self.buffer.source.text, around, self.offset)
        if plugin:
            self.held = self.habits.shares(plugin, self.buffer.path, self.buffer.source.text, self.offset)
            self.parameters = [*parameter_items(plugin, self.held)]
            found += self.parameters
        is_known = bool(found)
        if self.is_xacro and around:
            macros = self.macros
            if around[-1].startswith("xacro:") and around[-1].removeprefix("xacro:") not in KEYWORDS:
                found = [*block_items(around[-1], {**self.project.macros, **macros})]
            found += xacro_elements(macros)
        found += seen_items(self.usage.seen_elements(), "in this file")
        if not is_known or around[-1:] == ("plugin",):
            found += seen_items(usual.children(self.dialect, around[-1] if around else ""), "")
        return self._with_end(self._sorted_elements(found))

    def _sorted_elements(self, items: Iterable[Item]) -> list[Item]:
        unique: dict[str, Item] = {}
        for item in items:
            unique.setdefault(item.label, item)
        repeatable = {item.label for item in unique.values() if item.is_repeatable}
        scores = self.usage.elements(unique, self.dialect, repeatable, self.where.typed)
        if self.is_xacro:
            macros = [item.label for item in unique.values() if item.sort is Sort.MACRO]
            scores = {**scores, **dict(self._calls(macros, scores))}
            scores |= {f"xacro:{name}": -1.0 for name in self._open_macros()}
        present = {*self.usage.before, *self.usage.after}
        needed = {item.label for item in unique.values() if item.rank == 1 and item.label not in present}
        styles = set(map(_style, present)) - {""}
        read = {item.label for item in self.parameters} - present
        read = {name for name in read if not styles or _style(name) in {"", *styles}}
        own = {name: (name in needed) + (name in read) + self.held.get(name, 0.0) for name in scores}
        more = ((name, score + own[name]) for name, score in scores.items())
        return _ordered(unique.values(), dict(more))

    def _open_macros(self) -> dict[str, tuple[Parameter, ...]]:
        """The macros that the place is in, which do not call themselves, and their parameters."""
        found: list[tuple[str, tuple[Parameter, ...]]] = []
        for macro in _MACRO.finditer(self.buffer.source.text, 0, self.offset):
            if macro["inside"] is not None:
                name, given = _NAME.search(macro["inside"]), _PARAMETERS.search(macro["inside"])
                found.append((name[2] if name else "", tuple(parameters(given[2] if given else ""))))
            elif found:
                found.pop()
        return dict(found)

    def _calls(self, macros: Sequence[str], scores: Mapping[str, float]) -> Iterator[tuple[str, float]]:
        """How likely calls are: rather of macros that nobody calls yet, and that are called like their neighbors."""
        called = {
            f"xacro:{call.name}" for each in self.visible for read in each.readings for call in read.calls
        }
        new = [name for name in macros if name not in called]
        # Elsewhere than in robots and macros, elements of the format are likelier, as long as nothing is typed.
        share = 1.0 if self.where.typed or self.where.around[-1:] in {("robot",), ("xacro:macro",)} else 0.1
        near = words_in(" ".join([*self.usage.before[-1:], *self.usage.after[:1]]))
        files = _INCLUDED.findall(self.buffer.source.text, max(0, self.offset - 1000), self.offset)
        is_after = self.usage.before[-1:] == ["xacro:include"]
        file = words_in(files[-1].rpartition("/")[2]) if files and is_after else set[str]()
        for name in macros:
            own = words_in(name)
            alike = len(own & near) / max(1, len(own | near))
            included = len(own & file) / max(1, len(own))
            rest = 0.4 * (name in new) / max(1, len(new)) + 0.1 * alike
            yield name, scores[name] + share * (included + rest)
        opening = self.buffer.source.text.rfind("<", 0, self.offset)
        is_other = self.buffer.source.text[:opening].rstrip().endswith("</xacro:if>")
        for name, often in _KEYWORDS.items():
            if name in scores:
                yield name, scores[name] + share * (often + 0.5 * (is_other and name == "xacro:unless"))

    def _with_end(self, items: list[Item]) -> list[Item]:
        if self.written:
            items.insert(min(_BEFORE_END, len(items)), _end(f"/{self.written[-1]}"))
        return items

    def _attributes(self) -> list[Item]:
        tag = self.where.tag
        found: list[Item] = []
        if self.is_srdf:
            found += semantic_attributes(self.where)
        elif not tag.startswith("xacro:"):
            found += attribute_items(self.where, self.version, self.vendors)
        if self.is_xacro and tag.startswith("xacro:"):
            found += xacro_attributes(self.where, {**self.project.macros, **self.macros})
        if tag == "robot" and "xmlns:xacro" not in dict(self.where.given):
            text = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
            found.append(Item("xmlns:xacro", Sort.ATTRIBUTE, text, rank=6))
        found += seen_attributes(self.usage.seen_attributes(tag), self.where)
        needed = {item.label for item in found if item.rank == 1}
        scores = self.usage.attribute_scores(tag, {item.label for item in found}, self.dialect)
        return _ordered(found, {name: score + 2 * (name in needed) for name, score in scores.items()})

    def _values(self) -> list[Item]:
        where = self.where
        place = f"{where.tag}@{where.attribute}" if where.attribute else where.tag
        given = semantic_values(where) if self.is_srdf else value_items(where, self.version, self.vendors)
        choices = list(given)
        choices += self._usual_words(place, {item.label for item in choices})
        scores = self.usage.word_scores(place, {item.label for item in choices}, self.dialect)
        labels = [item.label for item in choices]
        last = self.usage.neighbors(place, self.offset)[0][:1] if len(labels) > MANY else []
        if last and last[0] in labels[:-1]:  # words that are written one after the other
            scores[labels[labels.index(last[0]) + 1]] += 1
        near = words_in(" ".join(value for _, value in where.given))
        own = plugins.file_of_class(dict(where.given).get("name", "")) if place == "plugin@filename" else None
        for n, version in enumerate(self.habits.versions(self.buffer.path) if place == "sdf@version" else ()):
            scores[version] = scores.get(version, 0.0) + 1 / (1 + n)
        for name in scores:
            words = words_in(name)
            scores[name] += len(words & near) / len(words) if words else 0.0
            scores[name] += 2 * (own is not None and plugins.stem(name) == own)
        found = _ordered(choices, scores)
        kinds = wanted(where, self.dialect, self.vendors)
        is_file = (where.attribute or where.tag) in _FILES and where.tag != "plugin"
        # Reading a long text takes a while.
        document = self.workspace.document(self.buffer.path) if kinds or is_file else None
        if document is not None and kinds:
            found += name_items(self.workspace, document, where, self.offset, self.usage, kinds)
        if self.is_xacro and where.tag == "xacro:insert_block" and where.attribute == "name":
            found += self._blocks()
        if document is not None and is_file:
            found += self._alike(path_items(document, where.typed, where.tag, where.around), place)
        if self.is_xacro and where.where is Where.VALUE and "$" not in where.typed:
            found += command_items()
        return found

    def _alike(self, files: Iterable[Item], place: str) -> list[Item]:
        """Files, those first that are called like what is around, as one that is used next to the place is."""
        text, typed = self.buffer.source.text, self.where.typed
        named = [found[2] for found in _NAME.finditer(text, max(0, self.offset - 2000), self.offset)]
        before, after = self.usage.neighbors(place, self.offset)
        near = [*named[:-4:-1], self.buffer.path.name]
        head = typed.rpartition("/")[0]
        used = [each for each in (*before, *after) if each.startswith(head)]
        ends = {os.path.splitext(each)[1] for each in before[:1]}
        items, scores = list(files), dict[str, float]()
        for item in items:
            own = words_in(item.label[len(head) :])
            shares = (len(own & (other := words_in(name))) / max(1, len(own | other)) for name in near)
            likeness = (share / n for n, share in enumerate(shares, 1))
            scores[item.label] = (
                2 * max(likeness, default=0.0) + (item.label in before[:1]) - (item.label in used)
            )
            scores[item.label] += os.path.splitext(item.label)[1] in ends
        return _ordered(items, scores)

    def _blocks(self) -> Iterator[Item]:
        """The properties that hold elements."""
        for visible in self.visible:
            for name, values in visible.given.items():
                if any(each.value is None and each.element.nodes for each in values):
                    yield Item(name, Sort.NAME, name, detail="property", rank=2)

    def _usual_words(self, place: str, known: set[str]) -> Iterator[Item]:
        """Words for a place whose words are not in the format, or that the text has there."""
        if place.endswith(("_interface@name", "hardwareInterface", "@reason")):
            yield from (
                Item(word, Sort.CHOICE, word) for word in dict.fromkeys(self.usage.seen_values(place))
            )
        if place == "plugin@filename":
            seen = dict.fromkeys([*self.usage.seen_values(place), *self.habits.others(self.buffer.path)])
            yield from (Item(file, Sort.FILE, file, detail="in this project", rank=4) for file in seen)
        if known and known <= {"true", "false"}:
            if self.usage.has_digits:
                yield from (Item(word, Sort.CHOICE, word) for word in ("1", "0"))
        elif not known:
            yield from (Item(word, Sort.CHOICE, word) for word in usual.words(self.dialect, place))

    def _in_text(self) -> Completion:
        """Values for an element that holds text, elements for one that holds elements."""
        found = self._of(self._values())
        if found.items or (self.where.typed and not self.where.typed[0].isalpha()):
            return found
        elements = (
            each._replace(text=f"<{each.text}", snippet=each.snippet and f"<{each.snippet}")
            for each in self._elements()
        )
        return self._of(elements)

    def _in_expression(self) -> Completion | None:
        """The names that an expression of xacro can use."""
        typed = self.where.typed
        if "$" not in typed:
            return None
        if "$(" not in typed[typed.rfind("${") :] and (found := _EXPRESSION.search(typed)) is not None:
            visible = self.visible
            own = {one.name.lstrip("*") for macro in self._open_macros().values() for one in macro}
            names = {name for each in visible for name in each.properties if name}
            word = found[1] or ""
            items = self._words_of_expressions(names | own, own, r"\$\{[^}]*\}", r"[^\W\d]\w*")
            return self._of(items, self.offset - len(word))
        if (found := _SUBSTITUTION.search(typed)) is not None and found[1]:
            text, path = self.buffer.source.text, self.buffer.path
            if found[1] == "arg":
                own = {name for each in self.visible for read in each.readings for name in read.arguments}
                names = {*_ASKED.findall(text), *self.project.arguments, *launched_names(self._document)}
            else:
                own = set(self.workspace.library(path).packages(path).names)
                names = {*_FOUND.findall(text), *self.project.found_by_others(path)}
            items = self._words_of_expressions(names | own, own, r"\$\([^)]*\)", r"[^\s()$]+")
            return self._of(items, self.offset - len(found[2]))
        return None

    def _words_of_expressions(self, names: set[str], own: set[str], expression: str, word: str) -> list[Item]:
        """Names for an expression: those that expressions nearby or in such places use, ``own`` ones, and those that
        are called like the place.
        """
        place = [value for _, value in self.usage.values.get(place_of(self.where), ()) if "$" in value]
        there = Counter(found for value in place for found in set(re.findall(word, value)))
        text, start = self.buffer.source.text, max(0, self.offset - 4000)
        scores = dict.fromkeys(names, 0.0)
        attribute = self.where.attribute
        near = {attribute} | words_in(
            f"{attribute} {self.where.tag} {dict(self.where.given).get('name', '')}"
        )
        uses = Counter(
            found for match in re.findall(expression, text) for found in set(re.findall(word, match))
        )
        most = max((uses[name] for name in names), default=0) or 1
        flags = self._flags() if self.where.tag in {"xacro:if", "xacro:unless"} else set()
        for match in re.finditer(expression, text[start : self.offset + 4000]):
            distance = abs(start + match.start() - self.offset)
            for found in re.findall(word, match[0]):
                if found in scores:
                    scores[found] += 20 / (20 + distance)
                    near |= words_in(found) if distance < 300 else set()
        for name in names:
            parts = words_in(name) or {name}
            scores[name] += 2 * len(parts & near) / max(1, len(parts)) + (name == attribute)
            scores[name] += (name in own) / 2 + 1.5 * there[name] / max(1, len(place))
            scores[name] += 1.0 if uses[name] == 0 else (uses[name] - 1) / most
            scores[name] += 1.5 * name.endswith(f"_{attribute}") + 0.5 * (name in flags)
        return _ordered((Item(name, Sort.PROPERTY, name) for name in sorted(names)), scores)

    def _flags(self) -> set[str]:
        """The arguments that are true or false by default."""
        read = (each for visible in self.visible for each in visible.readings)
        known = ((name, default) for each in read for name, default in each.arguments.items())
        return {name for name, default in known if default.strip().lower() in {"true", "false", "0", "1"}}


def _ordered(items: Iterable[Item], scores: Mapping[str, float]) -> list[Item]:
    """Items, the likeliest first, then by rank."""
    return sorted(items, key=lambda item: (-round(scores.get(item.label, 0.0), 3), item.rank))


def _style(name: str) -> str:
    """How a name of several words is put together; empty where it is of one."""
    return "snake" if "_" in name else "camel" if name != name.lower() else ""


def _end(name: str) -> Item:
    return Item(name, Sort.ELEMENT, f"{name}>", f"{name}>", "end tag", 0 if name[0] != "/" else 4)
