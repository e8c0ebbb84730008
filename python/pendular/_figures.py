"""The grammar of Pendular's figures (docs/how-to/figures.md, reports/figure_style.cpp), for matplotlib.

Measured values are filled symbols with bars of one standard error; the model is a line with a band
of one standard error, or hollow symbols where no line passes the readings; colour, symbol and dash
say which series both belong to.
"""

from typing import Any, List, Optional, Sequence, Tuple

import numpy as np

from pendular._tables import Array

STRESS_RATIO = r"stress ratio $\mu^* = |\sigma_{12}|/\sigma_{22}$"
SOLID_FRACTION = r"solid fraction $\Phi_S$"
NORMAL_STRESS = r"normal stress $\sigma_{22}$ [Pa]"
MODEL = "#0b62a4"
#: Of entries of a key that all series share.
EXPLAINING = "#606060"
MEASURED_TEXT, MODEL_TEXT = "measured, ± 1 standard error", "model, ± 1 standard error"
Look = Tuple[str, str, Any]
#: Colour, symbol and dash of series that a key names one by one.
LOOKS: List[Look] = [
    ("#0b62a4", "o", "-"),
    ("#c0392b", "s", (0, (8, 3))),
    ("#1e8449", "^", (0, (8, 3, 2, 3))),
    ("#6c3483", "v", (0, (3, 3))),
]
#: Of dry readings beside wet ones.
DRY_LOOK: Look = ("#7a7a7a", "D", (0, (2, 3)))


def looks_of(contents: Sequence[float]) -> List[Look]:
    """Looks of series of these liquid contents, in rising order: more than four wet ones share a
    scale of colours from dark to light."""
    wet = [content for content in contents if content != 0]
    if not wet:
        return LOOKS[:1]
    looks = LOOKS[: len(wet)]
    if len(wet) > len(LOOKS):
        import matplotlib

        scale = matplotlib.colormaps["viridis"]
        # Without its lightest fifth, which white paper hides.
        looks = [(matplotlib.colors.to_hex(scale(0.8 * k / (len(wet) - 1))), "o", "-")
                 for k in range(len(wet))]
    return ([DRY_LOOK] if len(wet) < len(contents) else []) + looks


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
    """Draws the measured and predicted values of a table of readings over the normal stress, a
    series for each liquid content."""
    parts = list(table.groupby("liquid_content", sort=True))
    for (_, part), look in zip(parts, looks_of([content for content, _ in parts])):
        part = part.sort_values("normal_stress")
        unit = part[scale].to_numpy() if isinstance(scale, str) else scale
        ax.errorbar(
            part["normal_stress"].to_numpy(),
            part[column] / unit,
            part[column + "_stderr"] / unit,
            fmt=look[1],
            color=look[0],
            capsize=2,
        )
        if "predicted_" + column in part:
            _predicted(ax, part, column, unit, look)
    ax.set_xscale("log")
    ax.set_xlabel(NORMAL_STRESS)
    ax.set_ylabel(label)


def predicted(ax: Any, table: Any, label: str, column: str) -> None:
    """Draws the predicted values of a table over the normal stress, a series for each liquid
    content."""
    parts = list(table.groupby("liquid_content", sort=True))
    for (_, part), look in zip(parts, looks_of([content for content, _ in parts])):
        _predicted(ax, part.sort_values("normal_stress"), column, 1, look)
    ax.set_xscale("log")
    ax.set_xlabel(NORMAL_STRESS)
    ax.set_ylabel(label)


def _predicted(ax: Any, part: Any, column: str, unit: Any, look: Look) -> None:
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
        if len(x) == 1:
            ax.plot(x, y, look[1], color=look[0], mfc="none", ms=9)
            continue
        ax.plot(x, y, color=look[0], linestyle=look[2], lw=1.2)
        ax.fill_between(x, y - e, y + e, color=look[0], alpha=0.2, lw=0)


def add_key(panels: Sequence[Any], table: Any, measured: bool = True) -> None:
    """Puts the key above the two panels: the series, of more than four wet ones the first and the
    last, and what symbols and lines are."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    contents = sorted(table["liquid_content"].unique())
    series = list(zip(contents, looks_of(contents)))
    if len(series) > len(LOOKS) + 1:
        series = series[:2] + series[-1:] if contents[0] == 0 else [series[0], series[-1]]
    names: List[Any] = [
        Line2D([], [], color=colour, marker=marker, linestyle=dash,
               label="dry" if content == 0 else rf"$\Phi_L/\Phi_S$ = {content:.3g}")
        for content, (colour, marker, dash) in series
    ]
    kinds: List[Any] = [Line2D([], [], color=EXPLAINING, marker="o", linestyle="",
                               label=MEASURED_TEXT)]
    if not measured:
        kinds.clear()
    if not measured or "predicted_shear_stress" in table:
        kinds.append(Patch(color=EXPLAINING, alpha=0.4, label=MODEL_TEXT))
    for panel, entries in zip((panels[0], panels[-1]), (names, kinds)):
        panel.legend(handles=entries, frameon=False, fontsize="small", loc="lower left",
                     bbox_to_anchor=(0, 1), borderaxespad=0.2, ncols=2 if entries is names else 1)


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
