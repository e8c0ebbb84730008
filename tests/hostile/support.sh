# Functions for the commands of an attack (attacks.sh). The commands run in the folder `here`, beside
# an empty folder `outside`.
timeout=$(command -v timeout)
export PENDULAR_STORE=$PWD/../store.sqlite

# study NAME: a study in a folder, with ready-made readings.
study() {
  mkdir -p "$1"
  cat >"$1/study.toml" <<'T'
# A comment of the user.
[grains]
diameter = "500 um"  # sieved
density = "1050 kg/m^3"
[[readings]]
file = "points.csv"
T
  cat >"$1/points.csv" <<'T'
normal_stress [Pa],stress_ratio,solid_fraction,inertial_number
1000,0.25,0.61,0.003
1000,0.29,0.595,0.03
3000,0.255,0.61,0.003
3000,0.295,0.594,0.03
T
}

# recordings NAME [OLD NEW]...: a study with one recording, with texts of its table replaced.
recordings() {
  local folder=$1
  mkdir -p "$folder"
  cp "$here/../../examples/dry-recordings/study.toml" "$here/../../examples/dry-recordings/dry_1.csv" "$folder"
  shift
  while [ $# -gt 1 ]; do
    OLD=$1 NEW=$2 perl -0pi -e 's/\Q$ENV{OLD}\E/$ENV{NEW}/' "$folder/dry_1.csv"
    shift 2
  done
}

# run ARGUMENTS...: runs the program, for 20 s of the processor, 60 s in all, and in 4 GB at most.
run() {
  (ulimit -v 4000000 -t 20; exec "$timeout" -s KILL 60 "$program" "$@") >../out 2>../err </dev/null
  echo $? >../code
}

# fail WHY: the attack had an effect.
fail() { echo "$*" >>../failed; }

# intact FILE: must still hold "untouched".
intact() { [ "$(cat "$1" 2>/dev/null)" = untouched ] || fail "$1 was overwritten"; }

# in_study TEXT: the study s with lines added to its study.toml.
in_study() { study s; printf '%s\n' "$1" >>s/study.toml; }
# edit OLD NEW: replaces a text of s/study.toml.
edit() { OLD=$1 NEW=$2 perl -0pi -e 's/\Q$ENV{OLD}\E/$ENV{NEW}/' s/study.toml; }

# store: a store with one run, the first of the atlas.
store() { head -2 "$PENDULAR_ATLAS" >one.csv; "$program" runs import one.csv >/dev/null; }
# read_only: makes a copy of the store, ro/s.sqlite, that the program cannot write.
read_only() {
  mkdir ro; cp "$PENDULAR_STORE" ro/s.sqlite; chmod 444 ro/s.sqlite; chmod 555 ro
  [ "$(id -u)" = 0 ] || return 0
  chmod 755 .. . ../..; cp "$program" ../p; program="setpriv --reuid=65534 --clear-groups ../p"
  run() { (timeout -s KILL 20 $program "$@") >../out 2>../err </dev/null; echo $? >../code; }
}
# sql COMMAND: changes the store, or prints what it holds.
sql() { sqlite3 "$PENDULAR_STORE" "$1"; }
# own_effect TEXT SUMMARY: the study s with an effect of its own, whose formula and summary are given.
own_effect() {
  recordings s
  printf '[[effect]]\nname = "own"\nparameter = "a"\nunit = "N m"\nlower = -1\nupper = 1\nsummary = "%s"\ntorque = "%s"\n' \
    "${2:-a torque}" "$1" >>s/study.toml
}

# book SHEET: the workbook b.xlsx, whose one sheet is this Python expression of bytes.
book() {
  python3 - "$1" <<'P'
import sys, zipfile
with zipfile.ZipFile("b.xlsx", "w", zipfile.ZIP_DEFLATED, compresslevel=1) as z:
    z.writestr("xl/workbook.xml", '<workbook xmlns:r="r"><sheets><sheet name="A" r:id="r1"/></sheets></workbook>')
    z.writestr("xl/_rels/workbook.xml.rels", '<Relationships><Relationship Id="r1" Target="worksheets/sheet1.xml"/></Relationships>')
    z.writestr("xl/worksheets/sheet1.xml", eval(sys.argv[1]))
P
}
