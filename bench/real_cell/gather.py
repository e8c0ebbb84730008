#!/usr/bin/env python3
"""Gathers finished runs of run_cells.py into the tables that ship: states.csv (a row for each run),
profiles.csv (a row for each layer of a run), across.csv (a row for each strip along the walls, of runs
that recorded them) and series.csv (what an instrument records). Rows of runs that are not in the work
folder stay as they are.

    gather.py [--work FOLDER] [--out FOLDER]
"""
import argparse
import csv
import sys
from collections import defaultdict
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
sys.dont_write_bytecode = True
import run_cells  # noqa: E402
from block_average import mean_and_error  # noqa: E402

KEYS = "cell,normal_stress [Pa],inertial_number [1],replicate"
HEADER = """\
# What LAMMPS found (29 Sep 2021, update 2; Debian lammps 20220106.git7586adbb6a) in cells with side
# walls; README.md says what is simulated and what the columns are. Units in brackets; a = m = load
# per area = 1 where a symbol stands.
"""
BLOCK = 5  # rows, strain 0.2
SETTLING = 5  # rows that are not kept: the lid changes its speed at once when a run begins


def mean(values):
    return sum(values) / len(values)


def rows_of(file):
    for line in file.read_text(encoding="ascii").splitlines():
        if not line.startswith("#"):
            yield [float(word) for word in line.split()]


def series_of(run, folder):
    """Rows of shear stress, normal stress and gap between the mean planes of the glued grains."""
    area = run.cell.length * run.cell.width
    return [(t / area, n / area, gap - 1) for _, t, n, gap in rows_of(folder / "series")]


def last_average(file):
    """Rows of the last of the averages in a file, each of which is over all that went before."""
    rows = []
    for row in rows_of(file):
        if len(row) == 3:  # begins a newer one
            rows = []
            continue
        rows.append(row[1:])
    return rows


def strips_of(run, folder, gap):
    """Strips along both side walls, half a diameter wide, without two diameters at base and lid:
    distance from the wall, velocity, stresses, solid fraction of the centres in it."""
    file = folder / "across"
    if not file.exists():
        return
    sums = defaultdict(lambda: [0.0] * 7)
    for y, z, count, vx, _, yy, zz, xz, *_ in last_average(file):
        if 2 < z < gap - 1.5:  # boxes two diameters high, by their middle
            box = run.cell.length * 0.5 * 2
            found = (box, count, vx, xz, zz, yy, count * 0.5235988)
            place = min(y, run.cell.width - y)
            sums[place] = [a + b for a, b in zip(sums[place], found)]
    for place in sorted(sums):
        volume, count, vx, *densities = sums[place]
        yield (place, vx / count, *(each / volume for each in densities))


def layers_of(run, folder):
    """Layers of one diameter from the base up: height, velocity, stresses, solid fraction, friction
    stress and normal stress at both walls."""
    layers = last_average(folder / "profile")
    volume = run.cell.length * run.cell.width
    for height, count, vx, xx, yy, zz, xz, wall_x, wall_y, wall_z in layers:
        if count < 0.2 * volume:
            continue
        sides = 2 * run.cell.length
        yield (
            height,
            vx / count,
            xz / volume,
            zz / volume,
            yy / volume,
            xx / volume,
            count * 0.5235988 / volume,
            -wall_x / sides,
            wall_y / sides,
            -wall_z / sides,
        )


def full(layers):
    """Layers that no lid or base cuts."""
    most = max(layer[6] for layer in layers)
    return [layer for layer in layers if layer[6] > 0.75 * most]


def sheared_height(layers, gap, speed):
    """V^2/integral of rate^2, from the base at 0 to the lid at `gap`."""
    inner = full(layers)
    heights = [0.0] + [layer[0] - 0.5 for layer in inner if 0.2 < layer[0] - 0.5 < gap - 0.2]
    speeds = [0.0] + [layer[1] for layer in inner if 0.2 < layer[0] - 0.5 < gap - 0.2]
    heights.append(gap)
    speeds.append(speed)
    squares = sum(
        (b - a) ** 2 / (y - x)
        for x, y, a, b in zip(heights, heights[1:], speeds, speeds[1:])
    )
    return speed**2 / squares


def state_of(run, series, layers, volume):
    steady = series[round(run.cell.transient / run_cells.ROW) :]
    shear, normal, gaps = zip(*steady)
    ratio = mean(shear) / mean(normal)
    blocks = [
        mean([t - ratio * n for t, n in zip(shear[k : k + BLOCK], normal[k : k + BLOCK])])
        for k in range(0, len(steady) - BLOCK + 1, BLOCK)
    ]
    _, error = mean_and_error(blocks)
    quarter = len(gaps) // 4
    creep = (mean(gaps[-quarter:]) - mean(gaps[:quarter])) / mean(gaps)
    gap = mean(gaps)
    speed = run.inertial_number * run.cell.height
    columns = volume / (run.cell.length * run.cell.width)
    return (
        run.seed,
        run.cell.strain,
        f"{columns:.4f}",
        f"{ratio:.5f}",
        f"{error / mean(normal):.5f}",
        f"{mean(normal):.4f}",
        f"{gap:.4f}",
        f"{columns / gap:.5f}",
        f"{100 * creep / 0.75 / run.cell.strain:.4f}",
        f"{sheared_height(layers, gap, speed):.2f}",
        f"{1 - full(layers)[-1][1] / speed:.3f}",
    )


def content_of(run, folder):
    """Volume of the liquid of the bridges over that of free grains."""
    if not run.cell.bridge_volume:
        return "0"
    counts = [row[1] for row in rows_of(folder / "bridges")]
    volume = float((folder / "volume").read_text(encoding="ascii"))
    return f"{mean(counts) * run.cell.bridge_volume / volume:.5f}"


STATE = (
    "seed,strain [1],grain_volume [a],stress_ratio [1],stress_ratio_stderr [1],"
    "mean_normal_stress [s22],gap [a],solid_fraction [1],gap_creep [%],sheared_height [a],lag [1],"
    "liquid_content [1]"
)
LAYER = (
    "height [a],velocity [sqrt(a s22 a/m)],shear_stress [s22],normal_stress [s22],"
    "lateral_stress [s22],flow_stress [s22],solid_fraction [1],wall_drag [s22],"
    "wall_pressure [s22],wall_lift [s22]"
)
STRIP = (
    "distance [a],velocity [sqrt(a s22 a/m)],shear_stress [s22],normal_stress [s22],"
    "lateral_stress [s22],solid_fraction [1]"
)


def kept(file):
    """Rows of an earlier table by the name of the run."""
    rows = defaultdict(list)
    if file.exists():
        lines = file.read_text(encoding="ascii").splitlines()
        lines = [line for line in lines if not line.startswith("#")][1:]
        for line, row in zip(lines, csv.reader(lines)):
            rows[tuple(row[:4])].append(line)
    return rows


def rows_from(run, folder):
    """Rows of a finished run without their keys, by table."""
    series, layers = series_of(run, folder), list(layers_of(run, folder))
    volume = float((folder / "volume").read_text(encoding="ascii"))
    state = (*state_of(run, series, layers, volume), content_of(run, folder))
    strips = strips_of(run, folder, gap=series[-1][2])
    return {
        "states": [",".join(map(str, state))],
        "profiles": [",".join(f"{x:.4g}" for x in layer) for layer in layers],
        "across": [",".join(f"{x:.4g}" for x in strip) for strip in strips],
        "series": [f"{t:.4f},{n:.4f},{gap:.4f}" for t, n, gap in series[SETTLING:]],
    }


COLUMNS = {
    "states": STATE,
    "profiles": LAYER,
    "across": STRIP,
    "series": "shear_stress [s22],normal_stress [s22],gap [a]",
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--work", type=Path, default=HERE.parents[1] / "build/real-cell")
    parser.add_argument("--out", type=Path, default=HERE)
    given = parser.parse_args()
    tables = {name: [f"{KEYS},{columns}"] for name, columns in COLUMNS.items()}
    earlier = {name: kept(given.out / f"{name}.csv") for name in tables}
    for run in run_cells.all_runs():
        folder = given.work / run.name
        key = (run.cell.name, f"{run.stress:g}", f"{run.inertial_number:g}", str(run.replicate))
        words = f'"{key[0]}",' + ",".join(key[1:])
        found = rows_from(run, folder) if folder.exists() else {}
        for name, lines in tables.items():
            if folder.exists():
                lines += [f"{words},{row}" for row in found[name]]
            else:
                lines += earlier[name][key]
    for name, lines in tables.items():
        text = HEADER + "\n".join(lines) + "\n"
        (given.out / f"{name}.csv").write_text(text, encoding="ascii")
    print(f"{len(tables['states']) - 1} runs", file=sys.stderr)


if __name__ == "__main__":
    main()
