#!/usr/bin/env python3
"""Draws what theory.py says of the cells through what was simulated: the figure of
docs/explanation/cell.md, and its numbers. Needs gnuplot.

    draw.py [--out FILE.png]
"""
import argparse
import math
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE)]
sys.dont_write_bytecode = True
import cells  # noqa: E402
import theory  # noqa: E402
from cells import key_of, rows_of  # noqa: E402

SHOWN = (0, 0.05, 0.15, 0.3)  # wall frictions


def numbers(row):
    return {key: float(value) for key, value in row.items() if key != "cell"}


def cell_named(name):
    return next(cell for cell in cells.CELLS if cell.name == name)


def load():
    """States and profiles, from the base up, by cell, stress, inertial number and replicate."""
    states, profiles = {}, defaultdict(list)
    for row in rows_of("states.csv"):
        states[key_of(row)] = numbers(row)
    for row in rows_of("profiles.csv"):
        profiles[key_of(row)].append(numbers(row))
    return states, profiles


def mobilised(profile, depth, gap):
    """Friction stress over normal stress at the walls, over the depth."""
    layers = [p for p in profile if p["height [a]"] - 0.5 > gap - depth]
    drag = sum(p["wall_drag [s22]"] for p in layers)
    pressure = sum(p["wall_pressure [s22]"] for p in layers)
    return drag / pressure if pressure else 0.0


def predicted(cell, stress, inertial_number, wall_friction):
    weight = cells.weight(stress) * cell.grains / (cell.length * cell.width)
    return theory.profile(
        cell.height, cell.width, wall_friction, weight, inertial_number * cell.height
    )


def velocity(rate, step, speed):
    """Velocity over the lid's, at the bottom of each slice."""
    left, result = speed, []
    for each in rate:
        left -= each * step
        result.append(left / speed)
    return result


def strip(cell, state, at_lid):
    """Width of the strip beside each wall that adds nothing to the stress ratio at the lid [a]."""
    return (1 - state["stress_ratio [1]"] / at_lid) * cell.width / 2


def across():
    """Prints stress ratio and solid fraction over the distance from the side walls, by diameters, and
    the strip that the first four lack in strength against the rest."""
    runs = defaultdict(lambda: defaultdict(list))
    for row in rows_of("across.csv"):
        runs[key_of(row)][int(float(row["distance [a]"]))].append(numbers(row))
    for key, places in runs.items():
        ratios, fractions = [], []
        for _, strips in sorted(places.items()):
            shear = sum(s["shear_stress [s22]"] for s in strips)
            ratios.append(shear / sum(s["normal_stress [s22]"] for s in strips))
            fractions.append(sum(s["solid_fraction [1]"] for s in strips) / len(strips))
        middle = sum(ratios[4:]) / len(ratios[4:])
        lost = sum(1 - ratio / middle for ratio in ratios[:4])
        print(f"{key}: stress ratio", *(f"{x:.3f}" for x in ratios))
        print("   solid fraction", *(f"{x:.3f}" for x in fractions))
        print(f"   strip {lost:.2f}")


def summary(states, profiles):
    print(
        "cell, stress, I: sheared height, mobilised wall friction, stress ratio, and by theory;\n"
        "strip beside each wall that adds nothing to the strength, with its error"
    )
    strips = defaultdict(list)
    for key, state in sorted(states.items()):
        cell = cell_named(key[0])
        gap, height = state["gap [a]"], state["sheared_height [a]"]
        walls = mobilised(profiles[key], height, gap) if cell.wall_friction else 0
        at_lid, _, _, rate = predicted(cell, key[1], key[2], walls)
        print(
            f"{key[0]:32} {key[1]:5.0f} {key[2]:.2f} {key[3]}: {height:5.1f} {walls:.3f} "
            f"{state['stress_ratio [1]']:.3f}   {theory.sheared_height(rate, cell.height / 120):5.1f} "
            f"{at_lid:.3f}   {strip(cell, state, at_lid):5.2f} "
            f"{state['stress_ratio_stderr [1]'] / at_lid * cell.width / 2:.2f}"
        )
        strips[key[0]].append(strip(cell, state, at_lid))
    for name, all_of_it in strips.items():
        mean = sum(all_of_it) / len(all_of_it)
        spread = math.sqrt(sum((x - mean) ** 2 for x in all_of_it) / max(1, len(all_of_it) - 1))
        print(f"{name:32} strip {mean:.2f} +- {spread / math.sqrt(len(all_of_it)):.2f}")


def points(file, rows):
    file.write_text("\n".join(" ".join(f"{x:.5g}" for x in row) for row in rows) + "\n")
    return file


def draw(states, profiles, stress, inertial_number, height, out):
    folder = Path(tempfile.mkdtemp())
    velocities, drags = [], []
    for colour, wall_friction in enumerate(SHOWN, 1):
        name = f"walls {wall_friction:g}, height {height}"
        key = (name, stress, inertial_number, 1)
        if key not in states:
            continue
        cell, gap, profile = cell_named(name), states[key]["gap [a]"], profiles[key]
        speed = inertial_number * cell.height
        depth = [gap - (p["height [a]"] - 0.5) for p in profile]
        vx = [p["velocity [sqrt(a s22 a/m)]"] / speed for p in profile]
        file = points(folder / f"v{colour}", list(zip(depth, vx))[1:-1])
        velocities.append(f"'{file}' with points pt 7 lc {colour} title 'walls {wall_friction:g}'")
        walls = mobilised(profile, states[key]["sheared_height [a]"], gap)
        _, deep, ratio, rate = predicted(cell, stress, inertial_number, walls)
        step = cell.height / len(rate)
        file = points(folder / f"t{colour}", zip([d + step / 2 for d in deep], velocity(rate, step, speed)))
        velocities.append(f"'{file}' with lines lc {colour} notitle")
        stresses = [p["shear_stress [s22]"] / p["normal_stress [s22]"] for p in profile]
        file = points(folder / f"m{colour}", list(zip(depth, stresses))[1:-1])
        drags.append(f"'{file}' with points pt 7 lc {colour} notitle")
        file = points(folder / f"r{colour}", zip(deep, ratio))
        drags.append(f"'{file}' with lines lc {colour} notitle")
    script = f"""\
set terminal pngcairo size 1100,480 font 'sans,11'
set output '{out}'
set multiplot layout 1,2
set xlabel 'depth under the lid [diameters]'
set xrange [0:{height}]
set ylabel 'velocity/velocity of the lid'
set yrange [0:1]
plot {', '.join(velocities)}
set ylabel 'shear stress/normal stress'
set yrange [0.2:0.36]
plot {theory.QUASI_STATIC} with lines dt 2 lc 'gray' title 'quasi-static', {', '.join(drags)}
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--out", type=Path, default=HERE.parents[1] / "docs/explanation/cell.png")
    parser.add_argument("--stress", type=float, default=3000)
    parser.add_argument("--inertial-number", type=float, default=0.02)
    parser.add_argument("--height", type=int, default=12)
    given = parser.parse_args()
    states, profiles = load()
    summary(states, profiles)
    across()
    draw(states, profiles, given.stress, given.inertial_number, given.height, given.out)


if __name__ == "__main__":
    main()
