"""Single simulations, stored ones, and files of measurements."""

from __future__ import annotations

import os
from typing import Dict, Mapping, Optional, Sequence, Union

from pendular import _core
from pendular._notify import Progress, told
from pendular.catalogues import FileView, Run, Runs
from pendular.states import Store, store_file

#: Size and stress of the sample, which effects with units need: the program's defaults.
_SCALE = {"diameter": 500e-6, "density": 1050.0, "normal_stress": 1000.0,
          "surface_tension": 20.6e-3}


def simulate(friction: float = 0.09, inertial_number: Optional[float] = None,
             reduced_pressure: Optional[float] = None, bridge_volume: float = 2e-3, *,
             stiffness_number: Optional[float] = None, beads: Optional[int] = None,
             strain: Optional[float] = None, seed: int = 1,
             effects: Optional[Mapping[str, Union[float, str]]] = None,
             scale: Optional[Mapping[str, float]] = None, fidelity: str = "standard",
             threads: int = 1, store: Store = None, progress: Progress = None) -> Run:
    """Simulates one state of steady shear, and keeps the run in the store.

    friction: friction coefficient between grains [1]
    inertial_number: shear rate times sqrt(m/(a s22)) [1] (default: the lowest of the fidelity)
    reduced_pressure: P* = a^2 s22/F0 of wet grains [1]; None: dry grains
    bridge_volume: volume of a bridge over a^3 [1]
    stiffness_number, beads, strain: as `pendular simulate` (default: those of the fidelity)
    effects: values by "EFFECT.PARAMETER", numbers in SI units or texts such as "3 uN"
    scale: diameter [m], density [kg/m^3], normal_stress [Pa] and surface_tension [N/m], which
        effects with units need
    threads: of this simulation; equal numbers give identical results

    Raises InputError for a state that cannot be simulated, SimulationError where the simulation
    fails. Ctrl-C ends it.
    """
    texts: Dict[str, str] = {
        name: value if isinstance(value, str) else repr(float(value))
        for name, value in (effects or {}).items()
    }
    with told(progress) as listener:
        return Run(_core.simulate(
            listener, store_file(store), threads, fidelity, friction, inertial_number,
            stiffness_number, reduced_pressure, bridge_volume, beads, strain, seed, texts,
            {**_SCALE, **(scale or {})},
        ))


def runs(condition: str = "", *, atlas: bool = False,
         store: Union[None, str, "os.PathLike[str]"] = None) -> Runs:
    """Returns the stored simulations that satisfy an SQL condition on the columns, such as
    "friction = 0.09 AND reduced_pressure IS NULL".

    atlas: those that come with the program, rather than those of the store
    """
    return Runs(_core.runs(condition, atlas, None if store is None else os.fspath(store)))


def import_file(file: Union[str, "os.PathLike[str]"], *, layout: str = "", encoding: str = "",
                decimal: str = "", sheet: str = "", columns: Sequence[str] = ()) -> FileView:
    """Reads a file of measurements of any layout, and returns what it is understood as.

    layout, encoding, decimal, sheet: where the file does not tell by its content
    columns: names and units of all columns, such as "Torque [mN m]", where the file has none
    """
    json, series = _core.import_file(os.fspath(file), layout, encoding, decimal, sheet,
                                     list(columns))
    return FileView(json, series)
