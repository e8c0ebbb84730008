#!/usr/bin/env python3
"""Spoils four studies of known friction in 300 ways, and reports which wrong frictions `calibrate` believes.

Each spoiled copy is calibrated from the atlas, without new simulations; a third of the copies also with
`[instrument] class`. What becomes of a copy:

  refused   exit code 2
  doubted   exit code 3, `believable` false, or a note on the cause that the unspoiled study does not have
  harmless  the friction is within 3 of its errors of the truth
  named     off by more, but one of the three largest causes in the error budget, or what acts alike, is the cause
  covered   off by more, no cause is named, but within 3 of the errors that the first line states, the systematic one included
  wrong     off by more than all of this, believed, and nothing names the cause
  failed    any other exit code, or no answer in time

Honest copies, with other noise, are calibrated too: how many of them are doubted?
Finished copies stay in the work folder, so that the same command goes on where it was stopped; another
program or other spoilings begin anew.

examples:
  spoilings.py build/release/pendular                                  all; the table goes to bench/results
  spoilings.py build/release/pendular --only copies,saturation --table /tmp/some.csv
  spoilings.py build/release/pendular --few                            about 25 of them, in a minute (ctest)
  spoilings.py build/release/pendular --proof --seed 21 --table /tmp/proof.csv   other frictions, cells and noise
  spoilings.py --program build/release/pendular --list                 names of all spoilings
"""
import argparse
import concurrent.futures
import csv
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE / "spoiling"))
import kinds  # noqa: E402
import studies  # noqa: E402

RESULTS = ROOT / "bench/results/spoilings.csv"
ATLAS = ROOT / "sim/atlas/atlas.csv"
SOURCES = [ATLAS, ATLAS.with_name("emulator.csv"), ROOT / "bench/foreign_worlds/states.csv",
           ROOT / "bench/laboratories/states.csv", ROOT / "bench/laboratories/instrument.py", ROOT / "examples/wet/truth.json"]
FATES = ["refused", "doubted", "harmless", "named", "covered", "wrong", "failed"]
FIELDS = ["study", "kind", "size", "instrument", "fate", "friction", "error", "truth", "off_in_errors",
          "off_with_typical", "chi2_per_dof", "p", "largest", "told_by", "printed", "first_line"]
SECONDS = 120  # that a calibration may take
FEW = 25
SEED = 10  # of the noise of the studies that are spoiled: their unspoiled fits have p between 0.6 and 0.9


@dataclass
class Case:
    study: str
    instrument: bool
    spoiling: kinds.Spoiling = None  # none: an honest copy
    seed: int = SEED
    fit_to: str = "dry"

    @property
    def kind(self):
        return self.spoiling.kind if self.spoiling else "honest"

    @property
    def size(self):
        return self.spoiling.size if self.spoiling else f"noise {self.seed}, fit to {self.fit_to}"

    @property
    def key(self):
        seed = f", noise {self.seed}" if self.spoiling and self.seed != SEED else ""
        return f"{self.study}, {self.kind} {self.size}{', class' if self.instrument else ''}{seed}"

    def make(self, folder):
        study = studies.honest(self.study, self.seed)
        study.fit_to = "all" if self.spoiling and self.spoiling.wet else self.fit_to
        if self.spoiling:
            self.spoiling.change(study)
        if self.instrument:
            study.more += f'\n[instrument]\nclass = "{"table" if study.table else "rheometer"}"\n'
        study.write(folder)


def all_cases(honest_copies, proof=False, seed=SEED):
    cases = []
    for spoiling in kinds.proof() if proof else kinds.spoilings():
        for study in spoiling.studies:
            cases.append(Case(study, False, spoiling, seed))
            if len(cases) % 4 == 0:  # of each three without it
                cases.append(Case(study, True, spoiling, seed))
    for study in (studies.PROOF | studies.PROOF_TABLES if proof else studies.TRUTHS):
        for seed in range(1, honest_copies + 1):
            fit_to = "all" if seed % 2 == 0 else "dry"
            cases.append(Case(study, seed % 3 == 0, seed=seed, fit_to=fit_to))
    return cases


def few(cases):
    """Every n-th spoiled copy."""
    spoiled = [case for case in cases if case.spoiling]
    return [spoiled[k * len(spoiled) // FEW] for k in range(FEW)]


class Laboratory:
    """Calibrates copies with one program, and keeps what it has found in a work folder."""

    def __init__(self, program, work):
        self.program, self.work = program.resolve(), work
        work.mkdir(parents=True, exist_ok=True)
        digest = hashlib.sha256(self.program.read_bytes())
        for source in [*sorted((HERE / "spoiling").glob("*.py")), *SOURCES]:
            digest.update(source.read_bytes())
        self.kept = work / f"answers-{digest.hexdigest()[:12]}.jsonl"
        self.answers = {}
        if self.kept.exists():
            text = self.kept.read_text()
            whole = text[:text.rfind("\n") + 1]  # an interrupted run leaves a part of a line
            if whole != text:
                self.kept.write_text(whole)
            self.answers = {answer["key"]: answer for answer in map(json.loads, whole.splitlines())}

    def answer(self, case):
        """Exit code, what was printed first, and the fit."""
        if case.key in self.answers:
            return self.answers[case.key]
        folder = self.work / hashlib.sha256(case.key.encode()).hexdigest()[:16]
        shutil.rmtree(folder, ignore_errors=True)
        case.make(folder / "study")
        words = [self.program, "calibrate", "study", "--no-confirm", "--quiet", "--all", "--threads", "1", "--store",
                 "store.sqlite", "--json", "fit.json"]
        environment = {**os.environ, "PENDULAR_ATLAS": str(ATLAS), "OPENBLAS_NUM_THREADS": "1"}
        try:
            done = subprocess.run([str(w) for w in words], cwd=folder, env=environment, timeout=SECONDS,
                                  capture_output=True, text=True, errors="replace")
            code, said = done.returncode, (done.stderr if done.returncode not in (0, 3) else done.stdout).strip()
        except subprocess.TimeoutExpired:
            code, said = -1, f"no answer in {SECONDS} s"
        answer = {"key": case.key, "code": code, "said": said[:8000], "fit": None}
        if code in (0, 3) and (folder / "fit.json").exists():
            fit = json.loads((folder / "fit.json").read_text())
            answer["fit"] = {name: fit.get(name) for name in ("parameters", "instrument", "chi2", "dof", "notes",
                                                              "believable", "reasons")}
        shutil.rmtree(folder)
        self.answers[case.key] = answer
        with self.kept.open("a") as file:
            file.write(json.dumps(answer) + "\n")
        return answer


def without_numbers(note):
    return re.sub(r"[-+]?[\d.]+(e[-+]?\d+)?", "#", note)


def remarks(said):
    """Notes and warnings that were printed."""
    return [line for line in said.split("\n") if line.startswith(("Note: ", "Warning: "))]


def told_by(case, answer, usual):
    """What raises doubt in the JSON: exit code, reason or note; empty where nothing does."""
    fit = answer["fit"]
    if answer["code"] == 3:
        return "exit code 3"
    if not fit["believable"]:
        return "not believable: " + (fit["reasons"] or [""])[0]
    if not case.spoiling:
        return ""
    for note in fit["notes"]:
        if without_numbers(note) not in usual and re.search(case.spoiling.words, note, re.I):
            return "note: " + note
    return ""


def printed(case, answer, usual):
    """What is printed on the cause, or of any misfit, although the result is believed."""
    for line in remarks(answer["said"]):
        on_cause = case.spoiling and re.search(case.spoiling.words, line, re.I)
        if without_numbers(line) not in usual and (on_cause or line.startswith("Warning")):
            return line
    hint = "more than the errors explain"
    return hint if hint in answer["said"] else ""


def budget_of(fit):
    """The three largest causes, as they are printed: of errors that act alike, the largest with the names of the others."""
    def size(error):
        return abs(error["shift"].get("friction") or 0)

    causes = []
    for error in sorted(fit["instrument"], key=size, reverse=True):
        if size(error) > 0 and not any(error["name"] in larger["alike"] for larger in causes):
            causes.append(error)
    return [(error["name"], *error["alike"]) for error in causes[:3]]


def judged(case, answer, usual):
    """A row of the table."""
    row = {"study": case.study, "kind": case.kind, "size": case.size, "instrument": int(case.instrument),
           "truth": (studies.TRUTHS | studies.PROOF | studies.PROOF_TABLES)[case.study], "first_line": answer["said"].split("\n")[0][:200]}
    fit = answer["fit"]
    if fit is None:
        row["fate"] = "refused" if answer["code"] == 2 else "failed"
        return row
    friction = fit["parameters"]["friction"]
    value, error = friction["value"], friction["stderr"]
    budget = budget_of(fit)
    row.update({"friction": value, "error": error, "largest": " ".join("=".join(cause) for cause in budget), "told_by": told_by(case, answer, usual)[:160],
                "printed": printed(case, answer, usual)[:160]})
    off = (value - row["truth"]) / error if error else math.inf
    row["off_in_errors"] = off
    if error:
        systematic = friction["stderr_typical_instrument"]
        row["off_with_typical"] = (value - row["truth"]) / math.hypot(error, systematic)
    if fit["dof"]:
        row["chi2_per_dof"] = fit["chi2"] / fit["dof"]
    # The program's p value allows for errors that few replicates determine; the JSON lacks it.
    p = re.search(r"degrees? of freedom \(p ([=<]) ([\d.e-]+)", answer["said"])
    row["p"] = f"{'<' if p[1] == '<' else ''}{p[2]}" if p else ""
    named = case.spoiling and case.spoiling.causes & {name for cause in budget for name in cause}
    if row["told_by"]:
        row["fate"] = "doubted"
    elif abs(off) <= 3:
        row["fate"] = "harmless"
    elif named:
        row["fate"] = "named"
    else:
        row["fate"] = "covered" if abs(row.get("off_with_typical", math.inf)) <= 3 else "wrong"
    return row


UNNAMED = ("covered", "wrong", "failed")  # fates that --check accepts only where the table of results has them


def known_wrong(path):
    """Copies that the table says are believed and off, without the cause."""
    if not path.exists():
        return set()
    with path.open() as file:
        return {key_of(row) for row in csv.DictReader(file) if row["fate"] in UNNAMED}


def key_of(row):
    return row["study"], row["kind"], row["size"], str(row["instrument"])


def write_table(path, rows):
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, FIELDS, lineterminator="\n", restval="")
        table.writeheader()
        for row in rows:
            table.writerow({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()})


def summary(rows):
    spoiled = [row for row in rows if row["kind"] != "honest"]
    counts = {}
    for row in spoiled:
        kind = "pair" if row["kind"].startswith("pair") else row["kind"]
        counts.setdefault(kind, Counter())[row["fate"]] += 1
    lines = ["| kind | copies | " + " | ".join(FATES) + " |", "|---" * (2 + len(FATES)) + "|"]
    for kind, count in [*sorted(counts.items()), ("all", Counter(row["fate"] for row in spoiled))]:
        cells = [str(count[fate] or "") for fate in FATES]
        lines.append(f"| {kind} | {sum(count.values())} | " + " | ".join(cells) + " |")
    honest = [row for row in rows if row["kind"] == "honest"]
    if honest:
        fates = Counter(row["fate"] for row in honest)
        lines.append("")
        off = sum(abs(row["off_in_errors"]) > 3 for row in honest)
        lines.append(f"Of {len(honest)} honest copies, {fates['doubted']} are doubted, {off} off by more than 3 errors.")
    believed = [row for row in spoiled if row["fate"] in ("named", "covered", "wrong")]
    beyond = sum(abs(row.get("off_with_typical", math.inf)) > 3 for row in believed)
    silent = sum(not row["printed"] for row in believed)
    lines.append(f"Of the {len(believed)} that are named, covered or wrong, {beyond} are off by more than 3 errors with the systematic "
                 f"one of the first line too, and {silent} come without a printed warning or a hint at a misfit.")
    return "\n".join(lines)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\nexamples")[0], epilog=__doc__[__doc__.index("examples:"):],
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, nargs="?", help="the program pendular")
    parser.add_argument("--program", dest="program_option", type=pathlib.Path, help="the same")
    parser.add_argument("--only", help="words, separated by commas: copies with one of them in study, kind or size")
    parser.add_argument("--few", action="store_true", help=f"{FEW} spoiled copies of all, no honest ones")
    parser.add_argument("--proof", action="store_true", help="spoil three studies of other frictions, on which nothing in the program was chosen")
    parser.add_argument("--seed", type=int, default=SEED, help=f"seed of the noise of the spoiled studies (default: {SEED})")
    parser.add_argument("--honest", type=int, default=30, help="honest copies of each study (default: 30)")
    parser.add_argument("--jobs", type=int, default=1, help="copies at a time (default: 1)")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/spoilings", help="folder of finished copies")
    parser.add_argument("--table", type=pathlib.Path, help="file for the table, with the summary beside it as .md (default of a complete run: bench/results/spoilings.csv)")
    parser.add_argument("--check", action="store_true", help="write no table; exit code 1 if a copy is covered, wrong or failed that bench/results/spoilings.csv does not list so")
    parser.add_argument("--list", action="store_true", help="print the copies, calibrate none")
    given = parser.parse_args()
    given.program = given.program or given.program_option
    if not given.program and not given.list:
        parser.error("which program? spoilings.py build/release/pendular")
    return given


def chosen_cases(given):
    cases = all_cases(given.honest, given.proof, given.seed)
    if given.few:
        cases = few(cases)
    if given.only:
        words = given.only.split(",")
        cases = [case for case in cases if any(word in case.key for word in words)]
    return cases


def usual_notes(laboratory, proof):
    """Notes on the unspoiled studies, by study, without their numbers."""
    usual = {}
    for study in (studies.PROOF | studies.PROOF_TABLES if proof else studies.TRUTHS):
        for instrument in (False, True):
            for fit_to in ("dry", "all"):
                answer = laboratory.answer(Case(study, instrument, fit_to=fit_to))
                if answer["fit"] is None:
                    raise SystemExit(f"{study}, unspoiled, is refused: {answer['said']}")
                notes = answer["fit"]["notes"] + remarks(answer["said"])
                usual.setdefault(study, set()).update(map(without_numbers, notes))
    return usual


def main():
    given = arguments()
    cases = chosen_cases(given)
    if given.list:
        print("\n".join(case.key for case in cases))
        return 0
    laboratory = Laboratory(given.program, given.work)
    usual = usual_notes(laboratory, given.proof)
    rows = []
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for case, answer in zip(cases, pool.map(laboratory.answer, cases)):
            rows.append(judged(case, answer, usual[case.study]))
            if rows[-1]["fate"] in ("wrong", "failed"):
                print(f"{rows[-1]['fate']}: {case.key}: {rows[-1]['first_line'][:160]}", flush=True)
    print(summary(rows))
    whole = not (given.few or given.only or given.check or given.proof or given.seed != SEED)
    if given.table or whole:
        path = given.table or RESULTS
        write_table(path, rows)
        path.with_suffix(".md").write_text(summary(rows) + "\n", encoding="utf-8")
    if given.check:
        known = known_wrong(RESULTS)
        new = [row for row in rows if row["kind"] != "honest" and row["fate"] in UNNAMED and key_of(row) not in known]
        for row in new:
            print(f"Not listed as {row['fate']}: {', '.join(key_of(row))}")
        return 1 if new else 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
