"""A robot for the examples."""

FILE = "arm.srdf"
ROBOT = {
    "arm.urdf": '<robot name="arm"><link name="base"/><link name="upper"/><link name="hand"/>'
    '<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>'
    '<limit lower="-1" upper="1" effort="5" velocity="2"/></joint>'
    '<joint name="wrist" type="fixed"><parent link="upper"/><child link="hand"/></joint></robot>',
    "package.xml": "<package><name>arm</name></package>",
}
GROUP = '<group name="all"><joint name="shoulder"/><link name="base"/><link name="upper"/></group>'
IN_SRDF = f'<robot name="arm">{GROUP}{{}}</robot>'
