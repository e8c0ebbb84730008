#pragma once

#include <toml++/toml.h>

#include <string>

#include "data/input_error.h"

namespace pendular {

/// Converts a position that the TOML parser reports. Columns count characters, not bytes.
Position position_in(const std::string& file, const toml::source_position& where);

/// Parses a text in TOML.
/// @param file path of the file with the text, for error messages
/// @throws InputError at the position of a syntax error, and for a key of more than 16 parts (a.b.c
///         has three)
toml::table parse_toml(const std::string& file, const std::string& text);

}  // namespace pendular
