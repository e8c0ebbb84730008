#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <utility>

#include "data/recordings/recording.h"
#include "python/bindings.h"
#include "python/convert.h"
#include "python/long_call.h"
#include "python/open_study.h"
#include "python/store.h"
#include "python/written_effect.h"
#include "workflow/json/measurements.h"

namespace py = pybind11;

namespace pendular::python {
namespace {

using Path = std::filesystem::path;

FitOptions fit_options(const std::optional<double>& confirm_seconds, bool cold, bool profile) {
    FitOptions fit{.confirm = confirm_seconds.has_value(), .cold = cold, .profile = profile};
    fit.confirming_seconds = confirm_seconds;
    return fit;
}

py::dict fit_dict(FitResult result) {
    py::dict dict;
    dict["json"] = to_python(result.json);
    dict["measured_covariance"] = to_numpy(std::move(result.measured_covariance));
    dict["predicted_covariance"] = to_numpy(std::move(result.predicted_covariance));
    dict["normalised"] = to_numpy(std::move(result.normalised));
    dict["lines"] = py::cast(result.lines);
    dict["of_means"] = result.of_means;
    return dict;
}

std::unique_ptr<OpenStudy> open_study(const Path& study, const std::optional<std::string>& fidelity,
                                      std::uint64_t seed, int threads,
                                      const std::optional<Path>& store, const Path& results,
                                      const std::vector<WrittenInPython>& effects) {
    StudySettings settings{.fidelity = fidelity_named(fidelity.value_or("standard")),
                           .fidelity_given = fidelity.has_value(),
                           .seed = seed,
                           .threads = threads,
                           .store = nullptr,
                           .folder = results,
                           .effects = {}};
    for (const WrittenInPython& effect : effects)
        settings.effects.push_back(effect_from(effect));
    // The store is opened after the study is read, so that a refused study makes no store.
    const py::gil_scoped_release release;
    auto opened = std::make_unique<OpenStudy>(study, settings);
    const py::gil_scoped_acquire acquire;
    opened->use(open_store(store));
    return opened;
}

/// Conditions of the entries of three arrays of equal length.
std::vector<Condition> conditions_of(const std::vector<double>& normal_stress,
                                     const std::vector<double>& inertial_number,
                                     const std::vector<double>& liquid_content) {
    std::vector<Condition> conditions;
    for (std::size_t k = 0; k < normal_stress.size(); ++k)
        conditions.push_back({.normal_stress = normal_stress[k],
                              .inertial_number = inertial_number.at(k),
                              .liquid_content = liquid_content.at(k)});
    return conditions;
}

py::dict prediction_dict(Prediction prediction) {
    py::dict dict;
    dict["value"] = to_numpy(std::move(prediction.value));
    dict["jacobian"] = to_numpy(std::move(prediction.jacobian));
    dict["covariance"] = to_numpy(std::move(prediction.covariance));
    return dict;
}

/// Files of recordings that a study names, each once.
std::vector<Path> recordings_of(const OpenStudy& opened) {
    std::vector<Path> files;
    for (const Source& source : opened.input().study.study().sources)
        if (source.kind == Source::Kind::recording)
            files.insert(files.end(), source.files.begin(), source.files.end());
    return files;
}

py::dict recording(const OpenStudy& opened, const Path& file) {
    Recording read;
    {
        const py::gil_scoped_release release;
        for (const Source& source : opened.input().study.study().sources)
            if (std::ranges::find(source.files, file) != source.files.end())
                read = read_recording(file, source.format);
    }
    py::dict columns;
    for (const SeriesColumn& column : series_columns())
        if (const auto& values = read.*column.values; !values.empty())
            columns[py::str(std::string(column.name))] = to_numpy(values);
    return columns;
}

}  // namespace

void bind_studies(py::module_& module) {
    module.def("open_study", open_study);
    py::class_<OpenStudy>(module, "OpenStudy")
        .def_property_readonly(
            "folder", [](const OpenStudy& self) { return self.input().study.study().folder; })
        .def_property_readonly(
            "file", [](const OpenStudy& self) { return self.input().study.study().file; })
        .def_property_readonly("results", &OpenStudy::folder)
        .def_property_readonly("effects",
                               [](const OpenStudy& self) {
                                   std::vector<std::string> names;
                                   for (const Effect* effect : self.input().study.effects())
                                       names.push_back(effect->name);
                                   return names;
                               })
        .def("readings",
             [](const OpenStudy& self) { return to_python(to_json(self.input().measurements)); })
        .def("recordings", recordings_of)
        .def("recording", recording)
        .def("calibrate",
             [](const OpenStudy& self, const py::object& on_event,
                const std::optional<double>& confirm_seconds, bool cold, bool profile) {
                 return fit_dict(long_call(on_event, [&](const auto& stop, const auto& listener) {
                     return self.calibrate(fit_options(confirm_seconds, cold, profile), stop,
                                           listener);
                 }));
             })
        .def("compare",
             [](const OpenStudy& self, const py::object& on_event) {
                 auto [json, fit] =
                     long_call(on_event, [&](const auto& stop, const auto& listener) {
                         return self.compare(stop, listener);
                     });
                 return std::pair{to_python(json), fit_dict(std::move(fit))};
             })
        .def(
            "predict",
            [](const OpenStudy& self, const py::object& on_event,
               const std::vector<double>& normal_stress, const std::vector<double>& inertial_number,
               const std::vector<double>& liquid_content) {
                const auto conditions =
                    conditions_of(normal_stress, inertial_number, liquid_content);
                return prediction_dict(
                    long_call(on_event, [&](const auto& stop, const auto& listener) {
                        return self.predict(conditions, stop, listener);
                    }));
            },
            py::arg("listener"), py::arg("normal_stress"), py::arg("inertial_number"),
            py::arg("liquid_content"))
        .def("diagnose",
             [](OpenStudy& self, const py::object& on_event,
                const std::optional<double>& confirm_seconds) {
                 return to_python(long_call(on_event, [&](const auto& stop, const auto& listener) {
                     return self.diagnose(confirm_seconds, stop, listener);
                 }));
             })
        .def("next",
             [](OpenStudy& self, const py::object& on_event) {
                 return to_python(long_call(on_event, [&](const auto& stop, const auto& listener) {
                     return self.next(stop, listener);
                 }));
             })
        .def("change", [](const OpenStudy& self, const py::object& on_event, bool add,
                          const std::string& effect, const std::optional<double>& confirm_seconds) {
            return to_python(long_call(on_event, [&](const auto& stop, const auto& listener) {
                return self.change(add ? Action::add : Action::drop, effect,
                                   fit_options(confirm_seconds, false, false), stop, listener);
            }));
        });
}

}  // namespace pendular::python
