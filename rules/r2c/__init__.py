"""ros2_control: the hardware of the joints of a robot."""

SOURCES = (
    "https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_components_userdoc.html",
    "https://control.ros.org/rolling/doc/gz_ros2_control/doc/index.html",
)
