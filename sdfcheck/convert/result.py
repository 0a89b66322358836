"""The result of a converter."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from sdfcheck.convert.comparison import Correspondence, SettingsProof, Verification, verify
from sdfcheck.convert.loss import Loss, LossKind, loss_at
from sdfcheck.convert.new_errors import guess_in
from sdfcheck.convert.settings_tree import Contents, Divergence
from sdfcheck.files.uris import file_path, scheme_of
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, Element, Value, read
from sdfcheck.source.record import Record
from sdfcheck.source.sniff import Kind
from sdfcheck.source.splice import Replacement, replaced
from sdfcheck.source.text import IN_QUOTES, Source, escape, relative_path


class Comparison(Record):
    """The two robots, each read from its own text by the parser of its format, and what became of what."""

    source: Mechanism
    result: Mechanism
    correspondence: Correspondence
    contents: tuple[Contents, Contents] | None = None
    """The other contents of the texts: sensors, plugins, materials."""
    translated: frozenset[Element] = frozenset()
    """The parts that the result has in another place or in other words."""
    copies: frozenset[tuple[Element, str]] = frozenset()
    """Custom elements and attributes, by element and name, that are in the result under their own name."""

    def verify(self, losses: Sequence[Loss] = ()) -> Verification:
        """Compare them; what is reported as a loss need not be equal."""
        settings = (
            SettingsProof(*self.contents, losses, self.translated, self.copies)
            if self.contents is not None
            else None
        )
        return verify(self.source, self.result, self.correspondence, settings=settings)


class Conversion(Record):
    """A finished conversion; ``comparisons`` (one for each model) are what there is to verify.

    ``document`` is the ``text``, read as a file beside the source.
    ``verifications`` are empty where nobody asked for them, or the text of the source is broken. ``files`` are further
    files that belong to the result, by their paths relative to it.
    """

    text: str
    document: Document
    losses: tuple[Loss, ...] = ()
    comparisons: tuple[Comparison, ...] = ()
    verifications: tuple[Verification, ...] = ()
    files: tuple[tuple[Path, str], ...] = ()

    @property
    def verification(self) -> Verification | None:
        """The verifications of all models as one; None if there are none."""
        if not self.verifications:
            return None
        done = self.verifications
        return Verification(
            sum(one.links for one in done),
            max(one.configurations for one in done),
            max(one.position for one in done),
            max(one.angle for one in done),
            max(one.inertia for one in done),
            tuple(difference for one in done for difference in one.differences),
            dict(sum((Counter(one.counts) for one in done), Counter())),
        )


def with_text(document: Document, text: str) -> Document:
    """The document as if its file had another text."""
    other = Document(Source(document.source.path, text), document.kind, [])
    other.library, other.included_by = document.library, document.included_by
    return other


def read_result(text: str, source: Document, kind: Kind) -> Document:
    """A text that was written, read as a file beside its source."""
    document = read(text.encode("utf-8", "surrogateescape"), source.path.with_suffix(f".{kind.value}"), kind)
    document.library = source.library
    return document


def lost_custom(one: Divergence) -> Loss:
    """The loss of custom data that the result does not have as it was."""
    assert one.element is not None
    message = f"`{one.name}` of {one.element.title} was {one.before} and is {one.after} in the result"
    return loss_at(one.element, LossKind.DROPPED_ELEMENT, message)


def conversion(
    source: Document,
    text: str,
    document: Document,
    losses: list[Loss],
    comparisons: list[Comparison],
    *,
    verified: bool = True,
) -> Conversion:
    """A conversion with its losses in order of place, compared with its source if ``verified``.

    A source whose text could only be guessed at proves nothing.
    """
    done = (
        tuple(comparison.verify(losses) for comparison in comparisons)
        if verified and guess_in(source) is None
        else ()
    )
    custom = (lost_custom(one) for verification in done for one in verification.custom)
    ordered = sorted(
        (*losses, *custom), key=lambda loss: (loss.span.source.path.as_posix(), loss.span.start, loss.message)
    )
    return Conversion(text, document, tuple(ordered), tuple(comparisons), done)


# Relative paths of a result, written for the folder that it goes to.


def seen_from(done: Conversion, source: Path, target: Path) -> str:
    """The text of a result, with meshes, textures and included files named as seen from the folder ``target``."""
    return replaced(done.text, relative_edits(done, source, target))


def relative_edits(done: Conversion, source: Path, target: Path) -> list[Replacement]:
    """The edits by which files are named as seen from the folder ``target``.

    They were named as seen from ``source``. Only what is there is written otherwise:
    simulators also look for a relative path in folders that their environment names.
    """
    if os.path.realpath(source) == os.path.realpath(target):
        return []
    root = root_of(done.document)
    values = [named.uri_value for named in (*root.resources, *root.includes)]
    edits = (edit for value in values if value is not None and (edit := _edit(value, source, target)))
    return sorted(set(edits))


def _edit(value: Value, source: Path, target: Path) -> Replacement | None:
    uri = value.text.strip()
    scheme = scheme_of(uri)
    path = file_path(uri) if scheme == "file" else uri
    if scheme not in {"", "file"} or not path or os.path.isabs(path):
        return None
    if not os.path.exists(source / path):
        return None
    moved = Path(relative_path(source / path, target)).as_posix()
    return spelled(value, f"file://{moved}" if scheme else moved)


def spelled(value: Value, uri: str) -> Replacement | None:
    """The edit that writes another address in the place of one; None in a text that is not all of one piece."""
    written = value.span.text.strip()
    if "<" in written:
        return None  # a comment or CDATA
    start = value.span.start + value.span.text.index(written)
    return start, start + len(written), escape(uri, IN_QUOTES)
