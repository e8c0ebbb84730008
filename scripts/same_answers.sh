#!/usr/bin/env bash
# Keeps what a program answers, so that a change of its structure can be shown to change no answer.
#
#   scripts/same_answers.sh keep PROGRAM FOLDER    # run every command below, keep text and JSON
#   scripts/same_answers.sh compare BEFORE AFTER   # name every answer that differs; exit code 1 if any
#
# Kept are simulations (dry, wet, each effect on grains), fits (emulated, confirmed by fresh runs,
# --cold), and compare, diagnose, next, add, drop and predict on the examples. Simulations have to
# agree bit for bit, fits to 1e-9 relative, everything else word for word. Keeping takes about ten
# minutes on two cores; a folder that was begun is continued.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
    sed -n '2,10s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
    exit 2
}

# keep_answer NAME ARGUMENTS: text, JSON and exit code of one command, unless they are there.
keep_answer() {
    local name=$1 code=0
    shift
    [ -e "$name.code" ] && return
    printf '%s\n' "$name"
    "$program" "$@" --quiet --json "$name.json" >"$name.txt" 2>&1 || code=$?
    echo "$code" >"$name.code"
}

simulations() {
    local short=(--beads 300 --stiffness-number 1000 --inertial-number 0.01 --strain 1)
    local wet=(--reduced-pressure 3)
    keep_answer simulate_dry simulate "${short[@]}" --friction 0.3
    keep_answer simulate_wet simulate "${short[@]}" "${wet[@]}"
    keep_answer simulate_rolling simulate "${short[@]}" --friction 0.3 --rolling-resistance.coefficient 0.1
    keep_answer simulate_sizes simulate "${short[@]}" --polydispersity.deviation 0.1
    keep_answer simulate_adhesion simulate "${short[@]}" --dry-adhesion.force "3 uN"
    keep_answer simulate_viscous simulate "${short[@]}" "${wet[@]}" --viscous-bridges.viscosity 0.05
    keep_answer simulate_rupture simulate "${short[@]}" "${wet[@]}" --rupture-distance.factor 0.6
    for switch in capillary-coulomb reversible-bridges willett-bridges; do
        keep_answer "simulate_$switch" simulate "${short[@]}" "${wet[@]}" "--$switch.on" 1
    done
    keep_answer simulate_many simulate "${short[@]}" "${wet[@]}" --rolling-resistance.coefficient 0.1 \
        --polydispersity.deviation 0.1 --viscous-bridges.viscosity 0.05 --willett-bridges.on 1
}

# study_answers EXAMPLE EFFECT: the way from its recordings to a verdict and one effect more.
study_answers() {
    local study=$1 effect=$2
    [ -e "$study" ] || cp -r "$here/examples/$study" "$study"
    keep_answer "import_$study" import "$study"
    keep_answer "calibrate_$study" calibrate "$study" --no-confirm
    keep_answer "compare_$study" compare "$study"
    keep_answer "diagnose_$study" diagnose "$study"
    keep_answer "next_$study" next "$study"
    keep_answer "add_$study" add "$study" "$effect"
    keep_answer "compare_${study}_added" compare "$study"
    keep_answer "diagnose_${study}_added" diagnose "$study"
    keep_answer "drop_$study" drop "$study" "$effect"
}

fresh_runs() {
    [ -e confirmed ] || cp -r "$here/examples/polystyrene" confirmed
    keep_answer calibrate_confirmed calibrate confirmed --fidelity quick
    keep_answer compare_confirmed compare confirmed
    [ -e cold ] || cp -r "$here/examples/dry-recordings" cold
    keep_answer calibrate_cold calibrate cold --fidelity quick --cold
    keep_answer compare_cold compare cold
}

predictions() {
    keep_answer predict_dry predict --friction 0.12
    keep_answer predict_wet predict --friction 0.09 --reduced-pressure 1 --liquid-content 0.03
    keep_answer predict_unknown predict --friction 0.9 --reduced-pressure 0.02 --liquid-content 0.2
}

keep() {
    program=$(realpath "$1")
    mkdir -p "$2"
    cd "$2"
    export XDG_DATA_HOME=$PWD/data
    unset PENDULAR_STORE
    simulations
    predictions
    study_answers dry-recordings torque-offset
    study_answers wet wall-friction
    study_answers hidden-effect wall-friction
    study_answers rumpf-to-full capillary-shear-stress
    study_answers water-glass torque-offset
    study_answers polystyrene contact-angle
    fresh_runs
}

[ $# -eq 3 ] || usage
case "$1" in
keep) keep "$2" "$3" ;;
compare) python3 "$here/scripts/compare_answers.py" "$2" "$3" ;;
*) usage ;;
esac
