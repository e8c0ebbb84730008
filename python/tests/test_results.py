"""Results as tables, arrays and figures."""

import copy
import pickle

import numpy as np
import pytest

import pendular


def test_a_reading_has_one_key_everywhere(study):
    fit = study.calibrate()
    readings, fitted = study.readings.to_dataframe(), fit.to_dataframe()
    assert readings.index.names == ["file", "step"]
    assert readings.index.is_unique
    assert set(readings.index) == set(fitted.index)
    joined = readings.join(fitted, rsuffix="_fit")
    assert (joined["shear_stress"] == joined["shear_stress_fit"]).all()
    assert ("dry_1.csv", 1) in readings.index


def test_rows_of_a_table_count_as_steps(example):
    study = pendular.open(example("polystyrene"), store=False)
    assert study.readings.keys_of_readings == [
        ("points.csv", 1), ("wet.csv", 1), ("wet.csv", 2), ("wet.csv", 3), ("wet.csv", 4)]
    assert study.calibrate().keys_of_readings == study.readings.keys_of_readings


def test_residuals_are_standardised(study):
    fit = study.calibrate()
    data = fit.to_xarray()
    measured, predicted = data["measured"].values, data["predicted"].values
    # The variance of measured minus predicted value, diagonal of both covariances, from which the
    # normalised residual follows where errors of measurement and model are independent.
    variance = np.diag(fit.measured_covariance + fit.predicted_covariance).reshape(-1, 2)
    np.testing.assert_allclose(fit.residuals, (measured - predicted) / np.sqrt(variance),
                               rtol=1e-9)
    assert data["predicted_covariance"].shape == (24, 2, 24, 2)
    assert data["normal_stress"].attrs["units"] == "Pa"


def test_means_of_many_readings_have_keys_of_no_reading():
    """Of 1000 readings, the fit uses 200 means, which must not be joined to single readings."""
    count, random = 1000, np.random.default_rng(1)
    table = {"normal_stress": np.geomspace(300, 3000, count),
             "stress_ratio": 0.25 + 0.003 * random.standard_normal(count),
             "stress_ratio_stderr": np.full(count, 0.003),
             "solid_fraction": 0.6 + 0.001 * random.standard_normal(count),
             "solid_fraction_stderr": np.full(count, 0.001),
             "inertial_number": np.full(count, 0.01)}
    study = pendular.Study(grains={"diameter": "500 um", "density": "1050 kg/m^3"},
                           readings=table, store=False)
    fit, readings = study.calibrate(), study.readings.to_dataframe()
    assert len(readings) == count and len(fit.keys_of_readings) == 200
    assert len(set(fit.keys_of_readings)) == 200
    assert not set(fit.keys_of_readings) & set(readings.index)
    assert readings.join(fit.to_dataframe(), rsuffix="_fit", how="inner").empty


def test_all_numbers_of_a_dataset_have_units(study):
    states = pendular.predict([0.1, 0.2], store=False)
    for result in (study.readings, study.calibrate(), states):
        for name, variable in result.to_xarray().data_vars.items():
            assert variable.attrs.get("units"), (result, name)


def test_fit_is_a_mapping_of_its_json(study):
    fit = study.calibrate(profile=True)
    friction = fit.parameters["friction"]
    assert fit["parameters"]["friction"]["value"] == friction.value
    assert fit.covariance[0, 0] == pytest.approx(friction.stderr**2)
    lower, upper = fit.intervals["friction"]
    assert lower < friction.value < upper
    assert not fit.believable and fit.reasons
    assert "0.322" in str(friction)


def results_of(study):
    fit = study.calibrate()
    return {
        "readings": study.readings,
        "recording": study.recordings["dry_1.csv"],
        "fit": fit,
        "comparison": study.compare(),
        "diagnosis": study.diagnose(),
        "next": study.next(),
        "prediction": study.predict_readings([1000, 2000], 0.01),
        "effects": pendular.effects,
        "runs": pendular.runs("friction = 0.09", atlas=True),
        "view": pendular.import_file(study.folder / "dry_1.csv"),
    }


def test_results_are_pickled_copied_and_shown(study):
    for name, result in results_of(study).items():
        assert pickle.loads(pickle.dumps(result)) == result, name
        assert copy.deepcopy(result) == result, name
        assert len(result.to_dataframe()) > 0, name
        assert repr(result).startswith("<") and " object at 0x" not in repr(result), name
        assert "<table" in result._repr_html_(), name
        if name in ("readings", "recording", "fit", "comparison", "diagnosis", "prediction"):
            panels = np.atleast_1d(result.plot())
            assert all(panel.has_data() for panel in panels), name
            panels[0].figure.canvas.draw()
            import matplotlib.pyplot

            matplotlib.pyplot.close("all")


def test_a_change_is_shown_as_its_errors_before_and_after(study):
    change = study.add("wall-friction").change
    text = change._repr_html_()
    assert "RMS error of shear stress" in text
    assert f"{change['before']['rms_percent']['shear_stress']:.4g}" in text
    assert f"{change['after']['chi2'] / change['after']['dof']:.4g}" in text


def test_states_have_the_shape_of_their_arguments():
    friction, pressure = np.array([0.06, 0.1, 0.2]), np.array([1.0, 3.0])
    states = pendular.predict(friction, reduced_pressure=pressure, liquid_content=0.02, grid=True,
                              store=False)
    assert states["stress_ratio"].shape == (3, 2)
    data = states.to_xarray()
    assert data["stress_ratio"].dims == ("friction", "reduced_pressure")
    assert data["stress_ratio"].sel(friction=0.1, reduced_pressure=3).item() == \
        states["stress_ratio"][1, 1]
    broadcast = pendular.predict(friction[:, None], reduced_pressure=pressure, liquid_content=0.02,
                                 store=False)
    np.testing.assert_array_equal(broadcast["stress_ratio"], states["stress_ratio"])
    copied = pickle.loads(pickle.dumps(states))
    np.testing.assert_array_equal(copied["solid_fraction"], states["solid_fraction"])
    states.plot("solid_fraction").figure.canvas.draw()
    assert "<table" in states._repr_html_()
    assert len(states.to_dataframe()) == 6


def test_dry_grains_have_no_bridges():
    states = pendular.predict(0.09, store=False)
    assert states.shape == () and 0.2 < states["stress_ratio"] < 0.3
    assert np.isnan(states["distant_force"]) and np.isnan(states.bridge_volume)
    assert "0.25" in str(states.estimate("stress_ratio"))


def test_states_together_are_those_one_by_one():
    pressure = np.linspace(0.6, 9, 70)  # several parts of the work, the last one not full
    together = pendular.predict(0.15, 0.002, pressure, liquid_content=0.01, store=False,
                                derivatives=True, threads=2)
    for k in (0, 31, 32, 69):
        alone = pendular.predict(0.15, 0.002, pressure[k], liquid_content=0.01, store=False,
                                 derivatives=True)
        for name in together.observables:
            # Products of matrices round otherwise than products with vectors. A variance is the
            # small difference of two numbers, which is why its rounding errors show most.
            error = float(alone.stderr(name))
            assert together[name][k] == pytest.approx(float(alone[name]), abs=1e-6 * error)
            assert together.stderr(name)[k] == pytest.approx(error, rel=1e-4)
            assert together.derivative(name, "friction")[k] == pytest.approx(
                float(alone.derivative(name, "friction")), rel=1e-6, abs=1e-6 * error)


def test_states_outside_of_the_range_are_nan_and_told():
    with pytest.warns(pendular.Note, match="1 of 3 states"):
        states = pendular.predict([0.1, 0.95, 0.2], store=False)
    assert list(states.supported) == [True, False, True]
    assert np.isnan(states["stress_ratio"][1]) and "0.95" in states.why_not[1]
    assert np.isfinite(states["stress_ratio"][[0, 2]]).all()


def test_numbers_out_of_range_are_nan_and_told():
    with pytest.warns(pendular.Note, match="1 of 3 states"):
        states = pendular.predict([0.1, np.nan, 0.2], store=False)
    assert list(states.why_not) == ["", "friction nan: 0 to 1 is needed", ""]
    assert np.isnan(states["stress_ratio"][1])
    assert np.isfinite(states["stress_ratio"][[0, 2]]).all()
    with pytest.raises(pendular.InputError, match="^friction nan: 0 to 1 is needed$"):
        pendular.predict(np.nan, store=False)
    with pytest.raises(pendular.InputError, match="^wet grains need either bridge volume or"):
        pendular.predict([0.1, 0.2], reduced_pressure=1.0, store=False)


def test_predicted_readings_are_those_of_the_fit(study):
    study.add("wall-friction")
    study = pendular.open(study.folder, store=False)
    table = study.compare().fit.to_dataframe()
    table = table[~table["fitted"]] if not table["fitted"].all() else table
    predicted = study.predict_readings(1000.0, [0.005, 0.01], 0.0)
    assert predicted.stderr.shape == (2, 2)
    assert predicted.covariance.shape == (4, 4)
    near = table[(table.normal_stress.between(950, 1050)) & (table.liquid_content == 0)]
    assert np.abs(predicted.shear_stress - near.shear_stress.mean()).max() < 30
