"""The scan of any text: one pass, never failing.

It also says why a text is not well formed (:mod:`sdfcheck.source.problems`) and rewrites
it in well-formed XML, so that the rest can be linted. Three steps: cut the text up, join
the tags, write.
"""

from __future__ import annotations

from sdfcheck.source.scanner.pairing import pair
from sdfcheck.source.scanner.prepare import Prepared, prepare
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.scanner.tokenizer import tokenize
from sdfcheck.source.scanner.tokens import TokenKind, Tokens
from sdfcheck.source.scanner.wellformed import Writer
from sdfcheck.source.text import Source


def scan(source: Source) -> Scan:
    """The places and defects of a text, and the text rewritten."""
    prepared = prepare(source)
    return assemble(source, prepared, tokenize(source, prepared.text), prepared.text)[0]


def assemble(source: Source, prepared: Prepared, tokens: Tokens, copied: str) -> tuple[Scan, int]:
    """The scan that the pieces of a text make, and where it ends; ``copied`` is the text that is written anew."""
    result = Scan()
    pairs = pair(source, prepared.text, tokens)
    writer = Writer(source, copied, result, tokens.entities)
    writer.write(pairs.steps)
    read = (problem for problem in (*prepared.problems, *tokens.problems) if problem.span.start < pairs.end)
    found = [*read, *pairs.problems, *result.problems]
    result.problems = sorted(found, key=lambda problem: (problem.span.start, problem.span.end))
    result.doubtful = [*prepared.doubtful, *tokens.doubtful, *pairs.doubtful]
    pieces = (token for token in tokens.pieces if token.kind is TokenKind.COMMENT)
    result.comments = [(token.start, token.end) for token in pieces if token.start < pairs.end]
    return result, pairs.end
