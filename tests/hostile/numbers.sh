# Numbers that no measurement has, units and formulas.

attack "numbers: a torque of 1e160" 2 "s/dry_1.csv:9:5: column 'Torque [mN m]'" <<'E'
recordings s; perl -pi -e 's/^([^,]*),[^,]*/$1,1e160/ if $. == 9' s/dry_1.csv; run import s
E
attack "numbers: a cell of 1e293" 2 "s/points.csv:2:6" <<'E'
study s; perl -pi -e 's/0.25,/1e293,/' s/points.csv; run calibrate s --no-confirm --quiet
E
attack "numbers: a header unit of 1e308 kN m" 2 "s/dry_1.csv:1:10: column 'Torque [1e308 kN m]'" <<'E'
recordings s "Torque [mN m]" "Torque [1e308 kN m]"; run import s
E
attack "numbers: a header unit of 1e-320 N m" 2 "s/dry_1.csv:1:10" <<'E'
recordings s "Torque [mN m]" "Torque [1e-320 N m]"; run import s
E
attack "numbers: a height of 1e200 mm" 2 "s/dry_1.csv:9" <<'E'
recordings s; perl -pi -e 's/^(([^,]*,){3})[^,]*/${1}1e200/ if $. == 9' s/dry_1.csv; run import s
E
attack "numbers: a time of 1e300 s" 2 "s/dry_1.csv:9" <<'E'
recordings s; perl -pi -e 's/^[^,]*/1e300/ if $. == 9' s/dry_1.csv; run import s
E
attack "numbers: an angular velocity of 1e250 rad/s" 2 "s/dry_1.csv:9" <<'E'
recordings s; perl -pi -e 's/^(([^,]*,){4})[^,]*/${1}1e250/ if $. == 9' s/dry_1.csv; run import s
E
attack "numbers: a normal force of 1e-300 N" 3 "0 readings" <<'E'
recordings s; perl -pi -e 's/^(([^,]*,){2})[^,]*/${1}1e-300/ if $. > 1' s/dry_1.csv; run import s
E
attack "numbers: not a number" 2 "states no value" <<'E'
study s; perl -pi -e 's/0.25,/nan,/' s/points.csv; run import s
E
attack "numbers: infinity" 2 "not a finite number" <<'E'
study s; perl -pi -e 's/0.25,/inf,/' s/points.csv; run import s
E
attack "numbers: 1e400" 2 "not a finite number" <<'E'
study s; perl -pi -e 's/0.25,/1e400,/' s/points.csv; run import s
E
attack "numbers: a number of a million digits" 2 "s/points.csv:2" <<'E'
study s; perl -pi -e 's/0.25,/("9" x 1000000).","/e' s/points.csv; run import s
E
attack "numbers: a normal stress of 1e-300 Pa" 2 "s/points.csv:2:1" <<'E'
study s; perl -pi -e 's/^1000/1e-300/' s/points.csv; run calibrate s --no-confirm --quiet
E
attack "numbers: a standard deviation of 1e-300" 2 "s/points.csv:2" <<'E'
study s; perl -pi -e 's/$/,stress_ratio_sd/ if $. == 1; s/$/,1e-300/ if $. > 1' s/points.csv; run calibrate s --no-confirm --quiet
E
attack "numbers: an inertial number of 1e200" 2 "s/points.csv:2" <<'E'
study s; perl -pi -e 's/0.003$/1e200/' s/points.csv; run calibrate s --no-confirm --quiet
E
attack "numbers: a liquid content of 1e300" 2 "" <<'E'
study s; perl -pi -e 's/$/,liquid_content/ if $. == 1; s/$/,1e300/ if $. > 1' s/points.csv
printf '[liquid]\nsurface_tension = "20 mN/m"\ncontact_angle = "0 deg"\n' >>s/study.toml; run calibrate s --no-confirm --quiet
E
attack "numbers: a diameter of 1e300 m" 2 "s/study.toml:3:12: 'diameter'" <<'E'
study s; edit '500 um' '1e300 m'; run calibrate s --no-confirm --quiet
E
attack "numbers: a density of 1e-300 kg/m^3" 2 "s/study.toml:4:11: 'density'" <<'E'
study s; edit '1050 kg/m^3' '1e-300 kg/m^3'; run calibrate s --no-confirm --quiet
E
attack "numbers: a surface tension of 1e300 N/m" 2 "'surface_tension'" <<'E'
in_study '[liquid]
surface_tension = "1e300 N/m"
contact_angle = "0 deg"'; run calibrate s --no-confirm --quiet
E
attack "numbers: radii of 1e200 m" 2 "_radius'" <<'E'
recordings s; edit '21 mm' '1e200 m'; edit '45 mm' '2e200 m'; run import s
E
attack "numbers: options of simulate" 2 "" <<'E'
run simulate --friction 1e300 --beads 200 --strain 0.1
E
attack "numbers: beads of simulate" 2 "" <<'E'
run simulate --beads 2000000000
E
attack "numbers: a campaign of 1e9 runs" 2 "1000000" <<'E'
printf '[[sobol]]\npoints = 1000000000\nfriction = [0, 1]\n' >c.toml; run campaign c.toml --dry-run
E
attack "numbers: a campaign of very many runs by a grid" 2 "" <<'E'
python3 -c 'l = ", ".join(f"{i/1000}" for i in range(1000)); print(f"[[grid]]\nfriction = [{l}]\ninertial_number = [{l}]\nstiffness_number = [{l}]")' >c.toml
run campaign c.toml --dry-run
E
attack "units: a power of 999999999" 2 "is not a unit" <<'E'
study s; edit '500 um' '1 m^999999999'; run import s
E
attack "units: 100,000 brackets" 2 "is not a unit" <<'E'
study s; perl -pi -e 's/500 um/"1 ".("(" x 100000)."m".(")" x 100000)/e' s/study.toml; run import s
E
attack "units: a megabyte" 2 "s/study.toml:3:12" <<'E'
study s; perl -pi -e 's/500 um/"1 ".("m" x 1000000)/e' s/study.toml; run import s
E
attack "units: 5000 factors with prefixes in a header" 2 "s/dry_1.csv:1:10" <<'E'
recordings s; perl -pi -e 's/mN m/join(".", ("mm") x 5000)/e' s/dry_1.csv; run import s
E
attack "units: a division by zero" 2 "is not a unit" <<'E'
study s; edit '500 um' '1 m/0'; run import s
E
attack "formulas: 100,000 brackets" 2 "s/study.toml:24:10" <<'E'
own_effect x; perl -pi -e 's/"x"/"\"".("(" x 100000)."torque + a".(")" x 100000)."\""/e' s/study.toml; run effects --study s
E
attack "formulas: a megabyte" 2 "s/study.toml:24:10" <<'E'
own_effect x; perl -pi -e 's/"x"/"\"torque + a".("+a" x 500000)."\""/e' s/study.toml; run effects --study s
E
attack "formulas: an assignment" 2 "'='" <<'E'
own_effect 'torque = a'; run effects --study s
E
attack "formulas: never finite" 2 "" <<'E'
own_effect 'torque + a/(torque - torque)'; printf '[model]\neffects = ["own"]\n' >>s/study.toml; run calibrate s --no-confirm --quiet
E
attack "numbers: an own formula whose square overflows" 2 "guard it" <<'E'
study s; printf '[[effect]]\nname = "own"\nparameter = "a"\nunit = "1"\nlower = -1.0\nupper = 1.0\nmatters = 0.1\nstress_ratio = "stress_ratio*exp(a*normal_stress)"\n' >>s/study.toml; run diagnose s
E
attack "numbers: a curve over 600 decades" 2 "narrower range" <<'E'
run predict --along reduced-pressure=1e-300:1e300 --liquid-content 0.03
E
attack "numbers: a curve of a thousand million points" 2 "--points" <<'E'
run predict --along friction=0:0.3 --points 1000000000
E
