#pragma once

#include <optional>
#include <string>

#include "workflow/listener.h"

namespace pendular::app {

/// Text as a sentence: with a capital at its beginning if its first word has lower-case letters
/// only, and with a full stop at its end unless it ends in ".", "?", a line end, or a command after
/// ": pendular ".
std::string as_sentence(std::string text);

/// Text of a duration given in seconds, for messages: "40 s", "1 min 20 s", "3 h 5 min".
std::string duration(double seconds);

/// Sentence on the progress of the work on a study, for the kinds of events that name what is being
/// done; empty for other kinds, and for a single fit.
std::string progress_sentence(const Event& event);

/// Share of the work that an event names which is done [1]; empty where it is not known.
std::optional<double> progress_share(const Event& event);

/// Numbers on simulations in progress: "45 %, 1 of 3 simulations done, 20 s left".
std::string progress_numbers(const EnsembleProgress& progress);

}  // namespace pendular::app
