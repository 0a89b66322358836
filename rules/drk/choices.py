"""Words that are not among the choices for one of Drake's elements."""

from sdfcheck import Diagnostic, VendorRule, VendorValue, named, suggest, write_instead


def unknown_choice(rule: VendorRule, value: VendorValue) -> Diagnostic:
    """The diagnostic of a value that is not one of the choices, and the one that was probably meant."""
    word, choices = value.text.strip(), value.slot.choices
    near = suggest(word, choices)
    rest = f"; did you mean `{near}`?" if near else f"; it is one of {named(choices, 'or')}"
    message, fix = f"{value.title} cannot be `{word}`", write_instead(near, value)
    return rule.report(value, message, value.slot.bad, rest=rest, fix=fix)
