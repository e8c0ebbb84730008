#include <fmt/format.h>

#include <set>

#include "data/readings.h"
#include "data/recording.h"
#include "data/replicates.h"
#include "data/steady_state.h"
#include "data/study.h"

namespace pendular {
namespace {

Measurements read_file(const std::filesystem::path& file, const Source& source, const Study& study,
                       RunClock& clock) {
    if (source.kind == Source::Kind::readings) return read_points(file, source, study);
    AnnularCell cell = *study.cell;
    cell.bead_volume = source.bead_volume.value_or(cell.bead_volume);
    return reduce_recording(read_recording(file), cell, study.grains,
                            source.liquid_content.value_or(0), clock);
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// Range of liquid contents over which separate bridges describe the liquid.
/// Source: Badetti et al. (2018), section 3.1: the bridges between three touching beads merge at
/// V0 = 0.008 a^3, which is a content of 0.063; theirs begin at 0.003.
constexpr double driest_pendular = 0.002, wettest_pendular = 0.065;

}  // namespace

std::optional<std::string> pendular_range_warning(double content) {
    if (content == 0 || (content >= driest_pendular && content <= wettest_pendular))
        return std::nullopt;
    return content > wettest_pendular
               ? fmt::format(
                     "liquid content {:g} is above the pendular range, which ends at about {:g}: "
                     "bridges of touching beads merge there, and the model of separate bridges "
                     "no longer holds",
                     content, wettest_pendular)
               : fmt::format(
                     "liquid content {:g} is below the pendular range, which begins at about {:g}: "
                     "so little liquid may stay between the asperities of the bead surfaces "
                     "instead of forming bridges",
                     content, driest_pendular);
}

namespace {

/// Warns once of each liquid content that separate bridges do not describe.
void check_pendular_range(Measurements& all) {
    std::set<double> contents;
    for (const Reading& reading : all.readings)
        contents.insert(reading.condition.liquid_content);
    for (const double content : contents) {
        if (const auto warning = pendular_range_warning(content)) all.notes.push_back(*warning);
    }
}

}  // namespace

Measurements read_measurements(const Study& study) {
    Measurements all;
    RunClock clock;
    for (const Source& source : study.sources) {
        for (const std::filesystem::path& file : source.files) {
            const Measurements part = read_file(file, source, study, clock);
            append(all.readings, part.readings);
            append(all.excluded, part.excluded);
            append(all.notes, part.notes);
        }
    }
    pool_replicates(all);
    check_pendular_range(all);
    return all;
}

}  // namespace pendular
