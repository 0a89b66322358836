"""Uris of meshes and textures, as they lead from the URDF."""

from __future__ import annotations

import os
from pathlib import Path

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.marks import PACKAGES
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.document import Element
from sdfcheck.source.relative import relative_path


def mesh_uri(context: Context, uri: str, element: Element) -> str:
    """The uri to write for a file that an element of the source names.

    A relative path is meant from the file that it is in, and must lead from the result.
    """
    package = uri.removeprefix("model://").partition("/")[0]
    given_back = package in context.scope.element.attributes.get(PACKAGES, "").split()
    if (context.options.package_uris or given_back) and uri.startswith("model://"):
        written = f"package://{uri.removeprefix('model://')}"
        context.ledger.note(
            LossKind.CHANGED_URI, element, f"`{uri}` is written as `{written}`", Severity.INFO
        )
        return written
    if "://" in uri or uri.startswith(("/", "file:")) or not uri:
        return uri
    here = element.document.path.parent
    if os.path.realpath(here) == os.path.realpath(context.folder):
        return uri
    return Path(relative_path(here / uri, context.folder)).as_posix()
