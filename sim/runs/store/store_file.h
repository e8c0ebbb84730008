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

constexpr int store_format = 1;  ///< version of the store's file format
/// Name of a store that is kept in memory only, without a file.
constexpr const char* store_in_memory = ":memory:";

/// Opens the SQLite file of a store, which somebody else may have made: views, triggers and
/// functions in its schema are not run.
/// @param file absolute path, or `store_in_memory`
/// @param must_exist true: a missing file is an error, and a file that cannot be written is opened
///         for reading only; false: a missing file is created, with its folder
/// @throws InputError for a file that is no store, or of a newer version
/// @throws SQLite::Exception
std::unique_ptr<SQLite::Database> open_store_file(const std::filesystem::path& file,
                                                  bool must_exist);

/// Converts an error of SQLite to an error with advice for the user and throws it: InputError where
/// the file cannot be opened or is not a valid store, else std::runtime_error.
[[noreturn]] void explain(const std::filesystem::path& file, const SQLite::Exception& error);

/// Device and inode number of a file, which tell whether another file has replaced it; zeros where
/// the file does not exist.
std::array<std::uint64_t, 2> identity_of(const std::filesystem::path& file);

}  // namespace pendular
