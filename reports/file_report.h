#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "data/recordings/file_view.h"
#include "data/recordings/measurements.h"
#include "reports/output.h"

namespace pendular {

/// Returns a sentence with the layout by which the file is read, and the numbers of its intervals
/// (steps of constant set points) and rows.
std::string file_sentence(const FileView& view);

/// Returns a sentence with the character encoding, the delimiter and the decimal mark.
std::string encoding_sentence(const FileView& view);

/// Returns a table of the columns: name, unit, the quantity read from the column and, if not all
/// intervals have the column, their number.
std::vector<std::string> columns_table(const FileView& view);

/// Returns a table of the intervals: number, role (such as preshear) with its reason, rows, lines
/// in the file, median normal stress [Pa] (or force [N]), largest shear stress [Pa] (or torque [N
/// m]).
std::vector<std::string> intervals_table(const FileView& view);

/// Returns a heading and a sentence for each fault (lines, fault, remedy applied) and for each kind
/// of rows left out (lines, reason), or one sentence if there are none.
/// @param all whether to name all lines concerned; otherwise at most 8 ranges of lines a sentence
std::vector<std::string> checks_lines(const FileView& view, bool all);

/// Returns what `pendular import STUDY` says of the readings of a study.
/// @param folder of readings.csv and excluded.csv
/// @param study the study's name as the user gave it
Output import_output(const Measurements& measurements, const std::filesystem::path& folder,
                     const std::string& study, bool all);

/// Returns a sentence on why nothing of some files is used; empty if anything is.
std::string unused_sentence(const std::vector<FileView>& views);

/// Returns what `pendular import FILE` says of a file.
/// @param is_answer whether the first sentence is the answer of the command
Output file_output(const FileView& view, bool all, bool is_answer = true);

/// Returns a sentence on the groups of points of a file, at least two, of which the study in `toml`
/// reads the first.
std::string groups_sentence(const FileView& view, const std::vector<std::string>& groups,
                            const std::filesystem::path& toml);

/// Returns a sentence on the number of guessed values in `toml`, the study.toml that was written.
std::string guesses_sentence(std::size_t guesses, const std::filesystem::path& toml);

}  // namespace pendular
