"""The module computes what the command line computes, with the same numbers."""

import json

import pytest

import pendular
from conftest import EXAMPLES, ROOT


def same(result, printed, *without):
    """Compares a result with the JSON of a command, both as the text of JSON has them: NaN, which
    JSON lacks, is null. The number of the format belongs to the file."""
    found = json.loads(json.dumps(nan_as_none(result.to_dict())))
    for key in ("format", *without):
        printed.pop(key, None)
        found.pop(key, None)
    assert found == printed


def nan_as_none(value):
    if isinstance(value, dict):
        return {key: nan_as_none(each) for key, each in value.items()}
    if isinstance(value, list):
        return [nan_as_none(each) for each in value]
    return None if isinstance(value, float) and not abs(value) < float("inf") else value


@pytest.mark.parametrize("name", EXAMPLES)
def test_readings_fit_and_comparison_are_those_of_the_command_line(name, example, command):
    folder = example(name)
    printed = [command("import", folder),
               command("calibrate", folder, "--no-confirm", "--profile"),
               command("compare", folder)]
    study = pendular.open(folder, store=False)
    same(study.readings, printed[0])
    same(study.calibrate(profile=True), printed[1])
    same(study.compare(), printed[2])


@pytest.mark.parametrize("name", EXAMPLES)
def test_diagnosis_and_next_measurement_are_those_of_the_command_line(name, example, command):
    folder = example(name)
    study = pendular.open(folder, store=False)
    try:
        diagnosed = study.diagnose()
    except pendular.InputError as refused:  # too few readings, for example
        with pytest.raises(AssertionError) as told:
            command("diagnose", folder)
        assert str(refused) in str(told.value)
        return
    # Sentences are for people: the module leaves them to the command line.
    printed = command("diagnose", folder)
    for each in printed["proposed"]:
        each["sentence"] = ""
    if printed["confirmed"]:
        printed["confirmed"]["open"] = ""
    same(diagnosed, printed, "sentence", "to_do")
    same(study.next(), command("next", folder), "to_do")


def test_every_example_is_compared():
    assert EXAMPLES == sorted(each.parent.name for each in (ROOT / "examples").glob("*/study.toml"))


def test_change_is_that_of_the_command_line(example, command, tmp_path):
    folder = example("hidden-effect")
    study = pendular.open(folder, store=False, results=tmp_path / "results")
    study.diagnose()
    changed = study.add("wall-friction")
    assert changed.effects == ["wall-friction"]
    dropped = changed.drop("wall-friction")
    assert dropped.effects == []
    printed = command("add", folder, "wall-friction")
    same(changed.change, printed, "rivals")


def test_rivals_of_a_change_are_those_of_the_diagnosis_on_disk(example, command):
    folder = example("hidden-effect")
    command("diagnose", folder)
    file = folder / "out" / "diagnosis.json"
    diagnosis = json.loads(file.read_text())
    diagnosis["confidence_set"] = [["wall-friction"], ["normal-force-gain"]]
    file.write_text(json.dumps(diagnosis))
    changed = pendular.open(folder, store=False).add("wall-friction")
    assert changed.change["rivals"] == [["normal-force-gain"]]


def test_a_change_keeps_the_fidelity_of_the_fit_unless_another_is_given(example):
    folder = example("dry-recordings")

    def fitted():
        return json.loads((folder / "out" / "fit.json").read_text())["fidelity"]["name"]

    pendular.open(folder, fidelity="quick", store=False).calibrate()
    pendular.open(folder, store=False).add("torque-offset")
    assert fitted() == "quick"
    pendular.open(folder, fidelity="standard", store=False).drop("torque-offset")
    assert fitted() == "standard"


def test_one_state_is_that_of_the_command_line(command):
    printed = command("predict", "--friction", 0.12, "--reduced-pressure", 1.5,
                      "--liquid-content", 0.02)
    states = pendular.predict(friction=0.12, reduced_pressure=1.5, liquid_content=0.02,
                              store=False, derivatives=True)
    for name in states.observables:
        assert float(states[name]) == printed[name]["value"]
        assert float(states.stderr(name)) == printed[name]["stderr"]
        for by, slope in printed[name]["derivatives"].items():
            assert float(states.derivative(name, by)) == slope["value"]
    assert float(states.bridge_volume) == printed["bridge_volume"]


def test_simulation_is_that_of_the_command_line(command):
    printed = command("simulate", "--fidelity", "quick", "--beads", 200, "--strain", 0.5,
                      "--friction", 0.2, "--rolling-resistance.coefficient", 0.1)
    run = pendular.simulate(friction=0.2, beads=200, strain=0.5, fidelity="quick", store=False,
                            effects={"rolling-resistance.coefficient": 0.1})
    # How fast the machine was differs.
    fast = [key for key in printed if "per_second" in key or "seconds" in key]
    same(run, printed, *fast)


def test_stored_runs_and_effects_are_those_of_the_command_line(command):
    condition = "friction = 0.09 AND reduced_pressure IS NULL"
    same(pendular.runs(condition, atlas=True),
         command("runs", "list", "--atlas", "--where", condition))
    printed = command("effects")["effects"]
    assert list(pendular.effects.values()) == printed


def test_file_is_understood_as_by_the_command_line(example, command):
    file = example("dry-recordings") / "dry_1.csv"
    view = pendular.import_file(file)
    same(view, command("import", file))
    assert [len(each["line"]) for each in view.series] == [each["rows"]
                                                           for each in view["intervals"]]
