"""The looks of Pendular's figures (reports/figure_style.cpp), for matplotlib.

Measured values are symbols with bars of one standard error, predicted values lines with a band of
one standard error; the liquid content chooses colour and symbol.
"""

from typing import Any, List, Optional, Sequence

import numpy as np

from pendular._tables import Array

STRESS_RATIO = r"stress ratio $\mu^* = |\sigma_{12}|/\sigma_{22}$"
SOLID_FRACTION = r"solid fraction $\Phi_S$"
NORMAL_STRESS = r"normal stress $\sigma_{22}$ [Pa]"
MODEL = "#0b62a4"
CALIBRATED = "#c0392b"
REFERENCE = "#888888"
#: Colour and symbol of each series; the first four as in the figures of the command line.
LOOKS = [
    ("#0b62a4", "o"),
    ("#c0392b", "s"),
    ("#1e8449", "^"),
    ("#6c3483", "v"),
    ("#b9770e", "D"),
    ("#0f8b8d", "*"),
    ("#111111", "o"),
    ("#808080", "s"),
]


def axes_of(axes: Optional[Sequence[Any]], count: int, title: str = "") -> List[Any]:
    """Returns `axes`, or those of a new figure with `count` panels side by side."""
    if axes is not None:
        return list(np.atleast_1d(np.asarray(axes, dtype=object)))
    import matplotlib.pyplot as plt

    figure, made = plt.subplots(1, count, figsize=(4.2 * count, 3.4), layout="constrained")
    if title:
        figure.suptitle(title)
    result = list(np.atleast_1d(made))
    for each in result:
        each.grid(color="#e4e4e4")
        each.set_axisbelow(True)
    return result


def measured_and_predicted(ax: Any, table: Any, label: str, column: str, scale: Any = 1) -> None:
    """Draws the measured symbols and predicted points of a table of readings over the normal
    stress, a series for each liquid content."""
    for k, (content, part) in enumerate(table.groupby("liquid_content", sort=True)):
        colour, marker = LOOKS[k % len(LOOKS)]
        part = part.sort_values("normal_stress")
        x = part["normal_stress"].to_numpy()
        unit = part[scale].to_numpy() if isinstance(scale, str) else scale
        name = "dry" if content == 0 else rf"$\Phi_L/\Phi_S$ = {content:.3g}"
        ax.errorbar(
            x,
            part[column] / unit,
            part[column + "_stderr"] / unit,
            fmt=marker,
            color=colour,
            mfc="white",
            capsize=2,
            label=name,
        )
        if "predicted_" + column in part:
            _predicted(ax, part, column, unit, colour)
    ax.set_xscale("log")
    ax.set_xlabel(NORMAL_STRESS)
    ax.set_ylabel(label)


def _predicted(ax: Any, part: Any, column: str, unit: Any, colour: str) -> None:
    """Draws the predicted values of a series: a line with its band for each inertial number, whose
    readings agree in it within 20 %."""
    value, error = part["predicted_" + column] / unit, part["predicted_" + column + "_stderr"] / unit
    for group in alike(part["inertial_number"].to_numpy(), 1.2):
        stress = part["normal_stress"].to_numpy()[group]
        # Replicates, within 2 % of each other, have one prediction.
        points = [
            (stress[at].mean(), value.to_numpy()[group][at].mean(), error.to_numpy()[group][at].mean())
            for at in alike(stress, 1.02)
        ]
        x, y, e = np.array(points).T
        ax.plot(x, y, "-" if len(x) > 1 else "_", color=colour, lw=1.2)
        ax.fill_between(x, y - e, y + e, color=colour, alpha=0.2, lw=0)


def alike(values: Array, factor: float) -> List[Array]:
    """Groups the indices of values, in rising order, of which each is at most `factor` times the
    first of its group."""
    groups: List[List[int]] = []
    for k in np.argsort(values, kind="stable"):
        if groups and values[k] <= factor * values[groups[-1][0]]:
            groups[-1].append(int(k))
        else:
            groups.append([int(k)])
    return [np.array(group) for group in groups]


def bars_across(ax: Any, names: Sequence[str], values: Sequence[float], label: str) -> None:
    """Draws horizontal bars, the first on top."""
    ax.barh(range(len(names)), values, color=MODEL, alpha=0.55, edgecolor=MODEL, height=0.62)
    ax.set_yticks(range(len(names)), names)
    ax.invert_yaxis()
    ax.set_xlabel(label)


