# Sizes and nesting of files.

attack "sizes: 40,000 dotted keys in study.toml" 2 "s/study.toml" <<'E'
study s; python3 -c 'print(".".join(["a"] * 40000) + " = 1")' >>s/study.toml; run import s
E
attack "sizes: 200,000 nested lists in study.toml" 2 "s/study.toml" <<'E'
study s; python3 -c 'print("a = " + "[" * 200000 + "]" * 200000)' >>s/study.toml; run import s
E
attack "sizes: 100,000 nested tables in study.toml" 2 "s/study.toml" <<'E'
study s; python3 -c 'print("a = " + "{a = " * 100000 + "1" + "}" * 100000)' >>s/study.toml; run import s
E
attack "sizes: a table's name of 40,000 parts in study.toml" 2 "s/study.toml" <<'E'
study s; python3 -c 'print("[" + ".".join(["a"] * 40000) + "]")' >>s/study.toml; run import s
E
attack "sizes: 1,000 dotted keys, then 1,000 more" 2 "s/study.toml" <<'E'
study s; python3 -c 'for i in range(1000): print(f"[a{i}." + ".".join(["a"] * 300) + "]")' >>s/study.toml; run import s
E
attack "sizes: a study.toml of 100 MB" 2 "s/study.toml" <<'E'
study s; head -c 100000000 /dev/zero | tr '\0' '#' >>s/study.toml; run import s
E
attack "sizes: a sparse recording of 2 GB" 2 "s/dry_1.csv" <<'E'
recordings s; truncate -s 2G s/dry_1.csv; run import s
E
attack "sizes: a sparse recording of 1 TB" 2 "s/dry_1.csv" <<'E'
recordings s; truncate -s 1T s/dry_1.csv; run import s
E
attack "sizes: 60,000 columns" 2 "s/points.csv" <<'E'
study s; python3 -c 'print(",".join(f"c{i}" for i in range(60000))); print(",".join(["1"] * 60000))' >s/points.csv; run import s
E
attack "sizes: a line of 100 MB" 2 "s/points.csv" <<'E'
study s; head -c 100000000 /dev/zero | tr '\0' '1' >>s/points.csv; run import s
E
attack "sizes: a fit.json of 100,000 nested lists" 2 "calibrate" <<'E'
study s; mkdir s/out; python3 -c 'print("[" * 100000)' >s/out/fit.json; run compare s
E
attack "sizes: a closed fit.json of 1,000,000 nested lists" 2 "calibrate" <<'E'
study s; mkdir s/out; python3 -c 'print("[" * 1000000 + "]" * 1000000)' >s/out/fit.json; run compare s
E
attack "sizes: a sparse fit.json of 2 GB" 2 "fit.json" <<'E'
study s; mkdir s/out; truncate -s 2G s/out/fit.json; run compare s
E
attack "sizes: a ladder.json of 1,000,000 nested lists" 2 "ladder.json" <<'E'
recordings s; mkdir s/out; python3 -c 'print("[" * 1000000 + "]" * 1000000)' >s/out/ladder.json; run add s torque-offset --quiet
E
attack "sizes: a sparse campaign of 2 GB" 2 "c.toml" <<'E'
truncate -s 2G c.toml; run campaign c.toml
E
attack "sizes: a sparse table of runs of 2 GB" 2 "t.csv" <<'E'
truncate -s 2G t.csv; run runs import t.csv
E
attack "sizes: a sparse checkpoint of 1 TB" 2 "truncated or corrupt" <<'E'
printf 'pendular checkpoint, format 4\nchecksum 0000000000000000 of 1000000000000 bytes\n' >x.ckpt
truncate -s $((1000000000000 + $(stat -c %s x.ckpt))) x.ckpt; run simulate --beads 200 --strain 1 --checkpoint x.ckpt
E
attack "sizes: a fit.json whose matrix has no rows" 2 "calibrate" <<'E'
study s; run calibrate s --no-confirm --quiet; perl -0pi -e 's/"parameter_covariance": \[.*?\]\s*\]/"parameter_covariance": []/s' s/out/fit.json; run compare s
E
attack "sizes: a fit.json whose friction is 1e300" 2 "fit.json" <<'E'
study s; run calibrate s --no-confirm --quiet; perl -0pi -e 's/("friction": \{\s*"value": )[^,]*/${1}1e300/' s/out/fit.json; run compare s
E
attack "sizes: a fit.json whose friction has another name" 2 "fit.json" <<'E'
study s; run calibrate s --no-confirm --quiet; perl -0pi -e 's/"friction": \{/"evil": {/' s/out/fit.json; run compare s
E
attack "sizes: a fit.json with numbers in place of texts" 2 "calibrate" <<'E'
study s; run calibrate s --no-confirm --quiet; perl -0pi -e 's/"unit": "1"/"unit": 1/' s/out/fit.json; run compare s
E
attack "sizes: an empty study.toml" 2 "s/study.toml" <<'E'
mkdir s; : >s/study.toml; run import s
E
attack "sizes: a study.toml of zeros" 2 "s/study.toml" <<'E'
mkdir s; head -c 1000 /dev/zero >s/study.toml; run import s
E
attack "sizes: 150,000 nearly empty rows under 1000 units" 2 "t.csv:20003" <<'E'
python3 -c 'print("Point No." + "".join(f",c{i}" for i in range(999))); print("[1]" + ",[Pa]" * 999); [print(f"{i},{i}") for i in range(1, 150001)]' >t.csv
run import t.csv
E
attack "sizes: 6000 intervals of 901 columns" 2 "t.csv:1:" <<'E'
python3 -c 'print("Action Name;" + ";".join(f"c{i}" for i in range(900))); [print(f"{chr(97 + i % 2)};1") for i in range(6000)]' >t.csv
run import t.csv
E
attack "sizes: 1100 intervals of 901 columns" 2 "no column is read" <<'E'
python3 -c 'print("Action Name;" + ";".join(f"c{i}" for i in range(900))); [print(f"{chr(97 + i % 2)};1") for i in range(1100)]' >t.csv
run import t.csv
E
attack "sizes: 2,000,000 rows of an interval each" 2 "more than 10000 intervals" <<'E'
python3 -c 'print("Time [s],Interval [1]"); [print(f"{i},{i}") for i in range(2000000)]' >t.csv; run import t.csv
E
attack "sizes: 60 million empty cells under one header" 2 "20 million cells" <<'E'
python3 -c 'print(",".join(f"c{i}" for i in range(1000))); [print("1" + "," * 999) for i in range(60000)]' >t.csv; run import t.csv
E
attack "sizes: 60 million cells on one line" 2 "cells on one line" <<'E'
python3 -c 'print("1," * 60000000)' >t.csv; run import t.csv
E
attack "sizes: 900 tables side by side over 200,000 rows" 2 "20 million cells" <<'E'
python3 -c 'print(";".join([";t in s"] * 900)); print(";".join(["1|1;2"] * 900)); [print("x") for i in range(200000)]' >t.csv; run import t.csv
E
attack "sizes: 300,000 keys before an interval" 2 "keys and values" <<'E'
python3 -c 'print("Interval and data points:\t1\t1\n\tTime\n\t[s]\n\t1\n"); [print(f"k{i}:\tv") for i in range(300000)]' >t.csv; run import t.csv
E
attack "sizes: 100,000 empty intervals, each with a row left out" 2 "more than 10000 intervals" <<'E'
python3 -c 'print("\n".join("Interval and data points:\t1\t1\n\tTime\n\t[s]\n\t1\n\n\t2\n" for i in range(100000)))' >t.csv; run import t.csv
E
attack "sizes: 300,000 different keys in a Rheoplus file" 2 "" <<'E'
python3 -c 'print("Data Series Information"); [print(f"k{i}:\tv") for i in range(300000)]' >t.csv; run import t.csv
E
attack "workbooks: a sheet that unpacks to 600 MB" 2 "unpacks to more than 256 MB" <<'E'
book 'b"<worksheet><sheetData>" + b" " * 600000000'; run import b.xlsx
E
attack "workbooks: 60 million empty cells" 2 "million tags" <<'E'
book 'b"<worksheet><sheetData><row>" + b"<c/>" * 60000000 + b"</row></sheetData></worksheet>"'; run import b.xlsx
E
attack "workbooks: a cell in column ZZZZ of 1000 rows" 2 "cells" <<'E'
book 'b"<worksheet><sheetData>" + b"".join(b"<row><c r=\"ZZZZ%d\"><v>1</v></c></row>" % (i + 1) for i in range(1000)) + b"</sheetData></worksheet>"'; run import b.xlsx
E
attack "workbooks: row 4 billion" 2 "at most 1048576 rows" <<'E'
book 'b"<worksheet><sheetData><row r=\"4000000000\"><c><v>1</v></c></row></sheetData></worksheet>"'; run import b.xlsx
E
attack "workbooks: entities of entities" 2 "&f;&a9;" <<'E'
book 'b"<!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\">" + b"".join(b"<!ENTITY a%d \"%s\">" % (i, b"&a%d;" % (i - 1) * 10) for i in range(1, 10)) + b"<!ENTITY f SYSTEM \"file:///etc/passwd\">]><worksheet><sheetData><row><c t=\"inlineStr\"><is><t>Time [s]&f;&a9;</t></is></c></row><row><c><v>x</v></c></row></sheetData></worksheet>"'
run import b.xlsx; ! grep -q root: ../out ../err || fail "a file was read"
E
attack "workbooks: 100,000 nested tags" 2 "b.xlsx" <<'E'
book 'b"<worksheet>" + b"<a>" * 100000 + b"</a>" * 100000 + b"</worksheet>"'; run import b.xlsx
E
attack "workbooks: a cut archive" 2 "no workbook" <<'E'
book 'b"<worksheet/>"'; truncate -s 300 b.xlsx; run import b.xlsx
E
