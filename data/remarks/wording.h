#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/remarks/remark.h"

namespace pendular {

/// Words for remarks, the only ones in the program. They stand left of `calib`, whose errors quote
/// warnings, and not in `reports`.

/// Returns a remark for the user: a sentence for a warning, a note and a fault of a file; the
/// reason, without a capital or a full stop, for rows and readings that are left out.
std::string text_of(const Remark& remark);

/// Returns the reason why rows of a step are left out, without the number of the step.
std::string reason_of(const Remark& remark);

/// Returns how many times stated errors exceed the scatter of repeated readings, such as "3.2", of
/// a remark of kind `errors_above_scatter`.
std::string factor_above_scatter(const Remark& note);

/// Returns a sentence on values that are probably wrong.
std::string doubt_text(const Remark& doubt);

/// Returns the reason for a doubt without the file, a capital or a full stop: of a value that
/// cannot be, of a column that differs from another by a factor, of a constant column.
std::string impossible_text(const Remark& doubt);
std::string factor_text(const Remark& doubt);
std::string constant_text(const Remark& doubt);

/// Returns a warning for the user if a liquid content [1] is outside of the pendular range, in
/// which the liquid forms separate bridges; empty inside of it and for dry grains.
std::optional<std::string> pendular_range_warning(double liquid_content);

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

/// Returns a sentence on the sheets of a workbook that are not read.
std::string unread_sheets_text(const std::string& file, const std::vector<std::string>& sheets);

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

/// Returns the number of readings with a doubt or without a usable mean, without transients and
/// steps that rest.
std::size_t readings_set_aside(const Measurements& measurements);

/// Whether import gave nothing to rely on: more readings were set aside than kept, or rows were
/// left out and no reading is there.
bool mostly_set_aside(const Measurements& measurements);

/// Returns a sentence with the reason for which most steps were left out, and advice, such as "The
/// normal force is negative in all 30 steps; compression must be positive: ...". Empty unless
/// `mostly_set_aside`, or if the reason is not known.
std::optional<std::string> common_reason(const Measurements& measurements);

/// Returns a sentence on why a study has no reading, with advice.
std::string why_no_reading(const Measurements& measurements);

}  // namespace pendular
