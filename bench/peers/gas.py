#!/usr/bin/env python3
"""Writes non-touching beads of diameter 1 at random positions in a box of solid fraction 0.3.

Once sheared at solid fraction 0.62 the box will be a cube. Usage: gas.py BEADS SEED FILE; the file
is a LAMMPS data file, whose atom lines are: id type diameter density x y z.
"""
import itertools
import math
import random
import sys

VOLUME = math.pi / 6


def random_places(count, size, rng):
    """Each place at least 1 from those before it, in a periodic box; bins are at least 1 wide."""
    bins_along = [int(edge) for edge in size]
    bins = {}
    places = []
    while len(places) < count:
        at = [rng.random() * edge for edge in size]
        key = [min(int(at[d] / size[d] * bins_along[d]), bins_along[d] - 1) for d in range(3)]
        around = (
            tuple((key[d] + step[d]) % bins_along[d] for d in range(3))
            for step in itertools.product((-1, 0, 1), repeat=3)
        )
        if all(apart(at, other, size) >= 1 for k in around for other in bins.get(k, ())):
            bins.setdefault(tuple(key), []).append(at)
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
    edge = (count * VOLUME / 0.62) ** (1 / 3)
    size = [edge, count * VOLUME / 0.3 / edge**2, edge]
    places = random_places(count, size, random.Random(seed))
    with open(path, "w", encoding="ascii") as out:
        print("beads at random\n", file=out)
        print(f"{count} atoms\n1 atom types\n", file=out)
        for axis, length in zip("xyz", size):
            print(f"0 {length!r} {axis}lo {axis}hi", file=out)
        print("0 0 0 xy xz yz\n\nAtoms # sphere\n", file=out)
        for k, (x, y, z) in enumerate(places, 1):
            print(f"{k} 1 1.0 {1 / VOLUME!r} {x!r} {y!r} {z!r}", file=out)


if __name__ == "__main__":
    main()
