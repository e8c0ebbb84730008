"""Effects on the instrument, written as functions of Python, to try an idea."""

from __future__ import annotations

import inspect
from typing import Any, Callable, Dict, Mapping, Optional

from pendular import _core

#: Function from the true state of the cell to what the instrument shows otherwise.
Show = Callable[..., Mapping[str, float]]


def instrument_effect(*, unit: str, lower: float, upper: float, neutral: float = 0.0,
                      smallest_of_interest: Optional[float] = None,
                      name: Optional[str] = None) -> Callable[[Show], Any]:
    """Makes an effect of a function, for `Study.with_effects`.

        @pendular.instrument_effect(unit="N m s/rad", lower=-1e-3, upper=1e-3)
        def speed_drag(drag, torque, angular_velocity):
            "Drag in proportion to the speed of the lid."
            return {"torque": torque + drag * angular_velocity}

    The first argument is the parameter, which fits determine, in `unit`; at `neutral` the effect
    must change nothing. The others are quantities of the true state of the cell, by name: torque
    [N m], normal_force [N], height [m], angular_velocity [rad/s], liquid_content [1], bead_volume
    [m^3], time [s], inner_radius, outer_radius, diameter [m], density [kg/m^3]. The function
    returns what the instrument shows of torque, normal_force, height and angular_velocity, as far
    as it differs. It is called for one state at a time, from several threads, and must depend on
    its arguments alone.

    unit: SI unit of the parameter; lower, upper, neutral: in this unit
    smallest_of_interest: smallest size that matters (default: a tenth of the range)
    """

    def decorate(function: Show) -> Any:
        signature = list(inspect.signature(function).parameters.values())
        parameter, others = signature[0].name, [each.name for each in signature[1:]]
        everything = any(each.kind is inspect.Parameter.VAR_KEYWORD for each in signature)

        def show(**state: float) -> Dict[str, float]:
            chosen = state if everything else {key: state[key] for key in [parameter, *others]}
            return dict(function(**chosen))

        size = (upper - lower) / 10 if smallest_of_interest is None else smallest_of_interest
        called = name or function.__name__.replace("_", "-")
        return _core.WrittenEffect(called, inspect.getdoc(function) or called, parameter, unit,
                                   lower, upper, neutral, size, show)

    return decorate
