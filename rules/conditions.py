"""The conditions of the rules, so that a clean file loads one module; written by ``make generate``."""

# The types are checked where the conditions are written.
# mypy: ignore-errors


CONDITIONS = {
}
