"""The results of converting one file."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.cli.convert.options import Request
from sdfcheck.consumers.reaction import Consumer
from sdfcheck.lint.wording import listed
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.cli.convert.inputs import Input, Judgement
    from sdfcheck.convert.comparison import Verification
    from sdfcheck.convert.result import Conversion
    from sdfcheck.lint.diagnostic import Diagnostic
    from sdfcheck.source.document import Document
    from sdfcheck.source.text import Span

    Convert = Callable[[Document, bool], Conversion]
    """Converts a document; compares the result with it if the second argument is true."""


PARSERS = {Consumer.GAZEBO: "libsdformat", Consumer.URDFDOM: "urdfdom"}
"""The parsers of the consumers that a result is for."""


class Outcome(NamedTuple):
    """The result; ``failed``: nothing is written."""

    file: Path
    errors: Sequence[Diagnostic]
    """Those of the source."""
    losses: Sequence[Diagnostic] = ()
    conversion: Conversion | None = None
    """The result, until it is written."""
    verification: Verification | None = None
    failed: bool = False
    way_out: str = ""
    """The option that converts it anyway, and how."""
    stopping: Sequence[Diagnostic] = ()
    """For what it is not written."""
    broken: Span | None = None
    """Where the text of the source is not XML."""
    also_by: str = ""
    """The consumers that have read source and result as well."""
    encoding: str = ""
    """That of the source, where the result has another."""
    refusal: tuple[Consumer, Diagnostic] | None = None
    """A consumer that refuses the result, like the source, and why."""

    def judged(self, judgement: Judgement) -> Outcome:
        """With what the consumers of the result say of it."""
        errors = judgement.errors
        if not errors:
            return self._replace(refusal=judgement.refusal)
        new = [one for one in errors if one not in self.errors]
        return self._replace(losses=[*self.losses, *new], failed=True, stopping=errors)

    @property
    def has_losses(self) -> bool:
        """Whether anything is worse than worth knowing."""
        return self.refusal is not None or any(one.severity.value != "info" for one in self.losses)

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        return (*self.errors, *self.losses)

    @property
    def verdict(self) -> str:
        """Whether the result is the same robot, and how that is known."""
        if self.failed:
            return "; ".join(filter(None, ("not converted, nothing written", self.way_out)))
        if self.verification is not None:
            text = f"verified: {self.verification}"
            text += f", also by {self.also_by}" if self.also_by else ""
            return text + self._refused
        if self.broken is not None:
            line, column = self.broken.begin
            return f"not verified: the text is broken at {line}:{column}; `sdfcheck lint` says how"
        return "not verified"

    @property
    def _refused(self) -> str:
        if self.refusal is None:
            return ""
        consumer, why = self.refusal
        return f"; {PARSERS[consumer]} refuses it: {why.message} ({why.code})"

    @property
    def reason(self) -> str:
        """Why nothing is written."""
        first = next(iter((*self.stopping, *self.diagnostics)), None)
        if first is None:
            return "it cannot be expanded"
        line, column = first.span.begin
        return f"{first.message} ({line}:{column}, {first.code})"


def converted(given: Input, convert: Convert, request: Request) -> Outcome:
    """Convert a document, and compare it with its source if that is asked for."""
    from sdfcheck.convert.broken_text import guess_in
    from sdfcheck.convert.loss import NotConvertible, to_diagnostic

    if given.document is None or given.stopping:
        way_out = "--no-lint converts it anyway" if given.document is not None else ""
        if given.document is None and given.file.suffix == ".urdf":
            way_out = "--no-expand leaves out what is for xacro"
        return Outcome(given.file, given.errors, failed=True, way_out=way_out, stopping=given.stopping)
    try:
        done = convert(given.document, request.verify)
    except NotConvertible as error:
        refused = [to_diagnostic(error.loss)]
        return Outcome(given.file, given.errors, refused, failed=True, stopping=refused)
    losses = [to_diagnostic(loss) for loss in done.losses]
    different = _differences(done, given.document, request)
    return Outcome(
        given.file,
        given.errors,
        [*losses, *different],
        done,
        done.verification,
        bool(different),
        stopping=different,
        broken=guess_in(given.document) if request.verify else None,
        also_by=listed(request.verify_with),
        encoding=given.encoding,
    )


def _differences(done: Conversion, document: Document, request: Request) -> list[Diagnostic]:
    """The findings of the comparison, as diagnostics of the source."""
    found = list(done.verification.differences) if done.verification is not None else []
    if request.verify_with:
        from sdfcheck.convert.independent import Judge, differences

        found += differences(done, document, map(Judge, request.verify_with))
    if not found or document.root is None:
        return []
    from sdfcheck.convert.loss import Loss, LossKind, to_diagnostic
    from sdfcheck.lint.diagnostic import Severity

    texts = (f"the result is not the same robot: {one.what} of `{one.name}` {one.text}" for one in found)
    span = document.root.span
    return [to_diagnostic(Loss(LossKind.NOT_VERIFIED, span, text, Severity.ERROR)) for text in texts]
