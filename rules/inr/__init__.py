"""INR: mass and inertia, of links that move."""

SOURCES = ("http://sdformat.org/spec?elem=link",)
