#!/usr/bin/env python3
"""Wet steady shear in five states, simulated by YADE and by Pendular: do they find the same?

YADE (Debian package `yade`) shears 1000 grains with the bridge force of Pendular, as
peers/README.md says. A state takes YADE about 45 s of one core per unit of strain. States are
sheared in turn, one unit of strain each; the same command goes on where it was stopped.

    bench/wet_strength.py                # result: bench/results/wet_strength.csv
    bench/wet_strength.py --strain 20    # goes on to a strain of 20 in each state
    bench/wet_strength.py --strain 0     # writes the table of what there is
"""
import argparse
import json
import math
import os
import subprocess
import sys
from collections import namedtuple
from pathlib import Path

sys.dont_write_bytecode = True
from block_average import mean_and_error  # noqa: E402

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
State = namedtuple("State", "name friction reduced_pressure bridge_volume")
STATES = (
    State("low-pressure", 0.09, 0.5, 0.004),
    State("little-liquid", 0.09, 1, 0.001),
    State("middle", 0.09, 2, 0.004),
    State("rough-grains", 0.25, 1, 0.004),
    State("much-liquid", 0.09, 5, 0.008),
)
INERTIAL_NUMBER = 0.01
STIFFNESS_NUMBER = 1000
GRAINS = 1000
TIME_STEP = 0.0052  # sqrt(m/(a s22)), about Pendular's own
SKIN = 0.1
TRANSIENT = 1.5  # strain that is left out, after a strain of 1.1 of preparation
PER_ROW = 0.25  # as in shear.yade.py
SEEDS = range(101, 105)  # of Pendular's runs
COLUMNS = (
    "normal_stress",
    "shear_stress",
    "solid_fraction",
    "contact_coordination",
    "distant_coordination",
    "distant_force",
    "fabric_12_distant",
    "capillary_stress_22",
    "capillary_shear_stress",
)
# Stresses are compared over the normal stress.
COMPARED = ("stress_ratio",) + COLUMNS[2:]


def yade(mode, folder, **options):
    words = [f"{key}={value}" for key, value in options.items()]
    command = ["yade", "-j1", "-n", "-x", HERE / "peers/shear.yade.py", mode, "wet=1"]
    command += [f"rate={INERTIAL_NUMBER}", *words]
    run = subprocess.run(
        [str(word) for word in command], cwd=folder, text=True, capture_output=True, check=False
    )
    if run.returncode:
        sys.exit(f"YADE stopped with exit code {run.returncode}:\n{run.stdout}{run.stderr}")
    return run.stdout


def prepare(state, number, folder):
    if (folder / "state.bin.gz").exists():
        return
    folder.mkdir(parents=True, exist_ok=True)
    gas = [sys.executable, HERE / "peers/gas.py", GRAINS, 500 + number, folder / "gas"]
    subprocess.run([str(word) for word in gas], check=True)
    yade(
        "prepare",
        folder,
        gas="gas",
        state="new.bin.gz",
        modulus=STIFFNESS_NUMBER**1.5,
        friction=state.friction,
        reduced_pressure=state.reduced_pressure,
        bridge_volume=state.bridge_volume,
        time_step=TIME_STEP,
    )
    (folder / "new.bin.gz").rename(folder / "state.bin.gz")


def rows_of(folder):
    """One tuple for each interval of strain, in the order of COLUMNS."""
    file = folder / "rows"
    if not file.exists():
        return []
    lines = file.read_text(encoding="ascii").splitlines()
    return [tuple(float(x) for x in line.split()[1:]) for line in lines]


def shear(folder, strain):
    said = yade(
        "sample", folder, state="state.bin.gz", end_state="new.bin.gz", strain=strain, skin=SKIN
    )
    rows = [line for line in said.splitlines() if line.startswith("row ")]
    with open(folder / "rows", "a", encoding="ascii") as out:
        out.writelines(line + "\n" for line in rows)
    (folder / "new.bin.gz").rename(folder / "state.bin.gz")


def found_by_yade(folder):
    columns = dict(zip(COLUMNS, zip(*rows_of(folder)[round(TRANSIENT / PER_ROW) :])))
    normal = columns["normal_stress"]
    mean_normal = sum(normal) / len(normal)
    columns["stress_ratio"] = columns["shear_stress"]
    found = {}
    for name in COMPARED:
        mean, error = mean_and_error(columns[name])
        if "stress" in name:
            # Normal stress swings about 1: the ratio of the means, its error from what is left.
            mean /= mean_normal
            left = [(x - mean * n) / mean_normal for x, n in zip(columns[name], normal)]
            error = mean_and_error(left)[1]
        found[name] = mean, error
    return found


def found_by_pendular(state, folder, pendular):
    runs = []
    for seed in SEEDS:
        file = folder / f"pendular-{seed}.json"
        if not file.exists():
            words = f"simulate --friction {state.friction} --inertial-number {INERTIAL_NUMBER} "
            words += f"--stiffness-number {STIFFNESS_NUMBER} --beads {GRAINS} --strain 8 "
            words += f"--reduced-pressure {state.reduced_pressure} "
            words += f"--bridge-volume {state.bridge_volume} --seed {seed} --threads 1 --quiet"
            command = [pendular, *words.split(), "--json", folder / "new.json"]
            subprocess.run(
                [str(word) for word in command],
                check=True,
                stdout=subprocess.DEVNULL,
                env={**os.environ, "PENDULAR_STORE": str(folder / "runs.db")},
            )
            (folder / "new.json").rename(file)
        runs.append(json.loads(file.read_text(encoding="utf-8")))
    found = {}
    for name in COMPARED:
        values = [run[name]["value"] for run in runs]
        errors = [run[name]["stderr"] for run in runs]
        found[name] = (
            sum(values) / len(values),
            math.sqrt(sum(error * error for error in errors)) / len(errors),
        )
    return found


def write_table(work, file, pendular):
    lines = [
        "# Wet steady shear simulated by YADE 2023.02a and by Pendular with one bridge force; a",
        f"# row for each state and quantity. Inertial number {INERTIAL_NUMBER}, stiffness number",
        f"# {STIFFNESS_NUMBER}, {GRAINS} grains. stderr: standard error of the mean. apart: difference in",
        "# combined standard errors. How it was made: bench/wet_strength.py.",
        "state,friction [1],reduced_pressure [1],bridge_volume [a3],strain_yade [1],quantity,"
        "yade [1],yade_stderr [1],pendular [1],pendular_stderr [1],apart [1]",
    ]
    for state in STATES:
        folder = work / state.name
        strain = len(rows_of(folder)) * PER_ROW - TRANSIENT
        if strain < 2:
            continue
        theirs, ours = found_by_yade(folder), found_by_pendular(state, folder, pendular)
        for name in COMPARED:
            apart = (ours[name][0] - theirs[name][0]) / math.hypot(ours[name][1], theirs[name][1])
            cells = [*state, f"{strain:g}", name]
            cells += [f"{x:.5f}" for x in (*theirs[name], *ours[name])]
            lines.append(",".join(str(cell) for cell in cells) + f",{apart:.2f}")
    Path(file).write_text("\n".join(lines) + "\n", encoding="ascii")
    print(f"{file}: {len(lines) - 5} rows")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--strain", type=float, default=12, help="averaged by YADE (default 12)")
    parser.add_argument("--work", type=Path, default=ROOT / "build/wet-strength")
    parser.add_argument("--pendular", type=Path, default=ROOT / "build/release/pendular")
    parser.add_argument("--out", type=Path, default=HERE / "results/wet_strength.csv")
    given = parser.parse_args()
    work = given.work.resolve()
    for number, state in enumerate(STATES):
        if given.strain > 0:
            print(f"preparing {state.name}", file=sys.stderr, flush=True)
            prepare(state, number, work / state.name)
    wanted = TRANSIENT + given.strain if given.strain > 0 else 0
    while True:
        short = [s for s in STATES if len(rows_of(work / s.name)) * PER_ROW < wanted]
        if not short:
            break
        for state in short:
            shear(work / state.name, 1)
            done = len(rows_of(work / state.name)) * PER_ROW
            print(f"{state.name}: strain {done:g} of {wanted:g}", file=sys.stderr, flush=True)
    write_table(work, given.out, given.pendular.resolve())


if __name__ == "__main__":
    main()
