#pragma once

#include <string>
#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Tests and roles of the rows of a table of points, as its columns of texts state them.
struct PointTexts {
    /// Test of each row, from a column that names materials, samples or the like; empty: none. The
    /// points of a test make a yield locus of their own.
    std::vector<std::string> tests;
    /// Whether each row is a preshear, as "Preshear 1" beside "Shear 1" says; empty: no column
    /// does.
    std::vector<bool> preshears;
};

/// Returns what the texts of a table of points say. A column tells tests apart if its name is one
/// of those that people give to materials and samples, and each of its texts or numbers stands at
/// two loads at least, preshears aside, or if each of its texts stands in three rows in succession.
PointTexts texts_of_points(const Block& table);

}  // namespace pendular
