#include "data/recordings/measurements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "data/files/formats/layouts.h"
#include "data/recordings/contradictions.h"
#include "data/recordings/copies.h"
#include "data/recordings/findings/look_inside.h"
#include "data/recordings/findings/saturation.h"
#include "data/recordings/grain_weight.h"
#include "data/recordings/incomplete_files.h"
#include "data/recordings/plausibility.h"
#include "data/recordings/quick_recording.h"
#include "data/recordings/readings.h"
#include "data/recordings/recording.h"
#include "data/recordings/repair.h"
#include "data/recordings/replicates.h"
#include "data/recordings/set_points.h"
#include "data/recordings/speed_units.h"
#include "data/recordings/stated_cell.h"
#include "data/recordings/steady_state.h"
#include "data/study/study.h"

namespace pendular {
namespace {

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

void append(Measurements& to, const Measurements& from) {
    append(to.readings, from.readings);
    append(to.excluded, from.excluded);
    append(to.doubts, from.doubts);
    append(to.findings, from.findings);
    append(to.file_findings, from.file_findings);
    append(to.notes, from.notes);
}

/// State that is passed from each file of a study to the next file.
struct FilesBefore {
    RunClock clock;
    KnownRows rows;
    InsideRecordings inside;
};

/// Reads a recording, and adds what its file says against study.toml and against its own set
/// points.
Recording read_checked(const std::filesystem::path& path, const FileFormat& format,
                       const AnnularCell& cell, Measurements& result) {
    if (auto recording = quick_recording(path, format)) {
        if (recording->averaged_rows > 1)
            result.notes.push_back(fmt::format(
                "{} has more than {} rows: each {} consecutive rows count as one, with their mean. "
                "Spikes and saturation within such a group are not seen.",
                path.filename().string(), most_kept_rows, recording->averaged_rows));
        return *std::move(recording);
    }
    const BlockFile file = read_blocks(path, format);
    Recording recording = recording_of(file, format);
    append(result.file_findings, compare_with_study(file, cell));
    std::vector<FileFinding> missed;
    check_set_points(file, missed);
    for (FileFinding& finding : missed)
        finding.file = file.file;
    append(result.file_findings, missed);
    return recording;
}

Measurements read_file(const std::filesystem::path& file, const Source& source, const Study& study,
                       FilesBefore& before) {
    if (source.kind == Source::Kind::readings) return read_points(file, source, study);
    AnnularCell cell = *study.cell;
    cell.bead_volume = source.bead_volume.value_or(cell.bead_volume);
    Measurements result;
    Recording recording = read_checked(file, source.format, cell, result);
    fill_from_stresses(recording, cell);
    append(result.excluded, recording.left_out);
    if (source.format.repair) repair_torques(recording, cell, result);
    before.rows.take_out_copies(recording, source, result);
    if (recording.size() == 0) return result;
    const Contradictions contradictions =
        take_out_contradictions(recording, cell, study.import, result);
    if (recording.size() == 0) return result;
    std::vector<RecordedStep> steps = recorded_steps(recording);
    const std::vector<Saturation> saturated = saturations(recording, steps);
    separate_from_spikes(saturated, recording.file, steps, result);
    before.inside.look_at(recording.file, steps, cell, study.import.least_strain);
    Measurements part = reduce_steps(steps, recording, cell, study.grains,
                                     source.liquid_content.value_or(0), before.clock, study.import);
    set_aside_contradicted(contradictions, part);
    set_aside_saturated(saturated, recording, steps, study.import, part);
    doubt_stuck_columns(recording, part, study.import);
    if (part.readings.empty() && !study.import.keep_implausible)
        doubt_solid_fraction_of(recording, cell, part);
    append(result, part);
    return result;
}

/// Findings inside of the recordings of a study; none where the study has only tables of readings.
std::vector<RecordingFinding> inside_findings(const std::vector<Reading>& readings,
                                              const Study& study, const InsideRecordings& inside) {
    if (!study.cell) return {};
    std::vector<Reading> recorded;
    std::ranges::copy_if(readings, std::back_inserter(recorded),
                         [](const Reading& reading) { return reading.within_run_only; });
    return inside.findings(recorded, *study.cell);
}

/// Range of liquid contents [1] in which the liquid forms bridges, most of them separate.
/// Source: Badetti et al. (2018), section 3.1: their smallest liquid content is 0.003, the largest
/// that they measured 0.075.
constexpr double driest_pendular = 0.002, wettest_pendular = 0.075;
/// Liquid content [1] from which bridges between three touching grains merge.
/// Source: Badetti et al. (2018), table philphis: V0 = 0.008 a^3; 2 % for the last printed digit.
constexpr double merging_content = 1.02 * 0.063;

/// Note on readings whose liquid content is beyond separate bridges, with the saturation of their
/// pores; empty where there are none.
std::optional<std::string> merging_note(const std::vector<Reading>& readings) {
    std::size_t count = 0;
    double content = 0, saturation = 0;
    for (const Reading& reading : readings) {
        const double own = reading.condition.liquid_content, fraction = reading.value(1);
        if (!(own > merging_content)) continue;
        ++count;
        content = std::max(content, own);
        if (fraction > 0 && fraction < 1)
            saturation = std::max(saturation, own * fraction / (1 - fraction));
    }
    if (count == 0) return std::nullopt;
    return fmt::format(
        "{} {} a liquid content above 0.063, up to {:.3g}{}: the bridges between three touching "
        "beads merge from there on, and the model of separate bridges is no longer exact",
        count, count == 1 ? "reading has" : "readings have", content,
        saturation > 0 ? fmt::format(" (liquid fills {:.2g} % of the pores)", 100 * saturation)
                       : "");
}

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
                     "the liquid may stay between the asperities of the bead surfaces instead of "
                     "forming bridges",
                     content, driest_pendular);
}

namespace {

/// Note on a cell in which few beads fit side by side, or on one another; empty if enough do.
std::optional<std::string> note_on_few_beads(const Study& study,
                                             const std::vector<Reading>& readings) {
    // Walls order the beads over some diameters: the model, a flow without walls, holds between
    // them. Source: GDR MiDi, Eur. Phys. J. E 14 (2004) 341: shear bands of 5 to 10 diameters.
    constexpr double enough = 10;
    if (!study.cell) return std::nullopt;
    const double diameter = study.grains.diameter,
                 width = study.cell->outer_radius - study.cell->inner_radius;
    double height = INFINITY;
    for (const Reading& reading : readings)
        height = std::min(height, reading.condition.height.value_or(INFINITY));
    const bool narrow = width < enough * diameter, low = height < enough * diameter;
    if (!narrow && !low) return std::nullopt;
    const auto beads = [&](const char* name, double size) {
        return fmt::format("the {} of the sample, {:.3g} mm, is {:.2g} bead diameters", name,
                           1e3 * size, size / diameter);
    };
    return fmt::format(
        "{}{}{}: below ten, the walls order the beads, and the model, a flow without walls, may "
        "not hold",
        narrow ? beads("width", width) : "", narrow && low ? "; " : "",
        low ? beads("height", height) : "");
}

/// Note on readings that are points of failure, if there are any.
std::optional<std::string> note_on_failure(const std::vector<Reading>& readings) {
    const auto count = std::ranges::count_if(
        readings, [](const Reading& reading) { return reading.condition.at_failure; });
    if (count == 0) return std::nullopt;
    return fmt::format(
        "{} of {} readings are points of failure: peaks of the shear stress of a consolidated "
        "bed, not steady shear. The model describes steady shear; the effect peak-strength is the "
        "factor between the two.",
        count, readings.size());
}

/// One note for each pattern of study.toml that matches no file.
std::vector<std::string> notes_on_missing_files(const Study& study) {
    std::vector<std::string> notes;
    for (const Source& source : study.sources) {
        if (!source.files.empty()) continue;
        notes.push_back(
            fmt::format("No file matches \"{}\" (line {} of study.toml): nothing is "
                        "read for this entry.",
                        source.pattern, source.position.line));
    }
    return notes;
}

}  // namespace

Measurements read_measurements(const Study& study) {
    Measurements all;
    FilesBefore before;
    for (const Source& source : study.sources)
        for (const std::filesystem::path& file : source.files)
            append(all, read_file(file, source, study, before));
    count_readings_once(all);
    doubt_impossible_readings(all, study);
    doubt_saturated(all, study.import);
    doubt_speed_units(all);
    append(all.findings, inside_findings(all.readings, study, before.inside));
    append(all.notes, notes_on_missing_files(study));
    append(all.notes, notes_on_incomplete_files(study, all));
    pool_replicates(all, study.scatter);
    if (const auto note = merging_note(all.readings)) all.notes.push_back(*note);
    if (const auto note = note_on_few_beads(study, all.readings)) all.notes.push_back(*note);
    if (const auto note = note_on_failure(all.readings)) all.notes.push_back(*note);
    all.weight_note = grain_weight_note(study, all.readings);
    return all;
}

}  // namespace pendular
