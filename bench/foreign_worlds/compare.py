#!/usr/bin/env python3
"""Compares states.csv with Pendular's simulations of the same set points, those of the benchmark
(bench/hidden_effects/runs.csv, stiffness number 1500). Prints, for each set of states, the mean of
LAMMPS (or YADE) minus Pendular in per cent, with its standard error, and chi2 of the set points.

Solid fractions are corrected to stiffness number 1000 by 4.1/stiffness number, times (contact
stress/normal stress)^(2/3); the capillary stress is Rumpf's, 0.6 Z 0.9 F0/(pi a^2), Z bridges a
grain, of which 0.9 F0 is the mean force.
"""
import csv
import math
from collections import defaultdict
from pathlib import Path

HERE = Path(__file__).resolve().parent
EFFECTS = {
    "plain": "",
    "wet": "",
    "plain-yade": "",
    "wet-reversible": "reversible-bridges.on=1",
    "polydispersity": "polydispersity.deviation=0.114",
}


def rows_of(file):
    with open(file, encoding="ascii") as text:
        yield from csv.DictReader(line for line in text if not line.startswith("#"))


def number(row, column):
    return float(row[column] or 0)


def pendular_runs():
    """Stress ratio and solid fraction by effect and inertial number, with pressure and volume."""
    runs = defaultdict(list)
    for row in rows_of(HERE.parent / "hidden_effects/runs.csv"):
        if row["friction"] == "0.11" and row["beads"] == "1200" and not row["failure"]:
            names = ["reduced_pressure", "bridge_volume", "stress_ratio", "stress_ratio_stderr"]
            names += ["solid_fraction", "solid_fraction_stderr"]
            key = row["effects"], number(row, "inertial_number")
            runs[key].append([number(row, name) for name in names])
    return runs


def foreign_states():
    """Runs by set point; rigid dry grains know no normal stress."""
    states, seen = defaultdict(list), set()
    for row in rows_of(HERE / "states.csv"):
        if row["seed"] in seen:  # one run of YADE serves several rows
            continue
        seen.add(row["seed"])
        attraction, volume = number(row, "attraction [a2 s22]"), number(row, "bridge_volume [a3]")
        states[row["world"], number(row, "inertial_number [1]"), attraction, volume].append(row)
    return states


def runs_of(runs, world, inertial_number, attraction):
    """Those of the world's effect."""
    if world != "adhesion":
        return runs[EFFECTS.get(world), inertial_number]
    forces = {
        float(effect.split("=")[1]): effect
        for effect, rate in runs
        if effect and effect.startswith("dry-adhesion.force=") and rate == inertial_number
    }
    force = min(forces, key=lambda each: abs(each - attraction))
    return runs[forces[force], inertial_number] if abs(force / attraction - 1) < 0.01 else []


def alike(run, attraction, volume):
    pressure, its_volume = run[:2]
    if volume == 0:
        return pressure == 0
    near = abs(pressure * attraction - 1) < 0.01 and abs(its_volume / volume - 1) < 0.03
    return pressure > 0 and near


def stiffness_correction(rows, attraction, volume):
    bridges = 0
    if volume > 0:
        content = sum(number(row, "mean_liquid_content [1]") for row in rows) / len(rows)
        bridges = math.pi * content / (3 * volume)
    contact_stress = 1 + 0.6 * bridges * 0.9 * attraction / math.pi
    return 4.1 * (1 / 1000 - 1 / 1500) * contact_stress ** (2 / 3)


def mean_of(values, errors):
    return sum(values) / len(values), math.sqrt(sum(error**2 for error in errors)) / len(values)


def main():
    runs, differences = pendular_runs(), defaultdict(list)
    for (world, inertial_number, attraction, volume), rows in foreign_states().items():
        of_effect = runs_of(runs, world, inertial_number, attraction)
        known = [run for run in of_effect if alike(run, attraction, volume)]
        if not known:
            continue
        for name, column in (("stress_ratio", 2), ("solid_fraction", 4)):
            own, own_error = mean_of(*([run[k] for run in known] for k in (column, column + 1)))
            if name == "solid_fraction":
                own += stiffness_correction(rows, attraction, volume)
            columns = f"{name} [1]", f"{name}_stderr [1]"
            other, error = mean_of(*([number(row, each) for row in rows] for each in columns))
            difference = 100 * (other / own - 1), 100 * math.hypot(error, own_error) / own
            differences[world, name].append(difference)
    for (world, name), pairs in differences.items():
        weight = sum(1 / error**2 for _, error in pairs)
        mean = sum(difference / error**2 for difference, error in pairs) / weight
        chi2 = sum((difference / error) ** 2 for difference, error in pairs)
        error = weight**-0.5
        print(f"{world:<16} {name:<15} {mean:+.3f} +- {error:.3f} %, chi2 {chi2:.1f} of {len(pairs)}")


if __name__ == "__main__":
    main()
