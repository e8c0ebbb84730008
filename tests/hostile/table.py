#!/usr/bin/env python3
"""Writes docs/hostile-input.md from the tables that attacks.sh --table writes.

    tests/hostile/table.py BEFORE.tsv AFTER.tsv >docs/hostile-input.md

BEFORE is the table of an earlier program, AFTER that of the present one.
"""
import csv
import re
import sys


def rows(name):
    with open(name, encoding="utf-8", errors="replace") as file:
        return {row[0]: row[1:] for row in csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE)}


def answer(row):
    """Exit code, time where it is long, and what was wrong or the first words of the answer."""
    code, seconds, verdict, text = (row + [""] * 4)[:4]
    end = "killed: no end, or no memory" if code == "137" else "crashed" if code in ("134", "139") else f"exit {code}"
    slow = f", {float(seconds):.0f} s" if code != "137" and float(seconds) >= 15 else ""
    if code == "0" and verdict == "ok":
        return "exit 0, as it should be"
    text = re.sub(r"/tmp/\S*/box/", "", text.removeprefix("error: "))
    text = re.sub(r"(.)\1{9,}", r"\1...", text)
    words = text[:90].rsplit(" ", 1)[0] + " ..." if len(text) > 90 else text
    if verdict not in ("ok", "") and not verdict.startswith(("exit code", "'")):
        words = verdict
    words = re.sub(r"([|`*_<>\\\[\]])", r"\\\1", words)
    return f"{end}{slow}" + (f": {words}" if words else "")


def main():
    before, after = rows(sys.argv[1]), rows(sys.argv[2])
    print(open(__file__.replace("table.py", "table.md"), encoding="utf-8").read())
    kind = ""
    for number, (name, row) in enumerate(after.items(), 1):
        now, what = name.split(": ", 1)
        if now != kind:
            kind = now
            print(f"\n### {kind.capitalize() if kind.islower() else kind}\n")
            print("| no. | attack | before | now |\n|---|---|---|---|")
        print(f"| {number} | {what} | {answer(before[name]) if name in before else ''} | {answer(row)} |")


main()
