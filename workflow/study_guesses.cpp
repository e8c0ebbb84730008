#include "workflow/study_guesses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "data/files/folded_name.h"
#include "data/files/sheet_path.h"
#include "data/files/text_pattern.h"
#include "data/quantities/number.h"
#include "data/recordings/stated_sample.h"
#include "workflow/file_views.h"

namespace pendular {

std::string texts_of(const FileView& view) {
    std::string text;
    for (const Block& block : view.file.blocks)
        if (text.empty()) text = block.test;
    return texts_of_group(view, text);
}

std::string texts_of_group(const FileView& view, const std::string& group) {
    std::string text = group;
    for (const std::string key : {"Sample name", "Name"})
        text += " | " + view.file.fact(key);
    text += " | " + file_to_open(view.file.file).stem().string();
    if (const auto sheet = as_sheet(view.file.file)) text += " | " + sheet->sheet;
    for (const std::string key : {"Project", "Projet", "Projekt"})
        text += " | " + view.file.fact(key);
    return text;
}

Guess guessed_diameter(const std::string& texts) {
    static const TextPattern length(R"((\d+(?:[.,]\d+)?)\s*(mm|um|µm|μm)(?![A-Za-z]))");
    const auto found = length.first(texts);
    if (!found) return {"500 um", "GUESS: no diameter was found in the file"};
    std::string number = found->parts[1];
    std::ranges::replace(number, ',', '.');
    return {fmt::format("{} {}", number, found->parts[2]),
            fmt::format("GUESS: from \"{}\" in the names of file and test", found->parts[0])};
}

std::optional<double> stated_percent(const std::string& texts) {
    static const TextPattern percent(R"((\d+(?:[.,p]\d+)?)\s*(?:%|pct))");
    static const TextPattern water(R"(_w(\d+)_)");
    auto found = percent.first(texts);
    if (!found) found = water.first(texts);
    if (!found) return std::nullopt;
    std::string number = found->parts[1];
    std::ranges::replace(number, ',', '.');
    std::ranges::replace(number, 'p', '.');
    return parse_number(number);
}

namespace {

/// Whether a word in small letters says that grains are wet, in one of the five languages, Polish,
/// Czech, Dutch, Swedish, Danish, Portuguese, Turkish, Hungarian or Finnish. Words for
/// humidity are left out, which may be that of the air.
bool says_wet(std::string_view word) {
    constexpr std::array begins = {"wet",     "moist",   "nass",    "naß",    "feucht", "wasser",
                                   "mouillé", "mouille", "mojad",   "bagnat", "mokr",   "wilgotn",
                                   "vlhk",    "våt",     "våd",     "molhad", "ıslak",  "islak",
                                   "nedves",  "märk",    "vochtig", "fugtig", "fuktig"};
    constexpr std::array whole = {
        "water",  "eau",   "agua",   "acqua", "humide", "humides", "húmedo", "húmeda", "humedo",
        "humeda", "umido", "umida",  "umidi", "umide",  "oil",     "öl",     "oel",    "natte",
        "woda",   "voda",  "vatten", "vand",  "víz",    "vizes",   "vesi",   "água"};
    return std::ranges::any_of(begins,
                               [&](std::string_view each) { return word.starts_with(each); }) ||
           std::ranges::find(whole, word) != whole.end();
}

/// Whether a word in small letters says that grains are dry.
bool says_dry(std::string_view word) {
    constexpr std::array words = {"dry",   "trocken", "sec",   "secs",  "sèche",  "sèches",
                                  "seco",  "seca",    "secco", "secca", "secchi", "asciutto",
                                  "droog", "droge",   "suchy", "suchá", "torr",   "tør",
                                  "kuiva", "száraz",  "kuru"};
    return std::ranges::find(words, word) != words.end();
}

bool any_word(std::string_view text, bool (*says)(std::string_view)) {
    std::string word;
    for (const char c : lower_case(text) + " ") {
        // Bytes beyond ASCII are parts of letters.
        if (std::isalpha(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) > 0x7f) {
            word += c;
            continue;
        }
        if (says(word)) return true;
        word.clear();
    }
    return false;
}

/// Whether the most specific text, or without a word there any other, says that grains are wet: a
/// test "dry" of a file "water.csv" does not.
bool named_wet(const std::string& texts) {
    static const TextPattern water(R"(_w\d)");  // "glass_w10"
    const std::string_view first = std::string_view(texts).substr(0, texts.find(" | "));
    if (any_word(first, says_dry) && !any_word(first, says_wet)) return false;
    return water.first(texts) || any_word(texts, says_wet);
}

}  // namespace

double guessed_mass_ratio(const std::string& texts) {
    return named_wet(texts) ? stated_percent(texts).value_or(1) / 100 : 0;
}

namespace {

constexpr double volume_per_mass = glass_density / water_density;

}  // namespace

LiquidGuess liquid_guessed_from(const std::string& texts) {
    const double mass_ratio = guessed_mass_ratio(texts);
    if (mass_ratio == 0) return {0, "GUESS: dry"};
    return {mass_ratio * volume_per_mass,
            fmt::format("GUESS: volume of water over volume of glass, {}",
                        stated_percent(texts) ? "from the names of file and test"
                                              : "as for 1 % of the mass")};
}

LiquidGuess guessed_liquid(const FileView& view) {
    if (const auto stated = stated_liquid(view.file)) {
        if (stated->by_mass)
            return {stated->value * volume_per_mass,
                    fmt::format("GUESS: volume of water over volume of glass, from {}, by mass",
                                stated->from)};
        return {stated->value,
                fmt::format("GUESS: {} is volume of liquid over that of grains", stated->from)};
    }
    return liquid_guessed_from(texts_of(view));
}

}  // namespace pendular
