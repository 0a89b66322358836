"""Robots that several sessions show."""

ROBOT = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <xacro:property name="size" value="0.5"/>
  <xacro:macro name="ball" params="name size:=1">
    <link name="${name}_ball"><visual><geometry><sphere radius="${size}"/></geometry></visual></link>
  </xacro:macro>
  <xacro:ball name="$(arg side)" size="${size * 2}"/>
  <link name="base"/>
</robot>
"""
URDF = """\
<robot name="r">
  <link name="base"><visual><geometry><mesh filename="arm.dae"/></geometry></visual></link>
  <link name="tip"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="tip"/><origin rpy="0 0 3.141593"/></joint>
</robot>
"""
