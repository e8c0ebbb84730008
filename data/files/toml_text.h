#pragma once

#include <toml++/toml.h>

#include <string>

#include "data/input_error.h"

namespace pendular {

/// Converts the position `where` of a TOML key or value, as the parser reports it, to a position in
/// `file`. Columns count characters, not bytes.
Position position_in(const std::string& file, const toml::source_position& where);

/// Parses a text in TOML; `file` is the name of the text's file in error messages.
/// @throws InputError at the position of a syntax error, and for a key of more than 16 parts
toml::table parse_toml(const std::string& file, const std::string& text);

}  // namespace pendular
