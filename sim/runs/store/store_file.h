#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace SQLite {
class Database;
class Statement;
class Exception;
}  // namespace SQLite

namespace pendular {

/// Version of the file format of stores.
constexpr int store_format = 1;
/// Path of a store (SQLite database of runs) that is in memory only, without a file.
constexpr const char* store_in_memory = ":memory:";

/// Opens the SQLite file of a store (file of simulation runs). Views, triggers and functions in its
/// schema are not executed, since the file may come from somebody else.
/// @param file absolute path, or `store_in_memory`
/// @param must_exist true: a missing file is an error, and a file that cannot be written is opened
///         for reading only; false: a missing file is created, with its folder
/// @throws InputError for a file that is no store, or of a newer version
/// @throws SQLite::Exception for other errors of SQLite
std::unique_ptr<SQLite::Database> open_store_file(const std::filesystem::path& file,
                                                  bool must_exist);

/// Replaces an error of SQLite by an error with advice for the user, and throws it.
/// @throws InputError if the file cannot be opened or is not a valid store
/// @throws std::runtime_error for any other error
[[noreturn]] void explain(const std::filesystem::path& file, const SQLite::Exception& error);

/// Device and inode number of a file, which change if another file replaces it; zeros if the file
/// does not exist.
std::array<std::uint64_t, 2> identity_of(const std::filesystem::path& file);

}  // namespace pendular
