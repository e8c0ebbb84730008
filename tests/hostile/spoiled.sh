#!/usr/bin/env bash
# Runs the program in spoiled environments, and checks what it answers and leaves.
#   spoiled.sh PROGRAM
# A full disk is a small file system in memory, which needs root; without it that part is left out.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1")
work=$(mktemp -d)
disk=$work/disk
trap 'umount "$disk" 2>/dev/null; rm -rf "$work"' EXIT
export PENDULAR_ATLAS=$here/../../sim/atlas/atlas.csv PENDULAR_STORE=$work/store.sqlite
cd "$work" || exit 1
cp -r "$here/../../examples/dry-recordings" s
failed=0 checks=0

# expect NAME CODES TEXT COMMAND...: the command must end with one of the codes ("0|1") and its output
# have TEXT; it may take 60 s.
expect() {
  local name=$1 codes=$2 text=$3 code
  shift 3
  checks=$((checks + 1))
  timeout -s KILL 60 "$@" >out.log 2>err.log </dev/null
  code=$?
  if ! [[ $code =~ ^($codes)$ ]] || ! { [ -z "$text" ] || grep -qaF -- "$text" out.log err.log; }; then
    failed=$((failed + 1))
    echo "FAILED $name: exit code $code, not $codes, or no '$text'"
    head -3 err.log out.log
  fi
}
# check NAME COMMAND...: the command must succeed.
check() {
  local name=$1
  shift
  checks=$((checks + 1))
  "$@" || { failed=$((failed + 1)); echo "FAILED $name"; }
}
calibrate=("$program" calibrate s --no-confirm --quiet)
small=(--beads 100 --stiffness-number 1000 --strain 0.5 --inertial-number 0.1 --quiet)

# Homes.
expect "no HOME" 0 Fitted env -u HOME -u PENDULAR_STORE -u XDG_DATA_HOME "${calibrate[@]}"
rm -rf .local
expect "HOME is nowhere" 0 Fitted env -u PENDULAR_STORE HOME=/proc/nowhere "${calibrate[@]}"
expect "HOME is a file" 0 Fitted env -u PENDULAR_STORE HOME=/dev/null "${calibrate[@]}"
expect "HOME is empty" 0 Fitted env -u PENDULAR_STORE HOME= "${calibrate[@]}"
rm -rf .local

# Locales and variables.
# A locale with decimal commas, made here, since a system may have none.
export LOCPATH=$work/locales
mkdir "$LOCPATH"
localedef -i de_DE -f UTF-8 "$LOCPATH/de_DE.UTF-8" 2>/dev/null || echo "Left out: a locale with decimal commas (package locales)."
for locale in de_DE.UTF-8 C nowhere; do
  expect "locale $locale" 0 Fitted env LC_ALL=$locale LANG=$locale "${calibrate[@]}" --json "$locale.json"
done
unset LOCPATH
check "numbers do not depend on the locale" cmp -s de_DE.UTF-8.json C.json
expect "no PATH" 0 Fitted env PATH=/nowhere "$(command -v timeout)" 60 "${calibrate[@]}"
expect "no variables at all" 0 effects env -i "$program" effects
expect "a strange terminal" 0 effects env TERM=nonsense COLUMNS=-5 "$program" effects
expect "temporary files nowhere" 0 Figures env TMPDIR=/nowhere "$program" compare s

# Limits.
expect "32 open files" 0 Figures bash -c "ulimit -n 32; '$program' compare s"
expect "8 open files" "0|1" "" bash -c "ulimit -n 8; '$program' compare s"
# OpenBLAS, where the system has it, starts a thread that waits for memory for ever.
export OPENBLAS_NUM_THREADS=1
expect "little memory" "0|1" "" bash -c "ulimit -v 200000; '$program' calibrate s --no-confirm --quiet"
# 120 MB of addresses suffice to begin, 160 MB with OpenBLAS; with less than 80 MB the loader says that
# it cannot. Between them a library on which Ceres depends (libgfortran) fails before the program begins.
least=120000
ldd "$program" | grep -q openblas && least=160000
expect "very little memory" "0|1" "" bash -c "ulimit -v $least; '$program' effects"
expect "too little memory to begin" 127 "error while loading shared libraries" \
  bash -c "ulimit -v 60000; '$program' effects"
expect "no CPU time left" "137|152|0|1" "" bash -c "ulimit -t 1; '$program' diagnose s --quiet"
expect "no processes" "0|1" "" bash -c "ulimit -u 1; '$program' import s"
expect "small files only" 1 "File too large" bash -c "ulimit -f 1; trap '' XFSZ; '$program' compare s"
check "study.toml after all that" cmp -s s/study.toml "$here/../../examples/dry-recordings/study.toml"
check "fit.json after all that" python3 -m json.tool s/out/fit.json /dev/null

# Output.
expect "output is full" 1 "standard output" bash -c "'$program' import s >/dev/full"
expect "output is closed" 1 "standard output" bash -c "'$program' import s >&-"
expect "errors are closed" 0 "" bash -c "'$program' import s 2>&-"
expect "input is closed" 0 "" bash -c "'$program' import s <&-"
expect "the reader has gone" "0|1|141" "" bash -c "'$program' effects | head -1; exit \${PIPESTATUS[0]}"

# Signals: the store is whole and the study unchanged. A shell without job control lets its background
# commands ignore SIGINT, which a program keeps until it installs a handler of its own.
heeding=(env --default-signal=INT,TERM,HUP)
for signal in INT TERM HUP; do
  "${heeding[@]}" "$program" simulate --beads 4000 --strain 50 --quiet >/dev/null 2>sig.log &
  pid=$!
  sleep 1
  kill -$signal $pid
  wait $pid
  check "SIG$signal ends a simulation with 130" test $? -eq 130
done
for command in "diagnose s" "next s" "calibrate s" "calibrate s --cold" "compare s" "effects --manual m"; do
  # shellcheck disable=SC2086
  setsid "${heeding[@]}" "$program" $command --quiet >/dev/null 2>sig.log &
  pid=$!
  sleep 0.3
  begin=$SECONDS
  kill -INT $pid 2>/dev/null
  wait $pid
  code=$?
  check "one Ctrl-C ends '$command' (exit code $code)" test $((SECONDS - begin)) -le 10
done
check "study.toml after signals" cmp -s s/study.toml "$here/../../examples/dry-recordings/study.toml"
expect "the store after signals" "0|2" "" "$program" runs list

# Stores.
expect "store nowhere" "1|2" "" "$program" simulate "${small[@]}" --store /proc/nowhere/s.sqlite
expect "store on a device" "1|2" "" "$program" runs list --store /dev/full
expect "store is a folder" 2 "folder" "$program" runs list --store /

# A full disk, at each write: whatever fits, nothing is cut off and the study stays.
mkdir -p "$disk"
if mount -t tmpfs -o size=2m tmpfs "$disk" 2>/dev/null; then
  for left in 0 4 8 16 32 64 128 256; do
    rm -rf "${disk:?}"/*
    cp -r "$here/../../examples/dry-recordings" "$disk/s"
    head -c 4000000 /dev/zero >"$disk/fill" 2>/dev/null
    truncate -s "-${left}K" "$disk/fill"
    expect "full disk but ${left} KB: add" "0|1" "" "$program" add "$disk/s" torque-offset --quiet
    expect "full disk but ${left} KB: compare" "0|1|2" "" "$program" compare "$disk/s"
    for file in "$disk"/s/out/*.json; do
      [ ! -e "$file" ] || check "full disk but ${left} KB: $(basename "$file")" python3 -m json.tool "$file" /dev/null
    done
    check "full disk but ${left} KB: study.toml" grep -q 'file = "dry_\*.csv"' "$disk/s/study.toml"
    check "full disk but ${left} KB: no parts" test -z "$(find "$disk" -name '*.part' -o -name '.pendular-*')"
  done
  rm -rf "${disk:?}"/*
  head -c 4000000 /dev/zero >"$disk/fill" 2>/dev/null
  expect "store on a full disk" 1 "" "$program" simulate "${small[@]}" --store "$disk/s.sqlite"
else
  echo "Left out: a full disk (needs root)."
fi
printf '%d of %d checks failed.\n' "$failed" "$checks"
[ "$failed" -eq 0 ]
