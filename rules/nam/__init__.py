"""NAM: names and scoped names."""

SOURCES = ("http://sdformat.org/tutorials?tut=composition_proposal",)
