#!/usr/bin/env python3
"""Time and memory of `pendular calibrate` and `diagnose` for studies of 20 to 3000 readings at random conditions.

    bench/many_readings.py PROGRAM [--readings 20,60,200,300,1000,3000] [--commands calibrate,diagnose]
                           [--folder build/many] [--tension "26 mN/m"]

The readings are predictions of one calibrated model with random errors: 300 predictions of `compare`, and
polynomials through them (RMS residual 4e-6) for other conditions. --tension: the study states another surface
tension than that of the readings (20.6 mN/m), so that a model with an effect is searched.
"""
import argparse
import json
import math
import os
import pathlib
import random
import subprocess
import time

STUDY = """[grains]
diameter = "500 um"
density = "1050 kg/m^3"
youngs_modulus = "3.3 GPa"
poisson_ratio = 0.3
[liquid]
surface_tension = "{}"
contact_angle = "0 deg"
viscosity = "50 mPa.s"
[[readings]]
file = "points.csv"
[model]
fit_to = "all"
"""
HEADER = ("normal_stress [Pa],stress_ratio,stress_ratio_sd,solid_fraction,solid_fraction_sd,"
          "inertial_number,liquid_content\n")
DEGREE = 4


def conditions(count):
    """Random conditions: normal stress [Pa], inertial number, liquid content."""
    rnd = random.Random(1000 + count)
    return [(float(f"{300 * 10 ** rnd.random():.6g}"), float(f"{0.003 * 26.7 ** rnd.random():.6g}"),
             rnd.choice([0, 0, 0.007, 0.03])) for _ in range(count)]


def write_study(folder, tension, points, values):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "study.toml").write_text(STUDY.format(tension))
    rows = [f"{s},{m:.7g},{0.02 * m:.4g},{p:.7g},{0.005 * p:.4g},{rate},{c}\n"
            for (s, rate, c), (m, p) in zip(points, values)]
    (folder / "points.csv").write_text(HEADER + "".join(rows))


def terms(stress, rate):
    x, u = math.sqrt(rate) / 0.28, 300 / stress
    return [x ** a * u ** b for a in range(DEGREE + 1) for b in range(DEGREE + 1 - a)]


def least_squares(rows, values):
    """Coefficients by Gram-Schmidt, twice for accuracy."""
    count = len(rows[0])
    columns = [[row[k] for row in rows] for k in range(count)]
    upper = [[0.0] * count for _ in range(count)]
    rest, along = list(values), [0.0] * count
    for k in range(count):
        for _ in range(2):
            for j in range(k):
                part = sum(a * b for a, b in zip(columns[j], columns[k]))
                upper[j][k] += part
                columns[k] = [b - part * a for a, b in zip(columns[j], columns[k])]
        upper[k][k] = math.sqrt(sum(a * a for a in columns[k]))
        columns[k] = [a / upper[k][k] for a in columns[k]]
        along[k] = sum(a * b for a, b in zip(columns[k], rest))
        rest = [b - along[k] * a for a, b in zip(columns[k], rest)]
    result = [0.0] * count
    for k in reversed(range(count)):
        known = sum(upper[k][j] * result[j] for j in range(k + 1, count))
        result[k] = (along[k] - known) / upper[k][k]
    return result


def model(program, folder):
    """Coefficients of stress ratio and solid fraction by liquid content."""
    points = conditions(300)
    write_study(folder, "20.6 mN/m", points, [(0.3 + rate, 0.6 - 0.2 * rate) for _, rate, _ in points])
    subprocess.run([program, "calibrate", folder, "--no-confirm", "--quiet"], check=True,
                   stdout=subprocess.DEVNULL)
    told = subprocess.run([program, "compare", folder, "--json", "-", "--quiet"], check=True,
                          capture_output=True, text=True).stdout
    by_content = {}
    for condition in json.loads(told)["by_condition"]:
        for one in condition["readings"]:
            by_content.setdefault(one["liquid_content"], []).append(one)
    result = {}
    for content, readings in by_content.items():
        rows = [terms(one["normal_stress"], one["inertial_number"]) for one in readings]
        ratios = [one["predicted"]["shear_stress"]["value"] / one["normal_stress"] for one in readings]
        fractions = [one["predicted"]["solid_fraction"]["value"] for one in readings]
        result[content] = least_squares(rows, ratios), least_squares(rows, fractions)
    return result


def measure(program, command, study, count):
    more = ["--no-confirm"] if command == "calibrate" else []
    begin = time.monotonic()
    with subprocess.Popen([program, command, study, "--quiet", *more], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True) as running:
        answer = running.stdout.readline().strip()
        running.stdout.read()
        _, _, used = os.wait4(running.pid, 0)
    print(f"{command:9} {count:6d} readings: {time.monotonic() - begin:6.1f} s, processor "
          f"{used.ru_utime + used.ru_stime:6.1f} s, {used.ru_maxrss // 1024} MB: {answer}", flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("program", type=pathlib.Path)
    options.add_argument("--readings", default="20,60,200,300,1000,3000")
    options.add_argument("--commands", default="calibrate,diagnose")
    options.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("build/many"))
    options.add_argument("--tension", default="20.6 mN/m")
    given = options.parse_args()
    os.environ.setdefault("PENDULAR_STORE", str(given.folder / "store.sqlite"))
    given.folder.mkdir(parents=True, exist_ok=True)
    program = given.program.resolve()
    laws = model(program, given.folder / "model")
    for count in map(int, given.readings.split(",")):
        points, rnd, values = conditions(count), random.Random(7), []
        for stress, rate, content in points:
            exact = [sum(a * b for a, b in zip(terms(stress, rate), law)) for law in laws[content]]
            values.append((exact[0] * (1 + 0.02 * rnd.gauss(0, 1)), exact[1] * (1 + 0.005 * rnd.gauss(0, 1))))
        study = given.folder / f"of_{count}"
        write_study(study, given.tension, points, values)
        for command in given.commands.split(","):
            measure(program, command, study, count)


if __name__ == "__main__":
    main()
