"""XAC: xacro, the macro language in which most URDF is written."""
