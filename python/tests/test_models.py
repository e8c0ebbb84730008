"""Studies from memory, effects by functions, and the model as a plain function."""

import shutil

import numpy as np
import pytest

import pendular

GRAINS = {"diameter": "500 um", "density": "1050 kg/m^3", "youngs_modulus": "3.3 GPa",
          "poisson_ratio": 0.3}
CELL = {"inner_radius": "21 mm", "outer_radius": "45 mm", "bead_mass": "60 g"}


def test_a_study_from_memory_is_the_one_on_disk(example):
    """The dry readings of an example, handed over as a table, give the fit of their file."""
    folder = example("polystyrene")
    import pandas

    toml = (folder / "study.toml").read_text()
    grains = toml[toml.index("[grains]"):toml.index("[liquid]")]
    (folder / "study.toml").write_text(grains + '[[readings]]\nfile = "points.csv"\n')
    on_disk = pendular.open(folder, store=False)
    points = pandas.read_csv(folder / "points.csv", comment="#")
    made = pendular.Study(grains=GRAINS, readings=points, store=False)
    assert made.calibrate().parameters == on_disk.calibrate().parameters


def test_tables_of_the_module_are_read_back(study):
    """A table that `to_dataframe` returned, its errors named NAME_stderr, is a table of readings."""
    table = study.readings.to_dataframe()
    dry = table[table.liquid_content == 0]
    columns = ["normal_stress", "inertial_number", "liquid_content", "shear_stress",
               "shear_stress_stderr", "solid_fraction", "solid_fraction_stderr"]
    made = pendular.Study(grains=GRAINS, readings=dry[columns], store=False)
    found = made.readings.to_dataframe()
    np.testing.assert_allclose(found["shear_stress"], dry["shear_stress"], rtol=1e-12)
    np.testing.assert_allclose(found["inertial_number"], dry["inertial_number"], rtol=1e-12)


def test_recordings_from_memory(study, tmp_path):
    recording = study.recordings["dry_1.csv"]
    made = pendular.Study(
        grains=GRAINS, cell=CELL, store=False,
        recordings=[{"file": recording.to_dataframe(), "liquid_content": 0.0},
                    {"file": study.folder / "dry_2.csv", "liquid_content": 0.0}])
    table, original = made.readings.to_dataframe(), study.readings.to_dataframe()
    np.testing.assert_allclose(table.loc["recording_1.csv", "shear_stress"],
                               original.loc["dry_1.csv", "shear_stress"], rtol=1e-9)
    kept = made.save(tmp_path / "kept")
    assert len(kept.readings["readings"]) == len(table)


def test_recordings_of_one_name_are_all_kept(example, tmp_path):
    """Files of one name in two folders, one named as the table of readings, and a pattern."""
    folder = example("dry-recordings")
    for new, old in (("lab1/dry.csv", 1), ("lab2/dry.csv", 2), ("lab2/readings.csv", 3)):
        (tmp_path / new).parent.mkdir(exist_ok=True)
        shutil.copy(folder / f"dry_{old}.csv", tmp_path / new)
    table = {"normal_stress": [1000.0], "stress_ratio": [0.25], "stress_ratio_stderr": [0.003],
             "solid_fraction": [0.6], "solid_fraction_stderr": [0.001], "inertial_number": [0.01]}
    made = pendular.Study(
        grains=GRAINS, cell={**CELL, "bead_mass": "20 g"}, store=False, readings=table,
        recordings=[{"file": tmp_path / "lab1/dry.csv", "liquid_content": 0.0},
                    {"file": str(tmp_path / "lab2/*.csv"), "liquid_content": 0.0}])
    assert list(made.recordings) == ["dry.csv", "dry_2.csv", "readings.csv"]
    for name, old in zip(made.recordings, (1, 2, 3)):
        assert (made.folder / name).read_bytes() == (folder / f"dry_{old}.csv").read_bytes()
    assert ("readings_2.csv", 1) in made.readings.keys_of_readings
    with pytest.raises(pendular.InputError, match="there is no file"):
        pendular.Study(grains=GRAINS, cell=CELL, recordings=[{"file": str(tmp_path / "no*.csv")}])


def test_all_tables_of_study_toml_can_be_given(example):
    file = example("dry-recordings") / "dry_1.csv"
    recordings = [{"file": file, "liquid_content": 0.0, "intervals": {"preshear": ["99"]}}]
    made = pendular.Study(
        grains=GRAINS, cell={**CELL, "bead_mass": "20 g"}, recordings=recordings,
        import_={"least_strain": 2.0}, scatter={"shear_stress": 0.02, "solid_fraction": 0.001},
        instrument={"class": "rheometer", "torque-gain": "0.5 %"},
        direct=[{"effect": "torque-gain", "value": 1.0, "error": 0.01}],
        rig={"normal_stress": ["0.1 kPa", "5 kPa"], "inertial_number": [0.003, 0.05],
             "direct": [{"effect": "torque-gain", "error": 0.01}]}, store=False)
    assert len(made.readings["readings"]) == 3
    # Each table is read: an unknown key in it is refused.
    for name, table in {"import_": {"wrong": 1}, "scatter": {"wrong": 1},
                        "direct": [{"wrong": 1}], "instrument": {"wrong": 1}}.items():
        with pytest.raises(pendular.InputError, match="wrong"):
            pendular.Study(grains=GRAINS, cell=CELL, recordings=recordings, **{name: table})


@pendular.instrument_effect(unit="N m", lower=-0.1, upper=0.1, smallest_of_interest=1e-4)
def my_torque_offset(offset, torque):
    """Drag of the bearing adds a constant torque."""
    return {"torque": torque + offset}


def test_an_effect_by_a_function_is_the_built_in_one(example):
    """The same map, as a function of Python and as an effect of the catalogue."""
    folder = example("dry-recordings")
    tried = pendular.open(folder, store=False).with_effects(my_torque_offset)
    assert tried.effects == ["my-torque-offset"]
    fit = tried.calibrate()
    built_in = pendular.open(folder, store=False).add("torque-offset")
    expected = built_in.compare().fit.parameters
    assert fit.parameters["my-torque-offset.offset"].value == pytest.approx(
        expected["torque-offset.torque"].value, rel=1e-6)
    assert fit.parameters["friction"].value == pytest.approx(expected["friction"].value, rel=1e-6)
    assert "my-torque-offset" not in (folder / "study.toml").read_text()


def test_a_study_with_functions_is_neither_saved_nor_changed(example, tmp_path):
    folder = example("dry-recordings")
    before = (folder / "study.toml").read_bytes()
    tried = pendular.open(folder, store=False).with_effects(my_torque_offset)
    for work in (lambda: tried.add("torque-gain"), lambda: tried.drop("my-torque-offset"),
                 lambda: tried.save(tmp_path / "saved")):
        with pytest.raises(pendular.InputError, match="my-torque-offset") as caught:
            work()
        assert caught.value.line is None
    assert (folder / "study.toml").read_bytes() == before
    assert not (tmp_path / "saved").exists()


def test_an_error_in_a_function_is_the_error_of_the_call(example):
    @pendular.instrument_effect(unit="N m", lower=-0.1, upper=0.1)
    def broken(offset, torque):
        return {"torque": torque / (offset * 0)}

    @pendular.instrument_effect(unit="N m", lower=-0.1, upper=0.1)
    def unknown(offset, torque):
        return {"torgue": torque}

    folder = example("dry-recordings")
    with pytest.raises(ZeroDivisionError):
        pendular.open(folder, store=False).with_effects(broken).calibrate()
    with pytest.raises(pendular.InputError, match="torgue"):
        pendular.open(folder, store=False).with_effects(unknown).calibrate()


def test_forward_has_the_derivatives_of_its_values(study):
    f = pendular.forward(study)
    assert f.names == ["friction"]
    p = np.array([0.12])
    step = 1e-5
    quotient = (f(p + step) - f(p - step)) / (2 * step)
    # Central differences err as step^2: far below this tolerance.
    np.testing.assert_allclose(f.jacobian(p)[:, 0], quotient, rtol=1e-4, atol=1e-7)
    # 24 readings, two values each, and the three direct measurements of the study.
    assert f.measured.shape == f(p).shape == (51,)
    assert f.covariance(p).shape == f.measured_covariance.shape == (51, 51)


def test_a_wrong_number_of_parameters_is_refused(study):
    f = pendular.forward(study)
    for wrong in ([], [0.1, 0.2], np.full(1000, 0.1)):
        for work in (f, f.jacobian, f.covariance, f.fit, f.whitened):
            with pytest.raises(pendular.InputError, match=r"has 1 parameter \(friction\), "):
                work(wrong)
    for which in (-1, 1):
        with pytest.raises(pendular.InputError, match="none has the number"):
            f._core.profile(f.start, which, 1.0)
    with pytest.raises(pendular.InputError):  # a mistake is no unlikely state
        f.whitened(f.start).log_likelihood([0.1, 0.1])


@pendular.instrument_effect(unit="N", lower=-1000, upper=1000)
def force_offset(offset, normal_force):
    return {"normal_force": normal_force + offset}


def test_impossible_states_have_no_likelihood(study):
    f = study.with_effects(force_offset).forward()
    with pytest.raises(pendular.ImpossibleState, match="normal force"):
        f([0.12, 900.0])  # the readings show a few newtons
    assert f.whitened([0.12, 0.0]).log_likelihood([0.12, 900.0]) == -np.inf


@pendular.instrument_effect(unit="N m", lower=-1, upper=1)
def nothing(size, torque):
    return {"torque": torque}


def test_a_fit_that_does_not_converge_is_an_error(study):
    f = study.with_effects(nothing).forward()
    with pytest.raises(RuntimeError, match="did not converge"):
        f.fit()
    with pytest.raises(RuntimeError, match="did not converge"):
        f.profile("friction")


def test_scipy_finds_the_fit_of_the_program(study):
    from scipy.optimize import least_squares

    changed = study.add("wall-friction")
    f = changed.forward()
    estimates, covariance, chi2 = f.fit()
    best = np.array([each.value for each in estimates.values()])
    residuals = f.whitened(best)
    found = least_squares(residuals, f.start, jac=residuals.jacobian, x_scale="jac",
                          bounds=tuple(f.bounds.T))
    np.testing.assert_allclose(found.x, best, atol=1e-3 * np.sqrt(np.diag(covariance)).min())
    assert 2 * found.cost == pytest.approx(chi2, rel=1e-6)


def test_lmfit_finds_the_fit_of_the_program(study):
    lmfit = pytest.importorskip("lmfit")
    f = study.add("wall-friction").forward()
    estimates, covariance, chi2 = f.fit()
    residuals = f.whitened([each.value for each in estimates.values()])
    start = lmfit.Parameters()
    keys = [name.replace("-", "_").replace(".", "_") for name in f.names]  # lmfit wants identifiers
    for key, value, (lower, upper) in zip(keys, f.start, f.bounds):
        start.add(key, value=value, min=lower, max=upper)
    found = lmfit.minimize(lambda p: residuals(list(p.valuesdict().values())), start,
                           scale_covar=False)
    assert found.chisqr == pytest.approx(chi2, rel=1e-5)
    for key, each in zip(keys, estimates.values()):
        assert found.params[key].value == pytest.approx(each.value, abs=0.02 * each.stderr)
        # lmfit differentiates by differences, and through the map of its bounds.
        assert found.params[key].stderr == pytest.approx(each.stderr, rel=0.05)
    intervals = lmfit.conf_interval(lmfit.Minimizer(
        lambda p: residuals(list(p.valuesdict().values())), start, scale_covar=False), found,
        sigmas=[1])
    lower, upper = f.profile("friction")
    ends = [value for _, value in intervals[keys[0]]]
    # lmfit's F test with 49 degrees of freedom and chi2/dof below 1 is another criterion than a
    # rise of chi2 by 1: the ratio of their widths is sqrt(chi2/dof), up to some per cent.
    ratio = (ends[-1] - ends[0]) / (upper - lower)
    assert ratio == pytest.approx((chi2 / (len(f.measured) - len(f.names))) ** 0.5, rel=0.1)


def test_iminuit_finds_the_fit_of_the_program(study):
    iminuit = pytest.importorskip("iminuit")
    f = study.add("wall-friction").forward()
    estimates, _, chi2 = f.fit()
    residuals = f.whitened([each.value for each in estimates.values()])
    minuit = iminuit.Minuit(lambda p: float(np.sum(residuals(p) ** 2)), f.start, name=f.names)
    minuit.errordef, minuit.limits = iminuit.Minuit.LEAST_SQUARES, f.bounds
    minuit.migrad()
    minuit.minos()
    assert minuit.valid and minuit.fval == pytest.approx(chi2, rel=1e-5)
    for name, each in estimates.items():
        assert minuit.values[name] == pytest.approx(each.value, abs=0.02 * each.stderr)
        # Minos follows the rise of chi2 by 1, as `profile` does.
        lower, upper = f.profile(name)
        below, above = minuit.params[name].merror
        assert above - below == pytest.approx(upper - lower, rel=0.02)


def test_profile_is_the_error_where_the_model_is_linear(study):
    f = study.add("wall-friction").forward()
    estimates, _, _ = f.fit()
    for name, each in estimates.items():
        lower, upper = f.profile(name)
        # chi2 of a parabola rises by 1 over one standard error; the model is linear to some per
        # cent over it.
        assert upper - lower == pytest.approx(2 * each.stderr, rel=0.1)


def test_calibration_has_a_profile_of_every_parameter(study):
    fit = study.add("wall-friction").calibrate(profile=True)
    assert list(fit.intervals) == list(fit.parameters) == ["friction", "wall-friction.coefficient"]
    for name, (lower, upper) in fit.intervals.items():
        each = fit.parameters[name]
        assert lower < each.value < upper
        assert upper - lower == pytest.approx(2 * each.stderr, rel=0.1)


def test_posterior_is_the_fit_where_the_model_is_linear(study):
    pytest.importorskip("emcee")
    f = study.add("wall-friction").forward()
    estimates, _, _ = f.fit()
    sampled = pendular.posterior(f, walkers=16, steps=600, burn_in=150, seed=2)
    independent = len(sampled.samples) / sampled.autocorrelation.max()
    for name, each in estimates.items():
        found = sampled.parameters[name]
        # Four standard errors of the mean of the samples; of the deviation, with the few per cent
        # by which the model is not linear.
        assert found.value == pytest.approx(each.value, abs=4 * each.stderr / independent**0.5)
        assert found.stderr == pytest.approx(each.stderr, rel=0.1 + 4 / (2 * independent) ** 0.5)
    assert "<table" in sampled._repr_html_() and len(sampled.to_dataframe()) == len(sampled.samples)
    assert all(panel.has_data() for panel in sampled.plot())
