#!/usr/bin/env python3
"""Compares cohesion.cpp with LAMMPS' own tabulated force where both can do the same: reversible
bridges in a gas that is closed. Prints the largest difference of a stress, relative to the largest
stress so far.

    check_cohesion.py [--work FOLDER]
"""
import argparse
import math
import shutil
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from run_worlds import HERE, build_cohesion  # noqa: E402

FORCE, VOLUME = 0.462, 0.0036
RANGE = VOLUME ** (1 / 3)
ENTRIES = 40001


def force(gap):
    return FORCE * (1 - max(gap, 0) / math.sqrt(max(gap, 0) ** 2 + 4 * VOLUME / math.pi))


def write_table(file):
    """The potential does not act; LAMMPS wants it."""
    first, last = 0.98, 1 + RANGE
    lines = ["# distance, potential, force", "", "BRIDGE", f"N {ENTRIES} R {first} {last:.10f}", ""]
    for k in range(ENTRIES):
        distance = first + (last - first) * k / (ENTRIES - 1)
        lines.append(f"{k + 1} {distance:.10f} 0 {-force(distance - 1):.12g}")
    file.write_text("\n".join(lines) + "\n", encoding="ascii")


def write_input(work):
    """sample.lmp with the table over its contacts, and closing.lmp."""
    sample = (HERE / "sample.lmp").read_text(encoding="ascii")
    overlay = f"pair_style hybrid/overlay granular table linear {ENTRIES}"
    sample = sample.replace("pair_style granular", overlay)
    sample = sample.replace("pair_coeff * * hertz", "pair_coeff * * granular hertz")
    sample += f"pair_coeff * * table {work}/bridge.table BRIDGE {1 + RANGE:.10f}\n"
    (work / "table.lmp").write_text(sample + f"include {HERE}/closing.lmp\n", encoding="ascii")
    # What the program reads from its folder.
    shutil.copy(HERE / "sample.lmp", work / "sample.lmp")
    shutil.copy(HERE / "closing.lmp", work / "flow.lmp")


def stresses(words):
    said = subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True)
    rows = [line.split() for line in said.stdout.splitlines()]
    rows = [row for row in rows if len(row) == 5 and row[0].isdigit()]
    return [[float(cell) for cell in row[1:4]] for row in rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--work", type=Path, default=HERE.parents[1] / "build/foreign-worlds/check")
    work = parser.parse_args().work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    build_cohesion(work)
    gas = [sys.executable, HERE.parent / "peers/gas.py", "1000", "3", work / "gas"]
    subprocess.run(gas, check=True)
    write_table(work / "bridge.table")
    write_input(work)
    variables = {"gas": work / "gas", "modulus": 31622.8, "friction": 0.11}
    variables |= {"rolling": 0, "time_step": 0.0053}
    given = [word for name, value in variables.items() for word in ("-var", name, value)]
    own = stresses([work / "cohesion", "reversible", FORCE, VOLUME, work, *given])
    table = stresses(["lmp", "-log", "none", "-in", work / "table.lmp", *given])
    assert len(own) == len(table) > 20
    largest = difference = 0
    for one, other in zip(own, table):
        largest = max([largest, *map(abs, other)])
        difference = max([difference, *(abs(a - b) / largest for a, b in zip(one, other))])
    print(f"{len(own)} times, normal stress up to {largest:.3g}: differences up to {difference:.1e}")


if __name__ == "__main__":
    main()
