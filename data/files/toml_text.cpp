#include "data/files/toml_text.h"

#include <fmt/format.h>

namespace pendular {

Position position_in(const std::string& file, const toml::source_position& where) {
    return {file, static_cast<int>(where.line), static_cast<int>(where.column)};
}

toml::table parse_toml(const std::string& file, const std::string& text) {
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw InputError(position_in(file, error.source().begin),
                         fmt::format("{}; correct the syntax here", error.description()));
    }
}

}  // namespace pendular
