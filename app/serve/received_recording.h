#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace pendular::app {

/// Answer to a request of a browser: the HTTP status, and a text that the page shows.
struct Answer {
    int status = 200;
    std::string text;

    bool ok() const { return status < 400; }
};

/// Largest file that a browser may send [bytes]. Chosen: the server keeps it in memory.
constexpr std::size_t largest_received = 64u << 20;

/// Returns the reason why a received file must not be stored under `name`; empty if it may. An
/// allowed name is printable text in UTF-8 of at most 200 bytes, names no folder, and begins with
/// neither a dot nor a hyphen.
std::string fault_of_name(const std::string& name);

/// Stores a recording in the folder of a study, or in the subfolder that a `file` pattern of a
/// [[recording]] in study.toml names. Nothing is stored unless the HTTP status is 201.
/// @param name name of the file, without a folder
/// @return HTTP status with a sentence: 201, stored; 200, the study has the file already, with
///         equal content; 400, invalid name (`fault_of_name`); 409, a file of different content has
///         the name; 422, no pattern matches the name, or the recording cannot be read or lacks a
///         quantity that steady shear needs, such as the gap height
/// @throws InputError if study.toml cannot be read
/// @throws std::runtime_error if the file cannot be written
Answer store_recording(const std::filesystem::path& study, const std::string& name,
                       const std::string& bytes);

}  // namespace pendular::app
