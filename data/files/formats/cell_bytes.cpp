#include "data/files/formats/cell_bytes.h"

#include <algorithm>

namespace pendular {

std::vector<std::size_t> bytes_of_cells(std::string_view line, char delimiter) {
    std::vector<std::size_t> bytes = {0};
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        // A quote within a cell, as in `G"`, begins no quoted text.
        if (line[i] == '"' &&
            (quoted || line.substr(bytes.back(), i - bytes.back()).find_first_not_of(" \t") ==
                           std::string_view::npos))
            quoted = !quoted;
        if (line[i] == delimiter && !quoted) bytes.push_back(i + 1);
    }
    bytes.push_back(line.size() + 1);
    return bytes;
}

std::size_t characters_in(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace pendular
