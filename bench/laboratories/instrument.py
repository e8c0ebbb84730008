"""An annular shear cell and its recordings, written without a line of Pendular.

Every formula here comes from the definitions, so that the program is tested on recordings that its own
virtual laboratory did not make: torque and height from stress and solid fraction, faults of the
instrument, noise, and files of other layouts. True states come from states.csv.
"""
import csv
import math
import pathlib
import random
from dataclasses import dataclass, field

G = 9.80665


@dataclass
class Cell:
    inner: float  # [m]
    outer: float

    def area(self):
        return math.pi * (self.outer**2 - self.inner**2)

    def torque(self, shear_stress):
        """Integral of 2 pi r^2 shear_stress from the inner to the outer radius."""
        return 2 * math.pi * shear_stress * (self.outer**3 - self.inner**3) / 3

    def arm(self):
        """Torque per force where every part of the area carries the same shear stress."""
        return self.torque(1) / self.area()


@dataclass
class Beads:
    name: str
    diameter: float
    density: float
    friction: float

    def mass(self):
        return self.density * math.pi * self.diameter**3 / 6


class States:
    """Stress ratio and solid fraction of one friction, smooth in the inertial number and 1/P*.

    Dry: cubic in ln I through all runs, by least squares. Wet: dry plus (a + a' ln I) x + b x^2 with
    x = 1/P*, for each liquid content.
    """

    def __init__(self, path, friction):
        with open(path) as file:
            rows = [r for r in csv.DictReader(file) if abs(float(r["friction"]) - friction) < 1e-9]
        self.dry, self.wet = {}, {}
        self.runs = len([r for r in rows if not r["reduced_pressure"]])
        if self.runs < 12:
            return
        for name in ("stress_ratio", "solid_fraction"):
            dry = [(math.log(float(r["inertial_number"])), float(r[name])) for r in rows
                   if not r["reduced_pressure"]]
            self.dry[name] = fit([[1, u, u * u, u**3] for u, _ in dry], [v for _, v in dry])
            for content in {float(r["liquid_content"]) for r in rows} - {0.0}:
                design, values = [], []
                for r in rows:
                    if float(r["liquid_content"]) != content:
                        continue
                    u, x = math.log(float(r["inertial_number"])), 1 / float(r["reduced_pressure"])
                    design.append([x, x * u, x * x])
                    values.append(float(r[name]) - self.of_dry(name, u))
                if len(values) >= 10:
                    self.wet[name, content] = fit(design, values)

    def of_dry(self, name, u):
        a = self.dry[name]
        return a[0] + a[1] * u + a[2] * u * u + a[3] * u**3

    def at(self, number, inverse_pressure=0.0, content=0.0):
        result = []
        for name in ("stress_ratio", "solid_fraction"):
            u = math.log(number)
            value = self.of_dry(name, u)
            if content > 0:
                a, x = self.wet[name, content], inverse_pressure
                value += a[0] * x + a[1] * x * u + a[2] * x * x
            result.append(value)
        return result

    def holds(self, content):
        """Whether states of a liquid content are known, beside the dry ones."""
        return self.runs >= 12 and (content == 0 or ("stress_ratio", content) in self.wet)


def fit(design, values):
    """Least squares by the normal equations, with Gauss-Jordan elimination."""
    n = len(design[0])
    m = [[sum(d[i] * d[j] for d in design) for j in range(n)] +
         [sum(d[i] * v for d, v in zip(design, values))] for i in range(n)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(m[k][i]))
        m[i], m[pivot] = m[pivot], m[i]
        m[i] = [x / m[i][i] for x in m[i]]
        for k in range(n):
            if k != i:
                m[k] = [x - m[k][i] * y for x, y in zip(m[k], m[i])]
    return [row[n] for row in m]


@dataclass
class Faults:
    torque_offset: float = 0.0   # [N m]
    torque_gain: float = 1.0
    force_offset: float = 0.0    # [N]
    force_gain: float = 1.0
    cross_talk: float = 0.0      # [m]
    height_offset: float = 0.0   # [m]
    lid_slip: float = 0.0
    wall_friction: float = 0.0
    bead_loss: float = 0.0
    torque_drift: float = 0.0    # relative, from the first to the last row of a recording
    wobble: float = 0.0          # relative amplitude of the torque, once per turn


@dataclass
class Shown:
    torque: float
    force: float
    height: float
    speed: float


@dataclass
class Rig:
    cell: Cell
    beads: Beads
    states: States
    bead_mass: float             # as weighed [kg]
    surface_tension: float = 0.0
    faults: Faults = field(default_factory=Faults)

    def shown(self, stress, speed=None, number=None, content=0.0):
        """What the instrument shows where it is set to a normal stress it shows, at a shown speed or
        at the inertial number that follows from what it shows."""
        f, cell, beads = self.faults, self.cell, self.beads
        force = stress * cell.area()
        at_lid = (force - f.force_offset) / f.force_gain
        volume = self.bead_mass / beads.density * (1 - f.bead_loss)
        fraction, ratio, set_speed = 0.6, 0.3, speed
        for _ in range(60):
            height = volume / (fraction * cell.area())
            k = f.wall_friction * 0.937
            thin = k * height / (cell.outer - cell.inner)
            carried = at_lid / math.exp(0.09 * thin)  # as in the cells of bench/real_cell
            true_stress = (carried + volume * beads.density * G / 2) / cell.area()
            shown_height = height + f.height_offset
            if speed is None:
                rate_shown = number / math.sqrt(beads.mass() / (beads.diameter * stress))
                set_speed = 2 * shown_height * rate_shown / (cell.inner + cell.outer)
            rate = (1 - f.lid_slip) * set_speed * (cell.inner + cell.outer) / (2 * height)
            true_number = rate * math.sqrt(beads.mass() / (beads.diameter * true_stress))
            inverse = (math.pi * self.surface_tension / beads.diameter) / true_stress
            ratio, fraction = self.states.at(true_number, inverse, content)
        torque = cell.torque(ratio * true_stress)
        # Share that acts along the flow in the upper half of the bed (docs/explanation/cell.md).
        length = 3.8 * beads.diameter * (min(max(true_number, 0.001), 0.15) / 0.03) ** -0.16
        x = height / length
        along = 2 / x * math.log(math.cosh(x) / math.cosh(x / 2))
        torque += along * thin * carried * (cell.outer**2 + cell.inner**2) / (cell.outer + cell.inner)
        torque = f.torque_gain * (torque + f.cross_talk * at_lid) + f.torque_offset
        return Shown(torque, force, shown_height, set_speed), true_number


@dataclass
class Noise:
    torque: float = 0.01         # of a step's mean, relative
    height: float = 0.002
    force: float = 0.002         # of a row
    within: float = 0.3          # share of torque and height noise from row to row
    memory: float = 0.0          # correlation of one row with the next


def series(random_, count, memory):
    """Noise of deviation 1 with correlation memory^lag."""
    x, out = random_.gauss(0, 1), []
    for _ in range(count):
        out.append(x)
        x = memory * x + math.sqrt(1 - memory * memory) * random_.gauss(0, 1)
    return out


def record(shown_steps, cell, rows, noise, faults, seed):
    """Rows (time, torque, force, height, speed, step) of one recording."""
    random_ = random.Random(seed)
    out, now, angle, total = [], 0.0, 0.0, rows * len(shown_steps)
    for step, s in enumerate(shown_steps, 1):
        # Deviation of a row such that the mean of the step has the share `within` of the scatter.
        single = math.sqrt(rows * (1 - noise.memory) / (1 + noise.memory))
        of_torque = 1 + noise.torque * math.sqrt(1 - noise.within**2) * random_.gauss(0, 1)
        of_height = 1 + noise.height * math.sqrt(1 - noise.within**2) * random_.gauss(0, 1)
        t = series(random_, rows, noise.memory)
        h = series(random_, rows, noise.memory)
        # A wobble once per turn shows in a step of some turns; a strain of 20 is one or two.
        strain_of_step = 60.0 if faults.wobble else 20.0
        spacing = strain_of_step / rows * 2 * s.height / (s.speed * (cell.inner + cell.outer))
        for k in range(rows):
            strain = strain_of_step * k / rows
            start = 1 - math.exp(-strain / 0.03) + 0.2 * math.exp(-strain / 0.2) * (strain > 0)
            torque = s.torque * of_torque * start * (1 + noise.torque * noise.within * single * t[k])
            torque *= 1 + faults.torque_drift * len(out) / total
            torque *= 1 + faults.wobble * math.sin(angle)
            height = s.height * of_height * (1 - 0.015 * math.exp(-strain / 0.2)) * (
                1 + noise.height * noise.within * single * h[k])
            force = s.force * (1 + noise.force * random_.gauss(0, 1))
            out.append((now, torque, force, height, s.speed, step))
            now += spacing
            angle += s.speed * spacing
    return out


def decimal_comma(rows):
    """Semicolons, decimal commas, uN m and 1/min."""
    lines = ["Time [s];Torque [uN.m];Normal Force [N];Gap [mm];Speed [1/min];Interval"]
    for time, torque, force, height, speed, step in rows:
        cells = [f"{time:.4f}", f"{1e6 * torque:.5g}", f"{force:.5g}", f"{1e3 * height:.5f}",
                 f"{speed * 30 / math.pi:.6g}", str(step)]
        lines.append(";".join(cells).replace(".", ","))
    return "\n".join(lines) + "\n"


def tabbed(rows):
    """Tabs, units in parentheses, gram-force and um."""
    lines = ["Time (s)\tTorque (mN.m)\tNormal force (gf)\tGap (um)\tAngular velocity (rad/s)\tInterval"]
    for time, torque, force, height, speed, step in rows:
        lines.append(f"{time:.4f}\t{1e3 * torque:.6g}\t{1e3 * force / G:.6g}\t{1e6 * height:.2f}"
                     f"\t{speed:.6g}\t{step}")
    return "\n".join(lines) + "\n"


def columns_in_other_order(rows):
    lines = ["Interval [1],Gap [m],Angular velocity [rpm],Normal force [mN],Torque [N m],Time [min]"]
    for time, torque, force, height, speed, step in rows:
        lines.append(f"{step},{height:.7f},{speed * 30 / math.pi:.6g},{1e3 * force:.6g},{torque:.7g}"
                     f",{time / 60:.6f}")
    return "\n".join(lines) + "\n"


LAYOUTS = {"decimal-comma": decimal_comma, "tabs": tabbed, "other-order": columns_in_other_order}


def study_toml(rig, liquid, contents):
    text = (f'[grains]\ndiameter = "{rig.beads.diameter * 1e3:g} mm"\n'
            f'density = "{rig.beads.density * 1e-3:g} g/cm^3"\n\n')
    if liquid:
        text += f'[liquid]\nsurface_tension = "{rig.surface_tension * 1e3:g} mN/m"\ncontact_angle = "0 deg"\n\n'
    text += (f'[cell]\ninner_radius = "{rig.cell.inner * 100:g} cm"\n'
             f'outer_radius = "{rig.cell.outer * 100:g} cm"\nbead_mass = "{rig.bead_mass * 1e3:.6g} g"\n')
    for content in contents:
        text += f'\n[[recording]]\nfile = "content_{content:g}_*.csv"\nliquid_content = {content:g}\n'
    return text + '\n[model]\nbase = "dem"\ncalibrate = ["friction"]\nfit_to = "dry"\neffects = ["grain-weight"]\n'


def write_lab(folder, rig, liquid, contents, steps, replicates, rows, noise, layout, seed):
    """Writes a study. `steps` maps a liquid content to set points (stress, speed, number)."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    (folder / "study.toml").write_text(study_toml(rig, liquid, contents))
    numbers = []
    for content in contents:
        for replicate in range(1, replicates + 1):
            shown = []
            for stress, speed, number in steps[content]:
                seen, true_number = rig.shown(stress, speed, number, content)
                shown.append(seen)
                numbers.append(true_number)
            rows_ = record(shown, rig.cell, rows, noise, rig.faults, seed * 1000 + len(numbers))
            name = f"content_{content:g}_{replicate}.csv"
            (folder / name).write_text(LAYOUTS[layout](rows_), encoding="utf-8")
    return numbers
