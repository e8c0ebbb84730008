#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Tests and roles of the rows of a table of points, as its columns of texts state them.
struct PointTexts {
    /// Test of each row, from a column that names materials, samples or the like, or from titles
    /// between the rows; empty: none. The points of a test make a yield locus of their own.
    std::vector<std::string> tests;
    /// Role of each row that is no point of failure, as `roles_in_column`; empty: no column states
    /// any.
    std::vector<std::string> roles;
    /// Names of columns at whose different values the same loads recur within a test, so that they
    /// may tell tests apart, or repeats.
    std::vector<std::string> doubtful = {};
};

/// Whether a column of this name names materials, samples or the like, of which each has a locus.
bool names_tests(std::string_view name);

/// Whether a column has a condition of tests, such as a temperature or a water content, of which
/// each value may have a locus.
bool names_condition(const BlockColumn& column);

/// Returns what the texts of a table of points say. A column tells tests apart if its name is one
/// of those that people give to materials and samples, and each of its texts or numbers stands at
/// two loads at least, preshears aside, or if each of its texts stands in three rows in succession.
/// Without such a column, titles between the rows do if below each stand two loads at least. A
/// column of a condition parts the points further where the same loads recur at its different
/// values, or where each value stands at three loads in succession.
PointTexts texts_of_points(const Block& table, const std::vector<Title>& titles);

}  // namespace pendular
