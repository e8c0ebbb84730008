#pragma once

#include <optional>
#include <string>

#include "data/recordings/file_view.h"

namespace pendular {

/// A value for study.toml with a comment on its origin.
struct Guess {
    std::string value, from;
};

/// Densities [kg/m^3] with which a mass of liquid over that of grains becomes a liquid content; the
/// study marks the result as a guess.
constexpr double glass_density = 2500, water_density = 1000;

/// Texts of a file that may say what was measured, the most specific first: names of tests and
/// samples, the file's name, the project's name.
std::string texts_of(const FileView& view);

/// Texts that may say what was measured in one group of the points of a file: its name in place of
/// those of tests.
std::string texts_of_group(const FileView& view, const std::string& group);

Guess guessed_diameter(const std::string& texts);

/// Mass of liquid over mass of grains that the names of file and test state, in per cent.
std::optional<double> stated_percent(const std::string& texts);

/// Mass of liquid over mass of grains [1] that the names of file and test suggest; 0 for dry
/// grains.
double guessed_mass_ratio(const std::string& texts);

/// Liquid content for study.toml with a comment on its origin.
struct LiquidGuess {
    double value = 0;  ///< volume of liquid over volume of grains [1]
    std::string from;
    double mass_ratio() const { return value * water_density / glass_density; }
};

/// Liquid content that the names of file and test suggest.
LiquidGuess liquid_guessed_from(const std::string& texts);

/// Liquid content that a file states in a column or above its table or, if it states none, that the
/// names of file and test suggest.
/// @throws InputError if the content changes within a recording
LiquidGuess guessed_liquid(const FileView& view);

}  // namespace pendular
