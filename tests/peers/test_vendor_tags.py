"""Drake sees the same robots before and after: friction, compliance, acceleration, rotors, gears and filters."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from sdfcheck.convert import sdf_to_urdf
from sdfcheck.convert.loss import NotConvertible
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Massless, Options
from sdfcheck.files.library import Library
from sdfcheck.source.document import Document, read
from sdfcheck.source.errors import WrongUsage
from tests.peers import drake_plants
from tests.peers.findings import SHARED

FOLDERS = (SHARED / "corpus" / "drake", SHARED / "found" / "drake")
LEAST = {".urdf": 33, ".sdf": 45}
"""So many files Drake loads before and after, at least."""

NOT_IN_URDF = ("drake:deformable_properties", "<plane>")
"""What Drake has in SDFormat only: shapes of links with it are others in URDF."""
NESTED = ("<model", "<include>")
"""Names in models of models change."""
NO_SIZE = "<radius>0"
SPLIT = ('type="universal"', 'type="screw"')
"""Joints of SDFormat that are several of URDF."""

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not SHARED.is_dir(), reason="the files to convert are not here"),
    pytest.mark.skipif(not drake_plants.is_installed(), reason="pydrake is not installed"),
]


def sources(suffix: str) -> Iterator[Document]:
    """The files that use a tag of Drake's."""
    for path in sorted(path for folder in FOLDERS for path in folder.rglob(f"*{suffix}")):
        data = path.read_bytes()
        if b"drake:" in data:
            document = read(data, path)
            document.library = Library()
            yield document


def convert(document: Document) -> str | None:
    try:
        if document.path.suffix == ".urdf":
            # With links that stay, so that each is compared with itself.
            return urdf_to_sdf(document, Options(massless=Massless.SMALL)).text
        return sdf_to_urdf.convert(document).text
    except (NotConvertible, WrongUsage):
        return None


def beside(document: Document, folder: Path, text: str) -> Path:
    """A new folder with a result, from which relative paths lead where they did.

    The folder is the result's alone: what is linked there is never written to.
    """
    inner = folder / str(len(list(folder.iterdir())))
    inner.mkdir()
    for other in document.path.parent.iterdir():
        (inner / other.name).symlink_to(other)
    path = inner / f"{document.path.stem}.converted{'.sdf' if document.path.suffix == '.urdf' else '.urdf'}"
    assert not path.is_symlink()
    path.write_text(text)
    return path


def apart(a: Any, b: Any, path: str = "") -> Iterator[str]:
    """In what two readings differ; what is only in the second is left out at the top, where it is driven by default."""
    if isinstance(a, dict) and isinstance(b, dict):
        for key in sorted({*a, *b}):
            if path == "/actuators" and key not in a:
                continue
            yield from apart(a.get(key), b.get(key), f"{path}/{key}")
    elif isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        for number, pair in enumerate(zip(a, b, strict=True)):
            yield from apart(*pair, f"{path}[{number}]")
    elif isinstance(a, float) and isinstance(b, float):
        if not math.isclose(a, b, rel_tol=1e-7, abs_tol=1e-7):
            yield f"{path}: {a} and {b}"
    elif a != b:
        yield f"{path}: {a} and {b}"


def compared(document: Document, before: Any, after: Any) -> Iterator[str]:
    text = document.source.text
    left_out = {"elements"} if any(word in text for word in NESTED[1:]) else set()
    if any(word in text for word in NOT_IN_URDF) and document.path.suffix == ".sdf":
        left_out |= {"shapes", "filters"}
    if any(word in text for word in SPLIT) and document.path.suffix == ".sdf":
        left_out |= {"joints", "actuators", "constraints"}
    if NO_SIZE in text or text.count(NESTED[0]) > 1:
        left_out |= {"shapes", "filters", "joints"}
    for fact in before.keys() - left_out:
        yield from apart(before[fact], after.get(fact), f"/{fact}")


@pytest.mark.parametrize("suffix", [".urdf", ".sdf"])
def test_drake_sees_the_same_robot(suffix: str, tmp_path: Path) -> None:
    pairs = {}
    for document in sources(suffix):
        if (text := convert(document)) is not None:
            pairs[document.path] = (document, beside(document, tmp_path, text))
    found = drake_plants.facts([*pairs, *(result for _, result in pairs.values())])
    wrong, seen = [], 0
    for path, (document, result) in pairs.items():
        before, after = found[path], found[result]
        if "error" in before:
            continue
        if "error" in after:
            wrong.append(f"{path.name}: the result is not loaded: {after['error'][:200]}")
            continue
        seen += 1
        wrong += [f"{path.name}: {text}" for text in compared(document, before, after)]
    assert not wrong, "\n".join(wrong)
    assert seen >= LEAST[suffix]
