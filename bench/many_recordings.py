#!/usr/bin/env python3
"""Time of `pendular import` for studies of 50 to 800 recordings, and its ratio to that of the study before.

    bench/many_recordings.py PROGRAM [OTHER_PROGRAM] [--recordings 50,100,200,400,800] [--folder build/recordings]

Each recording holds five steps of 100 rows at normal stresses from 0.4 to 6 kPa, with noise. Each time is the
shortest of three. With two programs (another version), both are timed in turn, with the ratio of their times.
"""
import argparse
import math
import pathlib
import random
import subprocess
import time

STUDY = """[grains]
diameter = "500 um"
density = "1050 kg/m^3"
[cell]
inner_radius = "21 mm"
outer_radius = "45 mm"
bead_mass = "20 g"
[[recording]]
file = "run_*.csv"
"""
HEADER = "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s],Interval [1]\n"
STRESSES = [400, 800, 1500, 3000, 6000]
AREA = math.pi * (0.045 ** 2 - 0.021 ** 2)
ARM = 2 * math.pi * (0.045 ** 3 - 0.021 ** 3) / 3
ROWS = 100


def recording(seed):
    rnd = random.Random(seed)
    lines, filling = [HEADER], 1 + 0.01 * rnd.gauss(0, 1)
    for step, stress in enumerate(STRESSES):
        level = 0.29 * stress * ARM * filling * (1 + 0.005 * rnd.gauss(0, 1))
        for row in range(ROWS):
            lines.append(f"{ROWS * step + row},{1e3 * level * (1 + 0.02 * rnd.gauss(0, 1)):.6g},"
                         f"{stress * AREA * (1 + 0.002 * rnd.gauss(0, 1)):.6g},"
                         f"{6.15 * (1 + 0.002 * rnd.gauss(0, 1)):.6g},0.1,{step + 1}\n")
    return "".join(lines)


def write_study(folder, count):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "study.toml").write_text(STUDY)
    for k in range(count):
        path = folder / f"run_{k + 1:04}.csv"
        if not path.exists():
            path.write_text(recording(k))


def seconds(program, study, repeat):
    times = []
    for _ in range(repeat):
        begin = time.monotonic()
        subprocess.run([program, "import", study, "--json", "/dev/null"], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        times.append(time.monotonic() - begin)
    return min(times)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("programs", type=pathlib.Path, nargs="+")
    options.add_argument("--recordings", default="50,100,200,400,800")
    options.add_argument("--repeat", type=int, default=3)
    options.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("build/recordings"))
    given = options.parse_args()
    programs = [program.resolve() for program in given.programs]
    before = [None] * len(programs)
    for count in map(int, given.recordings.split(",")):
        study = given.folder / f"of_{count}"
        write_study(study, count)
        times = [seconds(program, study, given.repeat) for program in programs]
        told = [f"{now:7.2f} s" + (f" ({now / last:.1f} times the study before)" if last else "")
                for now, last in zip(times, before)]
        ratio = f", ratio {times[1] / times[0]:.3g}" if len(times) > 1 else ""
        print(f"{count:5d} recordings: {'; '.join(told)}{ratio}", flush=True)
        before = times


if __name__ == "__main__":
    main()
