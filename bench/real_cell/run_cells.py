#!/usr/bin/env python3
"""Simulates cells with walls with LAMMPS; finished runs are kept, so that the same command goes on
where it was stopped. README.md says what is simulated.

    run_cells.py [--work FOLDER] [--only TEXT] [--replicate N] [--list]
"""
import argparse
import math
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
sys.dont_write_bytecode = True
import cells  # noqa: E402
import sample  # noqa: E402
from foreign_worlds.run_worlds import build_cohesion  # noqa: E402

MODULUS = 1000**1.5  # stiffness number 1000 under the lid
ROW = 0.04  # strain of the nominal height


@dataclass
class Run:
    cell: cells.Cell
    stress: float  # [Pa]
    inertial_number: float
    replicate: int

    @property
    def name(self):
        words = f"{self.cell.name} {self.stress:g}Pa {self.inertial_number:g} {self.replicate}"
        return words.replace(",", "").replace(" ", "-")

    @property
    def seed(self):
        number = 0
        for letter in self.name:
            number = (131 * number + ord(letter)) % 2_000_000_011
        return number


def all_runs(replicates=cells.REPLICATES):
    for replicate in replicates:
        for cell in cells.CELLS:
            for stress in cell.stresses:
                for inertial_number in cells.INERTIAL_NUMBERS:
                    yield Run(cell, stress, inertial_number, replicate)


def variables(run, folder, glued):
    cell = run.cell
    return {
        "here": HERE,
        "sample": folder / "sample",
        "width": cell.width if cell.walls else 0,
        "modulus": MODULUS,
        "friction": cell.friction,
        "wall_friction": cell.wall_friction,
        # As in bench/foreign_worlds: LAMMPS' arm is half of Pendular's.
        "rolling": 2 * cell.rolling,
        "rolling_stiffness": 4 * 1.4 / 1.7 * MODULUS / 2 * math.sqrt(0.0022),
        "weight": cells.weight(run.stress),
        "speed": run.inertial_number * cell.height,
        "time_step": 0.0053 if cell.rolling or cell.deviation or cell.bridge_volume else 0.0057,
        "height": cell.height,
        "transient": cell.transient,
        "strain": cell.strain,
        "row": ROW,
        "lid_grains": glued,
        "area": cell.length * cell.width,
        "series": folder / "series",
        "profile": folder / "profile",
        "across": folder / "across",
        "wet": int(cell.bridge_volume > 0),
        "bridges": folder / "bridges",
    }


def program(run, work):
    """Words before the variables. A wet cell needs LAMMPS with a force of attraction."""
    if not run.cell.bridge_volume:
        return ["lmp", "-log", "none", "-in", HERE / "in.lmp"]
    build_cohesion(work)
    force = cells.PULL_OFF_FORCE / (cells.DIAMETER**2 * run.stress)
    return [work / "cohesion", "capillary", force, run.cell.bridge_volume, HERE]


def simulate(run, work):
    done = work / run.name
    if done.exists():
        return
    folder = work / f"{run.name}.running"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    cell = run.cell
    glued, volume = sample.write(
        folder / "sample", cell.grains, cell.length, cell.width, run.seed, cell.deviation
    )
    words = program(run, work)
    for name, value in variables(run, folder, glued).items():
        words += ["-var", name, value]
    with open(folder / "said", "w", encoding="utf-8") as said:
        subprocess.run(
            [str(word) for word in words],
            check=True,
            stdout=said,
            stderr=subprocess.STDOUT,
            env={**os.environ, "OMP_NUM_THREADS": "1"},
        )
    (folder / "volume").write_text(f"{volume:.6f}\n", encoding="ascii")
    (folder / "sample").unlink()
    folder.rename(done)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--work", type=Path, default=HERE.parents[1] / "build/real-cell")
    parser.add_argument("--only", default="", help="text that the names of runs contain")
    parser.add_argument("--replicate", type=int, help="1 or 2; otherwise both")
    parser.add_argument("--list", action="store_true", help="runs, and whether each is done")
    given = parser.parse_args()
    work = given.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    replicates = (given.replicate,) if given.replicate else cells.REPLICATES
    runs = [run for run in all_runs(replicates) if given.only in run.name]
    for k, run in enumerate(runs, 1):
        if given.list:
            print(run.name, "done" if (work / run.name).exists() else "")
            continue
        print(f"{k} of {len(runs)}: {run.name}", file=sys.stderr, flush=True)
        try:
            simulate(run, work)
        except subprocess.CalledProcessError as error:
            print(f"{run.name} failed, see {run.name}.running/said: {error}", file=sys.stderr)


if __name__ == "__main__":
    main()
