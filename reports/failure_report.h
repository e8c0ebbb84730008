#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// "= 0.02", "< 0.001"; with another word in place of "= ".
std::string p_text(double p, const char* equals = "= ");

/// Those with p < 0.05, the most telling first.
std::vector<const Check*> significant_checks(const Checks& checks);

/// Where a model fails, one line a check that is significant; before them that of all together.
std::vector<std::string> checks_table(const Checks& checks);

/// The same, then the conditions and files that stand out.
std::vector<std::string> failure_table(const WhereItFails& where);

}  // namespace pendular
