"""Robots around the examples."""

HARDWARE = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
IN_ROBOT = (
    '<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>'
    '<joint name="lift" type="prismatic"><parent link="a"/><child link="b"/>'
    '<limit lower="0" upper="1" effort="5" velocity="2"/></joint>'
    '<joint name="tip" type="fixed"><parent link="b"/><child link="c"/></joint>'
    '<joint name="follower" type="continuous"><parent link="b"/><child link="d"/>'
    '<mimic joint="lift"/></joint>{}</robot>'
)
IN_BLOCK = IN_ROBOT.replace("{}", f'<ros2_control name="arm" type="system">{HARDWARE}{{}}</ros2_control>')
IN_LIFT = IN_BLOCK.replace("{}", '<joint name="lift">{}</joint>')
REFUSED = "ros2_control refuses the whole description"
SINCE_JAZZY = f"{REFUSED} from jazzy on"
