"""A quick look for what concerns the generations of Gazebo; what there is to say is said elsewhere."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind


def problems(document: Document) -> Iterator[object]:
    """Names of the past, materials by script, and settings of URDF that get lost on the way to Gazebo."""
    if document.root is None:
        return
    text = document.source.text
    if "ignition" in text:
        from sdfcheck.consumers.gazebo_names import ignition_names

        yield from ignition_names(document)
    if "_frame_id" in text:
        from sdfcheck.consumers.gazebo_names import frame_ids

        yield from frame_ids(document)
    if document.kind is Kind.SDF and "<script" in text:
        from sdfcheck.consumers.gazebo_materials import script_materials, told_once

        yield from told_once(script_materials(document))
    if document.kind is Kind.URDF and "<gazebo" in text:
        from sdfcheck.consumers.gazebo_extensions import extension_problems

        yield from extension_problems(document)


def classic_problems(document: Document) -> Iterator[object]:
    """What only Gazebo Classic reads; for those who ask about Gazebo."""
    if document.root is not None:
        from sdfcheck.consumers.gazebo_classic import classic_only

        yield from classic_only(document)
