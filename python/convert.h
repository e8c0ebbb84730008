#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace pendular::python {

/// Returns JSON as dicts, lists, strings and numbers of Python.
pybind11::object to_python(const nlohmann::ordered_json& json);

/// Returns a vector or matrix as an array of numpy, which takes over its memory.
pybind11::array to_numpy(Eigen::VectorXd vector);
pybind11::array to_numpy(Eigen::MatrixXd matrix);
pybind11::array to_numpy(const std::vector<double>& values);

}  // namespace pendular::python
