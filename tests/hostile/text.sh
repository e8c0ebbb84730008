# Texts that something else interprets: terminal, gnuplot, markup, SQL.
export escape=$'\033]0;owned\007\033[31m'

attack "terminal: header cell" 0 "not used" <<'E'
recordings s "Interval [1]" "Interval [1],x$escape"; sed -i '2,$s/$/,1/' s/dry_1.csv; run import s --all
E
attack "terminal: cell that is no number" 2 "not a finite number" <<'E'
study s; E=$escape perl -pi -e 's/0.25,/$ENV{E},/' s/points.csv; run import s
E
attack "terminal: unit of a column" 2 "is not a unit" <<'E'
study s; perl -pi -e 's/Pa/\x1bPa/' s/points.csv; run import s
E
attack "terminal: key of study.toml" 2 "unknown key" <<'E'
in_study '"\u001b]0;owned\u0007" = 1'; run import s
E
attack "terminal: listed effect" 2 "effect" <<'E'
in_study '[model]
effects = ["\u001b[31mred"]'; run import s
E
attack "terminal: pattern of a file" 2 "no file matches" <<'E'
study s; edit points.csv '\u001b[31m.csv'; run import s
E
attack "terminal: name of a file" 0 "" <<'E'
study s; mv s/points.csv "s/points$escape.csv"; edit points.csv 'points*.csv'; run import s --all
E
attack "terminal: name of a study" 2 "no study.toml" <<'E'
mkdir "s$escape"; run import "s$escape"
E
attack "terminal: argument of a command" 2 "unknown" <<'E'
study s; run import s "--$escape"
E
attack "terminal: name of a study's own effect" 2 "name" <<'E'
own_effect 'torque + a'; edit 'name = "own"' 'name = "\u001b[31mred"'; run effects --study s
E
attack "terminal: summary of a study's own effect" 0 "" <<'E'
own_effect 'torque + a' 'x\u001b]0;owned\u0007'; run effects own --study s
E
attack "terminal: formula" 2 "formula" <<'E'
own_effect 'torque + \u001b[31m'; run effects --study s
E
attack "terminal: note of fit.json" 0 "" <<'E'
study s; run calibrate s --no-confirm --quiet
perl -0pi -e 's/"notes": \[/"notes": ["\\u001b]0;owned\\u0007",/' s/out/fit.json; perl -0pi -e 's/,\s*\]/]/g' s/out/fit.json; run compare s --all
E
attack "terminal: key of fit.json" 2 "calibrate" <<'E'
study s; mkdir s/out; printf '{"format": "\\u001b[31m\033[31m", "\033[31m": }' >s/out/fit.json; run compare s
E
attack "terminal: condition of --where" 2 "condition" <<'E'
store; run runs list --where "$escape"
E
attack "terminal: failure of a stored run" 0 "run 1" <<'E'
store; sql "UPDATE runs SET failure = char(27) || '[31m'"; run runs show 1; cat ../out ../err >../first; run runs list; cat ../first >>../err
E
attack "terminal: proposed.toml" 2 "" <<'E'
study s; mkdir s/out; printf '[[effect]]\nname = "\\u001b[31m"\n' >s/out/proposed.toml; run add s --proposed 1
E
attack "terminal: campaign file" 2 "unknown key" <<'E'
printf '"\\u001b[31m" = 1\n' >c.toml; run campaign c.toml
E
attack "terminal: controls of 8 bit, and of writing direction" 2 "unknown key" <<'E'
in_study '"\u009b31m\u202e" = 1'; run import s
LC_ALL=C grep -qaP '\xc2\x9b|\xe2\x80\xae' ../err && fail "shown as they are"
E
attack "terminal: bytes that are no UTF-8" 2 "no study.toml" <<'E'
mkdir $'s\x9b31m'; run import $'s\x9b31m'
LC_ALL=C grep -qaP '\x9b' ../err && fail "shown as they are"
E
attack "gnuplot: backticks in a study's name" 0 "" <<'E'
study 's`touch PWNED`'; run calibrate 's`touch PWNED`' --no-confirm --quiet; run compare 's`touch PWNED`'
find .. -type f -name 'PWNED*' | grep -q . && fail "a command was run"
E
attack "gnuplot: backticks in --out" 0 "" <<'E'
study s; run calibrate s --no-confirm --quiet --out '`touch PWNED`'; run compare s --out '`touch PWNED`'
find .. -type f -name 'PWNED*' | grep -q . && fail "a command was run"
E
attack "gnuplot: a pipe in --out" 0 "" <<'E'
study s; run calibrate s --no-confirm --quiet --out '|touch PWNED'; run compare s --out '|touch PWNED'
find .. -type f -name 'PWNED*' | grep -q . && fail "a command was run"
E
attack "gnuplot: name of a file in a figure" 0 "" <<'E'
study s; mv s/points.csv 's/@{`touch PWNED`}"; system("touch PWNED2").csv'; edit points.csv '*.csv'
run calibrate s --no-confirm --quiet; run compare s
find .. -type f -name 'PWNED*' | grep -q . && fail "a command was run"
E
attack "gnuplot: plot of stored runs" 0 "drawn" <<'E'
store; run runs plot --out '`touch PWNED`'
find .. -type f -name PWNED | grep -q . && fail "a command was run"
E
attack "markup: summary of an effect in the manual" 0 "" <<'E'
own_effect 'torque + a' '<script>alert(1)</script> `touch PWNED`'; run effects --study s --manual 'm`touch PWNED`'
find .. -type f -name 'PWNED*' | grep -q . && fail "a command was run"
grep -rq '<script>' m*/ 2>/dev/null && fail "a script reached the manual"
E
attack "markup: name of a file in a figure" 0 "" <<'E'
study s; mv s/points.csv 's/<script>x.csv'; edit points.csv '*.csv'
run calibrate s --no-confirm --quiet; run compare s
cat s/out/figures/*.svg | grep -q '<script>' && fail "a script reached a figure"
E
attack "SQL: two commands in --where" 2 "condition" <<'E'
store; run runs list --where "1); DROP TABLE runs; --"; [ "$(sql 'SELECT count(*) FROM runs')" = 1 ] || fail "the table is gone"
E
attack "SQL: what else the file has, in --where" 2 "condition" <<'E'
store; run runs list --where "1) UNION SELECT * FROM sqlite_master --"
E
attack "SQL: an endless condition" 2 "condition" <<'E'
store; run runs list --where "(WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x FROM c) SELECT count(*) FROM c) > 0"
E
attack "SQL: memory asked for by a condition" 2 "too big" <<'E'
store; run runs list --where "length(replace(hex(zeroblob(400000000)), '0', 'aaaaaaaaaa')) > 0"
E
attack "SQL: a condition that writes a file" 2 "condition" <<'E'
store; run runs list --where "load_extension('x') OR writefile('PWNED', 'x')"
E
