#pragma once

#include <string>
#include <vector>

#include "data/input_error.h"

namespace pendular {

class StudyTable;

/// A formula of a written effect: what it gives and its text.
struct Formula {
    std::string target;  ///< "torque", ...: a key of [[effect]]
    std::string text;
    Position position;
};

/// An effect that a user defines in the study, [[effect]], its formulas not yet compiled.
struct WrittenEffect {
    std::string name;
    std::string parameter;            ///< "on": a switch
    std::string unit = "1";           ///< SI
    double lower = 0, upper = 1;      ///< [unit]
    double neutral = 0;               ///< [unit]
    double smallest_of_interest = 1;  ///< [unit]
    std::string summary = {};         ///< empty where the user gave none
    std::vector<Formula> formulas;
    Position position;  ///< of the table
    Position name_position = {}, parameter_position = {};

    /// Whether the formulas change what the instrument shows rather than the flow of the grains.
    bool of_instrument() const;
};

/// Quantities that the formulas of an [[effect]] can set: those of the instrument or those of the
/// flow. One effect sets quantities of one kind only.
const std::vector<std::string>& instrument_targets();
const std::vector<std::string>& flow_targets();

/// The [[effect]] tables of a study.
/// @throws InputError for anything missing, unknown or impossible in itself
std::vector<WrittenEffect> read_written_effects(const StudyTable& root);

}  // namespace pendular
