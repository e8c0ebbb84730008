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

/// Sentence on the progress of a computation, from an event that reports it: the stage that begins,
/// the share of simulations done, the fit at the end of a round, or the number of refits done.
/// Empty for notes and for a single refit.
std::string progress_sentence(const Event& event);

/// Share of the running computation that is done, from an event that reports progress [1]; empty
/// where the event does not state this share.
std::optional<double> progress_share(const Event& event);

/// Text on simulations in progress: share done, number done and time left, as in "45 %, 1 of 3
/// simulations done, 20 s left".
std::string progress_numbers(const EnsembleProgress& progress);

}  // namespace pendular::app
