#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "data/recordings/file_view.h"

namespace pendular {

/// Whether the rows of a table of points state liquid contents, which the tables of a begun study
/// then have too.
bool states_contents(const FileView& view);

/// Whether the rows of a table of points state errors of the shear stress. Without them, those of
/// `failure_table` are 1 % of the shear stress.
bool states_errors(const FileView& view);

/// Names of the groups of a table of points, in its order. A study describes one material, and
/// whether the groups are of one is not known. Empty for less than two groups, and for files that
/// are no tables of points.
std::vector<std::string> groups_of_points(const FileView& view);

/// Name of a table of a group, such as "failure_Sand_A": letters and digits of the group's name
/// behind that of the table. Names that are equal in small letters get a number.
/// @param taken names in small letters, to which the new one is added
std::string name_of_table(const std::string& table, const std::string& group,
                          std::set<std::string>& taken);

/// Table of the points of failure, each of which says that it is one. Points of tension, at a
/// normal stress that is not positive, are left out: no study reads them.
/// @param group of the points, which a column names; empty: all points
std::string failure_table(const FileView& view, const std::optional<std::string>& group = {});

/// Table of the ends of the preshears in steady shear; empty if there are none. If the file states
/// bulk densities, they are given without the liquid, with a standard deviation of 1 %.
/// @param mass_ratio mass of liquid over mass of grains [1]
/// @param group of the preshears, which a column names; empty: all preshears
std::string steady_table(const FileView& view, double mass_ratio,
                         const std::optional<std::string>& group = {});

}  // namespace pendular
