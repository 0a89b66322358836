"""SCH: the schema of the version that the document declares."""

SOURCES = ("http://sdformat.org/spec",)
