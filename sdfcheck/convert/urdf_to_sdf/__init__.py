"""URDF to SDFormat: document order, names, comments and the author's numbers are kept."""
