"""Documents around the examples of this family."""

_SDF = '<sdf version="1.9" xmlns:drake="http://drake.mit.edu">'
_ROBOT = '<robot name="r" xmlns:drake="http://drake.mit.edu">'
_MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
_FIXED = '<joint name="f" type="fixed"><parent link="world"/><child link="a"/></joint>'
_BOX = "<geometry><box><size>1 1 1</size></box></geometry>"
_SPHERE = "<geometry><sphere><radius>1</radius></sphere></geometry>"

MODEL = f'{_SDF}<model name="m"><link name="a"/><link name="b"/>{{}}</model></sdf>'
LINK = f'{_SDF}<model name="m"><link name="a">{{}}</link></model></sdf>'
JOINT = (
    f'{_SDF}<model name="m"><link name="a"/><link name="b"/><joint name="j" type="revolute">'
    "<parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis>{}</joint></model></sdf>"
)
AXIS = (
    f'{_SDF}<model name="m"><link name="a"/><link name="b"/><joint name="j" type="revolute">'
    "<parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>{}</axis></joint></model></sdf>"
)
COLLISION = f'{_SDF}<model name="m"><link name="a"><collision name="c">{{}}</collision></link></model></sdf>'
BOX = (
    f'{_SDF}<model name="m"><link name="a"><collision name="c">{_BOX}'
    "<drake:proximity_properties>{}</drake:proximity_properties></collision></link></model></sdf>"
)
SPHERE = BOX.replace(_BOX, _SPHERE)
ROBOT = (
    f'{_ROBOT}<link name="world"/><link name="a">{_MASS}</link><link name="b">{_MASS}</link>{_FIXED}'
    '<joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
    '<limit lower="-1" upper="1" effort="5" velocity="2"/></joint>{}</robot>'
)
ROBOT_LINK = f'{_ROBOT}<link name="world"/><link name="a">{_MASS}{{}}</link>{_FIXED}</robot>'
_LINKS = f'<link name="world"/><link name="a">{_MASS}</link><link name="b">{_MASS}</link>{_FIXED}'
ROBOT_JOINT = f"{_ROBOT}{_LINKS}{{}}</robot>"
