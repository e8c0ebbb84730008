# Stores of runs, tables of runs, campaigns.

attack "stores: a mistyped store is not made" 2 "no such file" <<'E'
run runs list --store ../outside/mistyped.sqlite; [ -z "$(ls ../outside)" ] || fail "made"
E
attack "stores: a mistyped store in a folder that is not there" 2 "no such file" <<'E'
run runs list --store nowhere/mistyped.sqlite; [ ! -e nowhere ] || fail "made"
E
attack "stores: one that cannot be written" 0 "1 simulation." <<'E'
store; read_only; run runs list --store ro/s.sqlite
E
attack "stores: a file of another kind" 2 "is no store of runs" <<'E'
head -c 10000 /dev/urandom >x.sqlite; run runs list --store x.sqlite
E
attack "stores: a database of another program" 2 "another program" <<'E'
sqlite3 x.sqlite 'CREATE TABLE t (a)'; run runs list --store x.sqlite
E
attack "stores: a newer version" 2 "newer version" <<'E'
store; sql 'PRAGMA user_version = 99'; run runs list
E
attack "stores: cut to half" 2 "corrupt" <<'E'
for i in $(seq 40); do head -$((i + 1)) "$PENDULAR_ATLAS" >all.csv; done; "$program" runs import all.csv; sqlite3 "$PENDULAR_STORE" 'PRAGMA wal_checkpoint(TRUNCATE)'
truncate -s 20000 "$PENDULAR_STORE"; rm -f "$PENDULAR_STORE"-*; run runs list
E
attack "stores: bytes overwritten" "0|2" "" <<'E'
store; sqlite3 "$PENDULAR_STORE" 'PRAGMA wal_checkpoint(TRUNCATE)'; printf '\377%.0s' $(seq 900) | dd of="$PENDULAR_STORE" bs=1 seek=5000 conv=notrunc; run runs list
E
attack "stores: a text where a number is needed" 2 "run 1" <<'E'
store; sql "UPDATE runs SET friction = 'abc'"; run runs list
E
attack "stores: a number where a text is needed" 2 "run 1" <<'E'
store; sql "UPDATE runs SET failure = x'00ff', effects = 5"; run runs list
E
attack "stores: a corrupt run, removed as the message says" 0 "0 simulations" <<'E'
store; sql "UPDATE runs SET friction = 'abc'"; run runs list; grep -q "runs prune" ../err || fail "no advice"
"$program" runs prune --where "id = 1" --yes; run runs list
E
attack "stores: an unknown effect" 2 "run 1" <<'E'
store; sql "UPDATE runs SET effects = 'no-such-effect.x=1'"; run runs list
E
attack "stores: friction of a run is 1e300" 2 "run 1" <<'E'
store; sql "UPDATE runs SET friction = 1e300, beads = -5"; run runs list
E
attack "stores: a text of 3 MB in a row" 2 "run 1" <<'E'
store; sql "UPDATE runs SET failure = replace(hex(zeroblob(1500000)), '0', 'x')"; run runs list
E
attack "stores: a state of 3 MB that unpacks to 3 GB" 2 "run 1" <<'E'
store; python3 - <<'P'
import os, sqlite3, zlib
c = zlib.compressobj(9); z = b''.join([c.compress(bytes(10**7)) for _ in range(300)]) + c.flush()
d = sqlite3.connect(os.environ['PENDULAR_STORE']); d.execute('UPDATE runs SET final_state = ?, trace = ?', (z, z)); d.commit()
P
run runs show 1
E
attack "stores: a state with a length of 2^60" 2 "run 1" <<'E'
store; python3 - <<'P'
import os, sqlite3, struct, zlib
z = zlib.compress(struct.pack('<Q', 2**60) * 20)
d = sqlite3.connect(os.environ['PENDULAR_STORE']); d.execute('UPDATE runs SET final_state = ?, trace = ?', (z, z)); d.commit()
P
run runs show 1
E
attack "stores: a state with a length of 2^31" 2 "run 1" <<'E'
store; python3 - <<'P'
import os, sqlite3, struct, zlib
z = zlib.compress(struct.pack('<Q', 2**31) * 20)
d = sqlite3.connect(os.environ['PENDULAR_STORE']); d.execute('UPDATE runs SET final_state = ?, trace = ?', (z, z)); d.commit()
P
run runs show 1
E
attack "stores: a state of random bytes" 2 "run 1" <<'E'
store; sql "UPDATE runs SET final_state = randomblob(1000), trace = randomblob(1000)"; run runs show 1
E
attack "stores: a view that never ends in place of the table" 2 "" <<'E'
store; python3 - <<'P'
import os, sqlite3
d = sqlite3.connect(os.environ['PENDULAR_STORE'])
names = [r[1] for r in d.execute('PRAGMA table_info(runs)')]
d.execute('ALTER TABLE runs RENAME TO old')
d.execute('CREATE VIEW runs AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) SELECT ' + ', '.join(f'old.{n}' for n in names) + ' FROM c, old')
d.commit()
P
run runs list
E
attack "stores: a trigger that removes other runs" 0 "1 runs added" <<'E'
store; sql "CREATE TRIGGER t AFTER INSERT ON runs BEGIN DELETE FROM runs WHERE id < new.id; END"; head -3 "$PENDULAR_ATLAS" >two.csv; run runs import two.csv
[ "$(sql 'SELECT count(*) FROM runs')" = 2 ] || fail "runs are lost"
E
attack "stores: removed during a campaign" "1|2" "" <<'E'
printf '[[list]]\nfriction = [0.1, 0.2, 0.3]\ninertial_number = 0.1\nbeads = 500\nstrain = 2\nstiffness_number = 1000\n' >c.toml
(for i in $(seq 200); do [ -s "$PENDULAR_STORE" ] && sleep 0.2 && rm -f "$PENDULAR_STORE"*; sleep 0.05; done) & run campaign c.toml --threads 1 --quiet; kill %1
E
attack "stores: an unknown column in a table of runs" 2 "unknown column" <<'E'
printf 'friction,evil\n0.1,1\n' >t.csv; run runs import t.csv; [ ! -e "$PENDULAR_STORE" ] || fail "a store was made"
E
attack "stores: beads of 1e18 in a table of runs" 2 "t.csv:2" <<'E'
python3 - <<'P'
import os
lines = open(os.environ['PENDULAR_ATLAS']).read().splitlines()[:2]
names, cells = lines[0].split(','), lines[1].split(',')
cells[names.index('beads')] = '1000000000000000000'
open('t.csv', 'w').write(','.join(names) + '\n' + ','.join(cells) + '\n')
P
run runs import t.csv
E
attack "stores: hyperparameters of an atlas that are not finite" 2 "emulator.csv" <<'E'
cp "$PENDULAR_ATLAS" atlas.csv; sed '2s/,[^,]*$/,1e300/' "$here/../../sim/atlas/emulator.csv" >emulator.csv; export PENDULAR_ATLAS=$PWD/atlas.csv; study s; run calibrate s --no-confirm --quiet
E
attack "stores: a checkpoint of random bytes" 2 "checkpoint" <<'E'
head -c 100000 /dev/urandom >x.ckpt; run simulate --beads 200 --strain 1 --checkpoint x.ckpt
E
attack "stores: an unknown column in double quotes selects nothing" 2 "did you mean 'crystallised'" <<'E'
store; run runs prune --where 'NOT "crystalized"' --yes
E
attack "stores: a condition that joins the runs with themselves" 2 "steps of SQLite" <<'E'
for i in $(seq 40); do head -$((i + 1)) "$PENDULAR_ATLAS" >all.csv; done; "$program" runs import all.csv
run runs list --where "(SELECT count(*) FROM runs a, runs b, runs c, runs d, runs e, runs f) > 1"
E
