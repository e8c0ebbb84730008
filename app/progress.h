#pragma once

#include <optional>
#include <string>

#include "workflow/listener.h"

namespace pendular::app {

/// Returns a text as a sentence. Its first letter becomes a capital if the first word has
/// lower-case letters only. A full stop is added unless the text ends in ".", "?", a line end, or a
/// command after ": pendular ".
std::string as_sentence(std::string text);

/// Text of a duration given in seconds, for messages: "40 s", "1 min 20 s", "3 h 5 min".
std::string duration(double seconds);

/// Sentence on an event of the work on a study: the stage that begins, the share of simulations
/// done, the result of a round of a fit, or the number of refits. Empty for notes and for a single
/// refit.
std::string progress_sentence(const Event& event);

/// Share of the work that is done at an event [1]; empty where the event does not tell it.
std::optional<double> progress_share(const Event& event);

/// Text on simulations in progress: share done, number done and time left, as in "45 %, 1 of 3
/// simulations done, 20 s left".
std::string progress_numbers(const EnsembleProgress& progress);

}  // namespace pendular::app
