#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <memory>
#include <utility>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/fit.h"
#include "calib/fit/parameter_errors.h"
#include "calib/model/study_model_space.h"
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
        const SessionOptions session{.fidelity = opened.settings().fidelity,
                                     .store = opened.settings().store.get(),
                                     .listener = listener};
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

py::tuple fit_dict(Fit found) {
    return py::make_tuple(to_numpy(std::move(found.parameters)),
                          to_numpy(std::move(found.covariance)), found.chi2, found.converged);
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
                 Eigen::VectorXd value;
                 {
                     const py::gil_scoped_release release;
                     value = self.model->predict(parameters, PredictionPart::values).value;
                 }
                 return to_numpy(std::move(value));
             })
        .def("jacobian",
             [](const Forward& self, const Eigen::VectorXd& parameters) {
                 Eigen::MatrixXd jacobian;
                 {
                     const py::gil_scoped_release release;
                     jacobian = self.model->predict(parameters, PredictionPart::slopes).jacobian;
                 }
                 return to_numpy(std::move(jacobian));
             })
        .def("covariance",
             [](const Forward& self, const Eigen::VectorXd& parameters) {
                 Eigen::MatrixXd covariance;
                 {
                     const py::gil_scoped_release release;
                     covariance =
                         self.model->predict(parameters, PredictionPart::covariance).covariance;
                 }
                 return to_numpy(std::move(covariance));
             })
        .def("fit",
             [](const Forward& self, const Eigen::VectorXd& start) {
                 std::optional<Fit> found;
                 {
                     const py::gil_scoped_release release;
                     found = fit(*self.model, self.measured, start);
                 }
                 return fit_dict(std::move(*found));
             })
        .def("profile", [](const Forward& self, const Eigen::VectorXd& start, Eigen::Index which,
                           double rise) {
            const py::gil_scoped_release release;
            return profile_interval(*self.model, self.measured,
                                    fit(*self.model, self.measured, start), which, rise);
        });
}

}  // namespace pendular::python
