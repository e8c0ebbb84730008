#!/usr/bin/env python3
"""Simulates the true states of bench/laboratories and writes them to states.csv.

    nice python3 make_states.py path/to/pendular SCRATCH [JOBS]

Each state is one run of `pendular simulate` with 2000 beads, twice as many as a fit at --fidelity quick,
and a seed that no fit and no virtual laboratory uses: these take theirs from hashes, these count from
7 000 001. States that states.csv already holds are not simulated again.
"""
import csv
import json
import math
import pathlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).parent
FIELDS = ["friction", "inertial_number", "reduced_pressure", "bridge_volume", "seed", "beads",
          "stiffness_number", "strain", "liquid_content", "stress_ratio", "stress_ratio_se",
          "solid_fraction", "solid_fraction_se"]
FRICTIONS = {"polystyrene": 0.09, "glass": 0.16, "steel": 0.25}
DRY_NUMBERS = [0.0035, 0.007, 0.014, 0.028, 0.056, 0.11]
WET_NUMBERS = [0.007, 0.04]
PRESSURES = [1, 1.7, 3, 6, 15]
CONTENTS = [0.03]
BEADS, KAPPA, STRAIN = 2000, 1000, 5


def simulate(program, store, friction, number, seed, pressure=None, volume=None, beads=BEADS,
             strain=STRAIN):
    words = [program, "simulate", "--json", "-", "--quiet", "--friction", friction,
             "--inertial-number", number, "--beads", beads, "--stiffness-number", KAPPA, "--strain",
             strain, "--seed", seed, "--store", store, "--threads", 1]
    if pressure is not None:
        words += ["--reduced-pressure", pressure, "--bridge-volume", volume]
    out = subprocess.run([str(w) for w in words], capture_output=True, text=True)
    if out.returncode != 0:
        raise RuntimeError(out.stderr)
    return json.loads(out.stdout)


def volume_for(program, store, friction, number, seed, pressure, content):
    """Bridge volume over a^3 that gives a liquid content 3 Z V0/(pi a^3), by one short run."""
    volume = content * math.pi / (3 * 6.5)
    found = simulate(program, store, friction, number, seed + 500000, pressure, volume, 500, 1)
    return volume * content / found["liquid_content"]["value"]


def state(task):
    program, store, friction, number, seed, pressure, content = task
    volume = ""
    if pressure is not None:
        volume = round(volume_for(program, store, friction, number, seed, pressure, content), 7)
        run = simulate(program, store, friction, number, seed, pressure, volume)
    else:
        run = simulate(program, store, friction, number, seed)
    return {"friction": friction, "inertial_number": number, "reduced_pressure": pressure or "",
            "bridge_volume": volume, "seed": seed, "beads": BEADS, "stiffness_number": KAPPA,
            "strain": STRAIN, "liquid_content": content or 0,
            "stress_ratio": run["stress_ratio"]["value"],
            "stress_ratio_se": run["stress_ratio"]["stderr"],
            "solid_fraction": run["solid_fraction"]["value"],
            "solid_fraction_se": run["solid_fraction"]["stderr"]}


def tasks(program, store):
    seed = 7000000
    for friction in FRICTIONS.values():
        for number in reversed(DRY_NUMBERS):
            for _ in range(2):
                seed += 1
                yield program, store, friction, number, seed, None, None
    for content in reversed(CONTENTS):
        for friction in FRICTIONS.values():
            for number in reversed(WET_NUMBERS):
                for pressure in PRESSURES:
                    seed += 1
                    yield program, store, friction, number, seed, pressure, content
    # Two more of each wet state: the truth is then known to about 0.2 % of the stress ratio.
    for content in reversed(CONTENTS):
        for friction in FRICTIONS.values():
            for number in reversed(WET_NUMBERS):
                for pressure in PRESSURES:
                    for _ in range(2):
                        seed += 1
                        yield program, store, friction, number, seed, pressure, content


def main():
    program, scratch = sys.argv[1], pathlib.Path(sys.argv[2])
    jobs = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    scratch.mkdir(parents=True, exist_ok=True)
    path = HERE / "states.csv"
    known = set()
    if path.exists():
        with path.open() as file:
            known = {int(row["seed"]) for row in csv.DictReader(file)}
    wanted = [t for t in tasks(program, str(scratch / "states.sqlite")) if t[4] not in known]
    with path.open("a", newline="") as file, ThreadPoolExecutor(jobs) as pool:
        table = csv.DictWriter(file, FIELDS, lineterminator="\n")
        if not known:
            table.writeheader()
        for row in pool.map(state, wanted):
            table.writerow(row)
            file.flush()
            print(row["seed"], row["friction"], row["inertial_number"], row["reduced_pressure"],
                  row["stress_ratio"], flush=True)


if __name__ == "__main__":
    main()
