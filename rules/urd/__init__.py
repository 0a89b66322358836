"""URD: URDF."""

SOURCES = ("http://wiki.ros.org/urdf/XML",)
