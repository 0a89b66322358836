"""Includes replaced by what they bring.

The children of an include (name, pose, static, placement frame, plugins) take precedence over those
of the included file. A merged model leaves a frame in place of its own, by the name that
libsdformat gives it.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from sdfcheck.convert.loss import Loss, LossKind, NotConvertible, loss_at
from sdfcheck.convert.result import Conversion
from sdfcheck.convert.writer import numbers, render
from sdfcheck.files.uris import locate, scheme_of
from sdfcheck.formats.sdf.survey import PARAMETERS, version_of
from sdfcheck.formats.version import Version
from sdfcheck.robot.includes.included import (
    Included,
    included,
    included_element,
    includes_of,
    with_parameters,
)
from sdfcheck.robot.motion.poses import to_rpy
from sdfcheck.robot.naming.name import MODEL_FRAME
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Altered, Xml, copied
from sdfcheck.source.document import Document, Element, Node
from sdfcheck.source.problems import SyntaxDefect
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, relative_path

# Includes replaced by what they bring.
#
# The children of an include (name, pose, static, placement frame, plugins) take precedence over those of the
# included file. A merged model leaves a frame in place of its own, by the name that libsdformat gives it.


# Files that were found beside an included file, as found from the file that includes it.


_FILES = frozenset(("color_range_image", "cubemap_uri", "diffuse", "filename", "normal", "texture", "uri"))


def relocated(name: str, text: str, found: Included, document: Document) -> str | None:
    """The new content of an element of that name; None if it can stay."""
    assert found.document is not None
    if name not in _FILES and not name.endswith("_map"):
        return None
    folder = found.document.path.parent
    if not text or scheme_of(text) or Path(text).is_absolute() or not os.path.exists(folder / text):
        return None
    return _seen_from(document, found, folder / text)


def _seen_from(document: Document, found: Included, file: Path) -> str:
    assert found.uri is not None
    uri = found.uri.text.strip()
    place = locate(document, uri).path
    if scheme_of(uri) in {"model", "package"} and place is not None:
        if os.path.isdir(place):
            return f"{uri.rstrip('/')}/{Path(relative_path(file, place)).as_posix()}"
        if file.is_relative_to(place.parent):
            return f"{uri.rpartition('/')[0]}/{file.relative_to(place.parent).as_posix()}"
    return Path(relative_path(file, document.path.parent)).as_posix()


_MERGED = frozenset(("frame", "gripper", "include", "joint", "link", "model", "plugin"))
_FREE = frozenset(("plugin",))
_OVERRIDES = ("pose", "static")

ToSdf = Callable[[Document, Version], Conversion]
"""Converts what is included to the version of the file that includes it."""


class IncludeExpansion:
    """Expands the includes of one document; ``notes`` say which are left, and why.

    With ``keeps_models`` what an included file includes as a model of its own stays an include.
    """

    def __init__(self, to_sdf: ToSdf, *, keeps_models: bool = False) -> None:
        self.to_sdf = to_sdf
        self.keeps_models = keeps_models
        self.notes: list[str] = []
        self.losses: list[Loss] = []
        self.expanded: list[Element] = []
        """The includes that were replaced."""

    def expand(self, element: Xml, document: Document, chain: tuple[Document, ...] = ()) -> None:
        """Replace all includes in an element that was copied from a document."""
        for child in element.children():
            if child.name in _FREE or ":" in child.name:
                continue
            if child.name != "include":
                self.expand(child, document, chain)
                continue
            if chain and self.keeps_models and _is_complete(child):
                continue
            if nodes := self._replacement(child, element.name, document, (*chain, document)):
                element.replace(child, *nodes)

    def replacement(self, include: Element) -> list[Xml]:
        """The elements that replace one include; empty if it has to stay."""
        assert include.parent is not None
        document = include.document
        nodes = self._replacement(copied(include), include.parent.name, document, (document,))
        return [node for node in nodes if isinstance(node, Xml)]

    def _replacement(
        self, include: Xml, parent: str, document: Document, chain: tuple[Document, ...]
    ) -> list[Node]:
        """The comments of an include, and what it brings; ``parent`` is the name of what it is in."""
        assert include.origin is not None
        found = included(document, include.origin)
        obstacle = _obstacle(found, chain)
        if found.model is None or found.document is None or obstacle:
            self._keep(include.origin, found, obstacle, chain)
            return []
        so_far = len(self.expanded)
        try:
            model = self._in_version(found, version_of(document))
            brought = copied(model)
            self.expand(brought, model.document, chain)
        except _Stays as error:
            del self.expanded[so_far:]
            self._keep(include.origin, found, str(error), chain)
            return []
        if model is not found.model:
            for part in brought.walk():  # its places are in no file
                part.origin = include.origin
        self.expanded.append(include.origin)
        self._report_root(model)
        _relocate(brought, found, document)
        _declare(brought, model, include.origin)
        parts = _merged(brought, include, found, parent) if found.merge else [_whole(brought, include, found)]
        return [*(node for node in include.nodes if not isinstance(node, Element)), *parts]

    def _keep(self, include: Element, found: Included, why: str, chain: tuple[Document, ...]) -> None:
        """Leave an include as it is; one that parameters outside of it have changed needs that one to stay."""
        self.notes.append(f"{_place(include)}: the include stays: {why}")
        is_copy = len(chain) > 1 and isinstance(include.document, Altered)
        if is_copy and found.model is not None and isinstance(found.model.document, Altered):
            raise _Stays(f"its {PARAMETERS} change an include that stays")

    def _report_root(self, model: Element) -> None:
        """Custom data of an included file that is not in its model stays there."""
        at = model.parent
        while at is not None:
            custom = [child for child in at.children() if child.is_custom and child is not model]
            names = [name for name in at.attributes if ":" in name]
            for child in custom:
                text = f"`{child.name}` in `{at.name}` of the included file is left out"
                self.losses.append(loss_at(child, LossKind.DROPPED_ELEMENT, text))
            for name in names:
                text = f"attribute `{name}` of `{at.name}` in the included file is left out"
                self.losses.append(loss_at(at, LossKind.DROPPED_ELEMENT, text))
            at = at.parent

    def _in_version(self, found: Included, version: Version) -> Element:
        """The parts of an include, in the version of the file that includes it; raises _Stays."""
        assert found.document is not None
        assert found.model is not None
        if found.document.kind is Kind.SDF and version_of(found.document) == version:
            return found.model
        converted = self._converted(found, version)
        model = included_element(converted)
        assert model is not None
        if found.model.name == "robot":  # they change what it is converted to
            model = with_parameters(found._replace(document=converted, model=model)).model
            assert model is not None
        return model

    def _converted(self, found: Included, version: Version) -> Document:
        assert found.document is not None
        assert found.model is not None
        document = found.model.document
        if isinstance(document, Altered):
            if found.model.name == "robot":
                raise _Stays(f"{PARAMETERS} of another include change this URDF")
            document = Altered(document)
            finish(document)
        try:
            conversion = self.to_sdf(document, version)
        except NotConvertible as error:
            raise _Stays(str(error)) from None
        verification = conversion.verification
        if verification is not None and not verification.is_equal:
            raise _Stays(f"{found.document.path} would be another robot in SDFormat {version}")
        for loss in conversion.losses:
            self.losses.append(loss)
            begin = loss.span.begin
            self.notes.append(f"{loss.span.source.path}:{begin.line}: in SDFormat {version}: {loss.message}")
        converted = Document(Source(found.document.path, conversion.text), Kind.SDF, [])
        converted.library = found.document.library
        return converted


class _Stays(Exception):
    """Why an include cannot be replaced."""


def finish(document: Altered) -> None:
    """Make the tree of a document, as it was changed, and its text go together again."""
    assert document.root is not None
    document.number()
    text = render(document.root, document.prolog, document.epilog, keeps_lines=True)
    document.source = Source(document.path, text)


def expanded(document: Document, to_sdf: ToSdf) -> tuple[Document, IncludeExpansion]:
    """The document with its includes replaced, and what became of them; itself if none was."""
    expansion, made = IncludeExpansion(to_sdf), Altered(document)
    assert made.root is not None
    expansion.expand(made.root, document)
    if not expansion.expanded:
        return document, expansion
    finish(made)
    return made, expansion


def needs_writing_out(document: Document) -> bool:
    """Does a document include URDF, itself or in what it includes?"""
    seen: list[Document] = []
    waiting = [document]
    while waiting:
        at = waiting.pop()
        seen.append(at)
        for include in includes_of(at):
            found = included(at, include)
            if found.model is None or found.document is None:
                continue
            if found.model.name == "robot":
                return True
            if found.document not in seen:
                waiting.append(found.document)
    return False


def _is_complete(include: Xml) -> bool:
    """Can an include be moved with what it is in? Without a pose it would be placed anew."""
    merges = include.attributes.get("merge", "").strip().lower() in {"true", "1"}
    return not merges and include.find("pose") is not None and include.find(PARAMETERS) is None


def _place(element: Element) -> str:
    return f"{element.document.path}:{element.span.begin.line}"


def _obstacle(found: Included, chain: tuple[Document, ...]) -> str:
    uri = f"`{found.uri.text.strip()}`" if found.uri is not None else "it"
    if found.model is None or found.document is None:
        return f"{uri} brings nothing ({found.obstacle.value if found.obstacle else 'unreadable'})"
    if any(isinstance(problem, SyntaxDefect) for problem in found.document.problems):
        return f"{uri} is broken; `sdfcheck lint` says how"
    if found.faults:
        return f"its {PARAMETERS} are at fault; `sdfcheck lint` says how"
    own = os.path.realpath(found.document.path)
    if any(os.path.realpath(outer.path) == own for outer in chain):
        return f"{uri} includes itself"
    if found.name is None:
        return f"{uri} brings a model without name"
    return ""


def _whole(brought: Xml, include: Xml, found: Included) -> Xml:
    """The model, light or actor with what the include says of it."""
    brought.attributes["name"] = found.name or ""
    for name in _OVERRIDES:
        given = include.find(name)
        if given is not None:
            brought.put(given)
    placement = include.find("placement_frame")
    if placement is not None and placement.content:
        brought.attributes["placement_frame"] = placement.content
    brought.extend(*_given(include))
    _give_custom(brought, include)
    return brought


def _give_custom(element: Xml, *others: Xml) -> None:
    """Hand on the custom attributes of the elements that one replaces."""
    for other in others:
        for name, text in other.attributes.items():
            if ":" in name and not name.startswith("xmlns:"):
                element.attributes.setdefault(name, text)


def _merged(brought: Xml, include: Xml, found: Included, parent: str) -> list[Xml]:
    """The parts of a model that is merged, after the frame that replaces it."""
    name = f"_merged__{found.name}__model__"
    frame = Xml("frame", name=name)
    first = next((child for kind in ("link", "model") for child in brought.children(kind)), None)
    link = brought.attributes.get("canonical_link", "").strip() or (first.attributes["name"] if first else "")
    if link:
        frame.attributes["attached_to"] = link
    pose = include.find("pose") or brought.find("pose") or Xml("pose", "0 0 0 0 0 0")
    pose.attributes.setdefault("relative_to", "world" if parent == "world" else MODEL_FRAME)
    placement = include.find("placement_frame")
    if (placement is not None and placement.content) or brought.attributes.get("placement_frame", "").strip():
        pose = _placed(found, name)
    frame.append(pose)
    _give_custom(frame, include, brought)
    parts = [child for child in brought.children() if child.name in _MERGED or ":" in child.name]
    prefixes = {key: uri for key, uri in brought.attributes.items() if key.startswith("xmlns:")}
    for part in (frame, *parts):
        if part is not frame:
            _settle(part, name)
        used = _prefixes(part)
        part.attributes.update({key: uri for key, uri in prefixes.items() if key[6:] in used})
    return [frame, *parts, *_given(include)]


def _given(include: Xml) -> list[Xml]:
    """The plugins and custom elements of an include, but for orders to its consumer."""
    return [
        child
        for child in include.children()
        if child.name == "plugin" or (child.is_custom and child.name != PARAMETERS)
    ]


def _placed(found: Included, name: str) -> Xml:
    """The pose of a merged model's own frame where another frame of it is placed."""
    document = found.include.document
    scope = root_of(document).scope_of(found.include)
    assert scope is not None
    own = scope.root.poses.in_scope(scope.nodes[name])
    relative_to = "world" if scope.kind == "world" else MODEL_FRAME
    return Xml("pose", numbers((*own[:3, 3], *to_rpy(own[:3, :3]))), relative_to=relative_to)


def _settle(part: Xml, name: str) -> None:
    """Parts that were relative to the model's own frame refer to the frame in its place."""
    _rename_frame(part, name)
    if part.name == "frame" and not part.attributes.get("attached_to", "").strip():
        part.attributes["attached_to"] = name
    elif part.name in {"include", "link", "model"}:
        pose = part.find("pose")
        if pose is None:
            pose = Xml("pose", "0 0 0 0 0 0")
            part.put(pose)
        if not pose.attributes.get("relative_to", "").strip():
            pose.attributes["relative_to"] = name


def _rename_frame(part: Xml, name: str) -> None:
    for attribute in ("attached_to", "expressed_in", "relative_to"):
        if part.attributes.get(attribute, "").strip() == MODEL_FRAME:
            part.attributes[attribute] = name
    if part.name in {"child", "parent"} and part.content == MODEL_FRAME:
        part.write(name)
    for child in part.children():
        if child.name in _FREE or ":" in child.name:
            continue
        if part.name != "model" or child.name == "pose":  # a nested model has a frame of its own
            _rename_frame(child, name)


def _relocate(brought: Xml, found: Included, document: Document) -> None:
    for part in brought.walk():
        text = relocated(part.name, part.content, found, document)
        if text is not None:
            part.write(text)


def _declare(brought: Xml, model: Element, include: Element) -> None:
    """Declare the prefixes that the model uses and only its own file declares."""
    there, here = model.namespaces, include.namespaces
    for prefix in sorted(_prefixes(brought)):
        uri = there.get(prefix)
        if uri is not None and here.get(prefix) != uri:
            brought.attributes.setdefault(f"xmlns:{prefix}", uri)


def _prefixes(element: Xml) -> set[str]:
    names = [name for one in element.walk() for name in (one.name, *one.attributes)]
    return {name.partition(":")[0] for name in names if ":" in name and not name.startswith("xmlns:")}
