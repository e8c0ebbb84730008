#!/usr/bin/env python3
"""Table of results.csv by each factor of the matrix, written to summary.csv.

The root mean square of error/(stated error) of friction and cohesion comes from laboratories without a
fault, as do the false findings per study; the share of faults named comes from the others.
"""
import csv
import math
import pathlib

HERE = pathlib.Path(__file__).parent
FACTORS = ["maker", "cell", "beads", "liquid", "protocol", "replicates", "rows", "noise", "fault"]


def numbers(rows, *names):
    kept = [r for r in rows if all(r[n] not in ("", None) for n in names)]
    return [[float(r[n]) for n in names] for r in kept]


def rms(values):
    return math.sqrt(sum(v * v for v in values) / len(values)) if values else math.nan


def ratio(rows, truth, found, stated):
    all_ = numbers(rows, truth, found, stated)
    if not all_:
        return "", 0
    return f"{rms([(f - t) / s for t, f, s in all_]):.2f}", len(all_)


def line(factor, value, rows):
    sound = [r for r in rows if r["fault"] == "none"]
    false = [v for v, in numbers(sound, "false_findings")]
    named = [v for v, in numbers(rows, "named")]
    told = [max(v) for v in numbers(rows, "named", "could_go_undetected")]
    friction, count = ratio(sound, "friction", "fitted", "stated")
    cohesion, wet = ratio(sound, "cohesion", "fitted_cohesion", "stated_cohesion")
    return {"factor": factor, "value": value, "laboratories": len(rows),
            "failed": sum(r["error"] != "" for r in rows), "sound": count,
            "friction_ratio": friction, "sound_wet": wet, "cohesion_ratio": cohesion,
            "false_findings_per_study": f"{sum(false) / len(false):.3f}" if false else "",
            "studies_with_false_findings": f"{sum(v > 0 for v in false) / len(false):.3f}" if false
            else "", "faulty": len(named),
            "named": f"{sum(named) / len(named):.2f}" if named else "",
            "named_or_undetectable": f"{sum(told) / len(told):.2f}" if told else ""}


def main():
    with (HERE / "results.csv").open() as file:
        rows = list(csv.DictReader(file))
    lines = [line("all", "", rows)]
    for factor in FACTORS:
        for value in sorted({r[factor] for r in rows}):
            lines.append(line(factor, value, [r for r in rows if r[factor] == value]))
    with (HERE / "summary.csv").open("w", newline="") as file:
        table = csv.DictWriter(file, lines[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(lines)
    for each in lines:
        print("  ".join(f"{v!s:>12}" for v in each.values()))


if __name__ == "__main__":
    main()
