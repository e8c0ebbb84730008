#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "sim/runs/store/run_store.h"

namespace pendular::python {

/// Opens the store `file`. None named: the user's store or, where it cannot be written, none, with
/// a warning of Python. An empty path: no store.
/// @throws InputError if the file is not a store
std::shared_ptr<RunStore> open_store(const std::optional<std::filesystem::path>& file);

}  // namespace pendular::python
