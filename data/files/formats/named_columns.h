#pragma once

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Reads the columns that the user names (`FileFormat::named_columns`) as the quantities that he
/// states, in place of any other column of these quantities. Columns with the errors of a named one
/// ("Tau_sd" of "Tau") become those of the quantity.
/// @throws InputError at the header if no interval has a column of the name
void use_named_columns(BlockFile& file, const FileFormat& format);

/// Returns a line with which a column is read as a quantity: `columns = { torque = "Md [mN m]" }`.
std::string line_to_name(std::string_view quantity, std::string_view name, std::string_view unit);

}  // namespace pendular
