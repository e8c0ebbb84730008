"""Steady shear predicted at many states at once."""

from __future__ import annotations

import os
import warnings
from functools import lru_cache
from typing import Any, Dict, List, Mapping, Optional, Sequence, Union

import numpy as np

from pendular import _core
from pendular._notify import Note, Progress, told
from pendular._tables import Array
from pendular.results import Estimate

Numbers = Any  #: number, sequence or array of numbers
Store = Union[None, bool, str, "os.PathLike[str]"]

_QUANTITIES = ("friction", "inertial_number", "reduced_pressure", "bridge_volume",
               "liquid_content")
_INPUTS = ("friction", "log_inertial_number", "inverse_reduced_pressure", "bridge_volume")


def store_file(store: Store) -> Optional[str]:
    """Returns what `_core` takes for a store: None for the user's, "" for none, or a path."""
    if store is None or store is True:
        return None
    return "" if store is False else os.fspath(store)


def cores() -> int:
    """Returns the number of cores that this process may use; where the system does not tell, that
    of the machine."""
    if hasattr(os, "sched_getaffinity"):  # not on macOS and Windows
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class States:
    """Observables of steady shear at states, with standard errors.

    All arrays have the shape `shape`, that of the arguments broadcast against each other or, with
    `grid`, their outer product. Numbers are NaN where a state has no such observable (bridges of
    dry grains) or cannot be predicted (`why_not`).
    """

    def __init__(self, result: Dict[str, Any], at: Dict[str, Array], dims: Sequence[str],
                 coordinates: Dict[str, Array]) -> None:
        #: Arguments by name, each of the shape `shape` [1].
        self.at = at
        self.shape = next(iter(at.values())).shape
        self.dims = tuple(dims)
        #: Names of the observables.
        self.observables: List[str] = list(result["observables"])
        self._value, self._stderr = result["value"], result["stderr"]
        self._slopes = list(result["slopes"])
        self._why_not = list(result["why_not"])
        self._coordinates = coordinates
        #: Volume of a bridge over a^3 [1], given or from the liquid content; NaN: dry.
        self.bridge_volume = result["bridge_volume"].reshape(self.shape)

    def __repr__(self) -> str:
        return f"<States of shape {self.shape}: {', '.join(self.observables)}>"

    def __getitem__(self, observable: str) -> Array:
        """Predicted values of an observable, such as "stress_ratio"."""
        values: Array = self._value[:, self._column(observable)].reshape(self.shape)
        return values

    def stderr(self, observable: str) -> Array:
        """Standard errors of an observable."""
        errors: Array = self._stderr[:, self._column(observable)].reshape(self.shape)
        return errors

    def derivative(self, observable: str, by: str) -> Array:
        """Derivatives of an observable with respect to "friction", "log_inertial_number",
        "inverse_reduced_pressure" or "bridge_volume" (with `derivatives=True`)."""
        if not self._slopes:
            raise ValueError("predict(..., derivatives=True) computes derivatives")
        slopes: Array = self._slopes[_INPUTS.index(by)][:, self._column(observable)]
        return slopes.reshape(self.shape)

    def estimate(self, observable: str, *index: int) -> Estimate:
        """Returns one value with its standard error."""
        return Estimate(float(self[observable][index]), float(self.stderr(observable)[index]))

    @property
    def supported(self) -> Array:
        """Whether each state could be predicted."""
        return np.array([not why for why in self._why_not]).reshape(self.shape)

    @property
    def why_not(self) -> Array:
        """Why each state could not be predicted; an empty text where it could."""
        return np.array(self._why_not, dtype=object).reshape(self.shape)

    def _called(self, observable: str) -> str:
        """Name in tables: a liquid content that was given keeps its name."""
        return "predicted_" + observable if observable in self.at else observable

    def _column(self, observable: str) -> int:
        try:
            return self.observables.index(observable)
        except ValueError:
            raise KeyError(
                f"no observable '{observable}'; known are {', '.join(self.observables)}"
            ) from None

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each state."""
        import pandas

        columns: Dict[str, Any] = {name: each.ravel() for name, each in self.at.items()}
        for name in self.observables:
            columns[self._called(name)] = self[name].ravel()
            columns[self._called(name) + "_stderr"] = self.stderr(name).ravel()
        return pandas.DataFrame(columns)

    def to_xarray(self) -> Any:
        """Returns an xarray.Dataset with variables NAME and NAME_stderr; all are
        dimensionless."""
        import xarray

        variables: Dict[str, Any] = {}
        for name in self.observables:
            called = self._called(name)
            variables[called] = (self.dims, self[name], {"units": "1"})
            variables[called + "_stderr"] = (self.dims, self.stderr(name), {"units": "1"})
        coordinates: Dict[str, Any] = {
            name: (name, each, {"units": "1"}) for name, each in self._coordinates.items()
        }
        for name, each in self.at.items():
            if name not in coordinates:
                coordinates[name] = (self.dims, each, {"units": "1"})
        return xarray.Dataset(variables, coords=coordinates)

    def plot(self, observable: str = "stress_ratio", axes: Optional[Sequence[Any]] = None) -> Any:
        """Draws an observable: a line with a band of one standard error over one varied quantity,
        a map over two."""
        from pendular import _figures

        panel = _figures.axes_of(axes, 1)[0]
        varied = list(self._coordinates) or [
            name for name, each in self.at.items() if each.size and np.ptp(each) > 0
        ]
        label = observable.replace("_", " ")
        if len(self.shape) == 2 and len(varied) == 2:
            mesh = panel.pcolormesh(self.at[varied[1]], self.at[varied[0]], self[observable],
                                    shading="nearest")
            panel.figure.colorbar(mesh, ax=panel, label=label)
            panel.set_xlabel(varied[1].replace("_", " "))
            panel.set_ylabel(varied[0].replace("_", " "))
            return panel
        if len(varied) != 1:
            raise ValueError("plot draws states along one quantity, or on a grid of two")
        x, y = self.at[varied[0]].ravel(), self[observable].ravel()
        order, error = np.argsort(x), self.stderr(observable).ravel()
        panel.plot(x[order], y[order], color=_figures.MODEL)
        panel.fill_between(x[order], (y - error)[order], (y + error)[order], alpha=0.25,
                           color=_figures.MODEL, lw=0)
        panel.set_xlabel(varied[0].replace("_", " "))
        panel.set_ylabel(label)
        return panel

    def _repr_html_(self) -> str:
        table = self.to_dataframe()[[*self.at, "stress_ratio", "stress_ratio_stderr",
                                     "solid_fraction", "solid_fraction_stderr"]]
        return str(table.to_html(max_rows=20, index=False, float_format=lambda x: f"{x:.4g}"))


@lru_cache(maxsize=4)
def _predictor(fidelity: str, stiffness_number: Optional[float], store: Optional[str],
               _stamp: Any) -> Any:
    return _core.StatePredictor(fidelity, stiffness_number, store)


def _stamp_of(store: Optional[str]) -> Any:
    """What changes when the runs do on which a predictor is trained."""
    files = [store] if store else [] if store == "" else [str(_core.standard_store())]
    stamps: List[Any] = [os.environ.get("PENDULAR_ATLAS")]
    for file in files:
        for each in (file, file + "-wal"):
            try:
                found = os.stat(each)
                stamps.append((each, found.st_mtime_ns, found.st_size))
            except OSError:
                stamps.append((each, None, None))
    return tuple(stamps)


def predict(friction: Numbers = 0.09, inertial_number: Numbers = 0.0,
            reduced_pressure: Optional[Numbers] = None, bridge_volume: Optional[Numbers] = None,
            liquid_content: Optional[Numbers] = None, *, grid: bool = False,
            stiffness_number: Optional[float] = None, derivatives: bool = False,
            fidelity: str = "standard", threads: Optional[int] = None, store: Store = None,
            progress: Progress = None) -> States:
    """Predicts steady shear from the simulations of atlas and store, without a new simulation.

    friction: friction coefficient between grains [1]
    inertial_number: shear rate times sqrt(m/(a s22)) [1]; 0: quasi-static limit
    reduced_pressure: P* = a^2 s22/F0 of wet grains [1]; None: dry grains
    bridge_volume: volume of a bridge over a^3 [1], or
    liquid_content: liquid volume over grain volume [1]
    grid: predict at all combinations of the arguments rather than broadcasting them
    stiffness_number: (E/((1 - nu^2) s22))^(2/3) [1] (default: that of the fidelity)
    derivatives: also compute derivatives, which takes three times as long

    The arguments are numbers or arrays. A single state that the simulations do not cover raises
    InputError, which names the nearest state within, and so does a single number outside of its
    range; of many, such states are NaN, `why_not` says why, and a warning how many.
    """
    given = {
        name: np.asarray(value, dtype=float)
        for name, value in zip(_QUANTITIES, (friction, inertial_number, reduced_pressure,
                                             bridge_volume, liquid_content))
        if value is not None
    }
    coordinates: Dict[str, Array] = {}
    if grid:
        coordinates = {name: each.ravel() for name, each in given.items() if each.ndim > 0}
        meshes = dict(zip(coordinates, np.meshgrid(*coordinates.values(), indexing="ij")))
        given = {name: meshes.get(name, each) for name, each in given.items()}
    arrays = dict(zip(given, np.broadcast_arrays(*given.values())))
    shape = next(iter(arrays.values())).shape
    named = store_file(store)
    predictor = _predictor(fidelity, stiffness_number, named, _stamp_of(named))
    flat: List[Optional[Array]] = [
        np.ascontiguousarray(arrays[name]).ravel() if name in arrays else None
        for name in _QUANTITIES
    ]
    count = cores() if threads is None else threads
    with told(progress) as listener:
        result = predictor.states(listener, derivatives, count, *flat)
    dims = list(coordinates) or [f"state_{k}" if len(shape) > 1 else "state"
                                 for k in range(len(shape))]
    states = States(result, arrays, dims, coordinates)
    if shape == () and not states.supported:
        # Raises InputError with the nearest state that can be predicted.
        predictor.at(*(None if each is None else float(each[0]) for each in flat))
    _warn_of(states)
    return states


def _warn_of(states: States) -> None:
    left_out = [why for why in states.why_not.ravel() if why]
    if left_out:
        warnings.warn(
            f"{len(left_out)} of {states.why_not.size} states cannot be predicted and are NaN; the "
            f"first: {left_out[0]}",
            Note, stacklevel=3,
        )


