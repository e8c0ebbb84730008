#include "bench/hidden_effects/truth.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

#include "data/files/csv.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular::bench {
namespace {

constexpr std::array kinds = {Truth::Kind::complete, Truth::Kind::effect, Truth::Kind::pair,
                              Truth::Kind::outside};

const Effect& known_effect(const std::string& name) {
    const auto& outside = outside_effects();
    const auto found = std::ranges::find(outside, name, &Effect::name);
    if (found != outside.end()) return *found;
    for (const OutsideEffect& each : more_outside_effects()) {
        if (each.effect.name == name) return each.effect;
    }
    return built_in_effect(name);
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), {}};
}

double number_at(const Table& table, const Row& row, std::size_t column) {
    const auto number = parse_number(row.cells.at(column).text);
    if (!number) {
        throw InputError(table.at(row, column),
                         fmt::format("'{}' is no number", row.cells[column].text));
    }
    return *number;
}

}  // namespace

bool Truth::hides(const std::string& effect) const {
    return std::ranges::any_of(
        hidden, [&](const ActiveEffect& active) { return active.effect->name == effect; });
}

bool Truth::well_separated() const {
    constexpr double large = 59, apart = 15;  // planned for 60, to three digits
    return kind == Kind::effect && noncentrality >= large && separation >= apart;
}

std::string to_string(Truth::Kind kind) {
    constexpr std::array names = {"complete", "effect", "pair", "outside"};
    return names.at(static_cast<std::size_t>(kind));
}

std::vector<Truth> read_truths(const std::filesystem::path& file) {
    const Table table = read_table(file);
    std::vector<Truth> truths;
    for (const Row& row : table.rows) {
        Truth truth{.name = row.cells.at(1).text};
        const auto kind = std::ranges::find(kinds, row.cells[0].text,
                                            [](Truth::Kind each) { return to_string(each); });
        if (kind == kinds.end()) {
            throw InputError(table.at(row, 0), fmt::format("unknown kind '{}'", row.cells[0].text));
        }
        truth.kind = *kind;
        const auto values = words_of(row.cells.at(3).text);
        std::size_t next = 0;
        for (const std::string& name : words_of(row.cells.at(2).text)) {
            ActiveEffect active{.effect = &known_effect(name)};
            for (std::size_t k = 0; k < active.effect->parameters.size(); ++k) {
                active.values.push_back(parse_number(values.at(next++)).value());
            }
            truth.hidden.push_back(std::move(active));
        }
        truth.friction = number_at(table, row, 4);
        truth.noncentrality = number_at(table, row, 5);
        truth.separation = number_at(table, row, 6);
        truth.most_like = row.cells.at(7).text;
        truths.push_back(std::move(truth));
    }
    return truths;
}

void write_truths(const std::filesystem::path& file, const std::vector<Truth>& truths) {
    std::string text = "kind,truth,effects,values,friction,noncentrality,separation,most_like\n";
    for (const Truth& truth : truths) {
        std::vector<std::string> names;
        std::vector<double> values;
        for (const ActiveEffect& active : truth.hidden) {
            names.push_back(active.effect->name);
            values.insert(values.end(), active.values.begin(), active.values.end());
        }
        text += fmt::format("{},{},{},{:.6g},{},{:.3g},{:.3g},{}\n", to_string(truth.kind),
                            truth.name, fmt::join(names, " "), fmt::join(values, " "),
                            truth.friction, truth.noncentrality, truth.separation, truth.most_like);
    }
    write_whole(file, text);
}

}  // namespace pendular::bench
