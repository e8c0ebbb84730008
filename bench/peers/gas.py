#!/usr/bin/env python3
"""Writes non-touching beads of mean diameter 1 at random positions in a box of solid fraction 0.3.

Once sheared at solid fraction 0.62 the box will be a cube. Usage: gas.py BEADS SEED FILE [DEVIATION];
DEVIATION: standard deviation of the diameters, which are evenly spaced quantiles of a uniform
distribution. The file is a LAMMPS data file, whose atom lines are: id type diameter density x y z.
"""
import itertools
import math
import random
import sys

VOLUME = math.pi / 6


def spread_diameters(count, deviation, rng):
    """In random order."""
    half_range = math.sqrt(3) * deviation
    diameters = [1 + half_range * ((2 * k + 1) / count - 1) for k in range(count)]
    if deviation > 0:
        rng.shuffle(diameters)
    return diameters


def random_places(diameters, size, rng):
    """No bead touches one before it, in a periodic box; bins are at least a diameter wide."""
    bins_along = [int(edge / max(diameters)) for edge in size]
    bins = {}
    places = []
    while len(places) < len(diameters):
        at = [rng.random() * edge for edge in size]
        key = [min(int(at[d] / size[d] * bins_along[d]), bins_along[d] - 1) for d in range(3)]
        around = (
            tuple((key[d] + step[d]) % bins_along[d] for d in range(3))
            for step in itertools.product((-1, 0, 1), repeat=3)
        )
        diameter = diameters[len(places)]
        if all(
            apart(at, other, size) >= ((diameter + others) / 2) ** 2
            for k in around
            for other, others in bins.get(k, ())
        ):
            bins.setdefault(tuple(key), []).append((at, diameter))
            places.append(at)
    return places


def apart(a, b, size):
    """Squared distance of the nearest images."""
    total = 0
    for d in range(3):
        step = a[d] - b[d]
        step -= size[d] * round(step / size[d])
        total += step * step
    return total


def main():
    count, seed, path = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
    rng = random.Random(seed)
    diameters = spread_diameters(count, float(sys.argv[4]) if len(sys.argv) > 4 else 0, rng)
    solid = VOLUME * sum(diameter**3 for diameter in diameters)
    edge = (solid / 0.62) ** (1 / 3)
    size = [edge, solid / 0.3 / edge**2, edge]
    places = random_places(diameters, size, rng)
    with open(path, "w", encoding="ascii") as out:
        print("beads at random\n", file=out)
        print(f"{count} atoms\n1 atom types\n", file=out)
        for axis, length in zip("xyz", size):
            print(f"0 {length!r} {axis}lo {axis}hi", file=out)
        print("0 0 0 xy xz yz\n\nAtoms # sphere\n", file=out)
        for k, (diameter, (x, y, z)) in enumerate(zip(diameters, places), 1):
            print(f"{k} 1 {diameter!r} {1 / VOLUME!r} {x!r} {y!r} {z!r}", file=out)


if __name__ == "__main__":
    main()
