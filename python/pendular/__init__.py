"""Rheometer recordings of beads beside a discrete-element model.

    import pendular

    study = pendular.open("examples/hidden-effect")
    fit = study.calibrate()
    print(fit.parameters["friction"])
    print(study.diagnose().effects)

All numbers are in SI units, angles in rad; a "stderr" is one standard error. What the module
computes is what the command line computes, with the same numbers.
"""

from typing import TYPE_CHECKING, Any

from pendular._core import ImpossibleState, InputError, Interrupted, SimulationError, __version__
from pendular._notify import Note
from pendular._forward import Forward, Posterior, Whitened, posterior
from pendular.catalogues import Effects, FileView, Run, Runs
from pendular.fits import Comparison, Fit, Prediction, Readings, Recording
from pendular.results import Estimate
from pendular.simulations import import_file, runs, simulate
from pendular.states import States, predict
from pendular.study import PathLike, Study, begin, open
from pendular.verdicts import Change, Diagnosis, NextMeasurement
from pendular._written import instrument_effect

if TYPE_CHECKING:
    effects: Effects

__all__ = [
    "Change",
    "Comparison",
    "Diagnosis",
    "Effects",
    "Estimate",
    "FileView",
    "Fit",
    "Forward",
    "ImpossibleState",
    "InputError",
    "Interrupted",
    "NextMeasurement",
    "Note",
    "Posterior",
    "Prediction",
    "Readings",
    "Recording",
    "Run",
    "Runs",
    "SimulationError",
    "States",
    "Study",
    "Whitened",
    "begin",
    "effects",
    "forward",
    "import_file",
    "instrument_effect",
    "open",
    "posterior",
    "predict",
    "runs",
    "simulate",
    "__version__",
]


def forward(study: "Study | PathLike") -> Forward:
    """Returns a study's model as a plain function of its parameters, with Jacobian and covariance.

    study: an open study, or its folder
    """
    return (study if isinstance(study, Study) else open(study)).forward()


def __getattr__(name: str) -> Any:
    """Makes the catalogue `pendular.effects` when it is first asked for."""
    if name == "effects":
        from pendular import _core

        globals()[name] = Effects(_core.effects())
        return globals()[name]
    raise AttributeError(f"module 'pendular' has no attribute '{name}'")
