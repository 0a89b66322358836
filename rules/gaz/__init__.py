"""GAZ: moving between Gazebo generations."""
