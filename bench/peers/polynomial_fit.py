#!/usr/bin/env python3
"""Friction of a dry quasi-static reading from runs at a few frictions and inertial numbers, as one
fits it by hand: stress ratio and solid fraction each as a polynomial,

    c0 + c1 x + c2 x^2 + c3 I^0.75,  x = ln(friction + 0.05),

by weighted least squares; at I = 0 the friction with the least chi2, its error where chi2 is 1 more.

Usage: polynomial_fit.py FIT STIFFNESS_NUMBER RUN... > RESULT. FIT is a fit.json of Pendular, from which
only reading and grains are taken; the runs have that stiffness number and are files of calibration.sh.
RESULT names the friction as a fit.json does. Errors common to all runs are Pendular's: of the exponent
of I (half the difference between 0.5 and 1) and of the correction to the stiffness of the grains.
"""
import json
import math
import sys

EXPONENT, EXTREME_EXPONENTS = 0.75, (0.5, 1.0)
RIGIDITY_FACTOR, RIGIDITY_FACTOR_ERROR = 1.23, 0.15  # of 3 x solid fraction x overlap
SCAN = 20000  # steps over the frictions simulated
NAMES = "stress_ratio", "solid_fraction"


def read_run(path):
    """A run: friction, inertial number, overlap, times; a line per block: normal and shear stress,
    solid fraction. Means come with the standard errors of independent blocks."""
    with open(path, encoding="ascii") as lines:
        head, *blocks = [[float(cell) for cell in line.split()] for line in lines]
    run = dict(zip(("friction", "inertial_number", "overlap", "wall_seconds", "cpu_seconds"), head))
    if len(blocks) < 2:
        sys.exit(f"{path}: a standard error takes two blocks")
    count = len(blocks)
    normal, shear, solid = (sum(column) / count for column in zip(*blocks))
    ratio = shear / normal
    run["normal_stress"] = normal
    run["stress_ratio"] = ratio, error_of_mean([(b[1] - ratio * b[0]) / normal for b in blocks])
    run["solid_fraction"] = solid, error_of_mean([b[2] - solid for b in blocks])
    return run


def error_of_mean(deviations):
    count = len(deviations)
    return math.sqrt(sum(d * d for d in deviations) / (count - 1) / count)


def inverse(matrix):
    """By Gauss-Jordan elimination."""
    size = len(matrix)
    rows = [list(row) + [float(i == j) for j in range(size)] for i, row in enumerate(matrix)]
    for i in range(size):
        pivot = max(range(i, size), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for k in range(size):
            if k != i:
                rows[k] = [a - rows[k][i] * b for a, b in zip(rows[k], rows[i])]
    return [row[size:] for row in rows]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def terms(friction, inertial_number, exponent):
    x = math.log(friction + 0.05)
    return [1, x, x * x, inertial_number**exponent]


class Polynomial:
    """Through points (friction, inertial number, value, standard error)."""

    def __init__(self, points, exponent):
        rows = [terms(p[0], p[1], exponent) for p in points]
        values = [p[2] for p in points]
        weights = [p[3] ** -2 for p in points]
        columns = list(zip(*rows))
        weighted = [[w * c for w, c in zip(weights, column)] for column in columns]
        self.covariance = inverse([[dot(a, b) for b in columns] for a in weighted])
        right = [dot(column, values) for column in weighted]
        self.coefficients = [dot(row, right) for row in self.covariance]
        residuals = [value - dot(self.coefficients, row) for value, row in zip(values, rows)]
        self.chi2 = sum(w * r * r for w, r in zip(weights, residuals))
        self.dof = len(points) - 4
        if self.dof > 0 and self.chi2 > self.dof:  # runs scatter more than they should
            self.covariance = [[c * self.chi2 / self.dof for c in row] for row in self.covariance]

    def value(self, friction):
        """In the quasi-static limit."""
        return dot(self.coefficients, terms(friction, 0, 1))

    def slope(self, friction):
        x = math.log(friction + 0.05)
        return (self.coefficients[1] + 2 * self.coefficients[2] * x) / (friction + 0.05)

    def variance(self, friction):
        row = terms(friction, 0, 1)
        return dot(row, [dot(c, row) for c in self.covariance])


class Model:
    """Both observables in the quasi-static limit, of grains as stiff as the study's."""

    def __init__(self, runs, share):
        """share: the part of the correction to rigid grains that is due."""
        factor = share * RIGIDITY_FACTOR * 3
        shifts = [factor * run["solid_fraction"][0] * run["overlap"] for run in runs]
        self.shift = sum(shifts) / len(shifts)
        points = [
            [
                (run["friction"], run["inertial_number"], run[name][0] - shift, run[name][1])
                for run, shift in zip(runs, by)
            ]
            for name, by in zip(NAMES, ([0] * len(runs), shifts))
        ]
        self.best = [Polynomial(p, EXPONENT) for p in points]
        self.extremes = [[Polynomial(p, exponent) for exponent in EXTREME_EXPONENTS] for p in points]

    def values(self, friction):
        return [polynomial.value(friction) for polynomial in self.best]

    def shift_error(self):
        return self.shift * RIGIDITY_FACTOR_ERROR / RIGIDITY_FACTOR

    def covariance(self, friction):
        form = [(a.value(friction) - b.value(friction)) / 2 for a, b in self.extremes]
        stiffness = [0, self.shift_error()]
        runs = [polynomial.variance(friction) for polynomial in self.best]
        return [
            [a * b + c * d + (runs[i] if i == j else 0) for j, (b, d) in enumerate(zip(form, stiffness))]
            for i, (a, c) in enumerate(zip(form, stiffness))
        ]


def quadratic(vector, matrix):
    return dot(vector, [dot(row, vector) for row in matrix])


def scan(model, measured, weight, frictions):
    """The best friction, the ends of the interval of chi2 + 1 (None: not among the frictions), chi2."""
    chi2 = [quadratic([m - v for m, v in zip(measured, model.values(f))], weight) for f in frictions]
    at = min(range(len(chi2)), key=chi2.__getitem__)
    inside = [k for k, c in enumerate(chi2) if c < chi2[at] + 1]
    low = frictions[inside[0]] if inside[0] > 0 else None
    high = frictions[inside[-1]] if inside[-1] + 1 < len(frictions) else None
    return frictions[at], low, high, chi2[at]


def calibrate(model, measured, errors, frictions):
    """Friction, standard error and the part of simulation in it, chi2. Weights are those of the model at
    the friction of the pass before."""
    friction = frictions[len(frictions) // 2]
    for _ in range(4):
        simulation = model.covariance(friction)
        total = [list(row) for row in simulation]
        for i, error in enumerate(errors):
            total[i][i] += error**2
        friction, low, high, chi2 = scan(model, measured, inverse(total), frictions)
    if low is None or high is None:
        sys.exit(f"the interval of chi2 + 1 around {friction:.3f} does not lie within the frictions "
                 f"simulated, {frictions[0]} to {frictions[-1]}: add some")
    weighted = [dot(row, [p.slope(friction) for p in model.best]) for row in inverse(total)]
    share = quadratic(weighted, simulation) / quadratic(weighted, total)
    return friction, (high - low) / 2, (high - low) / 2 * math.sqrt(share), chi2


def reading_of(fit):
    """Stress ratio, solid fraction, their standard errors, stiffness number of the study."""
    prediction, = fit["predictions"]
    if prediction["inertial_number"] != 0 or prediction["liquid_content"] != 0:
        sys.exit("the reading is not a dry one in the quasi-static limit")
    stress, grains = prediction["normal_stress"], fit["grains"]
    shear, solid = (prediction["measured"][name] for name in ("shear_stress", "solid_fraction"))
    modulus = grains["youngs_modulus"] / (1 - grains["poisson_ratio"] ** 2)
    return (
        [shear["value"] / stress, solid["value"]],
        [shear["stderr"] / stress, solid["stderr"]],
        (modulus / stress) ** (2 / 3),
    )


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        measured, errors, studied = reading_of(json.load(file))
    runs = [read_run(path) for path in sys.argv[3:]]
    runs.sort(key=lambda run: (run["inertial_number"], run["friction"]))
    kinds = [len({run[name] for run in runs}) for name in ("friction", "inertial_number")]
    if kinds[0] < 3 or kinds[1] < 2:
        sys.exit("the polynomial takes three frictions and two inertial numbers")
    model = Model(runs, 1 - float(sys.argv[2]) / studied)
    lowest, highest = (pick(run["friction"] for run in runs) for pick in (min, max))
    frictions = [lowest + (highest - lowest) * k / SCAN for k in range(SCAN + 1)]
    friction, error, of_simulation, chi2 = calibrate(model, measured, errors, frictions)
    result = {
        "parameters": {
            "friction": {
                "value": friction,
                "stderr": error,
                "stderr_measurement": math.sqrt(error**2 - of_simulation**2),
                "stderr_simulation": of_simulation,
            }
        },
        "chi2": chi2,
        "converged": True,
        "stiffness_number": studied,
        "correction": [-model.shift, model.shift_error()],
        "polynomials": {
            name: {"coefficients": p.coefficients, "chi2": p.chi2, "dof": p.dof}
            for name, p in zip(NAMES, model.best)
        },
        "runs": runs,
    }
    json.dump(result, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
