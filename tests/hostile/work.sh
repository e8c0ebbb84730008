# What happens to files while the program works, alone or beside another.

attack "work: two effects added at once" 0 "" <<'E'
recordings s; "$program" add s torque-offset --quiet >../first 2>&1 & run add s normal-force-offset --quiet; wait
grep -q torque-offset s/study.toml && grep -q normal-force-offset s/study.toml || fail "an effect is lost: $(grep effects s/study.toml) $(cat ../first ../err)"
E
attack "work: the lock is held by another program" 1 "held by" <<'E'
recordings s; exec 9<>s/.study.toml.lock; flock 9; PENDULAR_LOCK_SECONDS=1 run add s torque-offset --quiet
E
attack "work: no gnuplot for compare" 0 "gnuplot" <<'E'
study s; run calibrate s --no-confirm --quiet; PATH=/nowhere run compare s --json j.json; [ -s j.json ] && [ -s s/out/compare.json ] || fail "no JSON"
E
attack "work: no gnuplot for add" 0 "gnuplot" <<'E'
recordings s; PATH=/nowhere run add s torque-offset --quiet --json j.json; [ -s j.json ] || fail "no JSON"; grep -q torque-offset s/study.toml || fail "not added"
E
attack "work: a file name that is not UTF-8" 0 "" <<'E'
study s; mv s/points.csv $'s/points\xff.csv'; edit points.csv 'points*.csv'; run calibrate s --no-confirm --quiet; [ -s s/out/fit.json ] || fail "no fit.json"
E
attack "work: standard output closed" "1" "standard output" <<'E'
study s; ("$program" import s >&- 2>../err); echo $? >../code
E
attack "work: standard output a full device" "1" "standard output" <<'E'
study s; ("$program" import s >/dev/full 2>../err); echo $? >../code
E
attack "work: reader of the output gone" 0 "" <<'E'
study s; "$program" effects 2>../err | head -1 >../out; echo ${PIPESTATUS[0]} >../code
E
attack "work: reader of the output gone before the files are written" 0 "" <<'E'
study s; "$program" import s --all --json j.json 2>../err | true; test -s j.json; echo $? >../code
E
attack "work: a condition that fails only on runs" 2 "condition 'load_extension" <<'E'
store; run runs list --where 'load_extension(1)'
E
attack "work: a checkpoint whose stated size wraps round" 2 "truncated or corrupt" <<'E'
printf 'pendular checkpoint, format 4\nchecksum 0 of 18446744073709551615' >x.ckpt
run simulate --beads 200 --strain 1 --checkpoint x.ckpt
E
attack "work: a proposed summary that ends its own quotes" 0 "" <<'E'
study s; mkdir s/out
cat >s/out/proposed.toml <<'T'
[[proposal]]
effects = ["gain"]
[[effect]]
name = "gain"
summary = "shown\"x\\"
parameter = "factor"
lower = 0.5
upper = 2
neutral = 1
matters = 0.01
stress_ratio = "stress_ratio*factor"
T
run add s --proposed 1
E
attack "work: a store of an older version that cannot be written" 0 "1 simulation." <<'E'
store; sql 'ALTER TABLE runs DROP COLUMN distant_force; PRAGMA wal_checkpoint(TRUNCATE)' >/dev/null; read_only; run runs list --store ro/s.sqlite
E
attack "work: an empty store that cannot be written" 2 "is empty and cannot be written" <<'E'
rm -f "$PENDULAR_STORE"*; : >"$PENDULAR_STORE"; read_only; run runs list --store ro/s.sqlite
E
attack "work: a run removed from a store that cannot be written" 2 "cannot be written, so that no run can be removed" <<'E'
store; read_only; run runs prune --where "id = 1" --yes --store ro/s.sqlite
E
