"""Includes replaced by what they bring."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

from sdfcheck.convert.loss import Loss, LossKind, NotConvertible, loss_at
from sdfcheck.convert.result import Conversion
from sdfcheck.convert.rewrite.tidy import Branch, Remark, branch_of, render
from sdfcheck.convert.writer import numbers
from sdfcheck.files.uris import locate, scheme_of
from sdfcheck.formats.sdf.survey import PARAMETERS, survey
from sdfcheck.formats.version import Version
from sdfcheck.robot.includes.included import Included, included, included_element, with_parameters
from sdfcheck.robot.motion.rotations import to_rpy
from sdfcheck.robot.reserved import MODEL_FRAME
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Altered
from sdfcheck.source.document import Document, Element, Spans
from sdfcheck.source.problems import SyntaxDefect
from sdfcheck.source.relative import relative_path
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span

# Files that were found beside an included file, as found from the file that includes it.


_FILES = frozenset(("diffuse", "environment_map", "filename", "light_map", "normal", "uri"))


def relocated(name: str, text: str, found: Included, document: Document) -> str | None:
    """The new content of an element of that name; None if it can stay."""
    assert found.document is not None
    if name not in _FILES and not name.endswith("_map"):
        return None
    folder = found.document.path.parent
    if not text or scheme_of(text) or Path(text).is_absolute() or not (folder / text).exists():
        return None
    return _seen_from(document, found, folder / text)


def _seen_from(document: Document, found: Included, file: Path) -> str:
    assert found.uri is not None
    uri = found.uri.text.strip()
    place = locate(document, uri).path
    if scheme_of(uri) in {"model", "package"} and place is not None:
        if place.is_dir():
            return f"{uri.rstrip('/')}/{Path(relative_path(file, place)).as_posix()}"
        if file.is_relative_to(place.parent):
            return f"{uri.rpartition('/')[0]}/{file.relative_to(place.parent).as_posix()}"
    return Path(relative_path(file, document.path.parent)).as_posix()


# Includes replaced by what they bring.
#
# The children of an include (name, pose, static, placement frame, plugins) take precedence over those
# of the included file. A merged model leaves a frame in place of its own, by the name that
# libsdformat gives it.


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

    def expand(self, branch: Branch, document: Document, chain: tuple[Document, ...] = ()) -> None:
        """Replace all includes below a branch that was copied from a document."""
        parts: list[Branch | Remark | str] = []
        for part in branch.parts:
            if not isinstance(part, Branch) or part.name in _FREE or ":" in part.name:
                parts.append(part)
            elif part.name != "include":
                self.expand(part, document, chain)
                parts.append(part)
            elif chain and self.keeps_models and _is_complete(part):
                parts.append(part)
            else:
                parts += self._replaced(part, branch, document, (*chain, document))
        branch.parts = parts

    def replacement(self, include: Element) -> list[Branch]:
        """The nodes that replace one include; empty if it has to stay."""
        assert include.parent is not None
        document, own = include.document, branch_of(include)
        parts = self._replaced(own, Branch(include.parent.name), document, (document,))
        return [part for part in parts if isinstance(part, Branch) and part is not own]

    def _replaced(
        self, include: Branch, parent: Branch, document: Document, chain: tuple[Document, ...]
    ) -> list[Branch | Remark | str]:
        assert include.origin is not None
        found = included(document, include.origin)
        obstacle = _obstacle(found, chain)
        if found.model is None or found.document is None or obstacle:
            return self._kept(include, found, obstacle)
        so_far = len(self.expanded)
        try:
            model = self._in_version(found, survey(document).version)
            brought = branch_of(model)
            self.expand(brought, model.document, chain)
        except _Stays as error:
            del self.expanded[so_far:]
            return self._kept(include, found, str(error))
        if model is not found.model:
            for branch in brought.walk():  # its places are in no file
                branch.origin = include.origin
        self.expanded.append(include.origin)
        self._report_root(model)
        _relocate(brought, found, document)
        _declare(brought, model, include.origin)
        result: list[Branch | Remark | str] = [part for part in include.parts if isinstance(part, Remark)]
        for remark in result:
            assert isinstance(remark, Remark)
            remark.beside = False
        parts = _merged(brought, include, found, parent) if found.merge else [_whole(brought, include, found)]
        parts[0].after_gap = include.after_gap and not result
        return [*result, *parts]

    def _kept(self, include: Branch, found: Included, why: str) -> list[Branch | Remark | str]:
        """The include as it is; one that parameters outside of it have changed needs that one to stay."""
        assert include.origin is not None
        self.notes.append(f"{_place(include.origin)}: the include stays: {why}")
        is_copy = isinstance(include.origin.document, Altered)
        if is_copy and found.model is not None and isinstance(found.model.document, Altered):
            raise _Stays(f"its {PARAMETERS} change an include that stays")
        return [include]

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
        if found.document.kind is Kind.SDF and survey(found.document).version == version:
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
            assert document.root is not None
            document = Rendered(document, branch_of(document.root))
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


class Rendered(Document):
    """The text of a branch as a document; every place in it is the name of what an element was read from."""

    def __init__(self, document: Document, root: Branch) -> None:
        super().__init__(Source(document.path, render(root, document)), document.kind, [])
        self.library = document.library
        self.included_by = document.included_by
        self._sources = _sources(root, document.root)

    @property
    def spans(self) -> Spans:
        if self._spans is None:
            self._spans = _Borrowed(self, self._sources)
        return self._spans

    @property
    def is_expanded(self) -> bool:
        return True


class _Borrowed(Spans):
    """Every place in an element is the name of the element that it was read from."""

    def __init__(self, document: Rendered, sources: list[Element]) -> None:
        super().__init__(document.source, document.scan)
        self._of = dict(zip(document.elements, sources, strict=True))

    def span(self, element: Element, start: int, end: int) -> Span:
        return self._of[element].span


def _sources(root: Branch, fallback: Element | None) -> list[Element]:
    """For each element what it was read from, or what around it was."""
    found: list[Element] = []
    waiting = [(root, fallback)]
    while waiting:
        branch, around = waiting.pop()
        source = branch.origin if branch.origin is not None else around
        assert source is not None
        found.append(source)
        waiting += [(child, source) for child in reversed(list(branch.children))]
    return found


def expanded(document: Document, to_sdf: ToSdf) -> tuple[Branch, IncludeExpansion]:
    """The tree of a document with its includes replaced, and what became of them."""
    assert document.root is not None
    root, expansion = branch_of(document.root), IncludeExpansion(to_sdf)
    expansion.expand(root, document)
    return root, expansion


def _is_complete(include: Branch) -> bool:
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


def _whole(brought: Branch, include: Branch, found: Included) -> Branch:
    """The model, light or actor with what the include says of it."""
    brought.attributes["name"] = found.name or ""
    for name in _OVERRIDES:
        given = include.find(name)
        if given is not None:
            brought.put(given)
    placement = include.find("placement_frame")
    if placement is not None and placement.text:
        brought.attributes["placement_frame"] = placement.text
    brought.parts += [child for child in include.children if child.name == "plugin" or _is_custom(child)]
    _give_custom(brought, include)
    return brought


def _give_custom(branch: Branch, *others: Branch) -> None:
    """Hand on the custom attributes of the element that a branch replaces."""
    for other in others:
        for name, text in other.attributes.items():
            if ":" in name and not name.startswith("xmlns:"):
                branch.attributes.setdefault(name, text)


def _merged(brought: Branch, include: Branch, found: Included, parent: Branch) -> list[Branch]:
    """The parts of a model that is merged, after the frame that replaces it."""
    name = f"_merged__{found.name}__model__"
    frame = Branch("frame", name=name)
    first = next(
        (child for kind in ("link", "model") for child in brought.children if child.name == kind), None
    )
    link = brought.attributes.get("canonical_link", "").strip() or (first.attributes["name"] if first else "")
    if link:
        frame.attributes["attached_to"] = link
    pose = include.find("pose") or brought.find("pose") or Branch("pose", "0 0 0 0 0 0")
    pose.attributes.setdefault("relative_to", "world" if parent.name == "world" else MODEL_FRAME)
    placement = include.find("placement_frame")
    if (placement is not None and placement.text) or brought.attributes.get("placement_frame", "").strip():
        pose = _placed(found, name)
    frame.parts.append(pose)
    _give_custom(frame, include, brought)
    parts = [child for child in brought.children if child.name in _MERGED or ":" in child.name]
    prefixes = {key: uri for key, uri in brought.attributes.items() if key.startswith("xmlns:")}
    for part in (frame, *parts):
        if part is not frame:
            _settle(part, name)
        used = _prefixes(part)
        part.attributes.update({key: uri for key, uri in prefixes.items() if key[6:] in used})
    given = [child for child in include.children if child.name == "plugin" or _is_custom(child)]
    return [frame, *parts, *given]


def _is_custom(child: Branch) -> bool:
    """Is it someone's own, and not an order to the consumer of the include?"""
    return ":" in child.name and child.name != PARAMETERS


def _placed(found: Included, name: str) -> Branch:
    """The pose of a merged model's own frame where another frame of it is placed."""
    document = found.include.document
    scope = root_of(document).scope_of(found.include)
    assert scope is not None
    own = scope.root.poses.in_scope(scope.nodes[name])
    relative_to = "world" if scope.kind == "world" else MODEL_FRAME
    return Branch("pose", numbers((*own[:3, 3], *to_rpy(own[:3, :3]))), relative_to=relative_to)


def _settle(part: Branch, name: str) -> None:
    """Parts that were relative to the model's own frame refer to the frame in its place."""
    _rename_frame(part, name)
    if part.name == "frame" and not part.attributes.get("attached_to", "").strip():
        part.attributes["attached_to"] = name
    elif part.name in {"include", "link", "model"}:
        pose = part.find("pose")
        if pose is None:
            pose = Branch("pose", "0 0 0 0 0 0")
            part.put(pose)
        if not pose.attributes.get("relative_to", "").strip():
            pose.attributes["relative_to"] = name


def _rename_frame(part: Branch, name: str) -> None:
    for attribute in ("attached_to", "expressed_in", "relative_to"):
        if part.attributes.get(attribute, "").strip() == MODEL_FRAME:
            part.attributes[attribute] = name
    if part.name in {"child", "parent"} and part.text == MODEL_FRAME:
        part.text = name
    for child in part.children:
        if child.name in _FREE or ":" in child.name:
            continue
        if part.name != "model" or child.name == "pose":  # a nested model has a frame of its own
            _rename_frame(child, name)


def _relocate(brought: Branch, found: Included, document: Document) -> None:
    for branch in brought.walk():
        text = relocated(branch.name, branch.text, found, document)
        if text is not None:
            branch.text = text


def _declare(brought: Branch, model: Element, include: Element) -> None:
    """Declare the prefixes that the model uses and only its own file declares."""
    there, here = model.namespaces, include.namespaces
    for prefix in sorted(_prefixes(brought)):
        uri = there.get(prefix)
        if uri is not None and here.get(prefix) != uri:
            brought.attributes.setdefault(f"xmlns:{prefix}", uri)


def _prefixes(branch: Branch) -> set[str]:
    names = [name for one in branch.walk() for name in (one.name, *one.attributes)]
    return {name.partition(":")[0] for name in names if ":" in name and not name.startswith("xmlns:")}
