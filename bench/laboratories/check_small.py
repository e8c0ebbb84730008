#!/usr/bin/env python3
"""Six laboratories of instrument.py, as a test (ctest laboratories.small): seconds, from states.csv.

Three sound ones: the friction lies within 4 stated errors of the truth (in 1 of 5000 sets of three by
chance), the root mean square of the three in stated errors is below 2.5 (1 in 1000), and at most one has
a finding of the diagnosis. Three with a fault: it is named, or among the rivals, in each. Files have
three layouts that the program's own virtual laboratory does not write.
"""
import math
import pathlib
import sys
import tempfile

import matrix

SOUND = [{"cell": "21-45", "beads": "polystyrene", "protocol": "speed", "noise": "white"},
         {"cell": "30-60", "beads": "glass", "protocol": "number", "noise": "correlated"},
         {"cell": "14-30", "beads": "polystyrene", "protocol": "ramp", "noise": "white"}]
FAULTY = ["torque-offset", "height-offset", "force-gain"]


def main():
    program = pathlib.Path(sys.argv[1])
    results = []
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)
        for number, (spec, fault) in enumerate([(s, "none") for s in SOUND] +
                                               list(zip(SOUND, FAULTY))):
            whole = {"lab": 2 * number, "maker": "python", "liquid": "none", "replicates": 3,
                     "rows": 100, "fault": fault, **spec}
            lab = scratch / f"lab_{number}"
            matrix.make_python(whole, lab)
            results.append((whole, matrix.score(program, scratch, whole, lab, None)))
    for spec, result in results:
        print(spec["fault"], spec["cell"], {k: result[k] for k in ("ratio", "verdict", "effects",
                                                                   "rivals", "findings")})
    ratios = [r["ratio"] for s, r in results if s["fault"] == "none"]
    wrong = []
    if max(map(abs, ratios)) > 4 or math.sqrt(sum(r * r for r in ratios) / 3) > 2.5:
        wrong.append(f"frictions are off by {ratios} stated errors")
    if sum(r["false_findings"] > 0 for s, r in results if s["fault"] == "none") > 1:
        wrong.append("false findings in sound laboratories")
    wrong += [f"{s['fault']} is neither named nor a rival" for s, r in results
              if s["fault"] != "none" and not r["named"]]
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
