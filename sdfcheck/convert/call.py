"""Converting, called from programs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.consumers.reaction import Consumer
from sdfcheck.convert.loss import Loss, LossKind, NotConvertible
from sdfcheck.convert.result import Conversion
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.lint.targets import refusals
from sdfcheck.robot.load import opened
from sdfcheck.robot.root import Root
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.source.document import Document


def convert(  # noqa: PLR0913
    what: Root | str | bytes | os.PathLike[str],
    to: str,
    *,
    version: str | None = None,
    model: str = "",
    verify: bool = True,
    like: Consumer | None = None,
    tables: Sequence[Path] = (),
) -> Conversion:
    """Convert a description to ``"sdf"`` (from URDF, xacro or another version) or to ``"urdf"``.

    ``what`` is a path, a text (bytes, or a str that begins with ``<``) or what ``load``
    gave, ``tables`` as for it. ``version`` is that of the SDFormat to write; ``model`` the one to write as URDF
    where there are several; with ``like=Consumer.GAZEBO`` a robot of URDF is written as
    Gazebo builds it. The result has the ``text``, the ``losses`` and, with ``verify``, the
    ``verification``: only one that ``is_equal`` is the same robot. Nothing is written.

    Raises:
        OSError, sdfcheck.Unreadable: as for ``load``.
        sdfcheck.WrongUsage: there is no such conversion.
        sdfcheck.NotConvertible: its own consumer refuses the file, or the target cannot say it in any way.
    """
    document = (what if isinstance(what, Root) else opened(what, tables)).document
    if stopping := refusals(document):
        first = stopping[0]
        raise NotConvertible(Loss(LossKind.NOT_CONVERTIBLE, first.span, first.message, first.severity))
    if to == "urdf" and document.kind is Kind.SDF and version is None and like is None:
        from sdfcheck.convert.sdf_to_urdf import Options
        from sdfcheck.convert.sdf_to_urdf import convert as to_urdf

        return to_urdf(document, Options(model=model), verified=verify)
    has_likeness = like is None or (like is Consumer.GAZEBO and document.kind is Kind.URDF)
    if to == "sdf" and not model and has_likeness:
        return _to_sdf(document, _version(version), verify=verify, like=like)
    asked = {"version": version, "model": model, "like": like.title if like else ""}
    conditions = "".join(f", {name} {value}" for name, value in asked.items() if value)
    raise WrongUsage(f"{document.path}: {document.kind.description} is not converted to `{to}`{conditions}")


def _to_sdf(document: Document, version: Version, *, verify: bool, like: Consumer | None) -> Conversion:
    if document.kind is Kind.SDF:
        from sdfcheck.convert.migrate.migrate import sdf_to_sdf

        return sdf_to_sdf(document, version, verified=verify)
    from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
    from sdfcheck.convert.urdf_to_sdf.options import Options

    return urdf_to_sdf(document, Options(version, like=like), verified=verify)


def _version(text: str | None) -> Version:
    version = NEWEST if text is None else Version.parse(text)
    if version is None or not Version(1, 4) <= version <= NEWEST:
        raise WrongUsage(f"`{text}` is not a version of SDFormat from 1.4 to {NEWEST}")
    return version
