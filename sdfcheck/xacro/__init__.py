"""xacro: expansion with places, and what can be known without expanding."""
