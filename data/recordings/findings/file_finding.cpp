#include "data/recordings/findings/file_finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace pendular {

void add_line(std::vector<std::pair<int, int>>& lines, int line) {
    if (!lines.empty() && lines.back().second + 1 == line)
        lines.back().second = line;
    else
        lines.emplace_back(line, line);
}

std::string text_of_lines(const std::vector<std::pair<int, int>>& lines, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < std::min(most, lines.size()); ++i) {
        const auto& [first, last] = lines[i];
        text +=
            fmt::format("{}{}", text.empty() ? "" : ", ",
                        first == last ? std::to_string(first) : fmt::format("{}-{}", first, last));
    }
    if (lines.size() > most) text += fmt::format(" and {} more ranges", lines.size() - most);
    return text;
}

std::string text_of(const FileFinding& finding, std::size_t most) {
    std::string what = finding.what;
    if (finding.lines.empty() && !what.empty())
        what[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(what[0])));
    const bool one = finding.lines.size() == 1 && finding.lines[0].first == finding.lines[0].second;
    const std::string where =
        finding.lines.empty()
            ? ""
            : fmt::format("{} {}: ", one ? "Line" : "Lines", text_of_lines(finding.lines, most));
    return fmt::format("{}{} {}", where, what, finding.done);
}

}  // namespace pendular
