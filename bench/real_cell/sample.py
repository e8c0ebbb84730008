"""Random sample of a cell: base and lid of glued grains, and a gas of free grains between them."""
import math
import random

SPACING = 1.15  # of glued grains
ROUGH = 0.3  # largest offset of a glued grain from its plane


def plane(rng, length, width, height):
    columns, rows = round(length / SPACING), round(width / SPACING)
    for i in range(columns):
        for j in range(rows):
            yield (
                (i + 0.5 + 0.15 * (rng.random() - 0.5)) * length / columns,
                (j + 0.5 + 0.15 * (rng.random() - 0.5)) * width / rows,
                height + ROUGH * (2 * rng.random() - 1),
            )


def gas(rng, grains, length, width, bottom):
    columns, rows = int(length / 1.08), int((width - 0.1) / 1.08)
    places = []
    layer = 0
    while len(places) < grains:
        shift = 0.5 * (layer % 2)
        for i in range(columns):
            for j in range(rows):
                places.append(
                    (
                        ((i + shift + 0.5) * length / columns) % length,
                        0.05 + (j + 0.5) * (width - 0.1) / rows,
                        bottom + 1.08 * layer,
                    )
                )
        layer += 1
    top = bottom + 1.08 * (layer - 1)
    return rng.sample(places, grains), top


def grain(number, kind, diameter, place):
    density = 6 / math.pi  # mass 1 at diameter 1
    x, y, z = place
    return f"{number} {kind} {diameter:.6f} {density:.9f} {x:.6f} {y:.6f} {z:.6f}"


def write(file, grains, length, width, seed, deviation=0.0):
    """Writes LAMMPS' data file. Returns the number of glued grains of the lid and the volume of the
    free grains [a3]; diameters are uniform with a standard deviation of `deviation`."""
    rng = random.Random(seed)
    base = list(plane(rng, length, width, 0))
    free, top = gas(rng, grains, length, width, 1.4)
    lid = list(plane(rng, length, width, top + 1.4))
    half = math.sqrt(3) * deviation
    diameters = [1 + half * (2 * rng.random() - 1) for _ in free]
    atoms = [(1, d, p) for d, p in zip(diameters, free)]
    atoms += [(2, 1, p) for p in base] + [(3, 1, p) for p in lid]
    with open(file, "w", encoding="ascii") as out:
        out.write(f"grains of a cell\n\n{len(atoms)} atoms\n3 atom types\n\n0 {length} xlo xhi\n")
        out.write(f"0 {width} ylo yhi\n-2 {top + 4} zlo zhi\n\nAtoms # sphere\n\n")
        for k, (kind, diameter, place) in enumerate(atoms, 1):
            out.write(grain(k, kind, diameter, place) + "\n")
        out.write("\nVelocities\n\n")
        for k, (kind, _, _) in enumerate(atoms, 1):
            v = [0.3 * rng.gauss(0, 1) if kind == 1 else 0 for _ in range(3)]
            out.write(f"{k} {v[0]:.5f} {v[1]:.5f} {v[2]:.5f} 0 0 0\n")
    return len(lid), sum(math.pi / 6 * d**3 for d in diameters)
