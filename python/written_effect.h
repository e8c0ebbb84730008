#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "sim/catalogue/effect.h"

namespace pendular::python {

/// Effect on the instrument that a user writes as a function of Python. Numbers are in `unit`.
struct WrittenInPython {
    std::string name, summary, parameter, unit;
    double lower = 0, upper = 1, neutral = 0, smallest_of_interest = 0;
    /// Called with the true state of the cell and the parameter, as keyword arguments in SI units;
    /// returns a dict of the quantities that the instrument shows otherwise.
    pybind11::object show;
};

/// Returns the effect for the catalogue. It may be called, copied and destroyed by any thread, with
/// or without the lock of the interpreter.
Effect effect_from(const WrittenInPython& written);

}  // namespace pendular::python
