#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/emulator/known_runs.h"
#include "data/annular_cell.h"
#include "data/recordings/measurements.h"
#include "data/study/study.h"
#include "sim/catalogue/resolved_study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Study with its measurements, as read from files.
struct StudyInput {
    ResolvedStudy study;
    Measurements measurements;
    std::string text = {};  ///< text of study.toml as it was read
};

/// Reads a study and its recordings.
/// @param file study.toml, or the folder that contains study.toml
/// @throws InputError if a file of the study is wrong, if a listed effect is unknown, is defined
///         wrongly or does not apply to the study, or if a direct measurement is wrong
StudyInput read_input(const std::filesystem::path& file);

/// Returns the folder of a study, given the folder or the study.toml in it.
std::filesystem::path study_folder(const std::filesystem::path& study);

/// Files and folders to which a command writes.
struct OutputPlaces {
    std::filesystem::path folder;  ///< for results
    /// Paths in `folder`: files, and folders for files whose names are not known beforehand.
    std::vector<std::filesystem::path> files;
    std::optional<std::string> json;  ///< file of option --json; "-": standard output; empty: none
};

/// Checks, before a long computation, that the output of a command will not damage a study. Output
/// must not replace a file that the study reads, nor follow a link out of the results folder. An
/// output file must match no `file` pattern of study.toml: the study would read the file as a
/// measurement.
/// @throws InputError if output would replace an input, leave the folder or match a pattern; the
///         message says what to do
void protect_inputs(const Study& study, const OutputPlaces& outputs);

/// Reads a study and its recordings, after `protect_inputs`.
/// @throws InputError as the functions above
StudyInput read_input(const std::filesystem::path& file, const OutputPlaces& outputs);

/// Returns the study that study.toml in the folder of `file` describes. Empty if study.toml does
/// not exist or cannot be read.
std::optional<Study> study_beside(const std::filesystem::path& file);

/// Returns the shear cell of that study; empty without one.
std::optional<AnnularCell> cell_beside(const std::filesystem::path& file);

/// Returns the earlier runs that can train an emulator for a study: the runs of the atlas, then the
/// runs of `store`, latest first. Each run has the present physics version (`dem::physics_version`)
/// and suits the study (`runs_serving`). If there are more than `most_known` runs, the oldest runs
/// of `store` are left out and the listener receives a note. Empty if there are fewer than 20 such
/// runs.
/// @param store null: only the atlas is used
/// @throws InputError if the atlas cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener = {});

/// Returns the hyperparameters from the file beside the atlas; empty if there is no file.
EmulatorHyperparameters atlas_hyperparameters();

/// Largest number of runs on which an emulator is trained. The time of training grows with the cube
/// of the number, and is some seconds for `most_known` runs.
constexpr std::size_t most_known = 1500;

}  // namespace pendular
