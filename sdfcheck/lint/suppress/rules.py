"""The engine's own rules: what it says about suppressions."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.example import IN_URDF_JOINT, Bad, Good
from sdfcheck.lint.fix import Fix
from sdfcheck.lint.run import RuleFacts
from sdfcheck.source.text import Span


class UnusedSuppression:
    """A suppression comment silences nothing: what it names does not occur where it applies.

    It hides the next defect of that kind instead of an old one. Only rules that took
    part in the run are judged, so that a run of a few rules does not condemn the
    suppressions of all others.
    """

    code = "SUP001"
    name = "unused-suppression"
    severity = Severity.WARNING
    remedy = """Remove the comment, or the one name in its brackets that silences nothing.

    The defect was fixed, or the comment is not at its place: `ignore[…]` concerns the next element and
    what is in it, so it has to be directly before the element that the finding marked.
    """
    scaffold = IN_URDF_JOINT
    bad = (
        Bad(
            '<!-- «sdfcheck: ignore[internal-error]» agreed -->\n<axis xyz="0 0 1"/>',
            fixed='<axis xyz="0 0 1"/>',
        ),
    )
    good = (Good("<!-- sdfcheck said: ignore[internal-error] -->", why="prose, no directive"),)


class MalformedSuppression:
    """A comment that addresses sdfcheck is not understood, so it silences nothing.

    The directives are ``ignore[…]`` for the next element, ``disable[…]`` and
    ``enable[…]`` for what is between them, and ``ignore-file`` (all rules) or
    ``ignore-file[…]`` for the whole file; the brackets hold codes, names or families.
    """

    code = "SUP002"
    name = "malformed-suppression"
    severity = Severity.WARNING
    remedy = """Write it as `<!-- sdfcheck:ignore[name-of-the-rule] reason -->`, directly before the element.

    The name of the rule is in the first line of the finding, and `sdfcheck rules` lists all of them. A reason
    after the bracket is optional, and helps the next person. A comment that is not meant for sdfcheck has to
    begin with another word.
    """
    scaffold = IN_URDF_JOINT
    bad = (
        Bad(
            "<!-- sdfcheck: «ignored»[internal-error] -->",
            fixed="<!-- sdfcheck: ignore[internal-error] -->",
            unsafe=True,
            says="did you mean `ignore`?",
        ),
        Bad("<!-- sdfcheck: «ignore» internal-error -->", says="names no rule"),
        Bad(
            "<!-- sdfcheck: ignore[«internal-eror»] -->",
            fixed="<!-- sdfcheck: ignore[internal-error] -->",
            unsafe=True,
            says="did you mean `internal-error`?",
        ),
    )
    good = (Good("<!-- sdfcheck is a linter -->", why="prose that begins with a name, no directive"),)


OwnRule = type[UnusedSuppression] | type[MalformedSuppression]


def report(
    rule: OwnRule, span: Span, message: str, *, fix: Fix | None = None, help: str | None = None
) -> Diagnostic:
    """A diagnostic of one of these."""
    from sdfcheck.lint.rule import advice

    own = advice(rule.remedy) if fix is None else None
    return Diagnostic(rule.code, rule.name, rule.severity, message, span, fix=fix, help=help or own)


def _facts(rule: OwnRule, fixable: str) -> RuleFacts:
    summary = (rule.__doc__ or "").partition("\n\n")[0]
    return RuleFacts(
        rule.code, rule.name, "SUP", rule.severity, summary, fixable, True, (), (), {}, rule.__module__
    )


FACTS = (_facts(UnusedSuppression, "safe"), _facts(MalformedSuppression, "unsafe"))
"""The entry of the index of rules about these, if they were in a pack."""
