#!/usr/bin/env python3
"""Compares two folders that same_answers.sh kept: names every answer that differs.

Simulations have to agree bit for bit. Other numbers may differ by 1e-9 of their size, where a sum
was taken in another order; words, tables and exit codes may not.
"""
import json
import math
import re
import sys
from pathlib import Path

TOLERANCE = 1e-9
# What differs between two runs of the same program: the time they took and where they ran.
PASSING = {
    "seconds", "wall_seconds", "grain_steps_per_second", "particle_steps_per_second", "version",
    "created", "host",
}  # fmt: skip
# Names of format 1 with those of format 2. Former names that format 2 still writes are left out.
RENAMED = {
    "noncentrality_that_matters": "noncentrality_of_interest", "line": "sentence",
    "suspects": "suspect_measurements", "suspect_tests": "suspect_measurement_tests",
    "suspect": "suspect_measurement", "offending": "deviating_groups", "normalised": "misfit",
    "rungs": "ladder_steps", "matters": "smallest_of_interest", "changes": "acts_on",
    "touches": "readings", "scales": "hyperparameters", "by": "derivatives",
    "predicted_drop": "predicted_reduction", "refit_drop": "refitted_reduction",
    "absorbed": "share_imitated",
}  # fmt: skip
PASSING_TEXT = re.compile(r"\bin \d+(\.\d+)? (s|min)\b|bead-steps/s|computing time")
RUN_NAMES = re.compile(r"[0-9a-f]{16}( [0-9a-f]{16})*")  # hashes of runs and the times they took


def in_format_2(value):
    """Returns a document of format 1 with the keys of format 2, and former names beside them."""
    if isinstance(value, list):
        return [in_format_2(each) for each in value]
    if not isinstance(value, dict):
        return value
    kept = ("predicted_drop", "refit_drop", "absorbed")
    return {
        name: in_format_2(each)
        for key, each in value.items()
        for name in ([key] if key in kept else []) + [RENAMED.get(key, key)]
    }


def differences(before, after, exact, fresh, path=""):
    """Yields a line for each place at which two JSON values differ."""
    if isinstance(before, dict) and isinstance(after, dict):
        if before.get("format") == 1 and after.get("format") == 2:
            before = {**in_format_2(before), "format": 2}
        for key in sorted(before.keys() | after.keys()):
            if key in PASSING:
                continue
            if key not in before or key not in after:
                yield f"{path}/{key}: only {'before' if key in before else 'after'}"
            else:
                yield from differences(before[key], after[key], exact, fresh, f"{path}/{key}")
    elif isinstance(before, list) and isinstance(after, list):
        if len(before) != len(after):
            yield f"{path}: {len(before)} entries, then {len(after)}"
        for place, (one, other) in enumerate(zip(before, after)):
            yield from differences(one, other, exact, fresh, f"{path}/{place}")
    elif isinstance(before, float) and isinstance(after, float) and not exact:
        if not math.isclose(before, after, rel_tol=TOLERANCE, abs_tol=1e-300):
            yield f"{path}: {before!r}, then {after!r}"
    elif before != after and not (fresh and both_name_runs(before, after)):
        yield f"{path}: {before!r}, then {after!r}"


def both_name_runs(*values):
    """Whether both values are names of as many runs."""
    named = all(isinstance(value, str) and RUN_NAMES.fullmatch(value) for value in values)
    return named and len({len(value) for value in values}) == 1


def of_text(before, after):
    """Yields the first line in which two texts differ."""
    for number, (one, other) in enumerate(
        zip(before.splitlines() + [""], after.splitlines() + [""]), start=1
    ):
        if one != other and not PASSING_TEXT.search(one):
            yield f"line {number}: {one!r}, then {other!r}"
            return
    if len(before.splitlines()) != len(after.splitlines()):
        yield "one text is longer"


def of_file(before, after):
    if not after.exists() or not before.exists():
        return ["is in one folder alone"]
    if before.suffix == ".json":
        exact = before.name.startswith("simulate_")
        fresh = before.stem.endswith(("_confirmed", "_cold"))
        one, other = (json.loads(file.read_text()) for file in (before, after))
        return list(differences(one, other, exact, fresh))
    return list(of_text(before.read_text(), after.read_text()))


def main():
    before, after = map(Path, sys.argv[1:])
    names = sorted(
        before / p.name
        for p in {p.name: p for d in (before, after) for p in d.iterdir()}.values()
        if p.suffix in (".json", ".txt", ".code")
    )
    if not names:
        sys.exit(f"{before}: no answers; make them with same_answers.sh keep")
    different = 0
    for file in names:
        found = of_file(file, after / file.name)
        different += bool(found)
        for line in found[:5]:
            print(f"{file.name} {line}")
        if len(found) > 5:
            print(f"{file.name}: {len(found) - 5} further differences")
    print(f"{len(names)} answers, {different} differ")
    sys.exit(1 if different else 0)


if __name__ == "__main__":
    main()
