"""XAC: xacro, the macro language in which most URDF is written."""

SOURCES = ("https://github.com/ros/xacro/wiki",)
