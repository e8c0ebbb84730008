#include <nlohmann/json.hpp>

#include "python/bindings.h"
#include "python/convert.h"
#include "python/written_effect.h"
#include "workflow/json/commands.h"

namespace py = pybind11;

namespace pendular::python {

void bind_effects(py::module_& module) {
    module.def("effects", [] {
        std::vector<EffectEntry> entries;
        for (const Effect& effect : built_in_effects())
            entries.push_back({&effect});
        return to_python(to_json(entries));
    });
    py::class_<WrittenInPython>(module, "WrittenEffect")
        .def(py::init([](std::string name, std::string summary, std::string parameter,
                         std::string unit, double lower, double upper, double neutral,
                         double smallest_of_interest, py::object show) {
            return WrittenInPython{std::move(name),
                                   std::move(summary),
                                   std::move(parameter),
                                   std::move(unit),
                                   lower,
                                   upper,
                                   neutral,
                                   smallest_of_interest,
                                   std::move(show)};
        }))
        .def_readonly("name", &WrittenInPython::name)
        .def_readonly("parameter", &WrittenInPython::parameter)
        .def_readonly("unit", &WrittenInPython::unit)
        .def_readonly("show", &WrittenInPython::show);
}

}  // namespace pendular::python
