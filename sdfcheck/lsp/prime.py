"""Work that is done while no request waits, so that the next one is answered at once."""

from __future__ import annotations

from sdfcheck.lsp.completion.complete import complete
from sdfcheck.lsp.cursor import at
from sdfcheck.lsp.hover import hover
from sdfcheck.lsp.names.index import occurrences
from sdfcheck.lsp.workspace import Buffer, Workspace


def prime(workspace: Workspace, buffer: Buffer, *, is_first: bool) -> None:
    """Compute the views that requests about a text need, and drop the others."""
    buffer.tidy()
    document = workspace.document(buffer.path)
    if document is None:
        return
    at(document, len(document.source.text))
    names = occurrences(document).all
    buffer.checkpoints.around(buffer.source.text, len(buffer.source.text))
    if is_first and names:
        hover(document, names[0].span.start)
        complete(workspace, buffer, names[-1].span.start)
