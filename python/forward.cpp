#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/fit.h"
#include "calib/fit/parameter_errors.h"
#include "calib/model/study_model_space.h"
#include "data/input_error.h"
#include "python/bindings.h"
#include "python/convert.h"
#include "python/long_call.h"
#include "python/open_study.h"

namespace py = pybind11;

namespace pendular::python {
namespace {

/// Model of all readings of a study, dry ones first, and of its direct measurements.
struct Forward {
    std::unique_ptr<StudyModelSpace> space;  ///< holds what the model refers to
    std::shared_ptr<const Model> model;
    Measured measured;

    Forward(const OpenStudy& opened, const Listener& listener) {
        const StudyInput& input = opened.input();
        demand_readings(input.study, input.measurements);
        const std::vector<Reading> readings = readings_to_fit(input.measurements);
        check_range(readings, input.study, opened.settings().fidelity);
        const SessionOptions session{
            .fidelity = opened.settings().fidelity, .store = opened.store(), .listener = listener};
        space = std::make_unique<StudyModelSpace>(input.study, pendular::conditions_of(readings),
                                                  session.fidelity,
                                                  runs_for_diagnosis(input.study, session));
        model = space->with({});
        measured = stack(readings, input.study.direct());
    }
};

py::list parameters_of(const Forward& forward) {
    const ParameterBounds range = allowed(*forward.model);
    py::list list;
    for (std::size_t k = 0; k < forward.model->parameters().size(); ++k) {
        const Parameter& parameter = forward.model->parameters()[k];
        const auto i = static_cast<Eigen::Index>(k);
        list.append(py::make_tuple(parameter.name, parameter.unit, range.lower(i), range.upper(i),
                                   parameter.start));
    }
    return list;
}

/// Returns values of the parameters, in the order of the model.
/// @throws InputError if there are more or fewer values than parameters
const Eigen::VectorXd& checked(const Forward& forward, const Eigen::VectorXd& values) {
    std::vector<std::string> names;
    for (const Parameter& parameter : forward.model->parameters())
        names.push_back(parameter.name);
    if (values.size() != std::ssize(names)) {
        throw InputError(fmt::format("the model has {} parameter{} ({}), {} {} given", names.size(),
                                     names.size() == 1 ? "" : "s", fmt::join(names, ", "),
                                     values.size(), values.size() == 1 ? "was" : "were"));
    }
    return values;
}

/// Returns the prediction at parameters, computed without the lock of the interpreter.
Prediction predicted(const Forward& forward, const Eigen::VectorXd& parameters,
                     PredictionPart part) {
    checked(forward, parameters);
    const py::gil_scoped_release release;
    return forward.model->predict(parameters, part);
}

/// @throws std::runtime_error where the search does not converge
Fit fitted(const Forward& forward, const Eigen::VectorXd& start) {
    Fit found = fit(*forward.model, forward.measured, checked(forward, start));
    if (!found.converged)
        throw std::runtime_error(fmt::format("the fit did not converge: {}", found.message));
    return found;
}

py::tuple fit_tuple(Fit found) {
    return py::make_tuple(to_numpy(std::move(found.parameters)),
                          to_numpy(std::move(found.covariance)), found.chi2);
}

/// @throws InputError if the model has no parameter of the number `which`
std::pair<double, double> profile(const Forward& forward, const Eigen::VectorXd& start,
                                  Eigen::Index which, double rise) {
    if (which < 0 || which >= checked(forward, start).size())
        throw InputError(fmt::format("the model has {} parameters, and none has the number {}",
                                     start.size(), which));
    return profile_interval(*forward.model, forward.measured, fitted(forward, start), which, rise);
}

}  // namespace

void bind_forward(py::module_& module) {
    py::class_<Forward>(module, "Forward")
        .def(py::init([](const OpenStudy& opened, const py::object& on_event) {
            return long_call(on_event, [&](const auto&, const auto& listener) {
                return std::make_unique<Forward>(opened, listener);
            });
        }))
        .def("parameters", parameters_of)
        .def("measured", [](const Forward& self) { return to_numpy(self.measured.value); })
        .def("measured_covariance",
             [](const Forward& self) { return to_numpy(self.measured.covariance); })
        .def("values",
             [](const Forward& self, const Eigen::VectorXd& parameters) {
                 return to_numpy(predicted(self, parameters, PredictionPart::values).value);
             })
        .def("jacobian",
             [](const Forward& self, const Eigen::VectorXd& parameters) {
                 return to_numpy(predicted(self, parameters, PredictionPart::slopes).jacobian);
             })
        .def(
            "covariance",
            [](const Forward& self, const Eigen::VectorXd& parameters) {
                return to_numpy(predicted(self, parameters, PredictionPart::covariance).covariance);
            })
        .def("fit",
             [](const Forward& self, const Eigen::VectorXd& start) {
                 return fit_tuple(long_call(
                     py::none(), [&](const auto&, const auto&) { return fitted(self, start); }));
             })
        .def("profile", [](const Forward& self, const Eigen::VectorXd& start, Eigen::Index which,
                           double rise) {
            return long_call(py::none(), [&](const auto&, const auto&) {
                return profile(self, start, which, rise);
            });
        });
}

}  // namespace pendular::python
