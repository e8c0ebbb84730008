"""Four honest studies of known friction, as values that can be spoiled before they are written.

lammps        recordings, friction 0.11: states that LAMMPS found (bench/foreign_worlds), beads with weight
lammps-table  readings of the same states, as a table with standard errors and without a cell
polystyrene   recordings, friction 0.12: the states of examples/wet, beads without weight
glass         recordings at constant speed, friction 0.16, with water (bench/laboratories/states.csv)

Three more, on which nothing in the program was chosen, prove what the others suggest (spoilings.py --proof):
glass-0.09    as glass, with friction 0.09 and in a narrower cell
glass-0.25    as glass, with friction 0.25
glass-table   readings of glass beads of friction 0.25, as a table with standard errors and without a cell

instrument.py of bench/laboratories makes the recordings; nothing here uses code of Pendular.
"""
import csv
import json
import math
import pathlib
import random
import sys
from dataclasses import dataclass, field

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "bench/laboratories"))
import instrument  # noqa: E402
from instrument import G, Beads, Cell, Faults, Noise, Rig, Shown, States  # noqa: E402

TRUTHS = {"lammps": 0.11, "lammps-table": 0.11, "polystyrene": 0.12, "glass": 0.16}
PROOF = {"glass-0.09": 0.09, "glass-0.25": 0.25}
PROOF_TABLES = {"glass-table": 0.25}
RECORDINGS = ["lammps", "polystyrene", "glass"]
TABLES = ["lammps-table"]
TIME, TORQUE, FORCE, GAP, SPEED, STEP = range(6)  # columns of a row [s, N m, N, m, rad/s, 1]
ROWS = 120  # of a step
NOISE = Noise(torque=0.01, height=0.002, force=0.002, memory=0.5)


@dataclass
class File:
    name: str
    content: float
    rows: list


@dataclass
class Study:
    """What study.toml states, and what the files hold."""

    name: str
    keys: dict  # stated values in SI units
    files: list = field(default_factory=list)
    table: dict = field(default_factory=dict)  # a table of readings: header to values
    contents: dict = field(default_factory=dict)  # true liquid content to the stated one
    effects: list = field(default_factory=list)
    fit_to: str = "dry"
    more: str = ""  # further lines of study.toml
    cell_more: str = ""  # further lines of [cell]
    layout: str = ""
    edits: list = field(default_factory=list)  # of the text of each file
    source: random.Random = None  # of what a spoiling draws

    def add_effect(self, name):
        if name not in self.effects:
            self.effects.append(name)

    def steps(self):
        """(file, number of the step, its rows)."""
        for file in self.files:
            for number in sorted({row[STEP] for row in file.rows}):
                yield file, number, [row for row in file.rows if row[STEP] == number]

    def write(self, folder):
        folder.mkdir(parents=True)
        (folder / "study.toml").write_text(study_toml(self))
        texts = {f.name: LAYOUTS[self.layout](f.rows) for f in self.files}
        if self.table:
            texts = {"readings.csv": table_text(self.table)}
        for name, text in texts.items():
            for edit in self.edits:
                text = edit(text)
            (folder / name).write_text(text, encoding="utf-8")


def plain(rows):
    lines = ["Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s],Interval [1]"]
    for time, torque, force, height, speed, step in rows:
        lines.append(f"{time:.6f},{1e3 * torque:.7g},{force:.7g},{1e3 * height:.5f},{speed:.7g},{step}")
    return "\n".join(lines) + "\n"


LAYOUTS = {"plain": plain, **instrument.LAYOUTS}


def table_text(table):
    def cell(value):
        return value if isinstance(value, str) else f"{value:.6g}"

    lines = [",".join(table)]
    lines += [",".join(cell(value) for value in row) for row in zip(*table.values())]
    return "\n".join(lines) + "\n"


def study_toml(study):
    k = study.keys
    text = f'[grains]\ndiameter = "{k["diameter"] * 1e6:g} um"\ndensity = "{k["density"]:g} kg/m^3"\n\n'
    text += (f'[liquid]\nsurface_tension = "{k["tension"] * 1e3:g} mN/m"\n'
             f'contact_angle = "{k["angle"]:g} deg"\n\n')
    if study.table:
        text += '[[readings]]\nfile = "readings.csv"\n'
    else:
        text += (f'[cell]\ninner_radius = "{k["inner"] * 1e3:g} mm"\nouter_radius = "{k["outer"] * 1e3:g} mm"\n'
                 f'bead_mass = "{k["mass"] * 1e3:.6g} g"\n{study.cell_more}')
    for content, stated in study.contents.items():
        text += f'\n[[recording]]\nfile = "content_{content:g}_*.csv"\nliquid_content = {stated:g}\n'
    effects = ", ".join(f'"{name}"' for name in study.effects)
    return text + (f'\n[model]\nbase = "dem"\ncalibrate = ["friction"]\nfit_to = "{study.fit_to}"\n'
                   f"effects = [{effects}]\n{study.more}")


@dataclass
class State:
    stress: float
    number: float
    content: float
    ratio: float
    fraction: float
    ratio_error: float
    fraction_error: float


def lammps_states():
    """States by (content, replicate), in the order of measurement."""
    states = {}
    with (ROOT / "bench/foreign_worlds/states.csv").open() as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if row["world"] not in ("plain", "wet"):
                continue
            content = float(row["liquid_content [1]"])
            state = State(float(row["normal_stress [Pa]"]), float(row["inertial_number [1]"]), content,
                          *(float(row[f"{name} [1]"]) for name in (
                              "stress_ratio", "solid_fraction", "stress_ratio_stderr", "solid_fraction_stderr")))
            states.setdefault((content, int(row["replicate"])), []).append(state)
    return states


def example_states():
    states = {}
    for recording in json.loads((ROOT / "examples/wet/truth.json").read_text())["recordings"]:
        key = recording["liquid_content"], recording["replicate"]
        for step in recording["steps"]:
            ratio, fraction = step["run"]["stress_ratio"], step["run"]["solid_fraction"]
            states.setdefault(key, []).append(State(
                step["normal_stress"], step["inertial_number"], recording["liquid_content"],
                ratio["value"], fraction["value"], ratio["stderr"], fraction["stderr"]))
    return states


def shown(state, cell, beads, mass, weight):
    """What an exact instrument shows of a state at half of the height."""
    volume = mass / beads.density
    height = volume / (state.fraction * cell.area())
    rate = state.number / math.sqrt(beads.mass() / (beads.diameter * state.stress))
    force = state.stress * cell.area() - (volume * beads.density * G / 2 if weight else 0)
    return Shown(cell.torque(state.ratio * state.stress), force, height, 2 * height * rate / (cell.inner + cell.outer))


def keys_of(cell, beads, mass, tension):
    return {"diameter": beads.diameter, "density": beads.density, "tension": tension, "angle": 0.0,
            "inner": cell.inner, "outer": cell.outer, "mass": mass}


def recordings(name, seed, shown_steps, cell, beads, mass, tension, effects, layout):
    """shown_steps: (content, replicate) to what each step shows."""
    study = Study(name, keys_of(cell, beads, mass, tension), effects=effects, layout=layout)
    for place, ((content, replicate), steps) in enumerate(shown_steps.items()):
        rows = instrument.record(steps, cell, ROWS, NOISE, Faults(), 1000 * seed + place)
        study.files.append(File(f"content_{content:g}_{replicate}.csv", content, [list(r) for r in rows]))
        study.contents[content] = content
    return study


def lammps(seed):
    cell, beads, mass = Cell(21e-3, 45e-3), Beads("polystyrene", 0.5e-3, 1050, 0.11), 60e-3
    steps = {key: [shown(s, cell, beads, mass, True) for s in states] for key, states in lammps_states().items()}
    return recordings("lammps", seed, steps, cell, beads, mass, 20.6e-3, ["grain-weight"], "tabs")


def polystyrene(seed):
    cell, beads, mass = Cell(21e-3, 45e-3), Beads("polystyrene", 0.5e-3, 1050, 0.12), 60e-3
    steps = {key: [shown(s, cell, beads, mass, False) for s in states] for key, states in example_states().items()}
    return recordings("polystyrene", seed, steps, cell, beads, mass, 20.6e-3, [], "plain")


def glass(seed, name="glass", friction=0.16, cell=Cell(30e-3, 60e-3), mass=0.24):
    beads, tension = Beads("glass", 0.8e-3, 2500, friction), 72.8e-3
    states = States(ROOT / "bench/laboratories/states.csv", beads.friction)
    rig = Rig(cell, beads, states, mass, tension)
    steps = {}
    for content in (0.0, 0.03):
        for replicate in (1, 2, 3):
            # Inertial numbers of the states: 0.0035 to 0.11 without water, 0.007 to 0.04 with it.
            stresses, speeds = ((710, 1400, 3400), (7, 18)) if content else ((400, 1000, 2000, 5000), (4.4, 27))
            steps[content, replicate] = [rig.shown(stress, speed, None, content)[0]
                                         for stress in stresses for speed in speeds]
    return recordings(name, seed, steps, cell, beads, mass, tension, ["grain-weight"], "decimal-comma")


def table_of(name, states, beads, tension, source):
    """Readings of states, with errors of 1 % of the stress ratio and 0.2 % of the solid fraction."""
    study = Study(name, {"diameter": beads.diameter, "density": beads.density, "tension": tension, "angle": 0.0})
    names = ["normal_stress [Pa]", "stress_ratio [1]", "stress_ratio_se [1]", "solid_fraction [1]",
             "solid_fraction_se [1]", "inertial_number [1]", "liquid_content [1]"]
    study.table = {name: [] for name in names}
    for s in states:
        ratio, fraction = (v * (1 + r * source.gauss(0, 1)) for v, r in ((s.ratio, 0.01), (s.fraction, 0.002)))
        errors = math.hypot(0.01 * ratio, s.ratio_error), math.hypot(0.002 * fraction, s.fraction_error)
        values = [s.stress, ratio, errors[0], fraction, errors[1], s.number, s.content]
        for name, value in zip(names, values):
            study.table[name].append(value)
    return study


def lammps_table(seed):
    states = [s for each in lammps_states().values() for s in each]
    return table_of("lammps-table", states, Beads("polystyrene", 0.5e-3, 1050, 0.11), 20.6e-3, random.Random(5000 + seed))


def glass_table(seed):
    beads, tension = Beads("glass", 0.8e-3, 2500, 0.25), 72.8e-3
    known = States(ROOT / "bench/laboratories/states.csv", beads.friction)
    states = []
    for content, stresses, numbers in ((0.0, (400, 1000, 2000, 5000), (0.004, 0.02, 0.08)),
                                       (0.03, (710, 1400, 3400), (0.008, 0.035))):
        for stress in stresses:
            for number in numbers:
                ratio, fraction = known.at(number, math.pi * tension / beads.diameter / stress, content)
                states += 2 * [State(stress, number, content, ratio, fraction, 0.0, 0.0)]
    return table_of("glass-table", states, beads, tension, random.Random(6000 + seed))


MAKERS = {"lammps": lammps, "lammps-table": lammps_table, "polystyrene": polystyrene, "glass": glass,
          "glass-0.09": lambda seed: glass(seed, "glass-0.09", 0.09, Cell(33e-3, 55e-3), 0.15),
          "glass-0.25": lambda seed: glass(seed, "glass-0.25", 0.25), "glass-table": glass_table}


def honest(name, seed=1):
    """An honest study, with noise of its own for each seed."""
    study = MAKERS[name](seed)
    study.source = random.Random(f"{name} {seed}")
    return study
