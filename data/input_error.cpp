#include "data/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "data/files/sheet_path.h"

namespace pendular {
namespace {

std::string located(const Position& position, const std::string& message) {
    const std::string where = to_string(position);
    return where.empty() ? message : where + ": " + message;
}

}  // namespace

std::string to_string(const Position& position) {
    std::string text = position.file;
    const bool cell = position.line > 0 && position.column > 0;
    if (cell && as_sheet(text))
        return fmt::format("{}:{}", text, cell_name(position.line, position.column));
    if (position.line > 0) text += fmt::format(":{}", position.line);
    if (cell) text += fmt::format(":{}", position.column);
    return text;
}

InputError::InputError(const Position& position, const std::string& message)
    : std::runtime_error(located(position, message)),
      position_(std::make_shared<Position>(position)) {}

InputError::InputError(const std::string& message)
    : std::runtime_error(message), position_(std::make_shared<Position>()) {}

namespace {

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

int edit_distance(std::string_view first, std::string_view second) {
    const std::size_t rows = first.size() + 1;
    const std::size_t columns = second.size() + 1;
    std::vector<int> table(rows * columns);
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return table[i * columns + j]; };
    for (std::size_t i = 0; i < rows; ++i)
        at(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j < columns; ++j)
        at(0, j) = static_cast<int>(j);
    for (std::size_t i = 1; i < rows; ++i) {
        for (std::size_t j = 1; j < columns; ++j) {
            const int replace = same_letter(first[i - 1], second[j - 1]) ? 0 : 1;
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + replace});
            const bool swapped = i > 1 && j > 1 && same_letter(first[i - 1], second[j - 2]) &&
                                 same_letter(first[i - 2], second[j - 1]);
            if (swapped) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    }
    return at(rows - 1, columns - 1);
}

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known) {
    std::optional<std::string> best;
    int fewest = std::max(1, static_cast<int>(word.size()) / 3) + 1;
    for (const std::string& name : known) {
        // Each difference in length is an edit.
        const std::size_t longer = std::max(word.size(), name.size());
        if (longer - std::min(word.size(), name.size()) >= static_cast<std::size_t>(fewest))
            continue;
        const int distance = edit_distance(word, name);
        if (distance < fewest) {
            fewest = distance;
            best = name;
        }
    }
    return best;
}

namespace {

/// The only known name that begins with a word of at least three bytes; empty if there is none.
std::optional<std::string> only_name_from(std::string_view word,
                                          std::span<const std::string> known) {
    const auto begins = [&](const std::string& name) {
        return name.size() >= word.size() &&
               std::ranges::equal(word, name.substr(0, word.size()), same_letter);
    };
    const auto found = std::ranges::find_if(known, begins);
    const bool only = word.size() >= 3 && std::ranges::count_if(known, begins) == 1;
    return only ? std::optional(*found) : std::nullopt;
}

}  // namespace

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
    auto name = nearest(word, known);
    if (!name) name = only_name_from(word, known);
    if (name) return fmt::format("did you mean '{}'?", *name);
    return fmt::format("known are '{}'", fmt::join(known, "', '"));
}

}  // namespace pendular
