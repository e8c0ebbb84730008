"""A study's model as a plain function of its parameters, for scipy, lmfit, emcee and iminuit."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from pendular import _core
from pendular._tables import Array, Vector, html_table
from pendular.results import Estimate


class Forward:
    """Model of all readings of a study as a function of its parameters.

    `f(p)` returns the predicted values (m,): shear stress [Pa] and solid fraction [1] of each
    reading in turn, dry readings first, then the direct measurements. p is an array (k,) in the
    order of `names`, in `units`. An emulator, trained on earlier simulations, predicts; nothing
    is simulated. Any thread may call it.
    """

    def __init__(self, opened: Any) -> None:
        self._core = _core.Forward(opened, None)
        rows = self._core.parameters()
        #: Names of the parameters, the intergranular friction first.
        self.names: List[str] = [each[0] for each in rows]
        #: SI units of the parameters.
        self.units: List[str] = [each[1] for each in rows]
        #: Ranges (k, 2) within which the model can predict.
        self.bounds = np.array([each[2:4] for each in rows])
        #: Values (k,) at which a fit starts.
        self.start = np.array([each[4] for each in rows])
        #: Measured values (m,), ordered as the predicted ones.
        self.measured: Array = self._core.measured()
        #: Covariance (m, m) of the errors of the measured values.
        self.measured_covariance: Array = self._core.measured_covariance()

    def __repr__(self) -> str:
        return f"<Forward of {', '.join(self.names)}: {len(self.measured)} values>"

    def __call__(self, parameters: Vector) -> Array:
        """Predicted values (m,). Raises InputError where p has another length, ImpossibleState
        where no true state of the cell would make the instrument show the conditions of the
        readings."""
        return np.asarray(self._core.values(parameters))

    def jacobian(self, parameters: Vector) -> Array:
        """Derivatives (m, k) of the predicted values."""
        return np.asarray(self._core.jacobian(parameters))

    def covariance(self, parameters: Vector) -> Array:
        """Covariance (m, m) of the errors of the predicted values: noise of the simulations,
        errors of corrections, and the expected discrepancy of the model."""
        return np.asarray(self._core.covariance(parameters))

    def whitened(self, at: Vector) -> Whitened:
        """Returns residuals with the weights of the parameters `at`, for least squares."""
        return Whitened(self, at)

    def fit(self, start: Optional[Vector] = None) -> Tuple[Dict[str, Estimate], Array, float]:
        """Least squares of all readings by the program's own search: the parameters, their
        covariance (k, k) and chi2.

        The covariance is (J'J)^-1 of the whitened residuals. It lacks what `Study.calibrate` adds
        to its standard errors: for a scatter that is known from few replicates only, and for a
        model that is less exact than expected. Raises RuntimeError where the search does not
        converge."""
        values, covariance, chi2 = self._core.fit(self.start if start is None else start)
        estimates = {
            name: Estimate(float(values[k]), float(np.sqrt(covariance[k, k])), self.units[k])
            for k, name in enumerate(self.names)
        }
        return estimates, covariance, chi2

    def profile(self, name: str, rise: float = 1.0) -> Tuple[float, float]:
        """Both ends of the profile-likelihood interval of a parameter: chi2, minimised over all
        other parameters, rises by at most `rise` (1: 68 %, 3.84: 95 %). Raises RuntimeError where
        the search for the minimum does not converge."""
        lower, upper = self._core.profile(self.start, self.names.index(name), rise)
        return lower, upper


class Whitened:
    """Residuals L^-1 (measured - predicted) with L L' the covariance of measured minus predicted
    values at fixed parameters, as in the program's fits."""

    def __init__(self, forward: Forward, at: Vector) -> None:
        self.forward = forward
        self._factor = np.linalg.cholesky(forward.measured_covariance + forward.covariance(at))

    def __call__(self, parameters: Vector) -> Array:
        """Residuals (m,) in standard errors [1]; their sum of squares is chi2."""
        return self._solved(self.forward.measured - self.forward(parameters))

    def jacobian(self, parameters: Vector) -> Array:
        """Derivatives (m, k) of the residuals."""
        return -self._solved(self.forward.jacobian(parameters))

    def log_likelihood(self, parameters: Vector) -> float:
        """-chi2/2 within the bounds of the parameters, else -infinity, as for parameters at which
        the conditions of the readings are impossible (`ImpossibleState`)."""
        p, bounds = np.asarray(parameters, dtype=float), self.forward.bounds
        if not (np.all(p >= bounds[:, 0]) and np.all(p <= bounds[:, 1])):
            return -np.inf
        try:
            return float(-0.5 * np.sum(self(p) ** 2))
        except _core.ImpossibleState:
            return -np.inf

    def _solved(self, right: Array) -> Array:
        return np.asarray(np.linalg.solve(self._factor, right))


class Posterior:
    """Samples of the posterior of a model's parameters."""

    def __init__(self, names: List[str], units: List[str], samples: Array,
                 autocorrelation: Array) -> None:
        self.names, self.units = names, units
        #: Samples (n, k), the burn-in left out.
        self.samples = samples
        #: Integrated autocorrelation times (k,) of the chains, in steps of a walker.
        self.autocorrelation = autocorrelation

    def __repr__(self) -> str:
        return "<Posterior: " + ", ".join(f"{n} = {e}" for n, e in self.parameters.items()) + ">"

    @property
    def parameters(self) -> Dict[str, Estimate]:
        """Mean and standard deviation of each parameter."""
        mean, deviation = self.samples.mean(0), self.samples.std(0)
        return {
            name: Estimate(float(mean[k]), float(deviation[k]), self.units[k])
            for k, name in enumerate(self.names)
        }

    def interval(self, name: str, level: float = 0.68) -> Tuple[float, float]:
        """Central interval of a parameter that holds the share `level` of the samples."""
        column = self.samples[:, self.names.index(name)]
        lower, upper = np.quantile(column, [(1 - level) / 2, (1 + level) / 2])
        return float(lower), float(upper)

    def to_dataframe(self) -> Any:
        """Returns a pandas.DataFrame, a row for each sample."""
        import pandas

        return pandas.DataFrame(self.samples, columns=self.names)

    def plot(self, axes: Optional[Sequence[Any]] = None) -> List[Any]:
        """Draws the distribution of each parameter, with its central interval of 68 %; returns the
        axes."""
        from pendular import _figures

        panels = _figures.axes_of(axes, len(self.names))
        for k, (panel, name, unit) in enumerate(zip(panels, self.names, self.units)):
            panel.hist(self.samples[:, k], bins=60, density=True, color=_figures.MODEL, alpha=0.55)
            for end in self.interval(name):
                panel.axvline(end, color=_figures.EXPLAINING, linestyle="--", lw=1)
            panel.set_xlabel(name if unit == "1" else f"{name} [{unit}]")
            panel.set_ylabel("probability density")
        return panels

    def _repr_html_(self) -> str:
        rows = [(name, str(each), *self.interval(name)) for name, each in self.parameters.items()]
        return html_table(("parameter", "mean and standard deviation", "16 %", "84 %"), rows)


def posterior(forward: Forward, *, walkers: int = 16, steps: int = 1000, burn_in: int = 200,
              seed: int = 1, progress: bool = False) -> Posterior:
    """Samples the posterior of the parameters with emcee: a uniform prior within their bounds, and
    the likelihood of the least-squares fit, with its weights. Where the model is linear within the
    errors, mean and standard deviation are those of the fit.

    Source: Foreman-Mackey et al., Publ. Astron. Soc. Pac. 125 (2013) 306.
    """
    import emcee

    estimates, covariance, _ = forward.fit()
    best = np.array([each.value for each in estimates.values()])
    residuals = forward.whitened(best)
    random = np.random.RandomState(seed)
    near = random.multivariate_normal(best, 0.25 * covariance, size=walkers)
    begin = np.clip(near, forward.bounds[:, 0], forward.bounds[:, 1])
    sampler = emcee.EnsembleSampler(walkers, len(best), residuals.log_likelihood)
    sampler.random_state = random.get_state()
    sampler.run_mcmc(begin, burn_in + steps, progress=progress, skip_initial_state_check=True)
    return Posterior(
        forward.names, forward.units, sampler.get_chain(discard=burn_in, flat=True),
        np.asarray(sampler.get_autocorr_time(discard=burn_in, quiet=True)),
    )
