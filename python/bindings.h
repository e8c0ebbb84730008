#pragma once

#include <pybind11/pybind11.h>

// One function for each part of the module, each in a file of its own.

namespace pendular::python {

void bind_errors(pybind11::module_& module);
void bind_studies(pybind11::module_& module);
void bind_states(pybind11::module_& module);
void bind_simulations(pybind11::module_& module);
void bind_effects(pybind11::module_& module);
void bind_forward(pybind11::module_& module);
void bind_files(pybind11::module_& module);

}  // namespace pendular::python
