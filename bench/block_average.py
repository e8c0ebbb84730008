"""Means of correlated blocks of a simulation, with their standard errors."""
import math


def mean_and_error(blocks):
    """Standard error of the mean of correlated blocks, correlations summed up to the first that is
    not positive."""
    count = len(blocks)
    mean = sum(blocks) / count
    off = [block - mean for block in blocks]
    variance = sum(x * x for x in off) / (count - 1)
    stretch = 1
    for lag in range(1, count // 3):
        correlation = sum(a * b for a, b in zip(off, off[lag:])) / (count * variance)
        if correlation <= 0:
            break
        stretch += 2 * correlation
    return mean, math.sqrt(variance * stretch / count)
