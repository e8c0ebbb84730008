#pragma once

#include <toml++/toml.h>

#include <string>

#include "data/input_error.h"

namespace pendular {

/// Position in a file at which a node or key begins; columns count characters, not bytes.
Position position_in(const std::string& file, const toml::source_position& where);

/// @throws InputError at the place of a syntax error
toml::table parse_toml(const std::string& file, const std::string& text);

}  // namespace pendular
