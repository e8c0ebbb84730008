#!/usr/bin/env python3
"""Writes the recordings of this folder: what an annular cell would have shown of beads whose steady
state is known from an independent simulation.

The truth is the row of tests/physics/reference/dry-lammps.csv with friction 0.15, inertial number
0.003 and stiffness number 1000 (LAMMPS, 2000 beads): stress ratio 0.2929 +- 0.0028, solid fraction
0.6119 +- 0.0002. Its own standard errors are common to all recordings and not part of their scatter.

Three replicates of three steps (0.5, 1 and 2 kPa), each with a start-up transient, noise correlated
over 0.4 s, and scatter between the replicates of 4 % in torque and 0.4 % in solid fraction.

Usage: python3 make_recordings.py        (rewrites dry_1.csv to dry_3.csv here)
"""
import math
import pathlib
import random

STRESS_RATIO, SOLID_FRACTION, INERTIAL_NUMBER = 0.2929, 0.6119, 0.003
DIAMETER, DENSITY = 500e-6, 1050.0  # m, kg/m^3
INNER, OUTER, BEAD_MASS = 21e-3, 45e-3, 20e-3  # m, m, kg
NORMAL_STRESSES = (500.0, 1000.0, 2000.0)  # Pa
STEP_SECONDS, SAMPLING_SECONDS = 90.0, 0.2
TRANSIENT_SECONDS = 4.0
CORRELATION_SECONDS = 0.4
NOISE = {"torque": 0.03, "height": 0.002, "force": 0.002}  # relative, within a run
SCATTER = {"torque": 0.04, "height": 0.004}  # relative, between replicates

AREA = math.pi * (OUTER**2 - INNER**2)
MASS = DENSITY * math.pi * DIAMETER**3 / 6


def correlated(random_source, steps):
    """Gaussian noise of unit variance with an exponential memory (AR(1))."""
    keep = math.exp(-SAMPLING_SECONDS / CORRELATION_SECONDS)
    value = random_source.gauss(0, 1)
    for _ in range(steps):
        yield value
        value = keep * value + math.sqrt(1 - keep**2) * random_source.gauss(0, 1)


def step_rows(random_source, start, interval, normal_stress):
    """One step: start-up from a dense, unloaded state to steady shear."""
    rate = INERTIAL_NUMBER * math.sqrt(DIAMETER * normal_stress / MASS)
    height = BEAD_MASS / DENSITY / (AREA * SOLID_FRACTION) * (1 + random_source.gauss(0, SCATTER["height"]))
    speed = 2 * height * rate / (INNER + OUTER)
    torque = STRESS_RATIO * normal_stress * 2 * math.pi * (OUTER**3 - INNER**3) / 3
    torque *= 1 + random_source.gauss(0, SCATTER["torque"])
    count = round(STEP_SECONDS / SAMPLING_SECONDS)
    noises = zip(*(correlated(random_source, count) for _ in range(3)))
    for k, (a, b, c) in enumerate(noises):
        time = k * SAMPLING_SECONDS
        fading = math.exp(-time / TRANSIENT_SECONDS)
        yield (
            start + time,
            torque * (1 + 0.35 * fading - 1.1 * math.exp(-time / 0.5) + NOISE["torque"] * a),
            AREA * normal_stress * (1 + NOISE["force"] * b),
            height * (1 - 0.02 * fading + NOISE["height"] * c),
            speed,
            interval,
        )


def write_recording(path, seed):
    random_source = random.Random(seed)
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write("Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s],Interval [1]\n")
        for interval, normal_stress in enumerate(NORMAL_STRESSES, 1):
            start = (interval - 1) * STEP_SECONDS
            for t, torque, force, height, speed, step in step_rows(random_source, start, interval, normal_stress):
                file.write(f"{t:.1f},{1e3 * torque:.4f},{force:.5f},{1e3 * height:.5f},{speed:.6f},{step}\n")


def main():
    here = pathlib.Path(__file__).parent
    for replicate in (1, 2, 3):
        write_recording(here / f"dry_{replicate}.csv", seed=100 + replicate)


if __name__ == "__main__":
    main()
