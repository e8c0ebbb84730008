#!/usr/bin/env python3
"""200 laboratories of known truth, and what Pendular makes of them.

    nice python3 matrix.py path/to/pendular SCRATCH [--first N] [--last N] [--makers python,program]

Of eight laboratories, one is made by `pendular virtual-lab` and seven by instrument.py, which shares no
code with the program. Half of each have one fault of the instrument. Every laboratory adds one row to
results.csv; those that have a row are left out, so that the matrix resumes where it was stopped.
summary.py makes the table by cell, beads, protocol and so on.
"""
import argparse
import csv
import json
import math
import pathlib
import random
import shutil
import subprocess
import time
from dataclasses import replace

from instrument import Beads, Cell, Faults, Noise, Rig, States, write_lab

HERE = pathlib.Path(__file__).parent
CELLS = {"14-30": Cell(14e-3, 30e-3), "21-45": Cell(21e-3, 45e-3), "30-60": Cell(30e-3, 60e-3),
         "50-70": Cell(50e-3, 70e-3)}
BEADS = {"polystyrene": Beads("polystyrene", 0.5e-3, 1050, 0.09),
         "glass": Beads("glass", 0.8e-3, 2500, 0.16), "steel": Beads("steel", 1e-3, 7800, 0.25)}
LIQUIDS = {"none": 0.0, "oil": 20.6e-3, "water": 72.8e-3}
PROTOCOLS = ["speed", "number", "ramp"]
DRY_STRESSES = [400.0, 1000.0, 2000.0, 5000.0]
CONTENT = 0.03
LOWEST_NUMBER = 0.006  # inertial number of the slowest steps

# Names under which a fault may rightly be reported: effects, and kinds of findings of `import`.
FAULTS = {
    "none": (Faults(), []),
    "torque-offset": (Faults(torque_offset=1.0), ["torque-offset"]),  # scaled to the cell below
    "torque-gain": (Faults(torque_gain=1.06), ["torque-gain"]),
    "force-offset": (Faults(force_offset=1.0), ["normal-force-offset"]),
    "force-gain": (Faults(force_gain=0.95), ["normal-force-gain"]),
    "cross-talk": (Faults(cross_talk=1.0), ["cross-talk"]),
    "height-offset": (Faults(height_offset=0.4e-3), ["height-offset"]),
    "lid-slip": (Faults(lid_slip=0.3), ["lid-slip"]),
    "wall-friction": (Faults(wall_friction=0.12), ["wall-friction"]),
    "bead-loss": (Faults(bead_loss=0.03), ["bead-loss"]),
    # In the mean, a gain that drifts is a gain; recordings of one order of steps do not tell them apart.
    "torque-drift": (Faults(torque_drift=0.08), ["drift", "torque-gain"]),
    "wobble": (Faults(wobble=0.06), ["wobble"]),
}
OPTIONS = {  # hidden effects of virtual-lab; drift and wobble are no effects of the catalogue
    "torque_offset": "--torque-offset.torque", "torque_gain": "--torque-gain.gain",
    "force_offset": "--normal-force-offset.force", "force_gain": "--normal-force-gain.gain",
    "cross_talk": "--cross-talk.arm", "height_offset": "--height-offset.offset",
    "lid_slip": "--lid-slip.fraction", "wall_friction": "--wall-friction.coefficient",
    "bead_loss": "--bead-loss.fraction"}
FIELDS = ["lab", "maker", "cell", "beads", "liquid", "protocol", "replicates", "rows", "noise",
          "fault", "friction", "fitted", "stated", "ratio", "cohesion", "fitted_cohesion",
          "stated_cohesion", "cohesion_ratio", "findings", "verdict", "effects", "rivals", "named",
          "could_go_undetected", "false_findings", "chi2_per_dof", "believable", "seconds", "error"]


def two_digits(value):
    return float(f"{value:.2g}")


def plan(index):
    """Laboratory number `index`: factors that repeat with different periods, shuffled once."""
    random_ = random.Random(20240 + index)
    # Every eighth is made by the program, whose laboratories simulate states of their own for minutes;
    # of each maker's laboratories every second one has a fault.
    kinds = [k for k in FAULTS if k != "none"]
    maker = "program" if index % 8 == 1 else "python"
    if maker == "program":
        kinds = [k for k in kinds if k not in ("torque-drift", "wobble")]
    place = index // 8 if maker == "program" else index - (index + 6) // 8
    fault = kinds[place // 2 % len(kinds)] if place % 2 else "none"
    liquids = ["none", "oil", "none", "water"] if maker == "python" else ["none"]
    return {"lab": index, "maker": maker, "fault": fault, "cell": random_.choice(list(CELLS)),
            "beads": random_.choice(list(BEADS)), "liquid": random_.choice(liquids),
            "protocol": random_.choice(PROTOCOLS), "replicates": random_.choice([1, 2, 3, 4]),
            "rows": random_.choice([40, 400]), "noise": random_.choice(["white", "correlated"])}


def bead_mass(cell, beads):
    return two_digits(beads.density * 0.6 * cell.area() * 24 * beads.diameter)


def faults_of(spec):
    """Faults scaled to a few per cent of the torque or force at 1 kPa."""
    cell, faults = CELLS[spec["cell"]], FAULTS[spec["fault"]][0]
    return replace(faults, torque_offset=faults.torque_offset * 0.08 * cell.torque(300),
                   force_offset=faults.force_offset * 0.08 * cell.area() * 1000,
                   cross_talk=faults.cross_talk * 0.03 * cell.arm())


def stresses(spec, wet):
    if not wet:
        return DRY_STRESSES
    unit = math.pi * LIQUIDS[spec["liquid"]] / BEADS[spec["beads"]].diameter
    return [two_digits(unit * p) for p in (1.3, 2.5, 5, 12)]


def speed_for(spec, number, stress=1000.0):
    cell, beads = CELLS[spec["cell"]], BEADS[spec["beads"]]
    height = bead_mass(cell, beads) / beads.density / 0.6 / cell.area()
    rate = number / math.sqrt(beads.mass() / (beads.diameter * stress))
    return two_digits(2 * height * rate / (cell.inner + cell.outer) * 30 / math.pi) * math.pi / 30


def set_points(spec, wet):
    """Stress, speed and inertial number of each step; one of the latter is None."""
    all_ = stresses(spec, wet)
    middle = math.sqrt(all_[0] * all_[-1])
    if spec["protocol"] == "number":
        return [(s, None, i) for s in all_ for i in (LOWEST_NUMBER, 0.04)]
    speeds = [speed_for(spec, 0.03, middle)] if spec["protocol"] == "ramp" else [
        speed_for(spec, 0.008, middle), speed_for(spec, 0.05, middle)]
    if spec["protocol"] == "ramp":
        all_ = all_ + all_[-2::-1]
    return [(s, v, None) for s in all_ for v in speeds]


class MissingStates(Exception):
    """States that make_states.py has not simulated yet."""


def make_python(spec, folder):
    beads = BEADS[spec["beads"]]
    states = States(HERE / "states.csv", beads.friction)
    if not states.holds(CONTENT if spec["liquid"] != "none" else 0.0):
        raise MissingStates(f"states.csv lacks states of {spec['beads']}")
    rig = Rig(CELLS[spec["cell"]], beads, states, bead_mass(CELLS[spec["cell"]], beads), LIQUIDS[spec["liquid"]], faults_of(spec))
    contents = [0.0] + ([CONTENT] if spec["liquid"] != "none" else [])
    noise = Noise(memory=0.8 if spec["noise"] == "correlated" else 0.0)
    layout = ["decimal-comma", "tabs", "other-order"][spec["lab"] % 3]
    steps = {c: set_points(spec, c > 0) for c in contents}
    write_lab(folder, rig, spec["liquid"] != "none", contents, steps, spec["replicates"],
              spec["rows"], noise, layout, spec["lab"])
    if len(contents) < 2:
        return None
    # Line through the points of the fit: P* >= 2.3, under the lid, at the lowest number of a step.
    unit = math.pi * LIQUIDS[spec["liquid"]] / beads.diameter
    lines = [(1 / s, rig.states.at(LOWEST_NUMBER, unit / s, CONTENT)[0])
             for s in stresses(spec, True) if s >= 2.3 * unit]
    mean = [sum(v) / len(lines) for v in zip(*lines)]
    return (sum((x - mean[0]) * (y - mean[1]) for x, y in lines) /
            sum((x - mean[0])**2 for x, _ in lines))


def make_program(program, scratch, spec, folder):
    cell, beads = CELLS[spec["cell"]], BEADS[spec["beads"]]
    points = set_points(spec, False)
    words = [program, "virtual-lab", folder, "--dry", "--quiet", "--fidelity", "quick", "--threads", 1,
             "--friction", beads.friction, "--inner-radius", f"{cell.inner} m", "--outer-radius",
             f"{cell.outer} m", "--diameter", f"{beads.diameter} m", "--density",
             f"{beads.density} kg/m^3", "--bead-mass", f"{bead_mass(cell, beads)} kg",
             "--dry-normal-stresses", ", ".join(f"{s} Pa" for s in DRY_STRESSES), "--replicates",
             spec["replicates"], "--rows", spec["rows"], "--noise-seed", 100 + spec["lab"],
             "--states", scratch / "states_of_labs.sqlite", "--correlation-strain",
             0 if spec["noise"] == "white" else 0.5]
    if spec["protocol"] == "number":
        words += ["--inertial-numbers", "0.006, 0.04"]
    else:
        speeds = sorted({v for _, v, _ in points})
        words += ["--speeds", ", ".join(f"{v} rad/s" for v in speeds)]
    if spec["protocol"] == "ramp":
        words += ["--order", "up-and-down"]
    for name, value in vars(faults_of(spec)).items():
        if value != getattr(Faults(), name):
            words += [OPTIONS[name], value]
    run(words)


def run(words, accept=(0,)):
    out = subprocess.run([str(w) for w in words], capture_output=True, text=True)
    if out.returncode not in accept:
        raise RuntimeError(out.stderr.strip().splitlines()[-1] if out.stderr else str(words[1]))
    return out.stdout


def stated_friction(fit):
    value = fit["parameters"]["friction"]
    if isinstance(value, dict):
        return value["value"], value["stderr"]
    return value, math.sqrt(fit["parameter_covariance"][0][0])


def score(program, scratch, spec, folder, cohesion):
    common = ["--quiet", "--fidelity", "quick", "--threads", 1, "--store",
              scratch / "fits.sqlite", "--json", "-"]
    imported = json.loads(run([program, "import", folder, "--json", "-"]))
    # The true line is known at the lowest number of a step: its slope rises by 3 % to the quasi-static limit.
    at = ["--cohesion-inertial-number", LOWEST_NUMBER] if cohesion is not None else []
    fit = json.loads(run([program, "calibrate", folder, "--no-confirm"] + at + common, (0, 3)))
    diagnosis = json.loads(run([program, "diagnose", folder] + common, (0, 3)))
    value, error = stated_friction(fit)
    friction = BEADS[spec["beads"]].friction
    findings = [f.get("kind", "?") for f in imported["findings"] + imported["file_findings"]]
    rivals = sorted({name for names in diagnosis["confidence_set"] for name in names})
    right = FAULTS[spec["fault"]][1]
    # The effects of an inconclusive diagnosis are those that could go undetected: nothing is named.
    blamed = diagnosis["effects"] if diagnosis["verdict"] != "inconclusive" else []
    told = set(findings) | set(blamed) | set(rivals)
    named = bool(told & set(right)) or diagnosis["verdict"] == "suspect-measurement"
    undetected = diagnosis["verdict"] == "inconclusive" and set(diagnosis["effects"]) & set(right)
    result = {"friction": friction, "fitted": value, "stated": error,
              "ratio": (value - friction) / error if error else "",
              "findings": " ".join(findings), "verdict": diagnosis["verdict"],
              "effects": " ".join(diagnosis["effects"]), "rivals": " ".join(rivals),
              "named": int(named) if right else "",
              "could_go_undetected": int(bool(undetected)) if right else "",
              "false_findings": "",
              "chi2_per_dof": fit["chi2"] / fit["dof"] if fit["dof"] else "",
              "believable": fit.get("believable", "")}
    if spec["fault"] == "none":
        alarms = ["missing", "indistinguishable", "unknown", "suspect-measurement"]
        result["false_findings"] = len(findings) + (diagnosis["verdict"] in alarms)
    result.update(score_cohesion(fit, cohesion))
    return result


def score_cohesion(fit, truth):
    """Cohesion [Pa] of the wet content: from `cohesions`, where a version of the program writes it,
    else from the measured cohesion line."""
    if truth is None:
        return {}
    for entry in fit.get("cohesions", []) + fit.get("cohesion_lines", []):
        if entry.get("source", "measured") != "measured":
            continue
        if abs(entry.get("liquid_content", -1) - CONTENT) > 1e-6:
            continue
        found = entry.get("cohesion")
        if isinstance(found, dict) and found.get("stderr"):
            return {"cohesion": truth, "fitted_cohesion": found["value"],
                    "stated_cohesion": found["stderr"],
                    "cohesion_ratio": (found["value"] - truth) / found["stderr"]}
    return {"cohesion": truth}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("scratch", type=pathlib.Path)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--last", type=int, default=199)
    parser.add_argument("--makers", default="python,program")
    parser.add_argument("--results", type=pathlib.Path, default=HERE / "results.csv")
    a = parser.parse_args()
    a.scratch.mkdir(parents=True, exist_ok=True)
    done = set()
    if a.results.exists():
        with a.results.open() as file:
            done = {int(row["lab"]) for row in csv.DictReader(file)}
    for index in range(a.first, a.last + 1):
        spec = plan(index)
        if index in done or spec["maker"] not in a.makers.split(","):
            continue
        folder, begun, row = a.scratch / f"lab_{index}", time.time(), dict(spec)
        shutil.rmtree(folder, ignore_errors=True)
        try:
            cohesion = None
            if spec["maker"] == "python":
                cohesion = make_python(spec, folder)
            else:
                make_program(a.program, a.scratch, spec, folder)
            row.update(score(a.program, a.scratch, spec, folder, cohesion))
        except MissingStates as error:
            print(index, error, flush=True)
            continue
        except (RuntimeError, KeyError, json.JSONDecodeError) as error:
            row["error"] = f"{type(error).__name__}: {error}"
        row["seconds"] = round(time.time() - begun, 1)
        first = not a.results.exists()
        with a.results.open("a", newline="") as file:
            table = csv.DictWriter(file, FIELDS, lineterminator="\n")
            if first:
                table.writeheader()
            table.writerow({k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()})
        print({k: row.get(k) for k in ("lab", "maker", "fault", "verdict", "effects", "ratio",
                                       "findings", "seconds", "error")}, flush=True)


if __name__ == "__main__":
    main()
