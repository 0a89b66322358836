import re
from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Root, Rule, Severity, Value

_ENDS = frozenset("\"'<>: \t\r\n")
"""The characters around a name, or between its parts."""


class MalformedScopedName(Rule):
    """A reference has an empty part before, after or between `::`.

    A scoped name leads down into nested models, one name after the other. There is no
    way up: a leading `::` does not mean the outermost scope, and finds nothing.
    """

    code = "NAM005"
    name = "malformed-scoped-name"
    severity = Severity.ERROR
    remedy = """Write one name after the other with `::` between them, from the nearest model down.

    Something in the same model has no `::` at all. A model around it cannot be reached; move the reference
    outwards instead.
    """
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad('<frame name="f" attached_to="«::base»"/>', says="`::base` begins with `::`"),
        Bad('<frame name="f"><pose relative_to="«base::»"/></frame>', says="`base::` ends with `::`"),
        Bad(
            '<joint name="j" type="fixed"><parent>world</parent><child>«n::::l»</child></joint>'
            '<model name="n"><link name="l"/></model>',
            says="`n::::l` has an empty part",
        ),
    )
    good = (Good('<frame name="f" attached_to="n::l"/><model name="n"><link name="l"/></model>'),)

    @staticmethod
    def applies(root: Root) -> bool:
        return _may_be_odd(root.document.source.text) and any(map(_is_odd, root.names.references))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for value in filter(_is_odd, root.names.references):
            name = value.text.strip()
            if name.startswith("::"):
                what = "begins with `::`, and no reference leads out of its scope"
            else:
                what = "ends with `::`" if name.endswith("::") else "has an empty part"
            yield self.diagnostic(value, f"scoped name `{name}` {what}")


def _may_be_odd(text: str) -> bool:
    """The cheap question whether any ``::`` has nothing before or after it."""
    return any(
        text[match.start() - 1] in _ENDS or text[match.end() : match.end() + 1] in _ENDS
        for match in re.finditer("::", text)
    )


def _is_odd(reference: Value) -> bool:
    return "::" in reference.text and "" in reference.text.strip().split("::")
