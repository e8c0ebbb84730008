#include "reports/odd_file_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "reports/with_error.h"
#include "reports/words.h"
#include "workflow/json/diagnosis.h"

namespace pendular {
namespace {

/// Text of a mean deviation: "0.52 % lower", "0.1 % higher".
std::string side(double deviation) {
    return fmt::format("{:.2g} % {}", 100 * std::abs(deviation),
                       deviation < 0 ? "lower" : "higher");
}

/// Sentences on the distance of a file from the others.
std::string distance_text(const OddFile& odd, const std::string& verb, const std::string& model) {
    std::string text =
        fmt::format("{} {}: its {} is on average {} than by {}, that of the other {} files {}.",
                    std::filesystem::path(odd.file).filename().string(), verb,
                    odd.observable == 0 ? "shear stress" : "solid fraction", side(odd.deviation),
                    model, odd.files - 1, side(odd.others));
    if (const auto gap = odd.gap_error()) {
        text += fmt::format(" A gap that is shown {} too {} would do so.",
                            with_unit(std::abs(*gap), "m"), *gap > 0 ? "large" : "small");
    }
    return text;
}

/// The model that files are compared with, in words: "the model with wall-friction".
std::string model_in_words(const StudyDiagnosis& d) {
    const std::vector<std::string> effects = names_of(explaining_model(d.diagnosis), *d.models);
    return effects.empty() ? "the model" : "the model with " + joined(effects, "and");
}

}  // namespace

std::string odd_file_text(const OddFile& odd, const std::string& model) {
    std::string text = distance_text(odd, odd.stands_out() ? "stands out" : "deviates most", model);
    if (odd.alone) {
        text +=
            " It is the only file with its liquid content, so that the model may be at fault "
            "there.";
    }
    if (!odd.stands_out()) {
        text += fmt::format(
            " Fillings differ, and {} files are too few to be sure: in {:.0f} of "
            "100 studies, one deviates as far by chance.",
            odd.files, 100 * odd.p);
    }
    return text + " Look at this recording first, and repeat it with a new filling.";
}

std::string odd_file_line(const StudyDiagnosis& d) {
    const auto odd = odd_recording(d);
    return odd && odd->worth_a_look() ? odd_file_text(*odd, model_in_words(d)) : "";
}

std::string files_line(const StudyDiagnosis& d) {
    const auto odd = odd_recording(d);
    if (!odd) return "";
    const std::string words = model_in_words(d);
    if (odd->worth_a_look()) return odd_file_text(*odd, words);
    // To name the farthest of files that differ by chance would mislead.
    if (odd->p_by_readings >= significant_p)
        return fmt::format(
            "No file stands out: the scatter of the readings explains how the {} files differ.",
            odd->files);
    return "No file stands out. " + distance_text(*odd, "deviates most", words) +
           fmt::format(" Fillings that differ among {} files can explain that (p = {:.2g}).",
                       odd->files, odd->p);
}

}  // namespace pendular
