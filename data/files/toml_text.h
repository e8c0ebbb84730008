#pragma once

#include <toml++/toml.h>

#include <string>

#include "data/input_error.h"

namespace pendular {

/// Position of a TOML node or key in a file, from the parser's position. Columns count characters,
/// not bytes.
Position position_in(const std::string& file, const toml::source_position& where);

/// Parses a text in TOML; `file` names its file in error messages.
/// @throws InputError at the position of a syntax error
toml::table parse_toml(const std::string& file, const std::string& text);

}  // namespace pendular
