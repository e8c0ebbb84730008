#include "data/recordings/measurements.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "data/files/column_names.h"
#include "data/files/file_access.h"
#include "data/files/formats/layouts.h"
#include "data/files/header_cell.h"
#include "data/files/sheet_path.h"
#include "data/recordings/checks.h"
#include "data/recordings/copies.h"
#include "data/recordings/findings/detectors.h"
#include "data/recordings/findings/look_inside.h"
#include "data/recordings/plausibility.h"
#include "data/recordings/recording.h"
#include "data/recordings/stated_cell.h"
#include "data/recordings/stated_sample.h"
#include "data/recordings/steady_state.h"
#include "data/recordings/steps.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Removes readings of which more than 1 in 100 rows are among `lines`.
void set_rows_aside(std::vector<Reading>& readings, const std::set<int>& lines, int averaged_rows,
                    const Remark& words, std::vector<Remark>& marks) {
    std::erase_if(readings, [&](const Reading& reading) {
        const auto spoilt = lines_within(lines, reading.origin.line, reading.last_line);
        const auto rows =
            static_cast<std::size_t>((reading.last_line - reading.origin.line) / averaged_rows) + 1;
        if (100 * spoilt <= rows) return false;
        Remark& mark = marks.emplace_back(reading.remark(words.kind));
        mark.quantity = words.quantity;
        mark.count = spoilt;
        mark.of = rows;
        mark.limit = words.size;
        return true;
    });
}

/// Removes all readings if a column is doubtful throughout.
void set_all_aside(std::vector<Reading>& readings, const Remark& doubt,
                   std::vector<Remark>& marks) {
    for (const Reading& reading : readings) {
        marks.push_back(reading.remark(Kind::reading_of_wrong_column));
        marks.back().because = {doubt};
    }
    readings.clear();
}

}  // namespace

std::vector<Remark> set_spoilt_aside(std::vector<Reading>& readings,
                                     const std::vector<Remark>& faults, int averaged_rows) {
    std::vector<Remark> marks;
    std::set<int> contradicting;
    for (const Remark& fault : faults) {
        if (fault.outcome != Remark::Outcome::set_aside) continue;
        if (fault.kind == Kind::wrong_factor) set_all_aside(readings, fault, marks);
        if (fault.kind == Kind::contradicting_rows)
            contradicting.merge(all_lines(fault.because.front().lines));
    }
    set_rows_aside(readings, contradicting, averaged_rows, {.kind = Kind::contradicted_reading},
                   marks);
    for (const Remark& fault : faults)
        if (fault.kind == Kind::saturation && fault.corrected)
            set_rows_aside(
                readings, all_lines(fault.lines), averaged_rows,
                {.kind = Kind::saturated_reading, .quantity = fault.quantity, .size = fault.size},
                marks);
    for (const Remark& fault : faults)
        if (fault.kind == Kind::constant_torque && fault.outcome == Remark::Outcome::set_aside)
            set_all_aside(readings, fault, marks);
    return decide(std::move(marks), false);
}

namespace {

/// State that is passed from each file of a study to the next file.
struct FilesBefore {
    RunClock clock;
    KnownRows rows;
    InsideRecordings inside;
};

/// Checks that the study states a liquid content where a column of a recording has one: without it,
/// wet grains would count as dry.
/// @throws InputError if it does not, or if the content changes within the file
void check_liquid_column(const BlockFile& file, const Source& source) {
    const auto column = liquid_in_column(file);
    if (!column || column->value == 0 || source.liquid_content) return;
    throw InputError(source.position,
                     fmt::format("{} has the liquid content {:.4g} in {}; state liquid_content in "
                                 "this entry, the volume of liquid over that of grains, and add "
                                 "[liquid] to study.toml",
                                 std::filesystem::path(file.file).filename().string(),
                                 column->value, column->from));
}

/// Whether a column that a recording does not need has liquid contents.
bool has_liquid_column(const Recording& recording) {
    return std::ranges::any_of(recording.unused_columns, [](const std::string& header) {
        const HeaderCell parts = parse_header_cell(header);
        return meaning_of_column(parts.name, parts.unit).quantity == "liquid_content";
    });
}

/// Reads a recording, with remarks on what its file says against study.toml and against its own set
/// points.
Recording read_checked(const std::filesystem::path& path, const Source& source,
                       const AnnularCell& cell, std::vector<Remark>& found) {
    const FileFormat& format = source.format;
    if (auto recording = quick_recording(path, format)) {
        std::error_code unknown;
        if (has_liquid_column(*recording) &&
            std::filesystem::file_size(path, unknown) <= largest_table)
            check_liquid_column(read_blocks(path, format), source);
        if (recording->averaged_rows > 1)
            found.push_back({.kind = Kind::averaged_rows,
                             .files = {recording->file},
                             .count = static_cast<std::size_t>(recording->averaged_rows),
                             .of = most_kept_rows});
        return *std::move(recording);
    }
    const BlockFile file = read_blocks(path, format);
    check_liquid_column(file, source);
    Recording recording = recording_of(file, format);
    append(found, header_against_study(file, cell));
    append(found, missed_set_points(file));
    append(found, hidden_rows(file));
    append(found, std::exchange(recording.left_out, {}));
    return recording;
}

/// Detects faulty rows, decides what follows, and corrects or leaves out these rows.
Recording recording_without_faulty_rows(const std::filesystem::path& file, const Source& source,
                                        const AnnularCell& cell, bool keep_implausible,
                                        KnownRows& before, std::vector<Remark>& remarks) {
    std::vector<bool> rows;
    const auto say = [&](std::vector<Remark> found) {
        append(remarks, decide(std::move(found), keep_implausible));
    };
    std::vector<Remark> of_file;
    Recording recording = read_checked(file, source, cell, of_file);
    say(std::move(of_file));
    fill_from_stresses(recording, cell);
    if (source.format.repair) {
        say(torques_without_mark(recording, cell, rows));
        repair_torques(recording, cell, rows);
    }
    say(before.copies_in(recording, source, rows));
    recording.erase_rows(rows);
    say(contradictions(recording, cell, rows));
    if (!keep_implausible) recording.erase_rows(rows);
    return recording;
}

/// Readings of one recording. The order is that of the stations of a fault (ARCHITECTURE.md): rows
/// are left out before means are taken, and readings are marked by all that was found before.
Measurements measure(const std::filesystem::path& file, const Source& source, const Study& study,
                     FilesBefore& before) {
    AnnularCell cell = *study.cell;
    cell.bead_volume = source.bead_volume.value_or(cell.bead_volume);
    const bool keep = study.import.keep_implausible;
    Measurements result;
    const auto say = [&](std::vector<Remark> found) {
        append(result.remarks, decide(std::move(found), keep));
    };
    // Detect and decide.
    const Recording recording =
        recording_without_faulty_rows(file, source, cell, keep, before.rows, result.remarks);
    if (recording.size() == 0) return result;
    std::vector<RecordedStep> steps = recorded_steps(recording);
    find_creep(recording.file, steps);
    const std::vector<Remark> saturated = decide(saturations(recording, steps), keep);
    say(separate_from_spikes(saturated, recording.file, steps));
    say(saturated_steps(saturated, recording, steps));
    say(constant_columns(recording));
    before.inside.look_at(recording.file, steps, cell, study.import.least_strain);
    // Reduce.
    Measurements part = reduce_steps(steps, recording, cell, study.grains,
                                     source.liquid_content.value_or(0), before.clock, study.import);
    append(result.remarks, std::move(part.remarks));
    // Mark.
    std::vector<Remark> faults = result.doubts();
    append(faults, saturated);
    append(result.remarks, set_spoilt_aside(part.readings, faults, recording.averaged_rows));
    if (part.readings.empty()) say(impossible_filling(recording, cell));
    result.readings = std::move(part.readings);
    return result;
}

/// Remarks on faults inside of the recordings of a study; none where the study has only tables of
/// readings.
std::vector<Remark> inside_recordings(const std::vector<Reading>& readings, const Study& study,
                                      const InsideRecordings& inside) {
    if (!study.cell) return {};
    std::vector<Reading> recorded;
    std::ranges::copy_if(readings, std::back_inserter(recorded),
                         [](const Reading& reading) { return reading.within_run_only; });
    return inside.findings(recorded, *study.cell);
}

/// Removes the readings that decided remarks name (`impossible_reading`, `repeated_reading`).
void set_named_aside(std::vector<Reading>& readings, const std::vector<Remark>& remarks) {
    std::set<std::tuple<std::string, int, int>> named;
    for (const Remark& remark : remarks)
        if (remark.outcome == Remark::Outcome::left_out &&
            (remark.kind == Kind::impossible_reading || remark.kind == Kind::repeated_reading))
            named.emplace(remark.file(), remark.first_line(), remark.step);
    std::erase_if(readings, [&](const Reading& reading) {
        return named.contains({reading.origin.file, reading.origin.line, reading.step});
    });
}

/// Check of a study with all its readings.
using StudyCheck = std::vector<Remark> (*)(const Study& study, const Measurements& all);

constexpr StudyCheck checks_before_pooling[] = {
    [](const Study&, const Measurements& all) { return repeated_readings(all.readings); },
    [](const Study& study, const Measurements& all) {
        return study.import.keep_implausible ? std::vector<Remark>{}
                                             : near_copies(all.readings, all.remarks);
    },
    [](const Study& study, const Measurements& all) {
        return impossible_readings(all.readings, study);
    },
    [](const Study&, const Measurements& all) { return saturated_columns(all.remarks); },
    [](const Study&, const Measurements& all) { return other_speed_units(all.readings); },
    [](const Study& study, const Measurements&) { return patterns_without_file(study); },
    [](const Study& study, const Measurements&) { return unread_sheets(study); },
    incomplete_files};

constexpr StudyCheck checks_after_pooling[] = {
    [](const Study&, const Measurements& all) { return merging_bridges(all.readings); },
    [](const Study& study, const Measurements& all) { return few_beads(study, all.readings); },
    [](const Study&, const Measurements& all) { return creeping_gaps(all.readings); },
    [](const Study& study, const Measurements& all) { return uneven_shear(study, all.readings); },
    [](const Study&, const Measurements& all) { return points_of_failure(all.readings); },
    [](const Study& study, const Measurements& all) { return grain_weight(study, all.readings); }};

void check(std::span<const StudyCheck> checks, const Study& study, Measurements& all) {
    for (const StudyCheck each : checks) {
        std::vector<Remark> found = decide(each(study, all), study.import.keep_implausible);
        set_named_aside(all.readings, found);
        append(all.remarks, std::move(found));
    }
}

/// Readings of one file of an entry.
Measurements measurements_of(const std::filesystem::path& file, const Source& source,
                             const Study& study, FilesBefore& before) {
    try {
        return source.kind == Source::Kind::readings ? read_points(file, source, study)
                                                     : measure(file, source, study, before);
    } catch (const InputError& error) {
        if (!as_sheet(file) || !source.format.sheet.empty()) throw;
        throw InputError(
            fmt::format("{}. If this sheet is not to be read, name those that are in "
                        "line {} of study.toml: sheet = \"...\"",
                        error.what(), source.position.line));
    }
}

}  // namespace

Measurements read_measurements(const Study& study) {
    Measurements all;
    FilesBefore before;
    for (const Source& source : study.sources) {
        for (const std::filesystem::path& file : source.files) {
            Measurements of_file = measurements_of(file, source, study, before);
            all.readings.insert(all.readings.end(), of_file.readings.begin(),
                                of_file.readings.end());
            append(all.remarks, decide(std::move(of_file.remarks), study.import.keep_implausible));
        }
    }
    check(checks_before_pooling, study, all);
    append(all.remarks, decide(inside_recordings(all.readings, study, before.inside), false));
    pool_replicates(all, study.scatter);
    check(checks_after_pooling, study, all);
    return all;
}

}  // namespace pendular
