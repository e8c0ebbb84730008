#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace SQLite {
class Database;
class Statement;
class Exception;
}  // namespace SQLite

namespace pendular {

/// Version of the file format of stores.
constexpr int store_format = 1;
/// Path of a store in memory, without a file.
constexpr const char* store_in_memory = ":memory:";

/// Opens the SQLite file of a store. Views, triggers and functions in its schema are not executed,
/// since the file may come from somebody else. If `must_exist` is false, a missing file is created,
/// with its folder; if true, a file that cannot be written is opened for reading only.
/// @param file absolute path, or `store_in_memory`
/// @throws InputError if the file is missing although `must_exist` is true, or if the file is a
///         folder, a database of another program or a store of a newer format
/// @throws SQLite::Exception for other errors, such as a file that is not an SQLite database
std::unique_ptr<SQLite::Database> open_store_file(const std::filesystem::path& file,
                                                  bool must_exist);

/// Throws, in place of the error of SQLite, one whose message names the file and advises the user.
/// @throws InputError if the file cannot be opened or is not a valid store, or if a query exceeds a
///         limit of size or is forbidden
/// @throws std::runtime_error for any other error
[[noreturn]] void explain(const std::filesystem::path& file, const SQLite::Exception& error);

/// Returns device number and inode number of a file, which change if a new file replaces it; zero
/// if it does not exist.
std::array<std::uint64_t, 2> identity_of(const std::filesystem::path& file);

/// Returns bytes compressed by zlib.
std::string compressed(const std::string& bytes);
/// Returns the bytes that `compressed` compressed.
/// @throws std::runtime_error if the bytes are not valid zlib data, or if n compressed bytes expand
///         to more than 100 n + 65536 bytes
std::string expanded(const std::string& bytes);

}  // namespace pendular
