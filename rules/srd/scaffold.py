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
FINGER = (
    '<link name="{0}_tip"/><joint name="{0}" type="prismatic"><parent link="hand"/><child link="{0}_tip"/>'
    '<limit lower="0" upper="0.04" effort="5" velocity="1"/>{1}</joint>'
)
GRIPPER = ROBOT | {
    "arm.urdf": ROBOT["arm.urdf"].replace(
        "</robot>", FINGER.format("left", "") + FINGER.format("right", '<mimic joint="left"/>') + "</robot>"
    )
}
