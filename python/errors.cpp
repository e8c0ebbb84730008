#include <exception>
#include <stdexcept>

#include "data/input_error.h"
#include "python/bindings.h"
#include "sim/dem/simulation_error.h"

namespace py = pybind11;

namespace pendular::python {
namespace {

/// Raises an InputError of Python with the place of the mistake.
void set_input_error(const py::object& type, const pendular::InputError& error) {
    const Position& position = error.position();
    const py::object raised = type(error.what());
    const auto known = [](int number) {
        return number > 0 ? py::object(py::int_(number)) : py::none();
    };
    raised.attr("file") = position.file.empty() ? py::object(py::none()) : py::str(position.file);
    raised.attr("line") = known(position.line);
    raised.attr("column") = known(position.column);
    PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void bind_errors(py::module_& module) {
    static py::exception<pendular::InputError> input(module, "InputError", PyExc_ValueError);
    input.doc() =
        "Mistake in a file, key, value or argument that the user gave. The text names the mistake "
        "and what to do; for a file, it begins with file:line:column, which the attributes file, "
        "line and column have too (None: unknown).";
    for (const char* place : {"file", "line", "column"})
        input.attr(place) = py::none();  // of an error that Python raises
    static py::exception<std::domain_error> impossible(module, "ImpossibleState", PyExc_ValueError);
    impossible.doc() =
        "Parameters at which no true state of the cell would make the instrument show what it "
        "shows.";
    static py::exception<dem::SimulationError> simulation(module, "SimulationError",
                                                          PyExc_RuntimeError);
    simulation.doc() = "A simulation that cannot go on, for example since an overlap is too large.";
    static py::exception<dem::Interrupted> interrupted(module, "Interrupted", PyExc_RuntimeError);
    interrupted.doc() = "Work that was asked to stop. The text says what is kept.";
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const pendular::InputError& error) {
            set_input_error(input, error);
        } catch (const std::domain_error& error) {
            impossible(error.what());
        } catch (const dem::SimulationError& error) {
            simulation(error.what());
        } catch (const dem::Interrupted& error) {
            interrupted(error.what());
        }
    });
}

}  // namespace pendular::python
