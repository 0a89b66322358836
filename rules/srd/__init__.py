"""SRDF: what MoveIt knows about a robot that another file describes."""

SOURCES = ("https://moveit.picknik.ai/main/doc/examples/urdf_srdf/urdf_srdf_tutorial.html",)
