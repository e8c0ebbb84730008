#!/usr/bin/env python3
"""Plants each effect in a virtual laboratory, one at a time, and lets the program find it.

For each effect: a laboratory with it (simulated, seeds of its own), then calibrate, diagnose, add of
what was planted, and diagnose again. Writes a table of what was said and of the errors before and
after beside the scatter of replicates, below which no model can come. Finished laboratories stay in
the work folder, so that the same command goes on where it was stopped.
"""

import argparse
import csv
import json
import math
import os
import shutil
import subprocess
import sys
from pathlib import Path

root = Path(__file__).resolve().parent.parent

# Name, seed, and what is hidden; sizes of a few times what matters.
LABS = [
    ("complete", 52, []),
    ("torque-offset", 32, ["--torque-offset.torque", "1 mN m"]),
    ("torque-gain", 33, ["--torque-gain.gain", "1.05"]),
    ("normal-force-offset", 43, ["--normal-force-offset.force", "0.15 N"]),
    ("wall-friction", 44, ["--wall-friction.coefficient", "0.15"]),
    ("grain-weight", 41, ["--grain-weight.on", "1"]),
    ("height-offset", 42, ["--height-offset.offset", "0.2 mm"]),
    ("bead-loss", 34, ["--bead-loss.fraction", "0.02"]),
    ("lid-slip", 35, ["--lid-slip.fraction", "0.4"]),
    ("liquid-loss", 51, ["--liquid-loss.rate", "3e-4"]),
    ("wet-friction", 39, ["--wet-friction.difference", "0.03"]),
    ("contact-angle", 48, ["--contact-angle.angle", "40 deg"]),
    ("capillary-bridges", 47, ["--capillary-bridges.surface_tension", "28 mN/m"]),
    ("willett-bridges", 50, ["--willett-bridges.on", "1"]),
    ("rupture-distance", 49, ["--rupture-distance.factor", "0.6"]),
    ("reversible-bridges", 37, ["--reversible-bridges.on", "1"]),
    ("viscous-bridges", 38, ["--viscous-bridges.viscosity", "100 mPa s"]),
    ("unequal-bridges", 52, ["--unequal-bridges.deviation", "1"]),
    ("capillary-coulomb", 40, ["--capillary-coulomb.on", "1"]),
    ("rolling-resistance", 36, ["--friction", "0.3", "--rolling-resistance.coefficient", "0.2"]),
    ("dry-adhesion", 46, ["--dry-adhesion.force", "6 uN"]),
    ("polydispersity", 45, ["--polydispersity.deviation", "0.2"]),
]
# What changes with liquid content is looked for at two.
TWO_CONTENTS = {
    "liquid-loss", "wet-friction", "contact-angle", "capillary-bridges", "willett-bridges",
    "rupture-distance", "reversible-bridges", "viscous-bridges", "capillary-coulomb",
    "unequal-bridges",
}  # fmt: skip


def say(text):
    print(text, file=sys.stderr, flush=True)


def run(command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode not in (0, 3):  # 3: a fit that did not converge, which the table shows
        say(done.stderr[-2000:])
        sys.exit(f"planted_effects: this failed: {' '.join(map(str, command))}")
    return done


def make_lab(pendular, folder, name, seed, hidden):
    if (folder / "truth.json").exists():
        return
    shutil.rmtree(folder, ignore_errors=True)
    say(f"{name}: simulating")
    contents = "0.007, 0.03" if name in TWO_CONTENTS or name == "complete" else "0.03"
    run([pendular, "virtual-lab", folder, "--fidelity", "quick", "--seed", seed,
         "--store", folder.parent / "truth.sqlite", "--inertial-numbers", "0.01, 0.03",
         "--wet-normal-stresses", "0.3, 1, 3 kPa", "--liquid-contents", contents,
         "--quiet", *hidden])  # fmt: skip


def scatter(fit):
    """RMS scatter [%] of replicates about the means of their conditions, of each observable."""
    groups = {}
    for reading in fit["predictions"]:
        key = (round(math.log(reading["normal_stress"]) / 0.05),
               round(math.log(reading["inertial_number"]) / 0.05), reading["liquid_content"])
        groups.setdefault(key, []).append(reading["measured"])
    result = []
    for observable in ("shear_stress", "solid_fraction"):
        squares, freedom = 0.0, 0
        for group in groups.values():
            values = [one[observable]["value"] for one in group]
            mean = sum(values) / len(values)
            squares += sum((v / mean - 1) ** 2 for v in values)
            freedom += len(values) - 1
        result.append(100 * math.sqrt(squares / freedom) if freedom else math.nan)
    return result


def chi2_p(chi2, dof):
    """Probability of at least chi2 with dof degrees of freedom (Wilson and Hilferty 1931)."""
    z = ((chi2 / dof) ** (1 / 3) - 1 + 2 / (9 * dof)) / math.sqrt(2 / (9 * dof))
    return 0.5 * math.erfc(z / math.sqrt(2))


def diagnose(pendular, study, file):
    run([pendular, "diagnose", study, "--quiet", "--json", file])
    return json.loads(file.read_text())


def study_one(pendular, lab, work, name):
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(lab, work, ignore=shutil.ignore_patterns("out"))
    run([pendular, "calibrate", work, "--no-confirm", "--quiet"])
    before = diagnose(pendular, work, work / "before.json")
    row = {"planted": name, "verdict": before["verdict"],
           "named": " ".join(before["effects"] + before["suspect_measurements"]),
           "confidence_set": " | ".join(" + ".join(each) for each in before["confidence_set"]),
           "chi2_per_dof_joint": before["chi2"] / before["dof"]}  # fmt: skip
    if name == "complete":
        return row
    found = next(each for each in before["scan"] if each["effect"] == name)
    row |= {"power": found["power"], "p": found["p"], "predicted_reduction": found["predicted_reduction"],
            "refitted_reduction": found["refitted_reduction"]}  # fmt: skip
    run([pendular, "add", work, name, "--quiet"])
    ladder = json.loads((work / "out/ladder.json").read_text())["ladder_steps"]
    start, end = ladder[0], ladder[-1]
    fit = json.loads((work / "out/fit.json").read_text())
    floor = scatter(fit)
    for parameter, value in fit["parameters"].items():
        kind = "friction" if parameter == "friction" else "effect"
        row |= {kind: value["value"], f"{kind}_stderr": value["stderr"]}
    after = diagnose(pendular, work, work / "after.json")
    row |= {"chi2_before": start["chi2"], "chi2_after": end["chi2"], "dof_after": end["dof"],
            "p_after": chi2_p(end["chi2"], end["dof"])}  # fmt: skip
    for k, observable in enumerate(("shear_stress", "solid_fraction")):
        row |= {f"{observable}_rms_before": start["rms_percent"][observable],
                f"{observable}_rms_after": end["rms_percent"][observable],
                f"{observable}_scatter": floor[k]}  # fmt: skip
    row |= {"verdict_after": after["verdict"], "named_after": " ".join(after["effects"])}
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--work", type=Path, default=root / "build/planted",
                        help="folder of laboratories and studies (default build/planted)")
    parser.add_argument("--pendular", type=Path, default=root / "build/release/pendular")
    parser.add_argument("--out", type=Path, default=root / "bench/results/planted_effects.csv")
    parser.add_argument("--only", help="names of some, separated by commas")
    parser.add_argument("--finished", action="store_true",
                        help="only laboratories that are there already; simulates nothing")  # fmt: skip
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    # The atlas alone is known, as to a newcomer.
    os.environ["PENDULAR_STORE"] = str(options.work / "store.sqlite")
    rows = []
    for name, seed, hidden in LABS:
        lab = options.work / "labs" / name
        if options.only and name not in options.only.split(","):
            continue
        if options.finished and not (lab / "truth.json").exists():
            continue
        lab.parent.mkdir(exist_ok=True)
        make_lab(options.pendular, lab, name, seed, hidden)
        row = study_one(options.pendular, lab, options.work / "studies" / name, name)
        say(f"{name}: {row['verdict']} {row['named']}")
        rows.append(row)
    fields = max((list(row) for row in rows), key=len)
    version = run([options.pendular, "--version"]).stdout.splitlines()[0]
    with options.out.open("w", newline="") as file:
        file.write(f"# {version}; bench/planted_effects.py\n")
        writer = csv.DictWriter(file, fields, lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()})


if __name__ == "__main__":
    main()
