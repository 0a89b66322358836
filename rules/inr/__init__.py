"""INR: mass and inertia, of links that move."""
