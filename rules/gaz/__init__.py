"""GAZ: moving between Gazebo generations."""

SOURCES = ("https://gazebosim.org/docs/latest/gazebo_classic_migration/",)
