"""XML: the text itself, in every dialect."""

SOURCES = ("https://www.w3.org/TR/xml/",)
