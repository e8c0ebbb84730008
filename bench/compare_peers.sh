#!/usr/bin/env bash
# Speed of Pendular's solver beside LAMMPS and YADE on the same flow, one core each, in the same
# minutes. What is compared and how fairly: bench/peers/README.md.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=bench/common.sh
. "$root/bench/common.sh"

usage() {
  cat <<'END'
Usage: bench/compare_peers.sh [options]

Installs LAMMPS and YADE (Debian packages), shears the same beads with Pendular and with them, one
after the other on one core each, round by round, and prints speeds, the ratios of each round, and
the stress ratio and solid fraction each code finds.

Options:
  --rounds N         rounds, each with one measurement of every code (default 5)
  --beads "N ..."    sample sizes (default "2000 4000")
  --seconds S        length of a measurement of LAMMPS or YADE, at least; Pendular's are whole runs
                     of a strain of 1.5 (dry) or 2.5 (wet) and more (default 6)
  --out FILE         result, also printed (default bench/results/YYYY-MM-DD-peers.txt)
  --work DIR         initial states, kept for the next time (default build/peers)
  --pendular FILE    program to measure (default: build/release/pendular, built if need be)
  --no-install       take lammps, yade and python3 as they are
  --help             this text

Exit codes: 0 done; 1 something failed; 2 the command line is wrong; 130 interrupted.

Example:
  bench/compare_peers.sh --rounds 2 --beads 2000 --out /tmp/peers.txt
END
}

# The flow, in units of bead diameter, bead mass and imposed normal stress.
friction=0.09
rate=0.003 # the inertial number
stiffness_number=1000
reduced_pressure=2
bridge_volume=0.004

# Every code of a round, and the neighbour distances tried for it [diameters].
cases=(dry:pendular dry:lammps-granular dry:lammps-hertz dry:yade wet:pendular wet:yade)
lammps_skins=(0.03 0.05 0.08 0.12)
yade_skins=(0.02 0.05 0.1 0.2)

parse() {
  rounds=5 sizes="2000 4000" seconds=6 install=yes pendular="" out="" work=""
  while [ $# -gt 0 ]; do
    case $1 in
      --help) usage; exit 0 ;;
      --no-install) install=no; shift; continue ;;
      --rounds | --beads | --seconds | --out | --work | --pendular) ;;
      *) wrong "unknown option '$1'" ;;
    esac
    [ $# -ge 2 ] || wrong "$1 needs a value"
    case $1 in
      --rounds) rounds=$2 ;;
      --beads) sizes=$2 ;;
      --seconds) seconds=$2 ;;
      --out) out=$(realpath -m "$2") ;;
      --work) work=$(realpath -m "$2") ;;
      --pendular) pendular=$(realpath -m "$2") ;;
    esac
    shift 2
  done
  [[ $rounds =~ ^[1-9][0-9]*$ ]] || wrong "--rounds '$rounds' is not a whole number above 0"
  [[ $seconds =~ ^[0-9]+(\.[0-9]+)?$ && ! $seconds =~ ^[0.]+$ ]] || wrong "--seconds '$seconds' is not a number above 0"
  [[ $sizes =~ [0-9] ]] || wrong "--beads '$sizes' names no size"
  for size in $sizes; do
    [[ $size =~ ^[1-9][0-9]*$ && $size -ge 1000 ]] || wrong "--beads '$size' is not a whole number of at least 1000"
  done
}

install_packages() {
  local missing=() as_root=() package
  for package in lammps yade python3; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  [ $install = yes ] || fail "not installed: ${missing[*]}"
  command -v apt-get >/dev/null || fail "${missing[*]} cannot be had: this needs Debian or a system with apt-get"
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "run this as root, or install sudo; missing: ${missing[*]}"
    as_root=(sudo)
  fi
  say "Installing ${missing[*]}"
  { "${as_root[@]}" apt-get update -q && "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"; } >"$run/apt" 2>&1 || {
    tail -n 5 "$run/apt" >&2
    fail "${missing[*]} cannot be had: apt-get failed as above; Debian 12 has them in its section main"
  }
}

# Measurements. Each prints: steps time_step wall_seconds cpu_seconds normal_stress shear_stress solid_fraction

# measure_pendular WETNESS BEADS SEED
measure_pendular() {
  local liquid=()
  [ "$1" = dry ] || liquid=(--reduced-pressure "$reduced_pressure" --bridge-volume "$bridge_volume")
  local TIMEFORMAT='%U %S'
  { time run_logged "$run/pendular.log" "$pendular" simulate --friction $friction \
    --inertial-number $rate --stiffness-number $stiffness_number --beads "$2" --strain 0.5 \
    --seed "$3" --threads 1 --quiet --json "$run/pendular.json" "${liquid[@]}" 2>&3; } 3>&2 2>"$run/cpu"
  python3 - "$run/pendular.json" "$run/cpu" <<'END'
import json, sys
run = json.load(open(sys.argv[1]))
cpu = sum(map(float, open(sys.argv[2]).read().split()))
normal = run["held_normal_stress"]["value"]
print(run["steps"], run["time_step"], run["wall_seconds"], cpu, normal,
      normal * run["stress_ratio"]["value"], run["solid_fraction"]["value"])
END
}

# lammps FILE STYLE SKIN TIME_STEP VARIABLE VALUE ...
lammps() {
  local file=$1 style=$2 skin=$3 time_step=$4 variables=()
  shift 4
  while [ $# -gt 0 ]; do
    variables+=(-var "$1" "$2")
    shift 2
  done
  run_logged "$run/lammps.log" lmp -log none -in "$peers/$file" -var here "$peers" -var style "$style" \
    -var skin "$skin" -var time_step "$time_step" -var rate $rate -var friction $friction \
    -var modulus "$modulus" "${variables[@]}"
}

# measure_lammps STYLE SKIN TIME_STEP STEPS STATE END_STATE
measure_lammps() {
  lammps measure.lmp "$1" "$2" "$3" steps "$4" state "$5" end_state "$6"
  # The last run is the one timed: wall time and the share of it spent on the processor.
  awk -v steps="$4" -v time_step="$3" '
    /^Loop time/ { wall = $4 }
    /% CPU use/ { share = $1 / 100 }
    /^means/ { means = $2 " " $3 " " $4 }
    END { print steps, time_step, wall, wall * share, means }' "$run/lammps.log"
}

# yade_script MODE WETNESS OPTION=VALUE ...: in the directory of the state, where tables of bridges lie.
yade_script() {
  local mode=$1 wetness=$2 wet=0
  shift 2
  [ "$wetness" = dry ] || wet=1
  run_logged "$run/yade.log" yade -j1 -n -x "$peers/shear.yade.py" "$mode" wet=$wet rate=$rate "$@"
}

# measure_yade WETNESS SKIN TIME_STEP STEPS STATE END_STATE
measure_yade() {
  yade_script measure "$1" skin="$2" steps="$4" state="$5" end_state="$6"
  grep -q '^means' "$run/yade.log" || { tail -n 15 "$run/yade.log" >&2; fail "YADE did not finish"; }
  awk -v steps="$4" -v time_step="$3" '
    /^means/ { means = $2 " " $3 " " $4 }
    /^time/ { time = $2 " " $3 }
    END { print steps, time_step, time, means }' "$run/yade.log"
}

# measure CODE WETNESS ...: one of the peers
measure() {
  local code=$1 wetness=$2
  shift 2
  case $code in
    lammps-*) measure_lammps "${code#lammps-}" "$@" ;;
    yade) measure_yade "$wetness" "$@" ;;
  esac
}

# Preparation, kept between calls. A case's folder holds its initial state and `tuned`: skin and
# steps per second; the folder of a size the random gas and Pendular's time steps. The states' name
# ends as YADE wants it; LAMMPS does not mind.

# time_step WETNESS BEADS: Pendular's mean time step, which the peers take.
time_step() {
  local kept=$states/$2/time_step.$1 row
  if [ ! -s "$kept" ]; then
    row=$(measure_pendular "$1" "$2" 1000)
    awk '{ print $2 }' <<<"$row" >"$kept.new" && mv "$kept.new" "$kept"
  fi
  cat "$kept"
}

# prepare CODE WETNESS BEADS
prepare() {
  local code=$1 wetness=$2 beads=$3 dt
  dt=$(time_step "$wetness" "$beads")
  mkdir -p "$states/$beads/$code-$wetness"
  cd "$states/$beads/$code-$wetness"
  if [ ! -s initial.bin.gz ]; then
    say "$beads beads, $wetness, $code: preparing an initial state"
    shear_gas "$code" "$wetness" "$beads" "$dt"
    mv new.bin.gz initial.bin.gz
  fi
  if [ ! -s tuned ]; then
    say "$beads beads, $wetness, $code: looking for the best skin"
    tune "$code" "$wetness" "$beads" "$dt"
  fi
  cd "$root"
}

# shear_gas CODE WETNESS BEADS TIME_STEP
shear_gas() {
  if [ ! -s ../gas ]; then
    python3 "$peers/gas.py" "$3" 1 ../gas.new
    mv ../gas.new ../gas
  fi
  case $1 in
    # One way for both styles: the dashpot of gran/hertz/history is unstable while the gas closes.
    lammps-*) lammps prepare.lmp granular 0.05 "$4" gas ../gas state new.bin.gz ;;
    yade)
      yade_script prepare "$2" gas=../gas state=new.bin.gz modulus="$modulus" friction=$friction \
        reduced_pressure=$reduced_pressure bridge_volume=$bridge_volume time_step="$4"
      ;;
  esac
}

# tune CODE WETNESS BEADS TIME_STEP: the skin that costs the least processor time in the better of
# two tries, and the steps per second of processor time with it.
tune() {
  local code=$1 skins=("${lammps_skins[@]}") steps=$((4000000 / $3)) skin row tries=""
  [ "$code" != yade ] || skins=("${yade_skins[@]}") steps=$((600000 / $3))
  for skin in "${skins[@]}" "${skins[@]}"; do
    row=$(measure "$code" "$2" "$skin" "$4" "$steps" initial.bin.gz tuning.bin.gz)
    tries+=$(awk -v skin="$skin" '{ print $4 / $1, skin, $1 / $4 }' <<<"$row")$'\n'
  done
  sort -g <<<"${tries%$'\n'}" | awk 'NR == 1 { print $2, $3 }' >tuned.new
  rm -f tuning.bin.gz
  mv tuned.new tuned
}

# one_round ROUND BEADS: appends a row per case to $rows. Peers go on where their last round ended.
one_round() {
  local round=$1 beads=$2 case wetness code skin speed dt row current
  for case in "${cases[@]}"; do
    wetness=${case%:*} code=${case#*:}
    say "round $round of $rounds, $beads beads, $wetness: $code"
    if [ "$code" = pendular ]; then
      row=$(measure_pendular "$wetness" "$beads" "$round")
    else
      cd "$states/$beads/$code-$wetness"
      current=$run/$beads-$code-$wetness.bin.gz
      [ -e "$current" ] || cp initial.bin.gz "$current"
      read -r skin speed <tuned
      dt=$(time_step "$wetness" "$beads")
      row=$(measure "$code" "$wetness" "$skin" "$dt" \
        "$(awk -v s="$seconds" -v v="$speed" 'BEGIN { printf "%d", s * v + 1 }')" "$current" "$run/end.bin.gz")
      mv "$run/end.bin.gz" "$current"
      cd "$root"
    fi
    echo "$round $beads $wetness $code $row" >>"$rows"
  done
}

describe() {
  echo "Pendular beside LAMMPS and YADE, $(date +%F): friction $friction, I = $rate, stiffness number"
  echo "$stiffness_number, dry and at P* = $reduced_pressure with bridges of $bridge_volume a^3; one core each"
  echo
  describe_machine lammps yade
  echo "skins     diameters, the best of ${lammps_skins[*]} (LAMMPS), ${yade_skins[*]} (YADE):"
  for size in $sizes; do
    for case in "${cases[@]}"; do
      [ "${case#*:}" = pendular ] ||
        echo "          $size beads, ${case%:*} ${case#*:}: $(cut -d' ' -f1 "$states/$size/${case#*:}-${case%:*}/tuned")"
    done
  done
}

main() {
  parse "$@"
  peers=$root/bench/peers
  cd "$root"
  out=${out:-$root/bench/results/$(date +%F)-peers.txt}
  run=$(mktemp -d)
  trap 'rm -rf "$run"' EXIT
  trap 'exit 130' INT TERM
  rows=$run/rows
  export OMP_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1

  install_packages
  build_pendular
  modulus=$(python3 -c "print($stiffness_number**1.5)")
  # States are those of one flow and one set of input files.
  states=${work:-$root/build/peers}/$({ echo $friction $rate "$modulus" $reduced_pressure $bridge_volume &&
    cat "$peers"/{beads,height,measure,prepare}.lmp "$peers"/gas.py "$peers"/shear.yade.py; } | cksum | cut -d' ' -f1)
  for size in $sizes; do
    mkdir -p "$states/$size"
    for case in "${cases[@]}"; do
      [ "${case#*:}" = pendular ] || prepare "${case#*:}" "${case%:*}" "$size"
    done
  done

  local begin
  begin=$(describe)
  for ((round = 1; round <= rounds; ++round)); do
    for size in $sizes; do
      one_round $round "$size"
    done
  done
  { echo "$begin" && python3 "$peers/ratios.py" $rate <"$rows"; } >"$run/result"
  mkdir -p "$(dirname "$out")"
  cp "$run/result" "$out"
  cat "$out"
  say "Written to $out"
}

main "$@"
