#include "python/written_effect.h"

#include <fmt/format.h>

#include <memory>

#include "data/input_error.h"

namespace py = pybind11;

namespace pendular::python {
namespace {

/// Quantity of `CellState` by its name in Python.
struct CellQuantity {
    const char* name;
    double CellState::*value;
    bool shown;  ///< whether an effect may change what is shown of it
};
constexpr CellQuantity cell_quantities[] = {
    {"torque", &CellState::torque, true},
    {"normal_force", &CellState::normal_force, true},
    {"height", &CellState::height, true},
    {"angular_velocity", &CellState::angular_velocity, true},
    {"liquid_content", &CellState::liquid_content, false},
    {"bead_volume", &CellState::bead_volume, false},
    {"time", &CellState::time, false},
    {"inner_radius", &CellState::inner_radius, false},
    {"outer_radius", &CellState::outer_radius, false},
    {"density", &CellState::density, false},
    {"diameter", &CellState::diameter, false}};

/// Sets what the function returned.
/// @throws InputError where it is no quantity that an effect may change
void set_shown(CellState& state, const std::string& effect, const py::dict& changed) {
    for (const auto& [key, value] : changed) {
        const auto name = py::cast<std::string>(key);
        const CellQuantity* found = nullptr;
        for (const CellQuantity& each : cell_quantities)
            if (each.shown && name == each.name) found = &each;
        if (!found)
            throw InputError(fmt::format(
                "the effect {} returns '{}'; an effect may change torque, normal_force, height and "
                "angular_velocity",
                effect, name));
        state.*found->value = py::cast<double>(value);
    }
}

}  // namespace

Effect effect_from(const WrittenInPython& written) {
    // Copies share one reference, which is given up under the lock of the interpreter.
    const std::shared_ptr<py::object> function(new py::object(written.show), [](py::object* held) {
        const py::gil_scoped_acquire acquire;
        delete held;
    });
    const auto show = [function, name = written.name, parameter = written.parameter](
                          CellState state, const Values& values) {
        const py::gil_scoped_acquire acquire;
        py::dict arguments;
        for (const CellQuantity& each : cell_quantities)
            arguments[each.name] = state.*each.value;
        arguments[py::str(parameter)] = values[parameter];
        set_shown(state, name, (*function)(**arguments));
        return state;
    };
    return {.name = written.name,
            .summary = written.summary,
            .equation = "by a function of Python",
            .parameters = {{.name = written.parameter,
                            .unit = written.unit,
                            .lower = written.lower,
                            .upper = written.upper,
                            .neutral = written.neutral,
                            .smallest_of_interest = written.smallest_of_interest,
                            .meaning = written.summary}},
            .change = ChangeInstrument{.show = show, .where = ChangeInstrument::Where::transducers},
            .acts_through = {"1/normal_stress"},
            .references = {}};
}

}  // namespace pendular::python
