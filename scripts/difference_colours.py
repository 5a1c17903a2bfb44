"""Colours of a difference between two pictures."""

import numpy


def difference_colours(difference):
    """White where there is none, orange where it is above zero, blue where below; and what is full colour."""
    there = abs(difference[difference != 0])
    scale = numpy.quantile(there, 0.99) if there.size else 1.0
    strength = numpy.clip(difference / scale, -1, 1)[..., None]
    orange, blue = numpy.array([0.90, 0.38, 0.0]), numpy.array([0.0, 0.27, 0.70])
    return 1 - numpy.maximum(strength, 0) * (1 - orange) - numpy.maximum(-strength, 0) * (1 - blue), scale
