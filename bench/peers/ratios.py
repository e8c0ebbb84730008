#!/usr/bin/env python3
"""Tables of speeds and ratios from the rows of compare_peers.sh. Usage: ratios.py SHEAR_RATE < ROWS

A row: round beads wetness code steps time_step wall_seconds cpu_seconds normal_stress shear_stress
solid_fraction. Pendular is what the others are compared with, round by round.
"""
import statistics
import sys
from dataclasses import dataclass

OURS = "pendular"
BUSY = 0.95
"""Share of a core below which wall times say more of the machine than of the code."""


@dataclass
class Row:
    round: int
    beads: int
    wetness: str
    code: str
    steps: int
    time_step: float
    wall: float
    cpu: float
    normal: float
    shear: float
    solid: float

    def __post_init__(self):
        for name, kind in self.__annotations__.items():
            setattr(self, name, kind(getattr(self, name)))

    @property
    def speed(self):
        """Bead-steps per second of wall time."""
        return self.beads * self.steps / self.wall

    @property
    def cpu_speed(self):
        """Bead-steps per second of processor time."""
        return self.beads * self.steps / self.cpu

    def wall_per_strain(self, rate):
        return self.wall / (self.steps * self.time_step * rate)


def spread(values, form):
    """'min / median / max'"""
    return " / ".join(
        format(v, form) for v in (min(values), statistics.median(values), max(values))
    )


def mean_sd(values, form):
    """Mean and standard error of the rounds."""
    mean = format(statistics.fmean(values), form)
    if len(values) < 2:
        return mean
    return f"{mean} +- {format(statistics.stdev(values) / len(values)**0.5, form)}"


def table(heads, lines):
    widths = [max(map(len, column)) for column in zip(heads, *lines)]
    for line in [heads, *lines]:
        print("  " + "  ".join(cell.ljust(w) for cell, w in zip(line, widths)).rstrip())


def print_case(rows, rate):
    """Everything about one sample size, dry or wet."""
    codes = list(dict.fromkeys(row.code for row in rows))
    of = {code: [row for row in rows if row.code == code] for code in codes}
    table(
        ["", "million bead-steps/s", "s per unit strain", "core share", "time step",
         "stress ratio", "solid fraction", "normal stress"],
        [
            [
                code,
                spread([row.speed / 1e6 for row in of[code]], ".3g"),
                spread([row.wall_per_strain(rate) for row in of[code]], ".3g"),
                format(statistics.fmean(row.cpu / row.wall for row in of[code]), ".2f"),
                format(statistics.fmean(row.time_step for row in of[code]), ".4f"),
                mean_sd([row.shear / row.normal for row in of[code]], ".3f"),
                mean_sd([row.solid for row in of[code]], ".4f"),
                mean_sd([row.normal for row in of[code]], ".3f"),
            ]
            for code in codes
        ],
    )
    ours = {row.round: row for row in of[OURS]}
    pairs = {code: [(ours[row.round], row) for row in of[code]] for code in codes if code != OURS}
    print("\n  Pendular is faster by, in each round:")
    table(
        ["", "bead-steps/s", "time per unit strain", "bead-steps per second of processor time"],
        [
            [
                code,
                spread([a.speed / b.speed for a, b in both], ".2f"),
                spread([b.wall_per_strain(rate) / a.wall_per_strain(rate) for a, b in both], ".2f"),
                spread([a.cpu_speed / b.cpu_speed for a, b in both], ".2f"),
            ]
            for code, both in pairs.items()
        ],
    )


def main():
    rate = float(sys.argv[1])
    rows = [Row(*line.split()) for line in sys.stdin]
    print(f"\nmin / median / max over {max(row.round for row in rows)} rounds; "
          "means of the flow with standard errors from rounds")
    for beads, wetness in dict.fromkeys((row.beads, row.wetness) for row in rows):
        print(f"\n{beads} beads, {wetness}")
        print_case([r for r in rows if (r.beads, r.wetness) == (beads, wetness)], rate)
    if min(row.cpu / row.wall for row in rows) < BUSY:
        print("\nTHE MACHINE WAS BUSY: a code had less than 95 % of a core. Trust the ratios of "
              "processor time,\nnot those of wall time, or measure again.")
    print("\nAll measurements:")
    print(",".join(Row.__annotations__))
    for row in rows:
        print(",".join(format(getattr(row, name), ".6g") if kind is float else str(getattr(row, name))
                       for name, kind in Row.__annotations__.items()))


if __name__ == "__main__":
    main()
