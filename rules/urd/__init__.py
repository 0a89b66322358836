"""URD: URDF."""
