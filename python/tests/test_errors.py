"""Errors, warnings, Ctrl-C and progress."""

import os
import random
import re
import signal
import threading
import time

import numpy as np
import pytest

import pendular


def test_a_mistake_in_a_file_has_its_place(example):
    folder = example("dry-recordings")
    text = (folder / "study.toml").read_text()
    (folder / "study.toml").write_text(text.replace("diameter =", "diametre =", 1))
    with pytest.raises(pendular.InputError) as caught:
        pendular.open(folder)
    line = 1 + text[: text.index("diameter =")].count("\n")
    assert (caught.value.file, caught.value.line, caught.value.column) == \
        (str(folder / "study.toml"), line, 1)
    assert str(caught.value).startswith(f"{folder / 'study.toml'}:{line}:1: ")
    assert "did you mean 'diameter'" in str(caught.value)
    assert isinstance(caught.value, ValueError)


def test_a_mistake_in_an_argument_has_no_place(study):
    with pytest.raises(pendular.InputError, match="wall-friction") as caught:
        study.add("wall-frition")
    assert caught.value.line is None
    with pytest.raises(pendular.InputError, match="standard"):
        pendular.open(study.folder, fidelity="best")
    with pytest.raises(pendular.InputError, match="nearest state"):
        pendular.predict(friction=0.95, store=False)
    with pytest.raises(pendular.InputError, match="contract|must lie between"):
        pendular.simulate(effects={"rolling-resistance.coefficient": -1}, store=False)


def test_a_missing_fit_is_told(study):
    with pytest.raises(pendular.InputError, match="no calibration"):
        study.compare()
    with pytest.raises(pendular.InputError, match="no calibration"):
        study.predict_readings(1000.0)


def test_progress_goes_to_a_function_and_its_exception_ends_the_work(study):
    events = []
    study.diagnose(progress=lambda *event: events.append(event))
    refits = [event for event in events if event[0] == "refits"]
    assert refits and all(done <= total for _, _, done, total in refits)

    class Enough(Exception):
        pass

    def stop(kind, text, done, total):
        raise Enough

    with pytest.raises(Enough):
        study.diagnose(progress=stop)
    assert study.diagnose().verdict  # a later call is as any other


def test_the_answer_of_earlier_simulations_comes_before_those_that_check_it(example):
    study = pendular.open(example("polystyrene"), fidelity="quick", store=False)
    kinds = []

    class Enough(Exception):
        pass

    def stop(kind, *_):
        kinds.append(kind)
        if kind == "runs":
            raise Enough

    with pytest.raises(Enough):
        study.calibrate(confirm=True, progress=stop)
    assert [kind for kind in kinds if kind != "note"] == ["round", "runs"]


def test_progress_shows_the_bars_of_tqdm(study, capfd):
    study.diagnose(progress=True)
    assert "%" in capfd.readouterr().err


def interrupted(seconds, work):
    """Carries out work(progress=...), sends Ctrl-C some time after its first event, and returns how
    long the work went on after it, and the interrupt; None where the work had ended."""
    sent, timers = [], []

    def send():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    def begin(*_):
        if not timers:
            timers.append(threading.Timer(seconds, send))
            timers[0].start()

    try:
        work(progress=begin)
    except KeyboardInterrupt as interrupt:
        return time.monotonic() - sent[0], interrupt
    finally:
        for timer in timers:
            timer.cancel()
    return None


def stored(store):
    return len(pendular.runs("1", store=store)["runs"])


def test_ctrl_c_ends_simulations_at_any_instant_and_keeps_runs(example, tmp_path):
    folder, store = example("dry-recordings"), tmp_path / "store.sqlite"
    study = pendular.open(folder, fidelity="quick", store=store, threads=2)
    instants = random.Random(1)
    for _ in range(10):
        found = interrupted(instants.uniform(0.0, 0.6),
                            lambda progress: study.calibrate(cold=True, progress=progress))
        assert found is not None
        seconds, interrupt = found
        assert seconds < 5, "far longer than the steps of a simulation take"
        assert any("to continue" in note for note in interrupt.__notes__)
    ended = [stored(store)]

    def stop(kind, text, done, total):
        if kind == "runs" and done > ended[0]:
            ended.append(done)
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        study.calibrate(cold=True, progress=stop)
    assert stored(store) >= ended[-1] > ended[0]
    assert not (folder / "out" / "fit.json").exists()
    assert study.calibrate().converged  # nothing is left of the stop


def test_ctrl_c_ends_a_single_simulation():
    seconds, _ = interrupted(
        0.3, lambda progress: pendular.simulate(fidelity="paper", store=False, progress=progress))
    assert seconds < 5


def test_ctrl_c_ends_many_predictions():
    seconds, _ = interrupted(
        0.05, lambda progress: pendular.predict([0.1] * 200_000, store=False, progress=progress))
    assert seconds < 5


def test_a_time_for_simulations_is_a_number_of_minutes(study):
    for wrong in (-1, float("nan")):
        for work in (study.calibrate, study.diagnose):
            with pytest.raises(pendular.InputError, match="0 or more"):
                work(confirm=wrong)


def test_a_study_begins_with_a_file(example, tmp_path):
    file, folder = example("dry-recordings") / "dry_1.csv", tmp_path / "begun"
    study = pendular.begin(file, folder, store=False)
    assert list(study.recordings) == ["dry_1.csv"]
    assert (folder / "dry_1.csv").read_bytes() == file.read_bytes()
    assert "GUESS" in (folder / "study.toml").read_text()
    (folder / "dry_1.csv").unlink()
    (folder / "study.toml").write_text("mine")
    with pytest.raises(pendular.InputError, match="study.toml is there already"):
        pendular.begin(file, folder)
    assert (folder / "study.toml").read_text() == "mine"
    assert not (folder / "dry_1.csv").exists()


def test_readings_say_why_there_is_none(example):
    """All rows of a file in one interval, while the speed changes."""
    folder = example("dry-recordings")
    import pandas

    for file in folder.glob("dry_*.csv"):
        table = pandas.read_csv(file, comment="#")
        table = table.drop(columns=[each for each in table if each.startswith("Interval")])
        table.loc[:, [each for each in table if each.startswith("Angular")]] *= (
            10 ** np.linspace(0, 1, len(table)))[:, None]
        table.to_csv(file, index=False)
    readings = pendular.open(folder, store=False).readings
    assert len(readings["readings"]) == 0
    assert re.match(r"<0 readings, \d+ steps excluded: step 1: ", repr(readings))
    assert "excluded: step 1" in readings._repr_html_()


def test_a_study_begins_with_a_folder_of_files(example, tmp_path):
    source = example("dry-recordings")
    files = tmp_path / "exports"
    files.mkdir()
    for name in ("dry_2.csv", "dry_1.csv"):
        (files / name).write_bytes((source / name).read_bytes())
    (files / "notes.txt").write_text("Washed with ethanol.\n")
    with pytest.warns(pendular.Note, match="notes.txt"):
        study = pendular.begin(files, tmp_path / "begun", store=False,
                               grains={"density": "1050 kg/m^3"},
                               cell={"inner_radius": "21 mm", "outer_radius": "45 mm"})
    assert list(study.recordings) == ["dry_1.csv", "dry_2.csv"]
    assert len(study.readings["readings"]) == 6
    assert not (study.folder / "notes.txt").exists()
    text = (study.folder / "study.toml").read_text()
    assert "GUESS: no diameter was found in the file" in text and "2500" not in text
    named = pendular.begin([files / "dry_2.csv"], tmp_path / "named", store=False)
    assert list(named.recordings) == ["dry_2.csv"]
    # A file that is named must be readable, as the command line has it.
    with pytest.raises(pendular.InputError, match="notes.txt"):
        pendular.begin([files / "dry_2.csv", files / "notes.txt"], tmp_path / "none")
    # The guessed cell makes the beads denser than any packing: it says why nothing is left.
    assert "0 readings, 3 set aside: the solid fraction" in repr(named.readings)
    unreadable = tmp_path / "unreadable"
    unreadable.mkdir()
    for name in ("a.txt", "b.txt"):
        (unreadable / name).write_bytes((files / "notes.txt").read_bytes())
    with pytest.raises(pendular.InputError, match="no file can begin a study"):
        pendular.begin(unreadable, tmp_path / "none")
    (tmp_path / "empty").mkdir()
    with pytest.raises(pendular.InputError, match="no file"):
        pendular.begin(tmp_path / "empty", tmp_path / "none")
    assert not (tmp_path / "none").exists()
