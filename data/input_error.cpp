#include "data/input_error.h"

#include <fmt/format.h>

namespace pendular {
namespace {

std::string located(const Position& position, const std::string& message) {
    const std::string where = to_string(position);
    return where.empty() ? message : where + ": " + message;
}

}  // namespace

std::string to_string(const Position& position) {
    std::string text = position.file;
    if (position.line > 0) text += fmt::format(":{}", position.line);
    if (position.line > 0 && position.column > 0) text += fmt::format(":{}", position.column);
    return text;
}

InputError::InputError(const Position& position, const std::string& message)
    : std::runtime_error(located(position, message)) {}

InputError::InputError(const std::string& message) : std::runtime_error(message) {}

}  // namespace pendular
