"""Rules about what PyBullet makes of URDF."""
