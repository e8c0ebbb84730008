#!/usr/bin/env python3
"""Table of times to a calibrated friction, from the rows of calibration.sh.

Usage: calibration_table.py READING < ROWS. READING is a fit.json of the reading. A row: round method
wall_seconds cpu_seconds runs_made FIT, where FIT is a fit.json or what polynomial_fit.py writes.
"""
import json
import statistics
import sys
from dataclasses import dataclass

from ratios import BUSY, spread, table

DIRECT = "cold"
"""What the times of others are compared with."""
ERRORS = "stderr", "stderr_measurement", "stderr_simulation"
METHODS = {
    "emulator": "(a) pendular, emulator alone",
    "confirmed": "(b) pendular, emulator and runs",
    DIRECT: "(c) pendular, runs alone (--cold)",
    "lammps": "(d) LAMMPS and a polynomial",
}


@dataclass
class Row:
    round: int
    method: str
    wall: float
    cpu: float
    made: int
    fit: dict

    @classmethod
    def of(cls, line):
        number, method, wall, cpu, made, path = line.split()
        return cls(int(number), method, float(wall), float(cpu), int(made), read(path))

    @property
    def friction(self):
        return self.fit["parameters"]["friction"]

    @property
    def used(self):
        """Runs that the friction rests on, those of the atlas included."""
        return len(self.fit["runs"])


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def rounds(values):
    """'min / median / max', or the one value."""
    return spread(values, ".3g") if len(values) > 1 else format(values[0], ".3g")


def median(values, form):
    return format(statistics.median(values), form)


def over_direct(rows, direct):
    """Wall times over those of the same round; LAMMPS, which runs once, over the median."""
    by_round = {row.round: row.wall for row in direct}
    if len(rows) < len(direct):
        return [row.wall / statistics.median(by_round.values()) for row in rows]
    return [row.wall / by_round[row.round] for row in rows]


def print_reading(prediction):
    stress, measured = prediction["normal_stress"], prediction["measured"]
    shear, solid = measured["shear_stress"], measured["solid_fraction"]
    print(f"\nreading: stress ratio {shear['value'] / stress:g} +- {shear['stderr'] / stress:g}, solid "
          f"fraction {solid['value']:g} +- {solid['stderr']:g}, at {stress:g} Pa and I = "
          f"{prediction['inertial_number']:g}")


def print_methods(rows):
    of = {}
    for row in sorted(rows, key=lambda row: list(METHODS).index(row.method)):
        of.setdefault(row.method, []).append(row)
    table(
        ["", "wall time [s]", "over (c)", "processor time [s]", "friction", "standard error",
         "of measurement", "of simulation", "runs made", "runs used"],
        [
            [
                METHODS[method],
                rounds([row.wall for row in its]),
                rounds(over_direct(its, of[DIRECT])),
                rounds([row.cpu for row in its]),
                median([row.friction["value"] for row in its], ".4f"),
                *(median([row.friction[error] for row in its], ".4f") for error in ERRORS),
                median([row.made for row in its], "g"),
                median([row.used for row in its], "g"),
            ]
            for method, its in of.items()
        ],
    )
    for row in rows:
        if not row.fit["converged"]:
            print(f"  THE FIT DID NOT CONVERGE: {METHODS[row.method]}, round {row.round}")


def print_lammps(fit):
    shift, error = fit["correction"]
    print(f"\n(d) chi2 of the fit {fit['chi2']:.2f}; solid fractions corrected by {shift:.4f} +- {error:.4f}, "
          "from the overlaps\nmeasured, to the study's stiffness number "
          f"{fit['stiffness_number']:.0f}; chi2 of the runs about their polynomial:")
    for name, its in fit["polynomials"].items():
        print(f"  {name.replace('_', ' ')}: {its['chi2']:.1f} for {its['dof']} degrees of freedom")
    table(
        ["friction", "I", "stress ratio", "solid fraction (raw)", "normal stress", "overlap",
         "wall time [s]", "core share"],
        [
            [
                format(run["friction"], "g"),
                format(run["inertial_number"], "g"),
                "{:.4f} +- {:.4f}".format(*run["stress_ratio"]),
                "{:.5f} +- {:.5f}".format(*run["solid_fraction"]),
                format(run["normal_stress"], ".3f"),
                format(run["overlap"], ".5f"),
                format(run["wall_seconds"], ".1f"),
                format(core_share(run), ".2f"),
            ]
            for run in fit["runs"]
        ],
    )
    if min(map(core_share, fit["runs"])) < BUSY:
        print("\nTHE MACHINE WAS BUSY: a run of LAMMPS, which has one thread, had less than 95 % of a\n"
              "core. Trust processor times, not wall times, or measure again.")


def print_all(rows):
    print("\nAll measurements:")
    print("round,method,wall,cpu,friction", *ERRORS, "runs_made,runs_used", sep=",")
    for row in rows:
        numbers = row.wall, row.cpu, row.friction["value"], *(row.friction[error] for error in ERRORS)
        print(row.round, row.method, *(format(x, ".6g") for x in numbers), row.made, row.used, sep=",")


def core_share(run):
    return run["cpu_seconds"] / run["wall_seconds"]


def main():
    rows = [Row.of(line) for line in sys.stdin]
    print_reading(read(sys.argv[1])["predictions"][0])
    print("runs made: in the time given; those of the atlas, made before, are among the runs used\n")
    if max(row.round for row in rows) > 1:
        print("times of (a) to (c): min / median / max of the rounds; the rest: median of the rounds\n")
    print_methods(rows)
    for row in rows:
        if row.method == "lammps":
            print_lammps(row.fit)
    print_all(rows)


if __name__ == "__main__":
    main()
