"""Readings of a study, and the fit of its model to them."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from pendular._tables import Array, Key, frame, html_table, reading_keys, with_error
from pendular.results import Estimate, Result, column, uncertain

#: Units of a covariance of shear stress and solid fraction.
_SQUARES = {"units": "products of Pa; 1"}


class Readings(Result):
    """Measured readings of a study, in the order of study.toml.

    A reading is a pair of shear stress [Pa] and solid fraction [1] of one state of the sample,
    with the covariance of their errors.
    """

    def __init__(self, json: Dict[str, Any], folder: str) -> None:
        super().__init__(json)
        self._folder = folder

    def __repr__(self) -> str:
        return f"<{len(self.keys_of_readings)} readings{self._left_out()}>"

    def _left_out(self) -> str:
        """Why readings are set aside or, where there is no reading, why the first step gave none."""
        reasons = [each["reason"] for each in self["excluded"]]
        aside = [each for each in reasons if each.startswith("set aside: ")]
        if aside:
            return f", {len(aside)} {aside[0]}"
        steps = [each for each in reasons if each.startswith("step ")]
        return f", {len(steps)} steps excluded: {steps[0]}" if steps and not self["readings"] else ""

    @property
    def keys_of_readings(self) -> List[Key]:
        """Key (file, step) of each reading."""
        entries = self["readings"]
        return reading_keys(
            [each["file"] for each in entries],
            [each["step"] for each in entries],
            [each["line"] for each in entries],
            self._folder,
        )

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each reading, with the index (file, step)."""
        entries = self["readings"]
        columns: Dict[str, Any] = {
            "normal_stress": column(entries, "normal_stress"),
            "inertial_number": column(entries, "inertial_number"),
            "liquid_content": column(entries, "liquid_content"),
            "failure": column(entries, "failure", bool),
        }
        for name in ("shear_stress", "solid_fraction"):
            numbers = uncertain(entries, name)
            columns[name] = numbers["value"]
            columns[name + "_stderr"] = numbers["stderr"]
        columns["covariance"] = column(entries, "covariance")
        for name in ("shear_rate", "height", "time", "replicates"):
            columns[name] = column(entries, name)
        return frame(columns, self.keys_of_readings)

    def to_xarray(self) -> Any:
        """Returns an xarray.Dataset: values (reading, observable) and their covariance
        (reading, observable, observable), units in attrs."""
        import xarray

        entries = self["readings"]
        value = np.stack(
            [uncertain(entries, name)["value"] for name in ("shear_stress", "solid_fraction")], 1
        )
        stderr = np.stack(
            [uncertain(entries, name)["stderr"] for name in ("shear_stress", "solid_fraction")], 1
        )
        covariance = np.zeros((len(entries), 2, 2))
        covariance[:, 0, 0], covariance[:, 1, 1] = stderr[:, 0] ** 2, stderr[:, 1] ** 2
        covariance[:, 0, 1] = covariance[:, 1, 0] = column(entries, "covariance")
        return xarray.Dataset(
            {
                "measured": (("reading", "observable"), value, {"units": "Pa; 1"}),
                "covariance": (("reading", "observable", "observable2"), covariance, _SQUARES),
            },
            coords=_coordinates(entries, self.keys_of_readings),
        )

    def plot(self, axes: Optional[Sequence[Any]] = None) -> List[Any]:
        """Draws stress ratio and solid fraction over the normal stress; returns both axes."""
        return _plot_readings(self.to_dataframe(), axes, "")

    def _repr_html_(self) -> str:
        rows = [
            (
                *key,
                each["normal_stress"],
                each["liquid_content"],
                with_error(each["shear_stress"]["value"], each["shear_stress"]["stderr"]),
                with_error(each["solid_fraction"]["value"], each["solid_fraction"]["stderr"]),
            )
            for key, each in zip(self.keys_of_readings, self["readings"])
        ]
        headings = ("file", "step", "normal stress [Pa]", "liquid content [1]",
                    "shear stress [Pa]", "solid fraction [1]")
        return html_table(headings, rows, self._left_out().lstrip(", "))


def _coordinates(entries: Sequence[Mapping[str, Any]], keys: Sequence[Key]) -> Dict[str, Any]:
    units = {"normal_stress": "Pa", "inertial_number": "1", "liquid_content": "1"}
    coordinates: Dict[str, Any] = {
        "file": ("reading", [key[0] for key in keys]),
        "step": ("reading", [key[1] for key in keys]),
        "observable": ["shear_stress", "solid_fraction"],
        "observable2": ["shear_stress", "solid_fraction"],
    }
    for name, unit in units.items():
        coordinates[name] = ("reading", column(entries, name), {"units": unit})
    return coordinates


def _plot_readings(table: Any, axes: Optional[Sequence[Any]], title: str) -> List[Any]:
    from pendular import _figures

    panels = _figures.axes_of(axes, 2, title)
    _figures.measured_and_predicted(
        panels[0], table, _figures.STRESS_RATIO, "shear_stress", "normal_stress"
    )
    _figures.measured_and_predicted(panels[1], table, _figures.SOLID_FRACTION, "solid_fraction")
    _figures.add_key(panels, table)
    return panels


class Fit(Result):
    """Fit of a study's model to its readings (`pendular calibrate`).

    Arrays over readings are in the order of `keys_of_readings`: dry readings, then wet ones.
    """

    def __init__(self, result: Dict[str, Any], folder: str) -> None:
        super().__init__(result["json"])
        self._arrays = {key: value for key, value in result.items() if key != "json"}
        self._folder = folder

    def __repr__(self) -> str:
        values = ", ".join(f"{name} = {each}" for name, each in self.parameters.items())
        doubt = "" if self.believable else ", not to be believed"
        return f"<Fit: {values}; chi2/dof = {self.chi2:.4g}/{self.dof}{doubt}>"

    @property
    def parameters(self) -> Dict[str, Estimate]:
        """Fitted parameters by name, such as "friction" or "torque-offset.torque"."""
        return {
            name: Estimate(each["value"], each["stderr"], each["unit"])
            for name, each in self["parameters"].items()
        }

    @property
    def intervals(self) -> Dict[str, Tuple[float, float]]:
        """Profile-likelihood intervals of 68 % by name of the parameter, in its unit (with
        `calibrate(profile=True)`)."""
        return {
            name: (each["profile_68_percent"][0], each["profile_68_percent"][1])
            for name, each in self["parameters"].items()
            if "profile_68_percent" in each
        }

    @property
    def covariance(self) -> Array:
        """Covariance matrix of the fitted parameters (k, k), in the products of their units."""
        return np.array(self["parameter_covariance"])

    @property
    def chi2(self) -> float:
        """Misfit chi2 of the fitted readings [1]."""
        return float(self["chi2"])

    @property
    def dof(self) -> int:
        """Degrees of freedom of chi2."""
        return int(self["dof"])

    @property
    def converged(self) -> bool:
        """Whether the search for the best parameters converged."""
        return bool(self["converged"])

    @property
    def believable(self) -> bool:
        """Whether nothing was found that speaks against data or fit (`reasons`)."""
        return bool(self["believable"])

    @property
    def reasons(self) -> List[str]:
        """Reasons not to believe the fit, as sentences."""
        return list(self["reasons"])

    @property
    def keys_of_readings(self) -> List[Key]:
        """Key (file, step) of each reading. Of more than 200 readings, means of readings at similar
        conditions are fitted: they are the entries of the fit, with the numbers -1, -2, ... in
        place of the step and the file of their first reading, and belong to no single reading."""
        entries = self["predictions"]
        if self._arrays["of_means"]:
            files = reading_keys([each["file"] for each in entries], [1] * len(entries),
                                 self._arrays["lines"], self._folder)
            return [(file, -k) for k, (file, _) in enumerate(files, 1)]
        return reading_keys(
            [each["file"] for each in entries],
            [each["step"] for each in entries],
            self._arrays["lines"],
            self._folder,
        )

    @property
    def residuals(self) -> Array:
        """Standardised residuals (n, 2) of shear stress and solid fraction [1]: measured minus
        predicted value over the standard error of this difference."""
        return np.asarray(self._arrays["normalised"])

    @property
    def measured_covariance(self) -> Array:
        """Covariance (2n, 2n) of the errors of the measured values, shear stress [Pa] and solid
        fraction [1] of each reading in turn, with what readings share."""
        return np.asarray(self._arrays["measured_covariance"])

    @property
    def predicted_covariance(self) -> Array:
        """Covariance (2n, 2n) of the errors of the predicted values, ordered alike."""
        return np.asarray(self._arrays["predicted_covariance"])

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each reading, with the index (file, step)."""
        entries = self["predictions"]
        columns: Dict[str, Any] = {
            "normal_stress": column(entries, "normal_stress"),
            "inertial_number": column(entries, "inertial_number"),
            "liquid_content": column(entries, "liquid_content"),
            "failure": column(entries, "failure", bool),
            "fitted": column(entries, "fitted", bool),
        }
        for prefix, part in (("", "measured"), ("predicted_", "predicted")):
            for name in ("shear_stress", "solid_fraction"):
                numbers = uncertain(entries, part, name)
                columns[prefix + name] = numbers["value"]
                columns[prefix + name + "_stderr"] = numbers["stderr"]
        columns["residual_shear_stress"] = self.residuals[:, 0]
        columns["residual_solid_fraction"] = self.residuals[:, 1]
        columns["chi2"] = column(entries, "chi2")
        return frame(columns, self.keys_of_readings)

    def to_xarray(self) -> Any:
        """Returns an xarray.Dataset of measured and predicted values (reading, observable) with
        their whole covariances (reading, observable, reading2, observable2)."""
        import xarray

        entries, n = self["predictions"], len(self["predictions"])
        values = ("reading", "observable")
        whole = ("reading", "observable", "reading2", "observable2")

        def part(name: str) -> Array:
            return np.stack(
                [uncertain(entries, name, each)["value"]
                 for each in ("shear_stress", "solid_fraction")], 1,
            )

        def block(matrix: Array) -> Array:
            return matrix[: 2 * n, : 2 * n].reshape(n, 2, n, 2)

        return xarray.Dataset(
            {
                "measured": (values, part("measured"), {"units": "Pa; 1"}),
                "predicted": (values, part("predicted"), {"units": "Pa; 1"}),
                "residual": (values, self.residuals, {"units": "1"}),
                "measured_covariance": (whole, block(self.measured_covariance), _SQUARES),
                "predicted_covariance": (whole, block(self.predicted_covariance), _SQUARES),
            },
            coords=_coordinates(entries, self.keys_of_readings),
            attrs={"chi2": self.chi2, "dof": self.dof},
        )

    def plot(self, axes: Optional[Sequence[Any]] = None) -> List[Any]:
        """Draws measured and predicted stress ratio and solid fraction over the normal stress;
        returns both axes."""
        doubt = "" if self.believable else " (the fit is not to be used)"
        return _plot_readings(self.to_dataframe(), axes, "Readings and model" + doubt)

    def _repr_html_(self) -> str:
        rows = [
            (name, with_error(each["value"], each["stderr"]), each["unit"])
            for name, each in self["parameters"].items()
        ]
        caption = f"chi2 {self.chi2:.4g}, {self.dof} degrees of freedom"
        text = html_table(("parameter", "value", "unit"), rows, caption)
        return text + "".join(f"<p>{_escaped(each)}</p>" for each in self.reasons)


def _escaped(text: str) -> str:
    from html import escape

    return escape(text)


class Comparison(Result):
    """Comparison of the readings with the fitted model (`pendular compare`)."""

    def __init__(self, json: Dict[str, Any], fit: Fit) -> None:
        super().__init__(json)
        #: The fit that was compared.
        self.fit = fit

    def __repr__(self) -> str:
        return f"<Comparison: chi2 = {self['chi2']:.4g}, {self['dof']} degrees of freedom>"

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame of the parts of chi2 by condition."""
        import pandas

        return pandas.json_normalize(self["by_condition"])

    def plot(self, axes: Optional[Sequence[Any]] = None) -> List[Any]:
        """Draws measured and predicted values (`Fit.plot`)."""
        return self.fit.plot(axes)

    def _repr_html_(self) -> str:
        rms = self["rms_percent"]
        rows = [(name, float(rms[name])) for name in ("shear_stress", "solid_fraction")]
        caption = f"chi2 {self['chi2']:.4g}, {self['dof']} degrees of freedom"
        return html_table(("quantity", "RMS error [%]"), rows, caption)


class Prediction(Result):
    """Readings that a fitted model predicts at any conditions, as the instrument shows them."""

    def __init__(self, arrays: Dict[str, Any], at: Dict[str, Array]) -> None:
        super().__init__({**at, **arrays})

    def __repr__(self) -> str:
        return f"<Prediction of {len(self.shear_stress)} readings>"

    @property
    def shear_stress(self) -> Array:
        """Predicted shear stress (n,) [Pa]."""
        return np.asarray(self["value"][0::2])

    @property
    def solid_fraction(self) -> Array:
        """Predicted solid fraction (n,) [1]."""
        return np.asarray(self["value"][1::2])

    @property
    def covariance(self) -> Array:
        """Covariance (2n, 2n) of the errors, shear stress and solid fraction in turn."""
        return np.asarray(self["covariance"])

    @property
    def stderr(self) -> Array:
        """Standard errors (n, 2) of shear stress [Pa] and solid fraction [1]."""
        return np.asarray(np.sqrt(np.diag(self.covariance)).reshape(-1, 2))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Prediction) and all(
            np.array_equal(self[key], other[key]) for key in self
        )

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each condition."""
        import pandas

        return pandas.DataFrame(
            {
                "normal_stress": self["normal_stress"],
                "inertial_number": self["inertial_number"],
                "liquid_content": self["liquid_content"],
                "shear_stress": self.shear_stress,
                "shear_stress_stderr": self.stderr[:, 0],
                "solid_fraction": self.solid_fraction,
                "solid_fraction_stderr": self.stderr[:, 1],
            }
        )

    def plot(self, axes: Optional[Sequence[Any]] = None) -> List[Any]:
        """Draws predicted stress ratio and solid fraction over the normal stress; returns both
        axes."""
        from pendular import _figures

        panels = _figures.axes_of(axes, 2)
        table = self.to_dataframe()
        for panel, column, label, unit in (
            (panels[0], "shear_stress", _figures.STRESS_RATIO, table["normal_stress"]),
            (panels[1], "solid_fraction", _figures.SOLID_FRACTION, 1.0),
        ):
            drawn = table.assign(**{"predicted_" + column: table[column] / unit,
                                    "predicted_" + column + "_stderr": table[column + "_stderr"] / unit})
            _figures.predicted(panel, drawn, label, column)
        _figures.add_key(panels, table, measured=False)
        return panels

    def _repr_html_(self) -> str:
        return str(self.to_dataframe().to_html(index=False, float_format=lambda x: f"{x:.4g}"))


class Recording(Result):
    """Raw time series of one file in SI units: a mapping of columns to arrays (rows,).

    Columns that the file lacks are missing: time [s], torque [N m], normal_force [N], height [m],
    angular_velocity [rad/s], interval [1], shear_stress [Pa], normal_stress [Pa].
    """

    def __init__(self, columns: Dict[str, Array], file: str) -> None:
        super().__init__(dict(columns))
        self.file = file

    def __repr__(self) -> str:
        return f"<Recording {self.file}: {len(self['time'])} rows>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Recording) and list(self) == list(other) and all(
            np.array_equal(self[key], other[key], equal_nan=True) for key in self
        )

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each row of the file."""
        import pandas

        return pandas.DataFrame(dict(self))

    def _repr_html_(self) -> str:
        return str(self.to_dataframe().to_html(max_rows=10, float_format=lambda x: f"{x:.5g}"))

    def plot(self, axes: Optional[Sequence[Any]] = None) -> List[Any]:
        """Draws torque and height over time; returns both axes."""
        from pendular import _figures

        panels = _figures.axes_of(axes, 2, self.file)
        for panel, names, label in (
            (panels[0], ("torque", "shear_stress"), "torque [N m] or shear stress [Pa]"),
            (panels[1], ("height",), "height [m]"),
        ):
            name = next((each for each in names if each in self), None)
            if name:
                panel.plot(self["time"], self[name], color="#1b1b1b", lw=0.8)
            panel.set_xlabel("time [s]")
            panel.set_ylabel(label)
        return panels
