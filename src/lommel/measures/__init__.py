"""What is drawn from a wavefront or from its image: where the light is, how much, how sharp, how wrong."""
