#pragma once

#include <optional>
#include <string>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Kind of test, other than shear at constant speed, that the columns of an interval show, with the
/// evidence: "oscillation: the file has 'Storage Modulus', so that its stresses are amplitudes".
/// Kinds are oscillation (moduli, a phase angle, a frequency, waveforms), creep (a compliance) and
/// relaxation (a relaxation modulus). Columns without a number other than 0 count for none. Empty
/// where no column shows one.
std::optional<std::string> kind_shown_by_columns(const Block& block);

/// Whether a column has results of yield loci, such as a major principal stress, an unconfined
/// strength or a flowability: no study is made of them.
bool names_result_of_locus(const BlockColumn& column);

}  // namespace pendular
