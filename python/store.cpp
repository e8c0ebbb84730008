#include "python/store.h"

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <unistd.h>
#include <system_error>

namespace pendular::python {
namespace {

/// Opens a store, which a forked process must not close: the connection is that of its parent.
std::shared_ptr<RunStore> opened(const std::filesystem::path& file) {
    return {std::make_unique<RunStore>(file).release(), [process = getpid()](RunStore* store) {
                if (getpid() == process) delete store;
            }};
}

}  // namespace

std::shared_ptr<RunStore> open_store(const std::optional<std::filesystem::path>& file) {
    if (file) return file->empty() ? nullptr : opened(*file);
    const std::filesystem::path standard = RunStore::standard_file(),
                                folder = standard.parent_path();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && access(folder.c_str(), W_OK) == 0) return opened(standard);
    const std::string text = fmt::format(
        "{} cannot be written, so that no simulation is kept; store=FILE names another place",
        folder.string());
    if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 2) != 0)
        throw pybind11::error_already_set();  // warnings are errors
    return nullptr;
}

}  // namespace pendular::python
