#pragma once

#include "data/files/formats/table_parts.h"

namespace pendular {

/// Finds tables that stand side by side, where the names of the columns begin anew within their
/// line, and tables below one another, where the line of the names occurs again.
SeveralTables tables_in(const SourceLines& source);

}  // namespace pendular
