#include "workflow/study_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "calib/emulator/known_runs.h"
#include "calib/model/mohr_coulomb.h"
#include "data/files/file_access.h"
#include "data/files/sheet_path.h"
#include "data/files/text_file.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "data/recordings/measurements.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_table.h"

namespace pendular {
namespace {

namespace fs = std::filesystem;

/// All files that a study is read from.
std::vector<fs::path> inputs_of(const Study& study) {
    std::vector<fs::path> inputs = {study.file};
    for (const Source& source : study.sources) {
        std::ranges::transform(source.files, std::back_inserter(inputs), file_to_open);
    }
    return inputs;
}

/// Returns the `file` pattern of the study that would read an output as a measurement; empty where
/// no pattern would. An output without an extension is a folder of files.
std::optional<std::string> pattern_that_reads(const fs::path& output, const Study& study) {
    for (const Source& source : study.sources) {
        const bool folder = !output.has_extension();
        if (folder ? matches(output, study.folder, fs::path(source.pattern).parent_path().string())
                   : matches(output, study.folder, source.pattern)) {
            return source.pattern;
        }
    }
    return std::nullopt;
}

/// Whether writing `output` replaces the file `input`. Where `output` is a folder, any file in it
/// may be written.
bool would_replace(const fs::path& output, const fs::path& input) {
    std::error_code error;  // an output that is not there yet replaces nothing
    if (!fs::is_directory(output, error)) {
        return fs::equivalent(output, input, error);
    }
    return fs::equivalent(output, fs::canonical(input, error).parent_path(), error);
}

/// Checks that results go to no place that a link in the study names. A folder for results that the
/// user named may be a link.
/// @throws InputError where one of the outputs is a link that leads out of its folder
void protect_other_folders(const Study& study, const OutputPlaces& outputs) {
    if (outputs.folder.lexically_normal() == (study.folder / "out").lexically_normal())
        refuse_link_outside(outputs.folder);
    for (const fs::path& output : outputs.files) {
        refuse_link_outside(outputs.folder / output);
    }
}

}  // namespace

void protect_inputs(const Study& study, const OutputPlaces& outputs) {
    for (const fs::path& input : inputs_of(study)) {
        for (const fs::path& output : outputs.files) {
            const fs::path path = outputs.folder / output;
            if (would_replace(path, input)) {
                throw InputError(
                    fmt::format("--out {}: this command writes {}, where the study has its input "
                                "{}; nothing was written: name another folder",
                                outputs.folder.string(), path.string(), input.string()));
            }
        }
        if (outputs.json && *outputs.json != "-" && would_replace(*outputs.json, input)) {
            throw InputError(
                fmt::format("--json {}: that is the study's input {}; nothing was written: name "
                            "another file",
                            *outputs.json, input.string()));
        }
    }
    protect_other_folders(study, outputs);
    if (outputs.json && *outputs.json != "-") {
        if (const auto pattern = pattern_that_reads(*outputs.json, study)) {
            throw InputError(
                fmt::format("--json {0}: 'file = \"{1}\"' of the study would read it as a "
                            "measurement; nothing was written: name another file",
                            *outputs.json, *pattern));
        }
    }
    for (const fs::path& output : outputs.files) {
        const fs::path path = outputs.folder / output;
        if (const auto pattern = pattern_that_reads(path, study)) {
            throw InputError(
                fmt::format("--out {}: this command writes {}, which 'file = \"{}\"' of the study "
                            "would read as a measurement; nothing was written: name another "
                            "folder, or a narrower pattern",
                            outputs.folder.string(), path.string(), *pattern));
        }
    }
}

namespace {

/// Study with its measurements, checked before any work.
/// @throws InputError where a file of the study or an effect that it names is wrong
StudyInput with_measurements(const Study& read) {
    ResolvedStudy resolved(read);
    const Study& study = resolved;
    if (study.rig) {
        for (const StatedDirect& stated : study.rig->direct) {
            direct_measurement(stated, study, resolved.catalogue());
        }
    }
    Measurements measurements = read_measurements(study);
    std::string text = read_text(study.file, largest_settings);
    ResolvedStudy complete = resolved.changed_to(with_strengths(study, measurements.readings));
    if (const auto outside = std::ranges::count_if(
            inputs_of(study), [&](const fs::path& file) { return !is_within(file, study.folder); }))
        measurements.remarks.insert(
            std::ranges::find(measurements.remarks, Remark::Kind::grain_weight, &Remark::kind),
            {.kind = Remark::Kind::outside_files,
             .outcome = Remark::Outcome::note,
             .count = static_cast<std::size_t>(outside)});
    return {std::move(complete), std::move(measurements), std::move(text)};
}

}  // namespace

StudyInput read_input(const fs::path& file) {
    return with_measurements(read_study(file));
}

StudyInput read_input(const fs::path& file, const OutputPlaces& outputs) {
    Study study = read_study(file);
    protect_inputs(study, outputs);
    return with_measurements(study);
}

std::filesystem::path study_folder(const std::filesystem::path& study) {
    std::error_code error;  // set for a link to itself, for example
    if (std::filesystem::is_directory(study, error)) {
        return study;
    }
    return study.has_parent_path() ? study.parent_path() : std::filesystem::path(".");
}

std::optional<Study> study_beside(const std::filesystem::path& file) {
    const std::filesystem::path study = file.parent_path() / "study.toml";
    std::error_code error;
    if (!std::filesystem::is_regular_file(study, error)) return std::nullopt;
    try {
        return read_study(study);
    } catch (const InputError&) {
        return std::nullopt;  // 'pendular import STUDY' says what is wrong with it
    }
}

std::optional<AnnularCell> cell_beside(const std::filesystem::path& file) {
    const auto study = study_beside(file);
    return study ? study->cell : std::nullopt;
}

EmulatorHyperparameters atlas_hyperparameters() {
    const std::filesystem::path atlas = atlas_file();
    const auto file = atlas.parent_path() / hyperparameters_name;
    return !atlas.empty() && std::filesystem::exists(file) ? read_hyperparameters(file)
                                                           : EmulatorHyperparameters{};
}

std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener) {
    // Chosen: twice the number of hyperparameters of a process. With fewer runs, the fit makes its
    // own, at the conditions of the readings.
    constexpr std::size_t fewest = 20;
    const std::filesystem::path atlas = atlas_file();
    std::vector<StoredRun> stored;
    KnownRuns known;
    if (!atlas.empty()) {
        stored = read_runs(atlas);
        known.hyperparameters = atlas_hyperparameters();
    }
    if (store) {
        auto own = store->select();
        std::ranges::move(own.rbegin(), own.rend(), std::back_inserter(stored));
    }
    std::set<std::string> there;
    std::vector<dem::RunResult> runs;
    for (StoredRun& each : stored) {
        if (each.physics_version == dem::physics_version &&
            there.insert(run_description(each.run.parameters, each.run.threads)).second) {
            runs.push_back(std::move(each.run));
        }
    }
    known.runs = runs_serving(study, fidelity, runs);
    if (known.runs.size() > most_known) {
        tell(listener,
             {.text = fmt::format("Of {} simulations that could train the emulator, it uses {}: "
                                  "those of the atlas and the latest of the store. 'pendular runs "
                                  "prune' removes simulations from the store.",
                                  known.runs.size(), most_known)});
        known.runs.resize(most_known);
    }
    return known.runs.size() < fewest ? std::nullopt : std::optional(std::move(known));
}

}  // namespace pendular
