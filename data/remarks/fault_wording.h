#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "data/remarks/remark.h"

namespace pendular {

/// Returns the name of a file without its folder.
std::string file_name_of(const std::string& file);

/// Returns a text that begins with a capital.
std::string with_capital(std::string text);

/// Returns words for a column: "normal force", "gap".
std::string words_for_quantity(std::string quantity);

/// Returns a sentence on a fault inside recordings or of a file.
std::string fault_text(const Remark& fault);

/// Returns a sentence on what the program does about a fault of a file.
std::string done_about(const Remark& fault);

/// Returns ranges of lines as text, such as "12-15, 20", with at most `most` ranges and the number
/// of those left out.
std::string text_of_lines(const std::vector<Lines>& lines, std::size_t most = 8);

/// Returns a fault of a file with at most `most` ranges of lines, such as "Lines 12-15, 20: the
/// time goes back. The rows are left out."
std::string with_lines(const Remark& fault, std::size_t most = 8);

/// Returns sentences for the user about faults inside recordings, ordered by kind. One sentence
/// combines all that agree in kind, quantity and, for a wobble, period. It states where the fault
/// was found, its median size with the unit and in per cent, and the smallest p value or, for a
/// saturation, the share of saturated rows.
/// @param all each fault has a sentence of its own
std::vector<std::string> sentences(const std::vector<Remark>& faults, bool all = false);

}  // namespace pendular
