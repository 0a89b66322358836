"""What is worked out while nobody asks, so that the next question is answered at once."""

from __future__ import annotations

from sdfcheck.lsp.completion.complete import complete
from sdfcheck.lsp.cursor import at
from sdfcheck.lsp.hover import hover
from sdfcheck.lsp.names.index import occurrences
from sdfcheck.lsp.workspace import Buffer, Workspace


def prime(workspace: Workspace, buffer: Buffer, *, is_first: bool) -> None:
    """Work out what questions about a text need, and let go of what none will; at first load what answers need."""
    buffer.tidy()
    document = workspace.document(buffer.path)
    if document is None:
        return
    at(document, 0)
    names = occurrences(document).all
    buffer.checkpoints.around(buffer.source.text, len(buffer.source.text))
    if is_first and names:
        hover(document, names[0].span.start)
        complete(workspace, buffer, names[-1].span.start)
