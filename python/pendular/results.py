"""Results of a study: what the command line writes as JSON, with tables and figures.

A result is a read-only mapping of the command's JSON (docs/reference/json.md), so that
`fit["chi2"]` and `fit.chi2` are the same number. Results hold numbers alone: they can be pickled
and copied, and need neither the study nor its files.
"""

from __future__ import annotations

import copy
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from pendular._tables import Array, Key, frame, html_table, reading_keys, with_error


class Estimate(NamedTuple):
    """Number with its standard error; both have the unit `unit` ("1": dimensionless)."""

    value: float
    stderr: float
    unit: str = "1"

    def __str__(self) -> str:
        unit = "" if self.unit == "1" else f" {self.unit}"
        return with_error(self.value, self.stderr) + unit


class Result(Mapping[str, Any]):
    """Result of a command: a read-only mapping of its JSON."""

    def __init__(self, json: Dict[str, Any]) -> None:
        self._json = json

    def __getitem__(self, key: str) -> Any:
        return self._json[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._json)

    def __len__(self) -> int:
        return len(self._json)

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._json == other._json  # type: ignore[attr-defined]

    __hash__ = None  # type: ignore[assignment]

    def to_dict(self) -> Dict[str, Any]:
        """Returns a copy of the JSON."""
        return copy.deepcopy(self._json)


def _uncertain(entries: Sequence[Mapping[str, Any]], *path: str) -> Dict[str, Array]:
    """Columns of numbers with standard errors, {"value": .., "stderr": ..} at `path`."""
    found: List[Any] = list(entries)
    for name in path:
        found = [each[name] for each in found]
    return {
        "value": np.array([each["value"] for each in found], dtype=float),
        "stderr": np.array([each["stderr"] for each in found], dtype=float),
    }


def _column(entries: Sequence[Mapping[str, Any]], name: str, kind: Any = float) -> Array:
    return np.array([each[name] for each in entries], dtype=kind)


class Readings(Result):
    """Measured readings of a study, in the order of study.toml.

    A reading is a pair of shear stress [Pa] and solid fraction [1] of one state of the sample,
    with the covariance of their errors.
    """

    def __init__(self, json: Dict[str, Any], folder: str) -> None:
        super().__init__(json)
        self._folder = folder

    def __repr__(self) -> str:
        return f"<{len(self.keys_of_readings)} readings>"

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
            "normal_stress": _column(entries, "normal_stress"),
            "inertial_number": _column(entries, "inertial_number"),
            "liquid_content": _column(entries, "liquid_content"),
            "failure": _column(entries, "failure", bool),
        }
        for name in ("shear_stress", "solid_fraction"):
            numbers = _uncertain(entries, name)
            columns[name] = numbers["value"]
            columns[name + "_stderr"] = numbers["stderr"]
        columns["covariance"] = _column(entries, "covariance")
        for name in ("shear_rate", "height", "time", "replicates"):
            columns[name] = _column(entries, name)
        return frame(columns, self.keys_of_readings)

    def to_xarray(self) -> Any:
        """Returns an xarray.Dataset: values (reading, observable) and their covariance
        (reading, observable, observable), units in attrs."""
        import xarray

        entries = self["readings"]
        value = np.stack(
            [_uncertain(entries, name)["value"] for name in ("shear_stress", "solid_fraction")], 1
        )
        stderr = np.stack(
            [_uncertain(entries, name)["stderr"] for name in ("shear_stress", "solid_fraction")], 1
        )
        covariance = np.zeros((len(entries), 2, 2))
        covariance[:, 0, 0], covariance[:, 1, 1] = stderr[:, 0] ** 2, stderr[:, 1] ** 2
        covariance[:, 0, 1] = covariance[:, 1, 0] = _column(entries, "covariance")
        return xarray.Dataset(
            {
                "measured": (("reading", "observable"), value, {"units": "Pa; 1"}),
                "covariance": (("reading", "observable", "observable2"), covariance),
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
        return html_table(headings, rows)


def _coordinates(entries: Sequence[Mapping[str, Any]], keys: Sequence[Key]) -> Dict[str, Any]:
    units = {"normal_stress": "Pa", "inertial_number": "1", "liquid_content": "1"}
    coordinates: Dict[str, Any] = {
        "file": ("reading", [key[0] for key in keys]),
        "step": ("reading", [key[1] for key in keys]),
        "observable": ["shear_stress", "solid_fraction"],
        "observable2": ["shear_stress", "solid_fraction"],
    }
    for name, unit in units.items():
        coordinates[name] = ("reading", _column(entries, name), {"units": unit})
    return coordinates


def _plot_readings(table: Any, axes: Optional[Sequence[Any]], title: str) -> List[Any]:
    from pendular import _figures

    panels = _figures.axes_of(axes, 2, title)
    _figures.measured_and_predicted(
        panels[0], table, _figures.STRESS_RATIO, "shear_stress", "normal_stress"
    )
    _figures.measured_and_predicted(panels[1], table, _figures.SOLID_FRACTION, "solid_fraction")
    panels[0].legend(frameon=False, fontsize="small")
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
        """Key (file, step) of each reading."""
        entries = self["predictions"]
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
            "normal_stress": _column(entries, "normal_stress"),
            "inertial_number": _column(entries, "inertial_number"),
            "liquid_content": _column(entries, "liquid_content"),
            "failure": _column(entries, "failure", bool),
            "fitted": _column(entries, "fitted", bool),
        }
        for prefix, part in (("", "measured"), ("predicted_", "predicted")):
            for name in ("shear_stress", "solid_fraction"):
                numbers = _uncertain(entries, part, name)
                columns[prefix + name] = numbers["value"]
                columns[prefix + name + "_stderr"] = numbers["stderr"]
        columns["residual_shear_stress"] = self.residuals[:, 0]
        columns["residual_solid_fraction"] = self.residuals[:, 1]
        columns["chi2"] = _column(entries, "chi2")
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
                [_uncertain(entries, name, each)["value"]
                 for each in ("shear_stress", "solid_fraction")], 1,
            )

        def block(matrix: Array) -> Array:
            return matrix[: 2 * n, : 2 * n].reshape(n, 2, n, 2)

        return xarray.Dataset(
            {
                "measured": (values, part("measured"), {"units": "Pa; 1"}),
                "predicted": (values, part("predicted"), {"units": "Pa; 1"}),
                "residual": (values, self.residuals, {"units": "1"}),
                "measured_covariance": (whole, block(self.measured_covariance)),
                "predicted_covariance": (whole, block(self.predicted_covariance)),
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


class Diagnosis(Result):
    """Which physical effect a study's model lacks (`pendular diagnose`), without the sentences
    that the command prints."""

    def __repr__(self) -> str:
        return f"<Diagnosis: {self.verdict}{': ' if self.effects else ''}{', '.join(self.effects)}>"

    @property
    def verdict(self) -> str:
        """Result in one word: "nothing-missing", "inconclusive", "missing", "indistinguishable",
        "unknown" or "suspect-measurement"."""
        return str(self["verdict"])

    @property
    def effects(self) -> List[str]:
        """Names of the effects at which the verdict points."""
        return list(self["effects"])

    @property
    def complete(self) -> bool:
        """Whether what is named explains the readings."""
        return bool(self["complete"])

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each tested effect, indexed by its name."""
        import pandas

        rows = [
            {
                "effect": each["effect"],
                "parameter": each["parameter"],
                "unit": each["unit"],
                "estimate": each["estimate"]["value"],
                "estimate_stderr": each["estimate"]["stderr"],
                "predicted_reduction": each["predicted_reduction"],
                "refitted_reduction": each["refitted_reduction"],
                "p": each["p"],
                "decision": each["decision"],
            }
            for each in self["scan"]
        ]
        return pandas.DataFrame(rows).set_index("effect")

    def plot(self, axes: Optional[Sequence[Any]] = None) -> List[Any]:
        """Draws by how much chi2 would fall with each effect, the largest first."""
        from pendular import _figures

        panels = _figures.axes_of(axes, 1, self.verdict)
        scan = sorted(self["scan"], key=lambda each: -(each["predicted_reduction"] or 0))[:12]
        _figures.bars_across(
            panels[0],
            [each["effect"] for each in scan],
            [each["predicted_reduction"] or 0 for each in scan],
            r"predicted reduction of $\chi^2$",
        )
        return panels

    def _repr_html_(self) -> str:
        rows = [
            (each["effect"], each["parameter"],
             with_error(each["estimate"]["value"], each["estimate"]["stderr"]), each["unit"],
             each["p"], each["decision"])
            for each in self["scan"]
        ]
        caption = f"{self.verdict}: {', '.join(self.effects)}" if self.effects else self.verdict
        return html_table(("effect", "parameter", "estimate", "unit", "p", "decision"), rows, caption)


class NextMeasurement(Result):
    """Measurement that would tell most (`pendular next`)."""

    def __repr__(self) -> str:
        return f"<NextMeasurement between {', '.join(self.rivals)}>"

    @property
    def rivals(self) -> List[str]:
        """Models to tell apart; one: its parameters are to become more precise."""
        return list(self["rivals"])

    @property
    def steps(self) -> List[Dict[str, Any]]:
        """Points to measure: each with `point` (SI units) and the number `readings`."""
        if "series" in self and self["series"]["steps"]:
            return list(self["series"]["steps"])
        return [{"point": self["point"], "readings": self["repeats"]}] if "point" in self else []

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each point to measure."""
        import pandas

        return pandas.DataFrame([{**each["point"], "readings": each["readings"]}
                                 for each in self.steps])

    def _repr_html_(self) -> str:
        columns = ["readings", *dict.fromkeys(key for each in self.steps for key in each["point"])]
        rows = [[{**each["point"], "readings": each["readings"]}.get(name) for name in columns]
                for each in self.steps]
        return html_table(columns, rows, "between " + ", ".join(self.rivals))


class Change(Result):
    """Fits before and after an effect was added or dropped (`pendular add`, `pendular drop`)."""

    def __repr__(self) -> str:
        return f"<Change: {'written' if self.written else 'not written'}>"

    @property
    def written(self) -> bool:
        """Whether study.toml was changed; it is not where the new fit does not converge."""
        return bool(self["written"])


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


class Run(Result):
    """One simulation (`pendular simulate`): observables as {"value", "stderr"}, and what repeats
    it."""

    def __repr__(self) -> str:
        return f"<Run: stress ratio {self['stress_ratio']['value']:.4g}>"

    def observable(self, name: str) -> Estimate:
        """Returns an observable, such as "stress_ratio", with its standard error."""
        return Estimate(self[name]["value"], self[name]["stderr"])

    def _repr_html_(self) -> str:
        rows = [
            (name, with_error(each["value"], each["stderr"]))
            for name, each in self.items()
            if isinstance(each, dict) and set(each) == {"value", "stderr"}
        ]
        return html_table(("observable", "value"), rows)


class Runs(Result):
    """Stored simulations (`pendular runs list`)."""

    def __repr__(self) -> str:
        return f"<{len(self['runs'])} runs>"

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each run, indexed by its number in the store.
        Observables have columns NAME and NAME_stderr."""
        import pandas

        rows = []
        for run in self["runs"]:
            row: Dict[str, Any] = {}
            for name, each in run.items():
                if isinstance(each, dict) and set(each) == {"value", "stderr"}:
                    row[name], row[name + "_stderr"] = each["value"], each["stderr"]
                else:
                    row[name] = each
            rows.append(row)
        return pandas.DataFrame(rows).set_index("id") if rows else pandas.DataFrame(rows)

    def _repr_html_(self) -> str:
        names = ("friction", "inertial_number", "reduced_pressure", "stress_ratio",
                 "solid_fraction")
        rows = [
            [run["id"]] + [run[name]["value"] if isinstance(run[name], dict) else run[name]
                           for name in names]
            for run in self["runs"][:50]
        ]
        more = len(self["runs"]) - len(rows)
        return html_table(("run", *names), rows, f"and {more} more" if more else "")


class Effects(Result):
    """Catalogue of the effects that a model may lack (`pendular effects`), by name."""

    def __init__(self, json: Dict[str, Any]) -> None:
        super().__init__({each["name"]: each for each in json["effects"]})

    def __repr__(self) -> str:
        return f"<{len(self)} effects: {', '.join(self)}>"

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each parameter of an effect."""
        import pandas

        rows = [
            {"effect": name, "acts_on": each["acts_on"], **parameter}
            for name, each in self.items()
            for parameter in each["parameters"]
        ]
        return pandas.DataFrame(rows).set_index("effect")

    def _repr_html_(self) -> str:
        rows = [
            (name, each["acts_on"], ", ".join(f"{p['name']} [{p['unit']}]"
                                              for p in each["parameters"]), each["summary"])
            for name, each in self.items()
        ]
        return html_table(("effect", "acts on", "parameters", "summary"), rows)


class FileView(Result):
    """What one file of measurements is understood as (`pendular import FILE`)."""

    def __init__(self, json: Dict[str, Any], series: List[Dict[str, Array]]) -> None:
        super().__init__(json)
        #: Columns of each interval in SI units, with `line` in the file.
        self.series = series

    def __repr__(self) -> str:
        return f"<FileView {self['file']}: {self['layout']}, {len(self.series)} intervals>"

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame of all rows in SI units, with the index (interval, line)."""
        import pandas

        parts = [
            pandas.DataFrame(series).assign(number=interval["number"], role=interval["role"])
            for interval, series in zip(self["intervals"], self.series)
        ]
        return pandas.concat(parts).set_index(["number", "line"])

    def _repr_html_(self) -> str:
        rows = [(each["number"], each["name"], each["role"], each["rows"], each["why"])
                for each in self["intervals"]]
        caption = f"{self['file']}: layout {self['layout']}"
        return html_table(("interval", "name", "role", "rows", "why"), rows, caption)
