#pragma once

#include <string>

#include "data/recordings/file_view.h"

namespace pendular {

/// Whether the rows of a table of points state liquid contents, which the tables of a begun study
/// then have too.
bool states_contents(const FileView& view);

/// Table of the points of failure, each of which says that it is one. Points of tension, at a
/// normal stress that is not positive, are left out: no study reads them.
std::string failure_table(const FileView& view);

/// Table of the ends of the preshears in steady shear; empty if there are none. If the file states
/// bulk densities, they are given without the liquid, with a standard deviation of 1 %.
/// @param mass_ratio mass of liquid over mass of grains [1]
std::string steady_table(const FileView& view, double mass_ratio);

}  // namespace pendular
