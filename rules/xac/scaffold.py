"""The document around the examples of this family."""

FILE = "robot.sdf.xacro"

IN_XACRO = (
    '<sdf version="1.12" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    '<model name="m"><link name="base"/>{}</model></sdf>'
)
