#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "app/serve/answer.h"

namespace pendular::app {

/// Largest size of a recording that a server receives [bytes].
constexpr std::size_t largest_received = 64u << 20;

/// Reason why a file must not have this name in a study; empty where it may. A name is one part of
/// a path, printable text in UTF-8 of at most 200 bytes, and begins with neither a dot nor a
/// hyphen.
std::string fault_of_name(const std::string& name);

/// Stores a recording in the folder of a study, after checking that a pattern of a [[recording]] in
/// study.toml matches the name, that no other file would be replaced, and that the recording can be
/// read and has the quantities of steady shear. Nothing is stored otherwise. If a pattern names a
/// subfolder, the recording is stored there.
/// @param study folder of the study, or its study.toml
/// @param name name of the file, without a folder
/// @param bytes content of the file
/// @return HTTP status with a sentence: 201 stored; 200 there already with the same content; 400 a
///         wrong name; 409 another file has the name; 422 no pattern matches, or it cannot be read
/// @throws InputError where study.toml cannot be read
/// @throws std::runtime_error where the file cannot be written
Answer store_recording(const std::filesystem::path& study, const std::string& name,
                       const std::string& bytes);

}  // namespace pendular::app
