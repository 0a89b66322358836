"""RES: files, includes and plugins."""

SOURCES = (
    "http://sdformat.org/tutorials?tut=composition_proposal",
    "https://gazebosim.org/api/sim/8/resources.html",
)
