#!/usr/bin/env bash
# Time to a calibrated friction, by Pendular in three ways and by LAMMPS and a polynomial as one does it
# by hand. What is compared and how fairly: bench/peers/README.md.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=bench/common.sh
. "$root/bench/common.sh"

usage() {
  cat <<'END'
Usage: bench/calibration.sh [options]

Measures how long it takes to calibrate the friction of examples/polystyrene on its dry reading
  (a) with the emulator of the atlas alone      pendular calibrate --fidelity quick --no-confirm
  (b) with the emulator, confirmed by runs      pendular calibrate --fidelity quick
  (c) with runs alone                           pendular calibrate --fidelity quick --cold
  (d) with runs of LAMMPS at fixed frictions and two inertial numbers, and a polynomial through them
and prints times, frictions, their standard errors and how many runs were made. Finished runs of
LAMMPS are kept: the same command goes on where it was stopped.

Options:
  --rounds N             rounds of (a) to (c), each with a seed of its own (default 1)
  --threads N            runs side by side, in Pendular and LAMMPS (default: number of cores)
  --no-lammps            without (d)
  --frictions "X ..."    frictions of LAMMPS (default "0.03 0.06 0.1 0.16 0.25")
  --style NAME           its contacts: granular, as Pendular's, or hertz, faster (default granular)
  --beads N              beads of a run of LAMMPS (default 1000)
  --transient X          strain left out at its begin (default 1.5)
  --strain X             strain averaged (default 5)
  --out FILE             result, also printed (default bench/results/YYYY-MM-DD-calibration.txt)
  --work DIR             finished runs of LAMMPS (default build/calibration)
  --pendular FILE        program to measure (default: build/release/pendular, built if need be)
  --help                 this text

Exit codes: 0 done; 1 something failed; 2 the command line is wrong; 130 interrupted.

Examples:
  bench/calibration.sh --rounds 3
  bench/calibration.sh --no-lammps --out /tmp/calibration.txt
  bench/calibration.sh --beads 200 --transient 0.5 --strain 0.5 --frictions "0.05 0.1 0.2" --out /tmp/quick.txt
END
}

study=examples/polystyrene

# What LAMMPS simulates, in units of bead diameter, bead mass and imposed normal stress.
rates=(0.003 0.01) # inertial numbers; the slowest runs first
stiffness_number=1000
block=0.25       # strain of a block
time_step=0.0057 # Pendular's mean at these frictions
declare -A skins=([granular]=0.12 [hertz]=0.08) # the best that compare_peers.sh found

parse() {
  rounds=1 threads=$(getconf _NPROCESSORS_ONLN) lammps=yes frictions="0.03 0.06 0.1 0.16 0.25"
  style=granular beads=1000 transient=1.5 strain=5 out="" work="" pendular=""
  while [ $# -gt 0 ]; do
    case $1 in
      --help) usage; exit 0 ;;
      --no-lammps) lammps=no; shift; continue ;;
      --rounds | --threads | --frictions | --style | --beads | --transient | --strain | --out | --work | --pendular) ;;
      *) wrong "unknown option '$1'" ;;
    esac
    [ $# -ge 2 ] || wrong "$1 needs a value"
    case $1 in
      --rounds) rounds=$2 ;;
      --threads) threads=$2 ;;
      --frictions) frictions=$2 ;;
      --style) style=$2 ;;
      --beads) beads=$2 ;;
      --transient) transient=$2 ;;
      --strain) strain=$2 ;;
      --out) out=$(realpath -m "$2") ;;
      --work) work=$(realpath -m "$2") ;;
      --pendular) pendular=$(realpath -m "$2") ;;
    esac
    shift 2
  done
  check
}

check() {
  local number='^[0-9]+(\.[0-9]+)?$' friction
  [[ $rounds =~ ^[1-9][0-9]*$ ]] || wrong "--rounds '$rounds' is not a whole number above 0"
  [[ $threads =~ ^[1-9][0-9]*$ ]] || wrong "--threads '$threads' is not a whole number above 0"
  [ -n "${skins[$style]:-}" ] || wrong "--style '$style' is neither granular nor hertz"
  [[ $beads =~ ^[1-9][0-9]*$ && $beads -ge 200 ]] || wrong "--beads '$beads' is not a whole number of at least 200"
  [[ $transient =~ $number ]] || wrong "--transient '$transient' is not a number"
  { [[ $strain =~ $number ]] && awk -v s="$strain" -v b=$block 'BEGIN { exit s < 2 * b }'; } ||
    wrong "--strain '$strain' is not a number of at least two blocks of $block"
  for friction in $frictions; do
    [[ $friction =~ $number ]] || wrong "--frictions: '$friction' is not a number"
  done
  # Each once, in order: two spellings of a number are one friction.
  mapfile -t frictions < <(for friction in $frictions; do echo "$friction"; done | sort -gu)
  [ ${#frictions[@]} -ge 3 ] || wrong "--frictions: a polynomial takes three or more"
}

check_programs() {
  command -v python3 >/dev/null || fail "python3 is not installed"
  [ $lammps = no ] || command -v lmp >/dev/null ||
    fail "LAMMPS is not installed: apt-get install lammps (Debian), or leave it out with --no-lammps"
}

# timed FILE COMMAND...: writes wall and processor time [s] of a command into a file.
timed() {
  local file=$1 begin
  shift
  begin=$(date +%s.%N)
  (
    "$@"
    times >"$file.cpu" # minutes and seconds, of this shell and of what it ran
  )
  awk -F '[ms ]+' -v begin="$begin" -v end="$(date +%s.%N)" '
    { cpu += 60 * ($1 + $3) + $2 + $4 }
    END { printf "%.3f %.3f\n", end - begin, cpu }' "$file.cpu" >"$file"
}

# start COMMAND...: in the background, in a process group of its own, which stop ends as a whole.
start() {
  set -m
  "$@" &
  set +m
}
stop() {
  local group
  for group in $(jobs -pr); do
    kill -- "-$group" 2>/dev/null || true
  done
}

# Pendular

# The study without its wet readings, so that all methods fit the same and predict nothing else.
copy_study() {
  mkdir "$run/study"
  cp "$study/points.csv" "$run/study/"
  awk 'BEGIN { RS = ""; ORS = "\n\n" } !/\[\[readings\]\].*"wet\.csv"/' "$study/study.toml" >"$run/study/study.toml"
  [ "$(grep -c '^\[\[readings\]\]' "$run/study/study.toml")" = 1 ] || fail "$study has changed: one file of dry readings is wanted"
}

# calibrate SEED OPTION...: leaves fit.json and the runs made in $run/fit. Not to converge is a result.
calibrate() {
  "$pendular" calibrate "$run/study" --fidelity quick --seed "$1" --threads "$threads" --quiet "${@:2}" \
    --store "$run/fit/runs.sqlite" --out "$run/fit/out" --json "$run/fit/fit.json" >"$run/fit/log" 2>&1 </dev/null ||
    [ $? -eq 3 ] || {
    tail -n 15 "$run/fit/log" >&2
    fail "this failed: pendular calibrate ${*:2}"
  }
}

# measure_pendular ROUND METHOD OPTION...: appends a row to $rows
measure_pendular() {
  local kept=$run/$2-$1.json made
  say "round $1 of $rounds: $2"
  rm -rf "$run/fit" && mkdir "$run/fit"
  start timed "$run/time" calibrate "$1" "${@:3}"
  wait $! || exit 1
  made=$("$pendular" runs list --store "$run/fit/runs.sqlite" --json - --quiet 2>"$run/fit/log" |
    python3 -c 'import json, sys; print(len(json.load(sys.stdin)["runs"]))') || fail "the runs of $2 cannot be counted"
  mv "$run/fit/fit.json" "$kept"
  echo "$1 $2 $(cat "$run/time") $made $kept" >>"$rows"
}

# LAMMPS

# simulate FRICTION RATE FOLDER: a sample of its own for each run
simulate() {
  cd "$3"
  python3 "$peers/gas.py" "$beads" "$(cksum <<<"$1 $2" | cut -d' ' -f1)" gas
  run_logged log lmp -log none -in "$peers/steady.lmp" -var here "$peers" -var style granular -var flow_style "$style" \
    -var skin "${skins[$style]}" -var time_step $time_step -var rate "$2" -var friction "$1" \
    -var modulus "$modulus" -var gas gas -var state state.gz -var transient "$transient" -var strain "$strain" \
    -var block $block -var averages averages
}

# one_run FRICTION RATE: kept in a file that polynomial_fit.py reads
one_run() {
  local kept=$states/$1-$2 folder=$run/$1-$2
  mkdir "$folder"
  timed "$folder/time" simulate "$1" "$2" "$folder"
  {
    echo "$1 $2 $(awk '$1 == "overlap" { print $2 }' "$folder/log") $(cat "$folder/time")"
    awk '!/^#/ { print $2, $3, $4 }' "$folder/averages"
  } >"$kept.new"
  mv "$kept.new" "$kept"
  rm -rf "$folder"
}

# run_lammps: carries out the runs that are not kept, the longest first; their files in $lammps_runs
run_lammps() {
  local friction rate
  lammps_runs=() kept_before=0
  for rate in "${rates[@]}"; do
    for friction in "${frictions[@]}"; do
      lammps_runs+=("$states/$friction-$rate")
      if [ -s "$states/$friction-$rate" ]; then
        kept_before=$((kept_before + 1))
        continue
      fi
      while [ "$(jobs -pr | wc -l)" -ge "$threads" ]; do wait_for_one; done
      say "LAMMPS: friction $friction, I = $rate"
      start one_run "$friction" "$rate"
    done
  done
  while [ "$(jobs -pr | wc -l)" -gt 0 ]; do wait_for_one; done
  for friction in "${lammps_runs[@]}"; do
    [ -s "$friction" ] || fail "a run of LAMMPS failed"
  done
}

wait_for_one() {
  local status=0
  wait -n || status=$?
  [ $status -eq 0 ] || [ $status -eq 127 ] || fail "a run of LAMMPS failed" # 127: none was left
}

# measure_lammps: appends a row to $rows
measure_lammps() {
  local begin wall cpu
  begin=$(date +%s.%N)
  run_lammps
  python3 "$peers/polynomial_fit.py" "$run/reading.json" $stiffness_number "${lammps_runs[@]}" >"$run/lammps.json" ||
    fail "no friction from the runs of LAMMPS, which are kept in $states"
  if [ $kept_before -eq 0 ]; then
    wall=$(awk -v begin="$begin" -v end="$(date +%s.%N)" 'BEGIN { printf "%.3f", end - begin }')
  else
    wall=$(time_of_all)
  fi
  cpu=$(awk 'FNR == 1 { sum += $5 } END { print sum }' "${lammps_runs[@]}")
  echo "1 lammps $wall $cpu ${#lammps_runs[@]} $run/lammps.json" >>"$rows"
}

# time_of_all: what the runs would have taken in one go, each as long as it took: a run begins where
# the first of the processes is free.
time_of_all() {
  awk -v threads="$threads" '
    FNR == 1 {
      first = 1
      for (k = 2; k <= threads; ++k) if (busy[k] + 0 < busy[first] + 0) first = k
      busy[first] += $4
      if (busy[first] > longest) longest = busy[first]
    }
    END { print longest }' "${lammps_runs[@]}"
}

describe() {
  echo "Time to a calibrated friction, $(date +%F): the dry reading of $study, at quick fidelity,"
  echo "$threads runs side by side"
  echo
  if [ $lammps = no ]; then
    describe_machine
    return
  fi
  describe_machine lammps
  echo "runs (d)  $beads beads, frictions ${frictions[*]}, I = ${rates[*]}, stiffness number $stiffness_number,"
  echo "          averaged strain $strain after $transient, $style contacts, time step $time_step, skin ${skins[$style]}"
}

main() {
  parse "$@"
  peers=$root/bench/peers
  cd "$root"
  out=${out:-$root/bench/results/$(date +%F)-calibration.txt}
  run=$(mktemp -d)
  trap 'stop; rm -rf "$run"' EXIT
  trap 'exit 130' INT TERM
  rows=$run/rows
  export OMP_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1

  check_programs
  build_pendular
  copy_study
  local begin
  begin=$(describe)
  # Once untimed: what the program reads is in memory then, and its fit names the reading.
  mkdir "$run/fit" && calibrate 1 --no-confirm && mv "$run/fit/fit.json" "$run/reading.json"
  if [ $lammps = yes ]; then
    modulus=$(python3 -c "print($stiffness_number**1.5)")
    states=${work:-$root/build/calibration}/$({
      echo "$modulus" $block $time_step "$style" "${skins[$style]}" "$beads" "$transient" "$strain" "$threads"
      cat "$peers"/{beads,height,prepare,steady}.lmp "$peers"/gas.py
    } | cksum | cut -d' ' -f1)
    mkdir -p "$states"
    measure_lammps
  fi
  for ((round = 1; round <= rounds; ++round)); do
    measure_pendular $round emulator --no-confirm
    measure_pendular $round confirmed
    measure_pendular $round cold --cold
  done

  {
    echo "$begin"
    python3 "$peers/calibration_table.py" "$run/reading.json" <"$rows"
    [ $lammps = no ] || [ "$kept_before" -eq 0 ] ||
      echo "(d) was made in parts: its wall time is that of all runs in one go, each as long as it took."
  } >"$run/result"
  mkdir -p "$(dirname "$out")"
  cp "$run/result" "$out"
  cat "$out"
  say "Written to $out"
}

main "$@"
