"""xacro: expansion with places, and what can be told without expanding."""
