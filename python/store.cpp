#include "python/store.h"

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <unistd.h>
#include <system_error>

namespace pendular::python {

std::shared_ptr<RunStore> open_store(const std::optional<std::filesystem::path>& file) {
    if (file) return file->empty() ? nullptr : std::make_shared<RunStore>(*file);
    const std::filesystem::path standard = RunStore::standard_file(),
                                folder = standard.parent_path();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && access(folder.c_str(), W_OK) == 0) return std::make_shared<RunStore>(standard);
    const std::string text = fmt::format(
        "{} cannot be written, so that no simulation is kept; store=FILE names another place",
        folder.string());
    if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 2) != 0)
        throw pybind11::error_already_set();  // warnings are errors
    return nullptr;
}

}  // namespace pendular::python
