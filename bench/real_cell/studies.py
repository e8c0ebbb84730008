#!/usr/bin/env python3
"""Makes a study of each cell, with recordings as an instrument would write them, from the tables that
ship, and asks Pendular what is missing. Neither LAMMPS nor a new simulation is needed.

    studies.py PROGRAM [--work FOLDER] [--out FILE] [--state-walls] [--only TEXT] [--fillings]
        [--replicate N]

--state-walls: study.toml states the friction of the side walls, and what they mobilise.
--fillings: cells of the same walls and several heights are one study of several fillings.
--replicate: of this sample alone (1 or 2); otherwise a study has recordings of each.
"""
import argparse
import csv
import dataclasses
import json
import math
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE)]
sys.dont_write_bytecode = True
import cells  # noqa: E402
from cells import key_of, rows_of  # noqa: E402

INNER_RADIUS = 0.1  # [m]: an annulus as flat as the simulated cells
BEAD_MASS = math.pi / 6 * cells.DENSITY * cells.DIAMETER**3
ROW = 0.04  # strain from row to row of series.csv

STUDY = """\
[grains]
diameter = "{diameter:g} um"
density = "{density:g} kg/m^3"
{liquid}
[cell]
inner_radius = "{inner:g} mm"
outer_radius = "{outer:g} mm"
{walls}
# Between simulated samples of one state, as long as these; the samples are smaller than a real cell.
[scatter]
shear_stress = 0.012
solid_fraction = 0.003

{recordings}"""
# What walls of a measured friction mobilise (docs/explanation/cell.md), and how far cells differ.
DIRECT = """\
[[direct]]
effect = "shear-localisation"
value = "{value:.3f}"
error = "0.02"
"""
RECORDING = """\
[[recording]]
file = "{pattern}"
bead_mass = "{mass:.6g} g"
{liquid_content}
"""
LIQUID = """
[liquid]
surface_tension = "20.6 mN/m"
contact_angle = "0 deg"
"""


def tables(replicate=None):
    """States and series by cell, set point and replicate."""
    states, series = {}, defaultdict(list)
    for row in rows_of("states.csv"):
        if replicate in (None, key_of(row)[3]):
            states[key_of(row)] = row
    for row in rows_of("series.csv"):
        series[key_of(row)].append(
            [float(row[name]) for name in ("shear_stress [s22]", "normal_stress [s22]", "gap [a]")]
        )
    return states, series


def least_sheared(found, members, states):
    """Smallest height of the sheared layer over the gap, in the steps that gave readings."""
    keys = [key for key in states if key[0] in {cell.name for cell in members}]
    shares = []
    for reading in found.get("readings", []):
        key = min(
            keys,
            key=lambda k: abs(math.log(reading["normal_stress"] / k[1]))
            + abs(math.log(reading["inertial_number"] / k[2]))
            + 10 * abs((reading.get("liquid_content", 0) > 0) - (content_of(states[k]) > 0)),
        )
        shares.append(float(states[key]["sheared_height [a]"]) / float(states[key]["gap [a]"]))
    return f"{min(shares):.2f}" if shares else ""


def content_of(state):
    return float(state["liquid_content [1]"])


def radii(cell):
    return INNER_RADIUS, INNER_RADIUS + cell.width * cells.DIAMETER


def area(cell):
    inner, outer = radii(cell)
    return math.pi * (outer**2 - inner**2)


def recording(cell, steps, series):
    """CSV of the steps of one filling, one after the other."""
    inner, outer = radii(cell)
    lever = 2 * math.pi * (outer**3 - inner**3) / 3
    lines = ["Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s],Interval [1]"]
    time = 0.0
    for interval, (stress, inertial_number, key) in enumerate(steps, 1):
        second = math.sqrt(BEAD_MASS / (cells.DIAMETER * stress))  # unit of time of the simulation
        speed = inertial_number * cell.height  # [diameters per unit of time]
        omega = speed * cells.DIAMETER / second / ((inner + outer) / 2)
        interval_of_rows = ROW * cell.height / speed * second
        for shear, normal, gap in series[key]:
            values = (shear * stress * lever * 1e3, normal * stress * area(cell))
            lines.append(
                f"{time:.5f},{values[0]:.5g},{values[1]:.6g},{gap * cells.DIAMETER * 1e3:.5f},"
                f"{omega:.6g},{interval}"
            )
            time += interval_of_rows
    return "\n".join(lines) + "\n"


def write_study(folder, members, states, series, state_walls):
    folder.mkdir(parents=True, exist_ok=True)
    for earlier in folder.glob("*.csv"):  # the patterns of [[recording]] would find it
        earlier.unlink()
    entries = ""
    wet = any(cell.bridge_volume for cell in members)
    for cell in members:
        keys = sorted(key for key in states if key[0] == cell.name)
        columns = float(states[keys[0]]["grain_volume [a]"]) * cells.DIAMETER
        mass = columns * area(cell) * cells.DENSITY * 1e3
        stem = f"{'wet' if cell.bridge_volume else 'height'}_{cell.height}"
        content = sum(content_of(states[key]) for key in keys) / len(keys)
        content = f"liquid_content = {content:.4g}\n" if wet else ""
        for replicate in sorted({key[3] for key in keys}):
            steps = [(key[1], key[2], key) for key in keys if key[3] == replicate]
            text = recording(cell, steps, series)
            (folder / f"{stem}_{replicate}.csv").write_text(text, encoding="ascii")
        entries += RECORDING.format(pattern=f"{stem}_*.csv", mass=mass, liquid_content=content)
    first = members[0]
    if state_walls and first.wall_friction:
        mobilised = 0.9 * first.wall_friction / (1 + 3.6 * first.wall_friction)
        entries += DIRECT.format(value=mobilised)
    stated = f"wall_friction = {first.wall_friction:g}\n" if state_walls and first.walls else ""
    inner, outer = radii(first)
    (folder / "study.toml").write_text(
        STUDY.format(
            diameter=cells.DIAMETER * 1e6,
            density=cells.DENSITY,
            inner=inner * 1e3,
            outer=outer * 1e3,
            walls=stated,
            liquid=LIQUID if wet else "",
            recordings=entries,
        ),
        encoding="ascii",
    )


def asked(program, work, command, folder, *more):
    """JSON of a command; a dictionary with what it said where there is none."""
    words = [program, command, folder, *more, "--quiet", "--json", "-"]
    if command != "import":
        words += ["--store", work / "runs.sqlite"]
    said = subprocess.run([str(w) for w in words], capture_output=True, text=True, check=False)
    try:
        return json.loads(said.stdout)
    except json.JSONDecodeError:
        return {"error": (said.stderr.strip().splitlines() or ["no JSON"])[-1]}


def friction_of(fit):
    """Friction, its standard error, and that with the typical errors of an instrument."""
    if "parameters" not in fit:
        return "", "", ""
    friction = fit["parameters"]["friction"]
    total = math.hypot(friction["stderr"], friction["stderr_typical_instrument"])
    return tuple(f"{x:.4f}" for x in (friction["value"], friction["stderr"], total))


def by_walls(fit):
    """Part of the error of the friction by walls of unknown friction."""
    for each in fit.get("instrument", []):
        if each["name"] == "wall_friction":
            return f"{abs(each['shift']['friction']):.4f}"
    return ""


def cohesions_of(fit):
    """Cohesion over F0/a2 of wet readings: measured, and as the fit predicts it."""
    row = {}
    for source in ("measured", "simulated"):
        lines = [line for line in fit.get("cohesion_lines", []) if line["source"] == source]
        found = lines[0]["reduced_cohesion"] if lines else None
        row[f"cohesion {source}"] = f"{found['value']:.4f}" if found else ""
        row[f"stderr of cohesion {source}"] = f"{found['stderr']:.4f}" if found else ""
    return row


def chosen(diagnosis, said):
    """Effects that a user would add: those that the diagnosis says are missing, and the one that a
    warning of import names; of several that cannot be told apart, the one that the warnings suggest."""
    effects = diagnosis.get("effects", [])
    names = effects if diagnosis.get("verdict") == "missing" else []
    walls = "shear-localisation"
    if walls not in names and (walls in effects or f"The effect {walls} describes" in said):
        names = [*names, walls]
    return names


def added(program, work, folder, names):
    """Fit of a study whose model has these effects, which had none."""
    study = folder / "study.toml"
    text = study.read_text(encoding="ascii")
    listed = ", ".join(f'"{name}"' for name in names)
    study.write_text(f"{text}\n[model]\neffects = [{listed}]\n", encoding="ascii")
    fit = asked(program, work, "calibrate", folder, "--no-confirm")
    study.write_text(text, encoding="ascii")
    return fit


def within(fit, friction):
    """Whether the true friction is within two errors, those of the instrument included: 1, 0, or
    nothing where there is no fit."""
    value, _, error = friction_of(fit)
    return int(abs(float(value) - friction) <= 2 * float(error)) if value else ""


def judged(program, work, folder, friction, found):
    """Row of results of one study; `found`: what import says of it."""
    said = " ".join(doubt["what"] for doubt in found.get("doubts", []))
    fit = asked(program, work, "calibrate", folder, "--no-confirm")
    diagnosis = asked(program, work, "diagnose", folder)
    row = {
        "readings": len(found.get("readings", [])),
        "creep": int("gap still changes" in said),
        "uneven": int("the shear under the lid, down to a layer" in said),
        "believable": int(bool(fit.get("believable"))),
    }
    row |= dict(zip(("friction", "stderr", "with instrument"), friction_of(fit)))
    # Where there are too few readings, the program says so in place of a verdict.
    row["verdict"] = diagnosis.get("verdict", "none")
    row["effects"] = " ".join(diagnosis.get("effects", []))
    missing = chosen(diagnosis, said)
    row["added"] = " ".join(missing)
    after = added(program, work, folder, missing) if missing else {}
    names = ("friction added", "stderr added", "with instrument added")
    row |= dict(zip(names, friction_of(after)))
    coefficient = after.get("parameters", {}).get("shear-localisation.coefficient")
    row["coefficient"] = f"{coefficient['value']:.3f}" if coefficient else ""
    # What import names of the cell itself, beside what the readings show.
    layers = any("wall-layers" in note for note in found.get("notes", []))
    everything = [*missing, "wall-layers"]
    last = added(program, work, folder, everything) if layers else after or fit
    row["layers"] = int(layers)
    row |= dict(zip(("friction all", "stderr all", "with instrument all"), friction_of(last)))
    row |= {"within before": within(fit, friction), "within all": within(last, friction)}
    row |= {"by walls": by_walls(fit), "by walls all": by_walls(last)}
    return row | cohesions_of(last)


def dry_of(cell):
    dry = dataclasses.replace(cell, bridge_volume=0, name="")
    alike = (dataclasses.replace(each, name="") == dry for each in cells.CELLS)
    return [each for each, same in zip(cells.CELLS, alike) if same and cell.bridge_volume]


def groups(states, fillings):
    """Cells that are one study, by its name."""
    known = {key[0] for key in states}
    result = defaultdict(list)
    for cell in cells.CELLS:
        if cell.name in known:
            name = cell.name.rsplit(", height", 1)[0] if fillings else cell.name
            # Of wet beads, a study has the dry ones between the same walls, too.
            result[name] += [*dry_of(cell), cell]
    if fillings:
        return {k: v for k, v in result.items() if len({cell.height for cell in v}) > 1}
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("--work", type=Path, default=HERE.parents[1] / "build/real-cell-studies")
    parser.add_argument("--out", type=Path, help="CSV of the results")
    parser.add_argument("--state-walls", action="store_true")
    parser.add_argument("--fillings", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--replicate", type=int)
    given = parser.parse_args()
    states, series = tables(given.replicate)
    rows = []
    for name, members in groups(states, given.fillings).items():
        if given.only not in name:
            continue
        folder = given.work / name.replace(",", "").replace(" ", "-")
        write_study(folder, members, states, series, given.state_walls)
        cell = members[0]
        row = {"study": name, "wall friction": cell.wall_friction, "true friction": cell.friction}
        found = asked(given.program, given.work, "import", folder)
        row["least sheared"] = least_sheared(found, members, states)
        rows.append(row | judged(given.program, given.work, folder, cell.friction, found))
        print(rows[-1], file=sys.stderr, flush=True)
    if given.out and rows:
        with open(given.out, "w", encoding="utf-8", newline="") as file:
            table = csv.DictWriter(file, rows[0], lineterminator="\n")
            table.writeheader()
            table.writerows(rows)


if __name__ == "__main__":
    main()
