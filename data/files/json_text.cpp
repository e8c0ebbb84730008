#include "data/files/json_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "data/input_error.h"

namespace pendular {

std::string json_text(const nlohmann::ordered_json& object, int indent) {
    nlohmann::ordered_json document = {{"format", json_format}};
    document.update(object);
    // File names may contain bytes that are not UTF-8, which JSON requires: they are replaced.
    return document.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
           '\n';
}

void check_json_format(const nlohmann::ordered_json& object, const std::filesystem::path& file,
                       std::string_view advice) {
    const auto format = object.find("format");
    const auto known = [](const nlohmann::ordered_json& version) {
        return version.is_number_integer() && version >= 1 && version <= json_format;
    };
    if (format != object.end() && !known(*format)) {
        throw InputError({file.string()},
                         fmt::format("This file has the format {}, and this version of pendular "
                                     "reads the formats 1 to {}; update pendular, or {}",
                                     format->dump(), json_format, advice));
    }
}

}  // namespace pendular
