#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "data/input_error.h"
#include "python/bindings.h"
#include "python/convert.h"
#include "python/long_call.h"
#include "python/store.h"
#include "workflow/json/prediction.h"
#include "workflow/predicted_states.h"

namespace py = pybind11;

namespace pendular::python {
namespace {

/// Array of numbers, converted where it is not one of doubles in the order of C.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Value `k` of an optional array.
std::optional<double> entry(const std::optional<Numbers>& values, std::size_t k) {
    return values ? std::optional(values->data()[k]) : std::nullopt;
}

std::vector<RequestedState> requested_states(const Numbers& friction,
                                             const Numbers& inertial_number,
                                             const std::optional<Numbers>& reduced_pressure,
                                             const std::optional<Numbers>& bridge_volume,
                                             const std::optional<Numbers>& liquid_content) {
    std::vector<RequestedState> requested(static_cast<std::size_t>(friction.size()));
    for (std::size_t k = 0; k < requested.size(); ++k)
        requested[k] = {.friction = friction.data()[k],
                        .inertial_number = inertial_number.data()[k],
                        .reduced_pressure = entry(reduced_pressure, k),
                        .bridge_volume = entry(bridge_volume, k),
                        .liquid_content = entry(liquid_content, k)};
    return requested;
}

py::dict states_dict(PredictedStates states) {
    py::dict dict;
    py::list names;
    for (const dem::Observable which : states.observables)
        names.append(std::string(dem::observable_names[static_cast<std::size_t>(which)]));
    dict["observables"] = names;
    dict["value"] = to_numpy(std::move(states.value));
    dict["stderr"] = to_numpy(std::move(states.standard_error));
    py::list slopes;
    for (Eigen::MatrixXd& each : states.slopes)
        slopes.append(to_numpy(std::move(each)));
    dict["slopes"] = slopes;
    dict["bridge_volume"] = to_numpy(std::move(states.bridge_volume));
    dict["why_not"] = py::cast(states.why_not);
    return dict;
}

/// Predictor with the settings of a Python user.
std::unique_ptr<StatePredictor> predictor(const std::string& fidelity,
                                          std::optional<double> stiffness_number,
                                          const std::optional<std::filesystem::path>& store) {
    const Fidelity settings = fidelity_named(fidelity);
    const double stiffness = stiffness_number.value_or(settings.stiffness_number);
    StatePredictor::check_stiffness_number(stiffness);
    const std::shared_ptr<RunStore> opened = open_store(store);
    const py::gil_scoped_release release;
    return std::make_unique<StatePredictor>(settings, opened.get(), stiffness);
}

}  // namespace

void bind_states(py::module_& module) {
    py::class_<StatePredictor>(module, "StatePredictor")
        .def(py::init(&predictor))
        .def_property_readonly("stiffness_number", &StatePredictor::stiffness_number)
        .def_property_readonly(
            "runs", [](const StatePredictor& self) { return self.emulator().runs().size(); })
        .def("at",
             [](const StatePredictor& self, double friction, double inertial_number,
                std::optional<double> reduced_pressure, std::optional<double> bridge_volume,
                std::optional<double> liquid_content) {
                 const RequestedState requested{.friction = friction,
                                                .inertial_number = inertial_number,
                                                .reduced_pressure = reduced_pressure,
                                                .bridge_volume = bridge_volume,
                                                .liquid_content = liquid_content};
                 if (const std::string wrong = requested.why_wrong(); !wrong.empty())
                     throw InputError(wrong);
                 nlohmann::ordered_json json;
                 {
                     const py::gil_scoped_release release;
                     json = to_json(self.at(requested), self.emulator().runs());
                 }
                 return to_python(json);
             })
        .def("states", [](const StatePredictor& self, const py::object& on_event, bool slopes,
                          std::size_t threads, const Numbers& friction,
                          const Numbers& inertial_number,
                          const std::optional<Numbers>& reduced_pressure,
                          const std::optional<Numbers>& bridge_volume,
                          const std::optional<Numbers>& liquid_content) {
            const auto requested = requested_states(friction, inertial_number, reduced_pressure,
                                                    bridge_volume, liquid_content);
            return states_dict(long_call(on_event, [&](const auto& stop, const auto& listener) {
                const auto report = [&](std::size_t done) {
                    tell(listener, {.kind = Event::Kind::refits,
                                    .text = "states",
                                    .number = done,
                                    .total = requested.size()});
                };
                return predict_states(
                    self, requested,
                    {.slopes = slopes, .threads = threads, .stop = stop, .report = report});
            }));
        });
}

}  // namespace pendular::python
