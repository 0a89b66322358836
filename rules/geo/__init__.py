"""GEO: shapes and meshes, compared with each other and with the robot that they are part of."""

SOURCES = ("http://sdformat.org/spec?elem=geometry", "https://wiki.ros.org/urdf/XML/link")
