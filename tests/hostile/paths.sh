# Paths that lead out of a study, and output that would replace what is there.

attack "paths: a file of the folder above" 2 "allow_outside = true" <<'E'
study s; mv s/points.csv .; edit points.csv ../points.csv; run import s
E
attack "paths: a file of the system" 2 "allow_outside = true" <<'E'
study s; edit points.csv /etc/passwd; run import s
E
attack "paths: a link to a file of the system" 2 "allow_outside = true" <<'E'
study s; ln -sf /etc/passwd s/points.csv; run import s
E
attack "paths: a folder that is a link" 2 "allow_outside = true" <<'E'
study s; mv s/points.csv ../outside; ln -s ../../outside s/data; edit points.csv data/points.csv; run import s
E
attack "paths: outside where the study allows it" 0 "4 readings" <<'E'
study s; mv s/points.csv .; edit points.csv ../points.csv; perl -0pi -e 's/^/allow_outside = true\n/' s/study.toml; run import s
E
attack "paths: a link within the study" 0 "4 readings" <<'E'
study s; mkdir s/raw; mv s/points.csv s/raw; ln -s raw/points.csv s/points.csv; run import s
E
attack "paths: a pattern with very many matches" 2 "" <<'E'
study s; mkdir s/a s/b s/c s/d s/e; p=$(printf '*/../%.0s' $(seq 12)); edit points.csv "${p}*.csv"; run import s
E
attack "paths: kernel messages" 2 "not a regular file" <<'E'
study s; ln -sf /proc/kmsg s/points.csv; perl -0pi -e 's/^/allow_outside = true\n/' s/study.toml; run import s
E
attack "paths: kernel messages as a study" 2 "" <<'E'
run import /proc/kmsg
E
attack "paths: an endless device" 2 "not a regular file" <<'E'
run import /dev/zero
E
attack "paths: a pipe as a recording" 2 "points.csv" <<'E'
study s; rm s/points.csv; mkfifo s/points.csv; run import s
E
attack "paths: a pipe as a study" 2 "not a regular file" <<'E'
mkdir s; mkfifo s/study.toml; run import s
E
attack "paths: a pipe as a fit" 2 "fit.json" <<'E'
study s; mkdir s/out; mkfifo s/out/fit.json; run compare s
E
attack "paths: a pipe as a campaign" 2 "not a regular file" <<'E'
mkfifo c.toml; run campaign c.toml
E
attack "paths: a folder as a recording" 2 "points.csv" <<'E'
study s; rm s/points.csv; mkdir s/points.csv; run import s
E
attack "paths: a folder as study.toml" 2 "study.toml" <<'E'
mkdir -p s/study.toml; run import s
E
attack "paths: links in a circle" 2 "points.csv" <<'E'
study s; rm s/points.csv; ln -s points.csv s/points.csv; run import s
E
attack "paths: study.toml a link to itself" 2 "study.toml" <<'E'
mkdir s; ln -s study.toml s/study.toml; run import s
E
attack "paths: a study that is a link to itself" 2 "leads to itself" <<'E'
ln -s s s; run import s
E
attack "paths: out/readings.csv a link out of the study" 2 "s/out/readings.csv" <<'E'
study s; mkdir s/out; echo untouched >../outside/target; ln -s ../../../outside/target s/out/readings.csv; run import s; intact ../outside/target
E
attack "paths: out/fit.json a link out of the study" 2 "s/out/fit.json" <<'E'
study s; mkdir s/out; echo untouched >../outside/target; ln -s ../../../outside/target s/out/fit.json
run calibrate s --no-confirm --quiet; intact ../outside/target
E
attack "paths: a figure a link out of the study" 2 "parity" <<'E'
study s; run calibrate s --no-confirm --quiet; mkdir s/out/figures; echo untouched >../outside/target
ln -s ../../../../outside/target s/out/figures/parity.svg; run compare s; intact ../outside/target
E
attack "paths: a hidden figure a link out of the study" 0 "Figures" <<'E'
study s; run calibrate s --no-confirm --quiet; mkdir s/out/figures; echo untouched >../outside/target
for f in parity residuals; do for e in svg png pdf; do ln -s ../../../../outside/target s/out/figures/.$f.$e; done; done; run compare s; intact ../outside/target
E
attack "paths: the folder out a link out of the study" 2 "s/out" <<'E'
study s; ln -s ../../outside s/out; run import s; [ -z "$(ls ../outside)" ] || fail "written outside"
E
attack "paths: the folder figures a link out of the study" 2 "figures" <<'E'
study s; run calibrate s --no-confirm --quiet; ln -s ../../../outside s/out/figures; run compare s; [ -z "$(ls ../outside)" ] || fail "written outside"
E
attack "paths: --out onto the recording" 2 "name another folder" <<'E'
study s; mv s/points.csv s/readings.csv; edit points.csv readings.csv; cp s/readings.csv kept; run import s --out s; cmp -s kept s/readings.csv || fail overwritten
E
attack "paths: --json onto the recording" 2 "name another file" <<'E'
study s; cp s/points.csv kept; run import s --json s/points.csv; cmp -s kept s/points.csv || fail overwritten
E
attack "paths: --json onto study.toml" 2 "name another file" <<'E'
study s; cp s/study.toml kept; run import s --json s/study.toml; cmp -s kept s/study.toml || fail overwritten
E
attack "paths: --json onto a file the pattern reads" 2 "would read it as a measurement" <<'E'
study s; edit points.csv '*.csv'; run import s --json s/more.csv; [ ! -e s/more.csv ] || fail written
E
attack "paths: --json of predict onto a recording" 2 "" <<'E'
study s; cp s/points.csv kept; run calibrate s --no-confirm --quiet; run predict --friction 0.1 --json s/points.csv; cmp -s kept s/points.csv || fail overwritten
E
attack "paths: virtual-lab onto a study" 2 "" <<'E'
study s; cp -r s kept; run virtual-lab s; diff -r s kept >/dev/null || fail "files were changed"
E
attack "paths: runs export onto a recording" "2" "" <<'E'
store; study s; cp s/points.csv kept; run runs export s/points.csv; cmp -s kept s/points.csv || fail overwritten
E
attack "paths: a study of another user's mode" 0 "" <<'E'
recordings s; chmod 640 s/study.toml; run add s torque-offset --quiet; [ "$(stat -c %a s/study.toml)" = 640 ] || fail "mode $(stat -c %a s/study.toml)"
E
attack "paths: a study of another user" 0 "" <<'E'
recordings s; [ "$(id -u)" != 0 ] || chown 1234:1234 s/study.toml; owner=$(stat -c %u:%g s/study.toml); run add s torque-offset --quiet; [ "$(stat -c %u:%g s/study.toml)" = "$owner" ] || fail "owner $(stat -c %u:%g s/study.toml)"
E
attack "paths: the folder of a study is a link to itself" 2 "leads to itself" <<'E'
ln -s s s; run calibrate s
E
