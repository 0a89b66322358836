"""MuJoCo: what its reader of URDF does not take."""
