#!/usr/bin/env python3
"""Draws what theory.py says of the cells through what was simulated: the figures of
docs/explanation/cell.md, and their numbers. Needs gnuplot.

    draw.py [--out FILE.png] [--walls FILE.png]
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
    """States and profiles of dry beds, from the base up, by cell, stress, inertial number and replicate.
    The theory is of dry beds."""
    states, profiles = {}, defaultdict(list)
    for row in rows_of("states.csv"):
        if not cell_named(row["cell"]).bridge_volume:
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


def print_means(strips, what):
    """Prints the mean over the states of each cell, with its standard error."""
    for name, all_of_it in sorted(strips.items()):
        mean = sum(all_of_it) / len(all_of_it)
        spread = math.sqrt(sum((x - mean) ** 2 for x in all_of_it) / max(1, len(all_of_it) - 1))
        error = spread / math.sqrt(len(all_of_it))
        print(f"{name:36} {what} {mean:.2f} +- {error:.2f} ({len(all_of_it)} states)")


def across():
    """Prints stress ratio and solid fraction over the distance from the side walls, by diameters, and
    the strip that the first four lack in strength against the rest."""
    runs = defaultdict(lambda: defaultdict(list))
    for row in rows_of("across.csv"):
        if cell_named(row["cell"]).bridge_volume:
            continue
        runs[key_of(row)][int(float(row["distance [a]"]))].append(numbers(row))
    lost_in = defaultdict(list)
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
        lost_in[key[0]].append(lost)
    print_means(lost_in, "strip lost across")


def summary(states, profiles):
    print(
        "cell, stress, I: sheared height, mobilised wall friction, stress ratio, and by theory;\n"
        "strip beside each wall that adds nothing to the strength, with its error"
    )
    strips = defaultdict(list)
    for key, state in sorted(states.items()):
        cell = cell_named(key[0])
        # theory.py has the stress ratios of equal, free, dry grains.
        if cell.rolling or cell.deviation or cell.bridge_volume:
            continue
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
    print_means(strips, "strip")


def layers(profile):
    """Inner layers that no lid or base cuts, with velocity over shear rate and inertial number."""
    most = max(p["solid_fraction [1]"] for p in profile)
    for below, p, above in zip(profile, profile[1:], profile[2:]):
        if p["solid_fraction [1]"] < 0.75 * most:
            continue
        rise = above["velocity [sqrt(a s22 a/m)]"] - below["velocity [sqrt(a s22 a/m)]"]
        rate = rise / (above["height [a]"] - below["height [a]"])
        yield p, p["velocity [sqrt(a s22 a/m)]"] / rate, rate / math.sqrt(p["normal_stress [s22]"])


def sliding_friction(cell):
    """That of the walls, with grains that do not roll as freely all of the wall friction."""
    return cell.wall_friction if cell.rolling else theory.sliding_friction(cell.wall_friction)


def share_along(cell, layer):
    """Friction of the walls along the flow, over that of sliding grains."""
    return layer["wall_drag [s22]"] / layer["wall_pressure [s22]"] / sliding_friction(cell)


RANGES = (0, 1.5, 3, 4.5, 6)  # of velocity over rate [a]


def walls(states, profiles):
    """Prints what walls mobilise along the flow, over the friction of sliding grains, by velocity over
    rate, and the part of the load that they carry, beside what the effect wall-friction says."""
    print(
        "\ncell and sample: share along the flow by velocity over rate, seen and by the law; rms and\n"
        "mean difference of layers; part of the load carried, by the effect, and by a wall at rest [%]"
    )
    samples = defaultdict(list)
    for key in sorted(states):
        if cell_named(key[0]).wall_friction:
            samples[key[0], key[3]].append(key)
    for (name, replicate), keys in samples.items():
        cell = cell_named(name)
        seen, law = defaultdict(list), defaultdict(list)
        for key in keys:
            for p, length, inertial in layers(profiles[key]):
                place = sum(length >= limit for limit in RANGES)
                seen[place].append(share_along(cell, p))
                law[place].append(theory.mobilised_share(length, inertial))
        shares = "; ".join(
            f"{sum(seen[k]) / len(seen[k]):.2f} {sum(law[k]) / len(law[k]):.2f}" for k in sorted(seen)
        )
        off = [x - y for k in seen for x, y in zip(seen[k], law[k])]
        rms, mean = math.sqrt(sum(x * x for x in off) / len(off)), sum(off) / len(off)
        lifts = [sum(p["wall_lift [s22]"] for p in profiles[key]) for key in keys]
        carried = -100 * 2 * sum(lifts) / len(lifts) / cell.width
        rest = 2 * cell.wall_friction * 0.94 * cell.height / cell.width
        of_effect, of_rest = (100 * (1 - math.exp(-share * rest)) for share in (0.09, 1))
        print(
            f"{name:36} {replicate}: {shares}   {rms:.3f} {mean:+.3f}   {carried:.2f} {of_effect:.2f} {of_rest:.1f}"
        )


def points(file, rows):
    file.write_text("\n".join(" ".join(f"{x:.5g}" for x in row) for row in rows) + "\n")
    return file


def two_panels(out, left, right):
    """Draws two plots side by side. `left`, `right`: commands of gnuplot."""
    frame = f"set terminal pngcairo size 1100,480 font 'sans,11'\nset output '{out}'\nset multiplot layout 1,2\n"
    subprocess.run(["gnuplot"], input=f"{frame}{left}\n{right}\n", text=True, check=True)


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
    two_panels(
        out,
        f"""set xlabel 'depth under the lid [diameters]'
set xrange [0:{height}]
set ylabel 'velocity/velocity of the lid'
set yrange [0:1]
plot {', '.join(velocities)}""",
        f"""set ylabel 'shear stress/normal stress'
set yrange [0.2:0.36]
plot {theory.QUASI_STATIC} with lines dt 2 lc 'gray' title 'quasi-static', {', '.join(drags)}""",
    )


def draw_walls(states, profiles, out):
    """Left: shares of all layers over velocity over rate, in units of the length of theory.py. Right:
    shear stress over the depth, and what the drag of the walls by theory.py leaves of that at the lid."""
    folder = Path(tempfile.mkdtemp())
    rows = defaultdict(list)
    for key in states:
        cell = cell_named(key[0])
        if not cell.wall_friction:
            continue
        fitted = key[0].startswith("walls") and cell.height == 12 and key[3] == 1
        kind = "rolling" if cell.rolling else "fitted" if fitted else "other"
        for p, length, inertial in layers(profiles[key]):
            rows[kind].append((length / theory.sliding_length(inertial), share_along(cell, p)))
    titles = {"other": "other cells and samples", "fitted": "cells of the fit", "rolling": "grains with rolling resistance"}
    shares = [
        f"'{points(folder / kind, rows[kind])}' with points pt 7 ps 0.5 lc {colour} title '{title}'"
        for colour, (kind, title) in zip((7, 1, 2), titles.items())
        if rows[kind]
    ]
    stresses = []
    for colour, wall_friction in enumerate(SHOWN, 1):
        name = f"walls {wall_friction:g}, height 12"
        key = (name, 3000, 0.06, 1)
        cell, gap = cell_named(name), states[key]["gap [a]"]
        inner = list(layers(profiles[key]))
        deep = [gap - (p["height [a]"] - 0.5) for p, _, _ in inner]
        file = points(folder / f"s{colour}", zip(deep, (p["shear_stress [s22]"] for p, _, _ in inner)))
        stresses.append(f"'{file}' with points pt 7 lc {colour} title 'walls {wall_friction:g}'")
        above, stress = 0, states[key]["stress_ratio [1]"]
        line = [(above, stress)]
        for (p, length, inertial), depth in reversed(list(zip(inner, deep))):
            friction = theory.sliding_friction(wall_friction) * theory.mobilised_share(length, inertial)
            drag = 2 * friction * p["wall_pressure [s22]"] / cell.width
            stress -= drag * (depth + 0.5 - above)
            above = depth + 0.5
            line.append((above, stress))
        file = points(folder / f"l{colour}", line)
        stresses.append(f"'{file}' with lines lc {colour} notitle")
    two_panels(
        out,
        f"""set xlabel 'velocity/(shear rate x sliding length)'
set ylabel 'friction along the flow/that of sliding grains'
set xrange [0:3]
set yrange [-0.1:1.3]
set key bottom right
plot {', '.join(shares)}, tanh(x) with lines lw 2 lc 'black' title 'tanh'""",
        f"""set xlabel 'depth under the lid [diameters]'
set ylabel 'shear stress/load'
set xrange [0:12]
set yrange [0.24:0.38]
set key top right
plot {', '.join(stresses)}""",
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--out", type=Path, default=HERE.parents[1] / "docs/explanation/cell.png")
    parser.add_argument(
        "--walls", type=Path, default=HERE.parents[1] / "docs/explanation/cell_walls.png"
    )
    parser.add_argument("--stress", type=float, default=3000)
    parser.add_argument("--inertial-number", type=float, default=0.02)
    parser.add_argument("--height", type=int, default=12)
    given = parser.parse_args()
    states, profiles = load()
    summary(states, profiles)
    across()
    walls(states, profiles)
    draw_walls(states, profiles, given.walls)
    draw(states, profiles, given.stress, given.inertial_number, given.height, given.out)


if __name__ == "__main__":
    main()
