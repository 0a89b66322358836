"""From one format to the other and back: the changes in the robot, and the losses that report them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.convert.comparison import Change, ChangeKind
from sdfcheck.convert.file_difference import compare_files
from sdfcheck.convert.loss import Loss, LossKind
from sdfcheck.convert.sdf_to_urdf import Loops, Options, convert
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Options as BackOptions
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.document import Document, read

_REPORTED_BY = (
    (
        "link: .*/material(/.*)?",
        {LossKind.CHANGED_COLOR, LossKind.CHANGED_MATERIAL, LossKind.DROPPED_ELEMENT},
    ),
    ("link: collision .*/drake:proximity_properties", {LossKind.KEPT_AS_EXTENSION}),
    ("link: collision", {LossKind.DROPPED_ELEMENT}),
    ("model: drake:collision_filter_group .*", {LossKind.MERGED_MODEL}),
    ("link: .*/surface.*", {LossKind.DROPPED_ELEMENT, LossKind.KEPT_AS_EXTENSION}),
    (
        "link: visual .*/(cast_shadows|transparency|laser_retro|visibility_flags|layer)",
        {LossKind.DROPPED_ELEMENT},
    ),
    ("link: (mass|.*/density)", {LossKind.CHANGED_INERTIA}),
    ("joint: axis/limit/.*", {LossKind.DROPPED_ELEMENT}),
    ("model: (plugin|transmission) .*", {LossKind.KEPT_AS_EXTENSION}),
    ("link: visual .*/plugin .*", {LossKind.DROPPED_PLUGIN}),
    ("link: (visual|collision)( `.*` shape)?", {LossKind.UNSUPPORTED_GEOMETRY}),
    ("link: name of a (visual|collision)", {LossKind.KEPT_AS_EXTENSION, LossKind.RENAMED}),
    # Of a model that is merged, a file is named from the folder of the result.
    ("link: (visual|collision)( `.*`)? file", {LossKind.CHANGED_URI, LossKind.MERGED_MODEL}),
    ("link: sensor .*/gz_frame_id", {LossKind.MERGED_MODEL}),
    ("link: static|model: selfCollide", {LossKind.DROPPED_ELEMENT}),
    ("link: frame", {LossKind.SHIFTED_LINK_FRAME}),
    ("link: inertial", {LossKind.MASSLESS_LINK}),
    ("(link|joint|frame) renamed", {LossKind.MERGED_MODEL, LossKind.RENAMED}),
    ("(link|joint) (added|removed)", {LossKind.APPROXIMATED_JOINT}),
    ("joint: (type|child|parent|pitch|mimic|pose in the child)", {LossKind.APPROXIMATED_JOINT}),
    ("joint: parent and child", {LossKind.REVERSED_JOINT}),
)
"""The form of a change, and the losses that report such changes."""


def there_and_back(document: Document) -> tuple[list[Change], list[Loss]]:
    """The differences between a model and what it is after being URDF, and the losses of both ways.

    Raises NotConvertible where the model is not a tree.
    """
    there = convert(document, Options(loops=Loops.CUT))
    back = urdf_to_sdf(read(there.text.encode(), Path("there.urdf")), BackOptions())
    for done in (there, back):
        assert done.verification is not None
        assert done.verification.is_equal, done.verification.differences
    found = compare_files(document, read(back.text.encode(), Path("back.sdf")))
    changes = [change for _, group in found.changes for change in group]
    return changes, [*there.losses, *back.losses]


def back_and_there(document: Document) -> tuple[list[Change], list[Loss]]:
    """The differences between a URDF robot and what it is after being SDFormat, and the losses of both ways.

    Names of shapes that had none are left out: SDFormat requires them. Raises NotConvertible.
    """
    there = urdf_to_sdf(document, BackOptions())
    back = convert(read(there.text.encode(), Path("there.sdf")), Options(loops=Loops.CUT))
    for done in (there, back):
        assert done.verification is not None
        assert done.verification.is_equal, done.verification.differences
    found = compare_files(document, read(back.text.encode(), Path("back.urdf")))
    changes = [change for _, group in found.changes for change in group]
    named = [one for one in changes if not (one.what.startswith("name of a") and one.before == "none")]
    return named, [*there.losses, *back.losses]


_THE_SAME = {LossKind.UNSUPPORTED_GEOMETRY, LossKind.KEPT_AS_EXTENSION}
"""Losses that are infos where something else says the same: shapes in parts, and settings that cost names of shapes."""


def unwarned(changes: list[Change], losses: list[Loss]) -> Iterator[str]:
    """The changes of a robot that no warning names."""
    reported = [loss for loss in losses if loss.severity is not Severity.INFO or loss.kind in _THE_SAME]
    for change in changes:
        if change.what.endswith("@relative_to"):
            continue  # to the link that it is in
        if change.what.startswith("transmission") and change.before == "none":
            continue  # Drake wants one for each joint that is driven
        names = {
            word
            for text in (change.name, change.before, change.after)
            for word in re.split("__|[`:/ ]+", text)
        }
        names |= set(re.split("[`:/]+", change.what))
        if not any(_names_any(loss, names - {""}) for loss in reported):
            yield f"{change.part} {change.name}: {change.what} {change.before} → {change.after}"


def untold(changes: list[Change], losses: list[Loss]) -> Iterator[str]:
    """The changes that no loss has reported."""
    renamed = {change.after: change.before for change in changes if change.what.startswith("name of a")}
    has_maps = any("becomes an albedo map" in loss.message for loss in losses)
    for change in changes:
        if (
            has_maps
            and change.before == "none"
            and (change.what.rpartition("/")[2], change.after)
            in {("pbr", "1 settings"), ("diffuse", "1 1 1 1")}
        ):
            continue  # reported once for a texture, by its file
        looks = change.part
        looks += f": {change.what}" if change.kind is ChangeKind.CHANGED else f" {change.kind.value}"
        kinds: set[LossKind] = set()
        kinds = kinds.union(*(reported for pattern, reported in _REPORTED_BY if re.fullmatch(pattern, looks)))
        quoted = re.split("[`/]", change.what)
        names = {
            name
            for text in (change.name, change.before, *quoted)
            for name in (text, *re.split("::|__|/+", text))
        }
        names |= {renamed[name] for name in names if name in renamed}
        if not any(loss.kind in kinds and _names_any(loss, names - {""}) for loss in losses):
            yield f"{looks}: {change.name} {change.before} → {change.after}"


def _names_any(loss: Loss, names: set[str]) -> bool:
    words = set(re.split(r"[`:/]+", loss.message))
    return bool(words & names)
