"""PyBullet: what it makes of URDF."""
