#!/usr/bin/env python3
"""Simulates the foreign worlds of the benchmark with LAMMPS and YADE; finished runs are kept, so that the
same command goes on where it was stopped. README.md says what is simulated.

    run_worlds.py [--work FOLDER] [--only WORLD,...] [--table FILE] [--list]

--table FILE: write the states of all finished runs into the table, simulate nothing.
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
import states  # noqa: E402
from block_average import mean_and_error  # noqa: E402

STIFFNESS_NUMBER = 1000
BLOCK = 0.25  # strain
GRAINS = 1000


@dataclass
class Run:
    """One recorded step: reduced units, except for the normal stress, which names the step."""

    world: states.World
    normal_stress: float  # [Pa]
    liquid_content: float
    inertial_number: float
    replicate: int

    @property
    def wet(self):
        return self.liquid_content > 0

    @property
    def name(self):
        return (
            f"{self.world.name}-{self.normal_stress:g}Pa-{self.liquid_content:g}"
            f"-{self.inertial_number:g}-{self.replicate}"
        )

    @property
    def seed(self):
        """Of the gas. Worlds do not share samples."""
        number = 0
        for letter in self.name:
            number = (131 * number + ord(letter)) % 2_000_000_011
        return number

    @property
    def force(self):
        """F0/(a^2 s22): 1/P*, or the adhesion of dry grains."""
        if self.wet:
            return states.PULL_OFF_FORCE / (states.DIAMETER**2 * self.normal_stress)
        return self.world.adhesion / (states.DIAMETER**2 * self.normal_stress)

    @property
    def law(self):
        return self.world.bridges if self.wet else "contact" if self.world.adhesion else ""

    @property
    def bridge_volume(self):
        if not self.wet:
            return 0
        return self.world.bridge_volume(
            self.normal_stress, self.inertial_number, self.liquid_content
        )


def all_runs():
    yield from runs_of_lammps()
    # Dry grains with one stiffness number flow alike at every normal stress: one run serves all.
    plain = next(world for world in states.WORLDS if world.code == "yade")
    for replicate in (1, 2):
        for inertial_number in states.INERTIAL_NUMBERS:
            yield Run(plain, states.DRY_STRESSES[0], 0, inertial_number, replicate)


def runs_of_lammps():
    for world in states.WORLDS:
        if world.code == "yade":
            continue
        for inertial_number in states.INERTIAL_NUMBERS:
            for content in world.contents:
                stresses = states.WET_STRESSES if content else states.DRY_STRESSES
                for stress in stresses:
                    for replicate in (1, 2):
                        yield Run(world, stress, content, inertial_number, replicate)


def variables(run, folder):
    world = run.world
    modulus = STIFFNESS_NUMBER**1.5
    # K_T at the mean overlap, 0.0022; the arm of LAMMPS' rolling spring is a/4, of Pendular's a/2.
    rolling_stiffness = 4 * 1.4 / 1.7 * modulus / 2 * math.sqrt(0.0022)
    grain_volume = math.pi / 6 * GRAINS * (1 + 3 * world.deviation**2)
    return {
        "here": HERE,
        "gas": folder / "gas",
        "modulus": modulus,
        "friction": world.friction,
        "rolling": 2 * world.rolling,
        "rolling_stiffness": rolling_stiffness,
        "rate": run.inertial_number,
        "time_step": 0.0053 if run.law or world.rolling else 0.0057,
        "closed": world.closed,
        "grain_volume": grain_volume,
        # YADE's height follows more slowly to the normal stress after the fast shear.
        "transient": 1.5 if run.wet or world.code == "yade" else 1,
        "strain": 4 if run.wet or world.code == "yade" else 6,
        "block": BLOCK,
        "averages": folder / "averages",
        "bridges": 1 if run.law else 0,
    }


def lammps_command(run, folder, work):
    words = [
        word for name, value in variables(run, folder).items() for word in ("-var", name, value)
    ]
    if run.law:
        program = [work / "cohesion", run.law, repr(run.force), repr(run.bridge_volume), HERE]
    else:
        program = ["lmp", "-log", "none", "-in", HERE / "dry.lmp"]
    return [program + words]


def yade_commands(run, folder, _):
    """The state, then its averages."""
    given = variables(run, folder)
    command = ["yade", "-j1", "-n", "-x", HERE.parent / "peers/shear.yade.py"]
    common = [f"rate={run.inertial_number}", "wet=0", f"state={folder / 'state.yade.bz2'}"]
    prepare = [f"{key}={given[key]}" for key in ("gas", "modulus", "friction", "time_step")]
    prepare += ["reduced_pressure=1", "bridge_volume=0"]
    blocks = [f"{key}={given[key]}" for key in ("averages", "transient", "strain", "block")]
    return [
        [*command, "prepare", *common, *prepare],
        [*command, "blocks", *common, *blocks, "skin=0.05"],
    ]


def simulate(run, work):
    done = work / f"{run.name}.averages"
    if done.exists():
        return
    folder = work / f"{run.name}.running"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    gas = [sys.executable, HERE.parent / "peers/gas.py", GRAINS, run.seed, folder / "gas"]
    subprocess.run([str(word) for word in gas + [run.world.deviation]], check=True)
    commands = yade_commands if run.world.code == "yade" else lammps_command
    with open(folder / "said", "w", encoding="utf-8") as said:
        for command in commands(run, folder, work):
            subprocess.run(
                [str(word) for word in command],
                check=True,
                stdout=said,
                stderr=subprocess.STDOUT,
                env={**os.environ, "OMP_NUM_THREADS": "1"},
            )
    (folder / "averages").rename(done)
    shutil.rmtree(folder)


COLUMNS = (
    "world",
    "normal_stress [Pa]",
    "liquid_content [1]",
    "inertial_number [1]",
    "replicate",
    "seed",
    "grains",
    "strain [1]",
    "attraction [a2 s22]",
    "bridge_volume [a3]",
    "stress_ratio [1]",
    "stress_ratio_stderr [1]",
    "solid_fraction [1]",
    "solid_fraction_stderr [1]",
    "mean_normal_stress [s22]",
    "mean_shear_rate [1]",
    "mean_liquid_content [1]",
)


def row(run, averages, normal_stress):
    lines = [line.split() for line in averages.read_text().splitlines() if not line.startswith("#")]
    normal, shear, solid, rate, bridges = zip(*([float(x) for x in line[1:]] for line in lines))

    def mean(values):
        return sum(values) / len(values)

    # Normal stress swings about 1: the ratio of the means, its error from what is left in blocks.
    of_means = mean(shear) / mean(normal)
    _, error = mean_and_error([(t - of_means * n) / mean(normal) for t, n in zip(shear, normal)])
    ratio = of_means, error
    fraction = mean_and_error(solid)
    content = mean(bridges) * run.bridge_volume / (math.pi / 6 * GRAINS)
    cells = [run.world.name, f"{normal_stress:g}", f"{run.liquid_content:g}"]
    cells += [f"{run.inertial_number:g}", run.replicate, run.seed, GRAINS]
    cells += [f"{BLOCK * len(normal):g}", f"{run.force:.5g}", f"{run.bridge_volume:.5g}"]
    cells += [f"{value:.5f}" for value in (*ratio, *fraction)]
    cells += [f"{mean(normal):.4f}", f"{mean(rate):.5g}", f"{content:.4g}"]
    return ",".join(str(cell) for cell in cells)


HEADER = """\
# Steady states that LAMMPS found (29 Sep 2021, update 2; Debian lammps 20220106.git7586adbb6a) and,
# in worlds whose names end in -yade, YADE (2023.02a; Debian yade 2023.02a-1; one run for all normal
# stresses of an inertial number and replicate); a row for each recorded step. README.md says what is
# simulated. Units in brackets, a = m = s22 = 1 where a symbol stands. seed: of the random gas.
# stderr: standard error of the mean, from blocks of strain 0.25 and their correlation."""


def write_table(work, file):
    """Rows of runs that are not in the work folder stay as they are in the file."""
    file = Path(file)
    lines = file.read_text(encoding="ascii").splitlines() if file.exists() else []
    earlier = {tuple(line.split(",")[:5]): line for line in lines}
    rows = [HEADER, ",".join(COLUMNS)]
    for run in all_runs():
        averages = work / f"{run.name}.averages"
        stresses = states.DRY_STRESSES if run.world.code == "yade" else (run.normal_stress,)
        for stress in stresses:
            key = (run.world.name, f"{stress:g}", f"{run.liquid_content:g}")
            key += (f"{run.inertial_number:g}", str(run.replicate))
            if averages.exists():
                rows.append(row(run, averages, stress))
            elif key in earlier:
                rows.append(earlier[key])
    file.write_text("\n".join(rows) + "\n", encoding="ascii")
    print(f"{len(rows) - 2} rows", file=sys.stderr)


def build_cohesion(work):
    program = work / "cohesion"
    source = HERE / "cohesion.cpp"
    if program.exists() and program.stat().st_mtime > source.stat().st_mtime:
        return
    words = "c++ -O3 -march=native -std=c++20 $(pkg-config --cflags mpi-cxx) "
    words += f"{source} -llammps $(pkg-config --libs mpi-cxx) -o {program}"
    subprocess.run(["bash", "-c", words], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--work", type=Path, default=HERE.parents[1] / "build/foreign-worlds")
    parser.add_argument("--only", default="", help="worlds, separated by commas")
    parser.add_argument("--table", help="file")
    parser.add_argument("--list", action="store_true", help="runs, and whether each is done")
    given = parser.parse_args()
    work = given.work.resolve()
    if given.table:
        write_table(work, given.table)
        return
    only = given.only.split(",") if given.only else [world.name for world in states.WORLDS]
    work.mkdir(parents=True, exist_ok=True)
    runs = [run for run in all_runs() if run.world.name in only]
    if given.list:
        for run in runs:
            print(run.name, "done" if (work / f"{run.name}.averages").exists() else "")
        return
    if any(run.law for run in runs):
        build_cohesion(work)
    for k, run in enumerate(runs, 1):
        print(f"{k} of {len(runs)}: {run.name}", file=sys.stderr, flush=True)
        try:
            simulate(run, work)
        except subprocess.CalledProcessError as error:
            print(f"{run.name} failed, see {run.name}.running/said: {error}", file=sys.stderr)


if __name__ == "__main__":
    main()
