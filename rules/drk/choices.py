"""Words that are none of those that one of Drake's elements can have."""

from sdfcheck import (
    Diagnostic,
    VendorRule,
    VendorValue,
    named,
    suggest,
    write_instead,
)


def unknown_choice(rule: VendorRule, value: VendorValue) -> Diagnostic:
    """That a value is none of the choices, and which one was probably meant."""
    word, choices = value.text.strip(), value.slot.choices
    near = suggest(word, choices)
    rest = f"; did you mean `{near}`?" if near else f"; it is one of {named(choices, 'or')}"
    message, fix = f"{value.title} cannot be `{word}`", write_instead(near, value)
    return rule.report(value, message, value.slot.bad, rest=rest, fix=fix)
