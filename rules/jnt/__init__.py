"""JNT: joints."""

SOURCES = ("http://sdformat.org/spec?elem=joint", "http://wiki.ros.org/urdf/XML/joint")
