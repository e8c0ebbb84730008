"""Ways in which an honest experimenter goes wrong, as changes of a study (studies.py)."""
import math
import random
from dataclasses import dataclass, replace

from studies import FORCE, GAP, PROOF, PROOF_TABLES, RECORDINGS, SPEED, STEP, TABLES, TIME, TORQUE, File, honest


@dataclass
class Spoiling:
    kind: str
    size: str
    change: object  # function of the study
    studies: list
    causes: set  # entries of the error budget that name the cause
    words: str  # a note with these words (regular expression) tells of the cause
    wet: bool = False  # a fault of wet readings: the fit uses all readings

    @property
    def name(self):
        return f"{self.kind} {self.size}".strip()


ALL = []


def spoil(kind, size, change, causes, words, studies=tuple(RECORDINGS), wet=False):
    ALL.append(Spoiling(kind, size, change, list(studies), set(causes.split()), words, wet))


# Changes of recordings.


def column(number, change, files=lambda study, file: True):
    """Changes a column of the chosen files: change(value, row)."""
    def apply(study):
        for file in study.files:
            if files(study, file):
                for row in file.rows:
                    row[number] = change(row[number], row)
    return apply


def scaled(number, factor, **chosen):
    return column(number, lambda value, row: factor * value, **chosen)


def shifted(number, by, **chosen):
    return column(number, lambda value, row: value + by, **chosen)


def only(*names):
    return lambda study, file: any(file.name.endswith(f"_{n}.csv") for n in names)


def is_wet(study, file):
    return file.content > 0


def drifting(number, shift=0.0, factor=0.0):
    """A zero or gain that drifts from the first row of the day to the last."""
    def apply(study):
        count = sum(len(file.rows) for file in study.files)
        for k, row in enumerate(row for file in study.files for row in file.rows):
            row[number] = row[number] * (1 + factor * k / count) + shift * k / count
    return apply


def key(name, factor=1.0, plus=0.0):
    def apply(study):
        study.keys[name] = study.keys[name] * factor + plus
    return apply


def in_steps(change, spared=0):
    """change(study, rows of a step) in all steps but one of so many (0: none is spared)."""
    def apply(study):
        for k, (_, _, rows) in enumerate(study.steps()):
            if not spared or k % spared != 2:
                change(study, rows)
    return apply


def lost_plateau(size):
    def change(study, rows):
        for k, row in enumerate(rows):
            row[TORQUE] *= 1 - size / 2 + size * k / len(rows)
    return change


def run_in(size):
    def change(study, rows):
        for k, row in enumerate(rows):
            row[TORQUE] *= 1 + size * math.exp(-k / len(rows))
    return change


def noisy(size):
    def change(study, rows):
        for row in rows:
            row[TORQUE] *= 1 + study.source.gauss(0, size)
    return change


def stick_slip(size, sign):
    """A saw tooth of 12 rows; sign 1: the torque is highest where it should be, 0: about the mean."""
    def change(study, rows):
        for k, row in enumerate(rows):
            row[TORQUE] *= 1 + size * ((k % 12) / 11 - (1 if sign else 0.5))
    return change


def wobble(size):
    def change(study, rows):
        for k, row in enumerate(rows):
            row[TORQUE] *= 1 + size * math.sin(row[SPEED] * row[TIME])
    return change


def few_rows(count):
    def apply(study):
        for file in study.files:
            rows = [rows[:count] for f, _, rows in study.steps() if f is file]
            file.rows = [row for step in rows for row in step]
    return apply


def every_nth_row(nth):
    def apply(study):
        for file in study.files:
            file.rows = file.rows[::nth]
    return apply


def copies(noise, of_all=False, gain=1.0, shift=0.0):
    """Replicates with an even number are copies of the ones before them."""
    def apply(study):
        by_name = {file.name: file for file in study.files}
        for file in study.files:
            stem, replicate = file.name[:-4].rsplit("_", 1)
            source = 1 if of_all else int(replicate) - 1
            if int(replicate) == 1 or (not of_all and int(replicate) % 2):
                continue
            file.rows = [list(row) for row in by_name[f"{stem}_{source}.csv"].rows]
            for row in file.rows:
                for number in (TORQUE, FORCE, GAP):
                    row[number] *= 1 + study.source.gauss(0, noise) if noise else 1
                row[TORQUE] *= gain
                row[TIME] += shift
    return apply


def more_copies(times, noise):
    """Each file is handed in again, under other names."""
    def apply(study):
        for file in list(study.files):
            stem, replicate = file.name[:-4].rsplit("_", 1)
            for k in range(times):
                rows = [[v * (1 + study.source.gauss(0, noise)) if n in (TORQUE, FORCE, GAP) and noise else v
                         for n, v in enumerate(row)] for row in file.rows]
                study.files.append(File(f"{stem}_{replicate}{k}.csv", file.content, rows))
    return apply


def evaporating(loss, between=False):
    """The liquid content falls by a share along each file, or along all files of the content; the wet
    part of the stress ratio goes as content^0.16 between 0.006 and 0.03 (lammps)."""
    def apply(study):
        dry = sorted(row[TORQUE] / row[FORCE] for file in study.files if not file.content for row in file.rows)
        dry_ratio = dry[len(dry) // 2]
        for file in study.files:
            if not file.content:
                continue
            alike = [f for f in study.files if f.content == file.content]
            for k, row in enumerate(file.rows):
                gone = loss * k / len(file.rows)
                if between:
                    gone = loss * (alike.index(file) + k / len(file.rows)) / len(alike)
                wet_part = row[TORQUE] - dry_ratio * row[FORCE]
                row[TORQUE] -= max(wet_part, 0) * (1 - (1 - gone)**0.16)
    return apply


def swap(a, b, files=lambda study, file: True):
    """The values of two columns, as numbers of the units of a usual header, stand for each other."""
    unit = {TORQUE: 1e-3, FORCE: 1.0, GAP: 1e-3, SPEED: 1.0}

    def apply(study):
        for file in study.files:
            if files(study, file):
                for row in file.rows:
                    row[a], row[b] = row[b] / unit[b] * unit[a], row[a] / unit[a] * unit[b]
    return apply


def shuffled(study):
    for file in study.files:
        study.source.shuffle(file.rows)


def doubled(study):
    for file in study.files:
        file.rows = [list(row) for row in file.rows for _ in range(2)]


def no_intervals(study):
    for file in study.files:
        for row in file.rows:
            row[STEP] = 1


def late_intervals(study):
    """The number of the interval changes a tenth of a step too late."""
    for file in study.files:
        numbers = [row[STEP] for row in file.rows]
        for k, row in enumerate(file.rows):
            row[STEP] = numbers[max(0, k - len(numbers) // numbers[-1] // 10)]


def time_from_zero(study):
    for _, _, rows in study.steps():
        start = rows[0][TIME]
        for row in rows:
            row[TIME] -= start


def with_rows_lost(share):
    def apply(study):
        for file in study.files:
            file.rows = [row for row in file.rows if study.source.random() > share]
    return apply


def clipped(number, share):
    """The sensor ends at a share of its largest value in the study."""
    def apply(study):
        largest = sorted(row[number] for file in study.files for row in file.rows)[-len(study.files)]
        column(number, lambda value, row: min(value, share * largest))(study)
    return apply


def rounded(number, step):
    return column(number, lambda value, row: step * round(value / step))


def wall_friction(coefficient):
    """The wall carries a part of the force and adds to the torque, more the higher the filling is."""
    def apply(study):
        width = study.keys["outer"] - study.keys["inner"]
        arm = (study.keys["outer"]**2 + study.keys["inner"]**2) / (study.keys["outer"] + study.keys["inner"])
        for file in study.files:
            for row in file.rows:
                thin = 0.937 * coefficient * row[GAP] / width
                row[TORQUE] = row[TORQUE] * math.exp(-thin) + thin * math.exp(-thin) * row[FORCE] * arm
    return apply


def text(edit):
    return lambda study: study.edits.append(edit)


def replaced(*pairs):
    def edit(content):
        for old, new in pairs:
            content = content.replace(old, new)
        return content
    return text(edit)


def in_header(*pairs):
    def edit(content):
        first, rest = content.split("\n", 1)
        for old, new in pairs:
            first = first.replace(old, new)
        return first + "\n" + rest
    return text(edit)


def stated_content(change):
    def apply(study):
        study.contents = {true: change(true) for true in study.contents}
    return apply


def swapped_contents(study):
    wet = [content for content in study.contents if content]
    first = study.contents[wet[0]]
    for a, b in zip(wet, wet[1:]):
        study.contents[a] = study.contents[b]
    study.contents[wet[-1]] = first


def called_dry(study):
    study.contents[max(study.contents)] = 0.0


def direct(effect, value, error, then=None):
    def apply(study):
        if then:
            then(study)
        study.add_effect(effect)
        study.more += f'\n[[direct]]\neffect = "{effect}"\nvalue = "{value}"\nerror = "{error}"\n'
    return apply


def other_weight(study):
    """Beads with weight are modelled without it, and the other way round."""
    if "grain-weight" in study.effects:
        study.effects.remove("grain-weight")
    else:
        study.add_effect("grain-weight")


def more(line):
    def apply(study):
        study.more += f"\n{line}\n"
    return apply


def cell_more(line):
    def apply(study):
        study.cell_more += f"{line}\n"
    return apply


def both(*changes):
    def apply(study):
        for change in changes:
            change(study)
    return apply


GAIN, OFFSET = "gain|torque", "offset|torque|zero|drift"
for size in (-20, -5, -3, -1, 1, 3, 5, 20):
    spoil("torque-gain", f"{size:+d} %", scaled(TORQUE, 1 + size / 100), "torque-gain shear_stress", GAIN)
for size in (-22, -5, -3, -1, 1, 3, 5):
    spoil("force-gain", f"{size:+d} %", scaled(FORCE, 1 + size / 100), "normal-force-gain normal_stress", "force")
SPEED_CAUSE = "angular_velocity lid-slip"
spoil("speed", "x1.5", scaled(SPEED, 1.5), SPEED_CAUSE, "speed|angular|rpm|inertial")
spoil("speed", "x0.8", scaled(SPEED, 0.8), SPEED_CAUSE, "speed|angular|rpm|inertial")
spoil("speed", "1/min called rad/s", scaled(SPEED, 30 / math.pi), SPEED_CAUSE, "speed|angular|rpm|1/min|inertial")
spoil("speed", "rad/s called 1/min", scaled(SPEED, math.pi / 30), SPEED_CAUSE, "speed|angular|rpm|1/min|inertial")
spoil("speed", "Hz called rad/s", scaled(SPEED, 0.5 / math.pi), SPEED_CAUSE, "speed|angular|rpm|Hz|inertial")
for size in (-0.1, 0.05, 0.1, 0.25):
    spoil("gap-offset", f"{size:+g} mm", shifted(GAP, size * 1e-3), "height-offset", "gap|height|solid fraction")
for size in (-0.5, 0.1, 0.5, 2):
    spoil("torque-baseline", f"{size:+g} mN m", shifted(TORQUE, size * 1e-3), "torque-offset", OFFSET)
for size in (-200, -100, 20, 50, 200):
    spoil("force-tare", f"{size:+d} mN", shifted(FORCE, size * 1e-3), "normal-force-offset", "force")
spoil("tare-drift", "torque 0.3 mN m a day", drifting(TORQUE, 0.3e-3), "torque-offset", "drift|torque|step between")
spoil("tare-drift", "torque 1 mN m a day", drifting(TORQUE, 1e-3), "torque-offset", "drift|torque|step between")
spoil("tare-drift", "force 0.1 N a day", drifting(FORCE, 0.1), "normal-force-offset", "drift|force|step between")
spoil("tare-drift", "gap 0.1 mm a day", drifting(GAP, 0.1e-3), "height-offset", "drift|gap|step between")
spoil("gain-drift", "torque 5 % a day", drifting(TORQUE, factor=0.05), "torque-gain", "drift|torque|step between")
spoil("gain-drift", "torque 10 % a day", drifting(TORQUE, factor=0.10), "torque-gain", "drift|torque|step between")
for size in (-5, -1, 1, 5):
    spoil("density", f"{size:+d} %", key("density", 1 + size / 100), "density bead_mass", "density|solid fraction")
spoil("density", "2500 for 1050, 1050 for 2500",
      lambda s: s.keys.update(density=2500.0 if s.keys["density"] < 2000 else 1050.0), "density", "density|solid fraction")
for size in (-0.2, 0.2, 1):
    spoil("inner-radius", f"{size:+g} mm", key("inner", plus=size * 1e-3), "inner_radius", "radius|radii|solid fraction")
for size in (-1, 0.1, 0.5):
    spoil("outer-radius", f"{size:+g} mm", key("outer", plus=size * 1e-3), "outer_radius", "radius|radii|solid fraction")
spoil("diameter", "radius of the beads for it", key("diameter", 0.5), "diameter", "diameter|size")
spoil("diameter", "twice as large", key("diameter", 2), "diameter", "diameter|size")
spoil("diameter", "+10 %", key("diameter", 1.1), "diameter", "diameter|size")
for size in (-2, -0.5, 0.5, 2):
    spoil("bead-mass", f"{size:+g} %", key("mass", 1 + size / 100), "bead_mass", "mass|solid fraction|bead-loss")
COPY = "cop(y|ies)|repeat|same (rows|readings)|identical"
spoil("copies", "every second replicate, 0.05 % noise", copies(5e-4), "", COPY)
spoil("copies", "every second replicate, 0.5 % noise", copies(5e-3), "", COPY)
spoil("copies", "every second replicate, exact", copies(0), "", COPY)
spoil("copies", "every replicate, exact", copies(0, of_all=True), "", COPY)
spoil("copies", "every replicate, 0.05 % noise", copies(5e-4, of_all=True), "", COPY)
spoil("copies", "every second replicate, torque +1 %", copies(0, gain=1.01), "", COPY)
spoil("copies", "every second replicate, an hour later", copies(0, shift=3600.0), "", COPY)
spoil("copies", "each file five times more, 0.05 % noise", more_copies(5, 5e-4), "", COPY)
STEADY = "steady|plateau|transient|set aside|left out|drift|run-in|exclud"
spoil("lost-steps", "torque drifts by 30 % in 14 of 15 steps", in_steps(lost_plateau(0.3), 15), "", STEADY)
spoil("lost-steps", "torque drifts by 60 % in 14 of 15 steps", in_steps(lost_plateau(0.6), 15), "", STEADY)
spoil("lost-steps", "torque drifts by 3 % in every step", in_steps(lost_plateau(0.03)), "", STEADY)
spoil("lost-steps", "noise of 100 % in 14 of 15 steps", in_steps(noisy(1.0), 15), "", STEADY)
spoil("lost-steps", "noise of 30 % in all steps", in_steps(noisy(0.3)), "", STEADY)
spoil("run-in", "torque still 4 % above its level", in_steps(run_in(0.1)), "", STEADY)
spoil("run-in", "torque still 15 % above its level", in_steps(run_in(0.4)), "", STEADY)
spoil("few-rows", "first 8 of each step", few_rows(8), "", "rows|steady|strain|transient")
spoil("few-rows", "first 30 of each step", few_rows(30), "", "rows|steady|strain|transient")
spoil("few-rows", "every tenth", every_nth_row(10), "", "rows|steady|strain|transient")
DRYING = "evaporat|liquid|drift|content"
for loss in (10, 40, 80):
    spoil("evaporation", f"{loss} % in each file", evaporating(loss / 100), "liquid_content", DRYING, wet=True)
spoil("evaporation", "60 % in a day", evaporating(0.6, between=True), "liquid_content", DRYING, wet=True)
spoil("direct", "torque -2 mN m with the wrong sign", direct("torque-offset", "2 mN m", "0.05 mN m", shifted(TORQUE, -2e-3)),
      "torque-offset", "direct|torque-offset|measured")
spoil("direct", "torque 5 mN m, far off", direct("torque-offset", "5 mN m", "0.05 mN m"), "torque-offset",
      "direct|torque-offset|measured")
spoil("direct", "force 0.5 N, far off", direct("normal-force-offset", "0.5 N", "5 mN"), "normal-force-offset",
      "direct|normal-force-offset|measured")
spoil("direct", "gap 0.5 mm, far off", direct("height-offset", "0.5 mm", "10 um"), "height-offset",
      "direct|height-offset|measured")
spoil("direct", "torque 0.3 for 0.8 mN m", direct("torque-offset", "0.3 mN m", "0.02 mN m", shifted(TORQUE, 0.8e-3)),
      "torque-offset", "direct|torque-offset|measured")
CONTENT = "liquid content|content"
spoil("content", "in per cent", stated_content(lambda c: 100 * c), "liquid_content", CONTENT, wet=True)
spoil("content", "tenfold", stated_content(lambda c: 10 * c), "liquid_content", CONTENT, wet=True)
spoil("content", "+30 %", stated_content(lambda c: 1.3 * c), "liquid_content", CONTENT, wet=True)
spoil("content", "per mass of beads", lambda s: stated_content(lambda c: c * 1000 / s.keys["density"])(s), "liquid_content",
      CONTENT, wet=True)
spoil("content", "swapped", swapped_contents, "liquid_content", CONTENT, studies=("lammps", "polystyrene"), wet=True)
spoil("content", "the wettest called dry", called_dry, "liquid_content", "liquid|dry|wet", wet=True)
spoil("tension", "+26 %", key("tension", 1.26), "surface_tension", "tension", wet=True)
spoil("tension", "26 for 72", key("tension", 0.36), "surface_tension", "tension", wet=True)
spoil("angle", "40 deg for 0", lambda s: s.keys.update(angle=40.0), "contact_angle", "angle|wett", wet=True)
spoil("columns", "torque and force swapped", swap(TORQUE, FORCE), "", "torque|force|column")
spoil("columns", "gap and force swapped", swap(GAP, FORCE), "", "gap|force|column")
spoil("columns", "torque and force swapped in one file", swap(TORQUE, FORCE, only("2")), "", "torque|force|column")
spoil("columns", "torque and gap swapped", swap(TORQUE, GAP), "", "torque|gap|column")
spoil("rows", "shuffled", shuffled, "", "time|order|row")
spoil("rows", "each twice", doubled, "", "time|twice|repeat|row")
spoil("rows", "no intervals", no_intervals, "", "interval|step")
spoil("rows", "intervals too late", late_intervals, "", "interval|step")
spoil("rows", "time of each step from 0", time_from_zero, "", "time")
spoil("rows", "a third lost", with_rows_lost(1 / 3), "", "time|row")
spoil("decimal", "points to commas", replaced((".", ",")), "", "decimal|comma")
spoil("decimal", "commas to points", replaced((",", ".")), "", "decimal|comma")
spoil("decimal", "points lost", replaced(("0.0", "00")), "", "decimal|point")
spoil("unit", "torque in uN m called mN m", scaled(TORQUE, 1e3), "torque-gain", "torque|unit")
spoil("unit", "torque in ozf in called mN m", scaled(TORQUE, 1 / 7.0616), "torque-gain", "torque|unit")
spoil("unit", "force in gf called mN", scaled(FORCE, 1 / 9.80665), "normal-force-gain", "force|unit")
spoil("unit", "force in lbf called N", scaled(FORCE, 1 / 4.448), "normal-force-gain", "force|unit")
spoil("unit", "gap in mil called 0.01 mm", scaled(GAP, 1 / 2.54), "height-offset", "gap|unit")
SATURATED = "satur|limit|largest|constant"
for share in (50, 75, 90):
    spoil("saturation", f"torque at {share} %", clipped(TORQUE, share / 100), "", SATURATED)
spoil("saturation", "force at 50 %", clipped(FORCE, 0.5), "", SATURATED)
COARSE = "resol|round|digit|coarse"
for step in (0.1, 1, 5):
    spoil("quantised", f"torque {step:g} mN m", rounded(TORQUE, step * 1e-3), "", COARSE)
spoil("quantised", "gap 0.1 mm", rounded(GAP, 1e-4), "", COARSE)
spoil("quantised", "gap 1 mm", rounded(GAP, 1e-3), "", COARSE)
spoil("quantised", "force 0.5 N", rounded(FORCE, 0.5), "", COARSE)
SLIP = "stick|slip|wobble|drift"
spoil("stick-slip", "5 % below the level", in_steps(stick_slip(0.05, 1)), "", SLIP)
spoil("stick-slip", "20 % below the level", in_steps(stick_slip(0.2, 1)), "", SLIP)
spoil("stick-slip", "20 % about the mean", in_steps(stick_slip(0.2, 0)), "", SLIP)
spoil("wobble", "8 % once per turn", in_steps(wobble(0.08)), "", SLIP)
WALL = "wall|friction of the wall"
for size in (0.03, 0.1, 0.2):
    spoil("wall-friction", f"{size:g}", wall_friction(size), "wall-friction", WALL)
spoil("lid", "cross-talk of 0.5 mm", column(TORQUE, lambda v, row: v + 0.5e-3 * row[FORCE]), "cross-talk", "cross-talk|torque")
spoil("lid", "slip of 30 %", scaled(SPEED, 1 / 0.7), SPEED_CAUSE, "slip|speed")
spoil("one-file", "torque +5 %", scaled(TORQUE, 1.05, files=lambda s, f: f is s.files[1]), "", "differ|torque|step between")
spoil("one-file", "torque +15 %", scaled(TORQUE, 1.15, files=lambda s, f: f is s.files[1]), "", "differ|torque|step between")
spoil("one-file", "gap +0.2 mm", shifted(GAP, 2e-4, files=lambda s, f: f is s.files[1]), "", "differ|gap|step between")
spoil("one-file", "bead mass -3 %", scaled(GAP, 0.97, files=lambda s, f: f is s.files[1]), "", "differ|gap|step between")
spoil("weight", "the other model of it", other_weight, "grain-weight", "weight")
spoil("cell", "torque formula as printed", cell_more('torque_formula = "as_printed"'), "torque-gain", "printed|torque")
spoil("cell", "discrepancy of 10 % stated", lambda s: setattr(s, "more", "discrepancy = 0.1\n" + s.more), "", "discrepancy")


# Changes of tables of readings.


def name_of(begin, study):
    """The header of a column; KeyError where an earlier change has left it out or renamed it."""
    for name in study.table:
        if name.startswith(begin + " "):
            return name
    raise KeyError(begin)


def values(begin, change, chosen=lambda k, table: True):
    """Changes the column that begins so: change(value, number of the row)."""
    def apply(study):
        name = name_of(begin, study)
        study.table[name] = [change(v, k) if chosen(k, study.table) else v for k, v in enumerate(study.table[name])]
    return apply


def times(begin, factor, **chosen):
    return values(begin, lambda value, k: factor * value, **chosen)


def constant(begin, value):
    return values(begin, lambda _, k: value)


def without(*begins):
    def apply(study):
        study.table = {n: v for n, v in study.table.items() if not any(n.startswith(b + " ") for b in begins)}
    return apply


def renamed(old, new):
    def apply(study):
        study.table = {n.replace(old, new): v for n, v in study.table.items()}
    return apply


def in_order(order):
    """order(study, numbers of the rows) gives the rows of the new table."""
    def apply(study):
        count = len(next(iter(study.table.values())))
        chosen = order(study, list(range(count)))
        study.table = {name: [column_[k] for k in chosen] for name, column_ in study.table.items()}
    return apply


def shuffled_rows(study, numbers):
    study.source.shuffle(numbers)
    return numbers


def row_copies(noise, all_rows=False, times_=1):
    """Every second reading at a condition is a copy of the first one."""
    def apply(study):
        table = study.table
        first = {}
        names = [n for n in table if n.startswith(("stress_ratio [", "solid_fraction ["))]
        for k, condition in enumerate(zip(table["normal_stress [Pa]"], table["inertial_number [1]"],
                                          table["liquid_content [1]"])):
            source = first.setdefault(condition, k)
            if source != k:
                for name in names:
                    table[name][k] = table[name][source] * (1 + (study.source.gauss(0, noise) if noise else 0))
        if all_rows:
            in_order(lambda s, numbers: numbers * times_)(study)
    return apply


def digits(begin, count):
    return values(begin, lambda value, k: f"{value:.{count}f}")


def drift_of(begin, share):
    def apply(study):
        name = name_of(begin, study)
        column_ = study.table[name]
        study.table[name] = [v * (1 + share * k / len(column_)) for k, v in enumerate(column_)]
    return apply


def swapped_columns(a, b):
    def apply(study):
        names = [name_of(x, study) for x in (a, b)]
        table = study.table
        table[names[0]], table[names[1]] = table[names[1]], table[names[0]]
    return apply


def wet_rows(k, table):
    return float(table["liquid_content [1]"][k]) > 0


def as_shear_stress(gain_of_normal):
    """States the shear stress in place of the ratio, beside a wrong normal stress."""
    def apply(study):
        table = {}
        normal = study.table["normal_stress [Pa]"]
        for name, column_ in study.table.items():
            if name.startswith("stress_ratio"):
                name = name.replace("stress_ratio", "shear_stress").replace("[1]", "[Pa]")
                column_ = [v * n for v, n in zip(column_, normal)]
            table[name] = column_
        table["normal_stress [Pa]"] = [gain_of_normal * n for n in normal]
        study.table = table
    return apply


def table(kind, size, change, causes, words, wet=False):
    spoil(kind, size, change, causes, words, studies=TABLES, wet=wet)


RATIO, FRACTION = "stress_ratio", "solid_fraction"
for size in (-20, -5, -3, -1, 1, 3, 5, 20):
    table("ratio-gain", f"{size:+d} %", times(RATIO, 1 + size / 100), "shear_stress", "stress")
for size in (-5, -2, 2, 5):
    table("normal-stress", f"{size:+d} % beside shear stress", as_shear_stress(1 + size / 100), "normal_stress", "normal stress")
table("normal-stress", "over the full disk", as_shear_stress(0.78), "normal_stress", "normal stress")
table("normal-stress", "over the full disk, in the ratio",
      both(times("normal_stress", 0.78), times(RATIO, 1 / 0.78), times(RATIO + "_se", 1 / 0.78)), "normal_stress shear_stress", "stress")
table("normal-stress", "kPa called Pa", times("normal_stress", 1e-3), "normal_stress", "normal stress|unit|kPa")
table("normal-stress", "Pa called kPa", renamed("normal_stress [Pa]", "normal_stress [kPa]"), "normal_stress", "normal stress|unit|kPa")
table("normal-stress", "Pa called mPa", renamed("normal_stress [Pa]", "normal_stress [mPa]"), "normal_stress", "normal stress|unit|mPa")
table("normal-stress", "psi called kPa", times("normal_stress", 1 / 6.895), "normal_stress", "normal stress|unit")
for size in (-3, -1, -0.5, 0.5, 1, 3):
    table("fraction-gain", f"{size:+g} %", times(FRACTION, 1 + size / 100), "solid_fraction", "solid fraction")
table("fraction", "porosity", values(FRACTION, lambda v, k: 1 - v), "solid_fraction", "solid fraction|porosity")
table("fraction", "in per cent", times(FRACTION, 100), "solid_fraction", "solid fraction|per cent|unit")
table("fraction", "0.64 in every row", constant(FRACTION, 0.64), "solid_fraction", "solid fraction|same|equal")
table("fraction", "0.60 in every row", constant(FRACTION, 0.6), "solid_fraction", "solid fraction|same|equal")
table("fraction", "left out", without(FRACTION, FRACTION + "_se"), "solid_fraction", "solid fraction")
table("fraction", "with the liquid's volume", lambda s: values(
    FRACTION, lambda v, k: v * (1 + s.table["liquid_content [1]"][k]))(s), "solid_fraction liquid_content", "solid fraction|liquid", wet=True)
NUMBER = "inertial number"
for value in (0, 2e-4, 0.1):
    table("inertial-number", f"{value:g} in every row", constant("inertial_number", value), "inertial_number", NUMBER)
table("inertial-number", "x2", times("inertial_number", 2), "inertial_number", NUMBER)
table("inertial-number", "x0.5", times("inertial_number", 0.5), "inertial_number", NUMBER)
table("inertial-number", "called a shear rate", renamed("inertial_number [1]", "shear_rate [1/s]"), "inertial_number", NUMBER + "|shear rate")
ERRORS = "standard error|_s[de]|scatter"
SE = (RATIO + "_se", FRACTION + "_se")
table("errors", "ten times too large", both(*(times(n, 10) for n in SE)), "", ERRORS)
table("errors", "ten times too small", both(*(times(n, 0.1) for n in SE)), "", ERRORS)
table("errors", "of the fraction ten times too small", times(SE[1], 0.1), "", ERRORS)
table("errors", "of the ratio ten times too large", times(SE[0], 10), "", ERRORS)
table("errors", "of the ratio missing", without(SE[0]), "", ERRORS)
table("errors", "of the fraction missing", without(SE[1]), "", ERRORS)
table("errors", "all missing", without(*SE), "", ERRORS)
table("errors", "a cell empty", values(SE[0], lambda v, k: "" if k == 3 else v), "", ERRORS + "|empty")
table("errors", "a cell 0", values(SE[0], lambda v, k: "0" if k == 3 else v), "", ERRORS + "|zero|0")
table("errors", "in per cent", both(*(values(n, lambda v, k: 1.0) for n in SE)), "", ERRORS)
table("errors", "sd of five values called sd", both(*(times(n, 5**0.5) for n in SE), renamed("_se", "_sd")), "", ERRORS)
table("errors", "95 % intervals called se", both(*(times(n, 1.96) for n in SE)), "", ERRORS)
table("errors", "se called 95 % intervals", renamed("_se", "_u95"), "", ERRORS + "|u95")
table("errors", "swapped", swapped_columns(*SE), "", ERRORS)
table("round", "ratio 0.3, fraction 0.61", both(digits(RATIO, 1), digits(FRACTION, 2)), "", COARSE)
table("round", "ratio 0.30, fraction 0.6", both(digits(RATIO, 2), digits(FRACTION, 1)), "", COARSE)
table("round", "ratio 0.300 of two digits", values(RATIO, lambda v, k: f"{v:.2f}0"), "", COARSE)
table("round", "ratio 0.3000 of one digit", values(RATIO, lambda v, k: f"{v:.1f}000"), "", COARSE)
table("round", "errors to one digit", both(digits(SE[0], 2), digits(SE[1], 3)), "", COARSE + "|" + ERRORS)
table("round", "shear stress 80 +- 3.0", both(as_shear_stress(1), values("shear_stress", lambda v, k: f"{10 * round(v / 10)}"),
                                              constant("shear_stress_se", "3.0")), "", COARSE + "|" + ERRORS)
table("round", "shear stress 80.0 +- 3.0", both(as_shear_stress(1), values("shear_stress", lambda v, k: f"{10 * round(v / 10)}.0"),
                                                constant("shear_stress_se", "3.0")), "", COARSE + "|" + ERRORS)
table("content", "0.03 in every wet row", values("liquid_content", lambda v, k: 0.03 if v else v), "liquid_content", CONTENT, wet=True)
table("content", "column left out", without("liquid_content"), "liquid_content", "liquid|wet|dry", wet=True)
table("content", "empty in wet rows", values("liquid_content", lambda v, k: "" if v else v), "liquid_content", "liquid|empty", wet=True)
table("content", "in per cent", times("liquid_content", 100), "liquid_content", CONTENT, wet=True)
table("content", "per mass of beads", times("liquid_content", 0.952), "liquid_content", CONTENT, wet=True)
table("content", "the driest called dry", values("liquid_content", lambda v, k: 0 if v == 0.006 else v), "liquid_content", "liquid|dry|wet", wet=True)
table("content", "swapped", values("liquid_content", lambda v, k: {0.006: 0.03, 0.03: 0.006}.get(v, v)), "liquid_content", CONTENT, wet=True)
table("row-copies", "every second, 0.05 % noise", row_copies(5e-4), "", COPY)
table("row-copies", "every second, exact", row_copies(0), "", COPY)
table("row-copies", "each row five times", in_order(lambda s, n: n * 5), "", COPY)
table("row-copies", "every second, five times", row_copies(0, True, 5), "", COPY)
table("table-rows", "shuffled", in_order(shuffled_rows), "", "order")
table("table-rows", "one twice", in_order(lambda s, n: n + [3]), "", COPY)
table("table-rows", "half of them lost", in_order(lambda s, n: n[::2]), "", "row|reading")
table("table-columns", "ratio and fraction swapped", swapped_columns(RATIO, FRACTION), "", "stress|solid")
table("table-columns", "number and content swapped", swapped_columns("inertial_number", "liquid_content"), "", "liquid|inertial")
table("decimal", "points to commas", replaced((".", ",")), "", "decimal|comma")
table("decimal", "semicolons and commas", replaced((",", ";"), (".", ",")), "", "decimal|comma")
table("tension", "26 for 20.6", key("tension", 1.26), "surface_tension", "tension", wet=True)
table("tension", "72 for 20.6", key("tension", 3.5), "surface_tension", "tension", wet=True)
table("angle", "40 deg for 0", lambda s: s.keys.update(angle=40.0), "contact_angle", "angle", wet=True)
table("diameter", "radius of the beads for it", key("diameter", 0.5), "diameter", "diameter", wet=True)
table("diameter", "+10 %", key("diameter", 1.1), "diameter", "diameter", wet=True)
table("table-drift", "ratio 5 % a day", drift_of(RATIO, 0.05), "", "drift|stress")
table("table-drift", "ratio 15 % a day", drift_of(RATIO, 0.15), "", "drift|stress")
table("table-drift", "fraction 1 % a day", drift_of(FRACTION, 0.01), "", "drift|solid")
table("peaks", "ratio +12 %, fraction +1 % as of failure", both(times(RATIO, 1.12), times(FRACTION, 1.01)), "", "failure|peak")
table("typing", "0.28 as 0.82 once", values(RATIO, lambda v, k: 0.82 if k == 7 else v), "", "reading|row|stress")
table("typing", "a ratio ten times too large once", values(RATIO, lambda v, k: 10 * v if k == 7 else v), "", "reading|row|stress")
table("typing", "a fraction 0.64 for 0.61 once", values(FRACTION, lambda v, k: v + 0.03 if k == 7 else v), "", "reading|row|solid")
table("ratio", "angle in degrees", values(RATIO, lambda v, k: math.degrees(math.atan(v))), "shear_stress", "stress")
table("ratio", "sine for tangent", values(RATIO, lambda v, k: math.sin(math.atan(v))), "shear_stress", "stress")
table("ratio", "wet rows with the cohesion taken off", times(RATIO, 0.75, chosen=wet_rows), "shear_stress", "stress|wet", wet=True)
table("discrepancy", "10 % stated", more("discrepancy = 0.1"), "", "discrepancy")


def applies(change, name):
    """Whether the second of two changes still finds what it changes."""
    try:
        change(honest(name))
    except (KeyError, TypeError):
        return False
    return True


def pairs(count, seed=3):
    """Pairs of spoilings of different kinds, as many for each study."""
    result = []
    for study in RECORDINGS + TABLES:
        source = random.Random(f"{study} {seed}")
        possible = [s for s in ALL if study in s.studies]
        seen = set()
        while len(seen) < count:
            a, b = source.sample(possible, 2)
            change = both(a.change, b.change)
            if a.kind == b.kind or (a.name, b.name) in seen or (study in TABLES and not applies(change, study)):
                continue
            seen.add((a.name, b.name))
            result.append(Spoiling(f"pair: {a.kind} + {b.kind}", f"{a.size} + {b.size}", change, [study],
                                   a.causes | b.causes, f"{a.words}|{b.words}", a.wet or b.wet))
    return result


def proof():
    """The single ways of recordings and of tables, for the studies on which nothing was chosen."""
    return ([replace(s, studies=list(PROOF)) for s in ALL if "glass" in s.studies]
            + [replace(s, studies=list(PROOF_TABLES)) for s in ALL if "lammps-table" in s.studies])


def spoilings():
    """All ways, 300 with the pairs: those that two studies share count once."""
    return ALL + pairs((300 - len(ALL)) // len(RECORDINGS + TABLES))
