#include "data/study/study_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "data/files/text_file.h"
#include "data/files/toml_text.h"
#include "data/input_error.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

void check_keys(const toml::table& table, const std::string& file, const std::string& name,
                const std::vector<std::string>& known) {
    for (const auto& [key, node] : table) {
        const std::string word(key.str());
        if (std::find(known.begin(), known.end(), word) != known.end()) continue;
        const std::string where = name.empty() ? "" : " in " + name;
        throw InputError(
            position_in(file, key.source().begin),
            fmt::format("unknown key '{}'{}; {}", word, where, did_you_mean(word, known)));
    }
}

}  // namespace

StudyTable StudyTable::parse(const std::string& file, const std::string& text,
                             const std::vector<std::string>& keys) {
    const auto root = std::make_shared<const toml::table>(parse_toml(file, text));
    return StudyTable(root, *root, file, "", keys);
}

StudyTable StudyTable::read(const std::filesystem::path& file,
                            const std::vector<std::string>& keys) {
    return parse(file.string(),
                 fmt::format("{}\n", fmt::join(read_lines(file, largest_settings), "\n")), keys);
}

StudyTable::StudyTable(std::shared_ptr<const toml::table> root, const toml::table& table,
                       const std::string& file, std::string name,
                       const std::vector<std::string>& keys)
    : root_(std::move(root)), table_(&table), name_(std::move(name)) {
    position_ = position_in(file, table.source().begin);
    check_keys(table, file, name_, keys);
}

bool StudyTable::has(std::string_view key) const {
    return table_->contains(key);
}

bool StudyTable::holds_table(std::string_view key) const {
    const toml::node* const node = table_->get(key);
    return node && node->is_table();
}

Position StudyTable::at(std::string_view key) const {
    const toml::node* const node = table_->get(key);
    return node ? position_of(*node) : position_;
}

Position StudyTable::position_of(const toml::node& node) const {
    return position_in(position_.file, node.source().begin);
}

void StudyTable::refuse(std::string_view key, const std::string& message) const {
    throw InputError(at(key), fmt::format("'{}': {}", key, message));
}

std::string StudyTable::path_of(std::string_view key) const {
    const std::size_t first = name_.find_first_not_of('['), end = name_.find(']');
    return name_.empty() ? std::string(key)
                         : fmt::format("{}.{}", name_.substr(first, end - first), key);
}

std::optional<StudyTable> StudyTable::table(std::string_view key,
                                            const std::vector<std::string>& keys) const {
    const toml::node* const node = table_->get(key);
    if (!node) return std::nullopt;
    if (!node->is_table()) refuse(key, fmt::format("must be a table; write [{}]", path_of(key)));
    return StudyTable(root_, *node->as_table(), position_.file, fmt::format("[{}]", path_of(key)),
                      keys);
}

std::optional<StudyTable> StudyTable::open_table(std::string_view key) const {
    const toml::node* const node = table_->get(key);
    if (!node || !node->is_table()) return table(key, {});
    std::vector<std::string> all;
    for (const auto& [name, value] : *node->as_table())
        all.emplace_back(name.str());
    return table(key, all);
}

std::vector<std::string> StudyTable::keys() const {
    std::vector<std::string> all;
    for (const auto& [name, value] : *table_)
        all.emplace_back(name.str());
    return all;
}

std::vector<StudyTable> StudyTable::tables(std::string_view key,
                                           const std::vector<std::string>& keys) const {
    std::vector<StudyTable> result;
    const toml::node* const node = table_->get(key);
    if (!node) return result;
    if (!node->is_array_of_tables())
        refuse(key, fmt::format("must be a list of tables; write [[{}]]", path_of(key)));
    for (const toml::node& element : *node->as_array())
        result.push_back(StudyTable(root_, *element.as_table(), position_.file,
                                    fmt::format("[[{}]]", path_of(key)), keys));
    return result;
}

double StudyTable::finite_number(std::string_view key, const toml::node& node) const {
    const double value = *node.value<double>();
    if (const auto why = beyond_measure(value)) refuse(key, *why);
    return value;
}

double StudyTable::quantity_from_text(std::string_view key, const toml::node& node,
                                      const Unit& expected) const {
    if (!node.is_string())
        refuse(key, fmt::format("must be a quantity; write a string like \"1 {}\"",
                                expected.spelling()));
    try {
        const double value = quantity_in_si(*node.value<std::string>(), expected);
        if (const auto why = beyond_measure(value)) throw std::invalid_argument(*why);
        return value;
    } catch (const std::invalid_argument& error) {
        refuse(key, error.what());
    }
}

double StudyTable::quantity_of(std::string_view key, const toml::node& node,
                               std::string_view unit) const {
    const Unit expected(unit);
    if (!node.is_number()) return quantity_from_text(key, node, expected);
    if (!expected.same_dimension(Unit("1")))
        refuse(key, missing_unit(fmt::format("{}", *node.value<double>()), expected));
    return finite_number(key, node);
}

std::optional<double> StudyTable::quantity(std::string_view key, std::string_view unit) const {
    const toml::node* const node = table_->get(key);
    return node ? std::optional(quantity_of(key, *node, unit)) : std::nullopt;
}

std::vector<double> StudyTable::quantities(std::string_view key, std::string_view unit) const {
    std::vector<double> result;
    const toml::node* const node = table_->get(key);
    if (node && node->is_array()) {
        for (const toml::node& element : *node->as_array())
            result.push_back(quantity_of(key, element, unit));
        if (result.empty()) refuse(key, "is empty; write at least one value");
    } else if (node) {
        result.push_back(quantity_of(key, *node, unit));
    }
    return result;
}

std::optional<double> StudyTable::quantity_in(std::string_view key, const Unit& unit) const {
    const toml::node* const node = table_->get(key);
    if (!node) return std::nullopt;
    return node->is_number() ? unit.to_si(finite_number(key, *node))
                             : quantity_from_text(key, *node, unit);
}

double StudyTable::required_quantity(std::string_view key, std::string_view unit) const {
    if (const auto value = quantity(key, unit)) return *value;
    throw InputError(position_,
                     fmt::format("{} lacks '{}'; add {} = {}", name_, key, key,
                                 unit == "1" ? "a number" : fmt::format("\"... {}\"", unit)));
}

double StudyTable::positive_quantity(std::string_view key, std::string_view unit) const {
    const double value = required_quantity(key, unit);
    if (value < smallest_magnitude)
        refuse(key, value <= 0 ? "must be positive" : "is too small; correct it");
    return value;
}

std::vector<double> StudyTable::numbers(std::string_view key) const {
    std::vector<double> result;
    const auto take = [&](const toml::node& node) {
        const auto value = node.is_number() ? node.value<double>() : std::nullopt;
        if (!value || beyond_measure(*value)) {
            throw InputError(position_of(node), fmt::format("'{}': must be a finite number", key));
        }
        result.push_back(*value);
    };
    const toml::node* const node = table_->get(key);
    if (node && node->is_array()) {
        for (const toml::node& element : *node->as_array())
            take(element);
        if (result.empty()) refuse(key, "is empty; write at least one number");
    } else if (node) {
        take(*node);
    }
    return result;
}

std::optional<std::string> StudyTable::text(std::string_view key) const {
    const toml::node* const node = table_->get(key);
    if (!node) return std::nullopt;
    if (!node->is_string()) refuse(key, "must be a string; put it in quotes");
    return node->value<std::string>();
}

std::optional<bool> StudyTable::flag(std::string_view key) const {
    const toml::node* const node = table_->get(key);
    if (!node) return std::nullopt;
    if (!node->is_boolean()) refuse(key, "must be true or false, without quotes");
    return node->value<bool>();
}

std::optional<Word> StudyTable::stated(std::string_view key) const {
    const toml::node* const node = table_->get(key);
    if (!node) return std::nullopt;
    if (node->is_number()) return Word{fmt::format("{}", finite_number(key, *node)), at(key)};
    return Word{*text(key), at(key)};
}

std::string StudyTable::choice(std::string_view key, const std::vector<std::string>& words) const {
    std::string word = text(key).value_or(words.front());
    if (std::find(words.begin(), words.end(), word) == words.end())
        refuse(key, fmt::format("unknown \"{}\"; {}", word, did_you_mean(word, words)));
    return word;
}

std::vector<std::string> StudyTable::words(std::string_view key,
                                           const std::vector<std::string>& missing) const {
    if (!has(key)) return missing;
    std::vector<std::string> result;
    for (Word& word : placed_words(key))
        result.push_back(std::move(word.text));
    return result;
}

std::vector<Word> StudyTable::placed_words(std::string_view key) const {
    std::vector<Word> result;
    const toml::node* const node = table_->get(key);
    if (!node) return result;
    if (!node->is_array())
        refuse(key, fmt::format("must be a list of names; write {} = [\"...\"]", key));
    for (const toml::node& element : *node->as_array()) {
        if (!element.is_string())
            throw InputError(position_of(element), "must be a name; put it in quotes");
        result.push_back({*element.value<std::string>(), position_of(element)});
    }
    return result;
}

}  // namespace pendular
