#pragma once

#include <boost/program_options.hpp>
#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/declaration.h"
#include "app/output_paths.h"
#include "sim/runs/fidelity.h"

namespace pendular::app {

/// Checks and returns the seed of random numbers that the user gave by option --seed.
/// @throws InputError for a negative seed
std::uint64_t checked_seed(std::int64_t seed);

/// Values of the command-line options that every command has, and the study that the command reads.
struct CommonOptions {
    /// File to which the command writes the result as JSON, or "-" for standard output. Empty if
    /// the command writes no JSON.
    std::optional<std::string> json;
    /// Folder for the results of the command, given by option --out. Empty without this option.
    std::optional<std::filesystem::path> out;
    /// Fidelity: settings of the simulations, such as number of grains, stiffness number and
    /// strain.
    Fidelity fidelity;
    /// Number of simulations or refits that are computed at the same time.
    int threads = 1;
    /// Whether the command prints no progress on standard error.
    bool quiet = false;
    /// Whether the command prints all rows of tables and all notes.
    bool all = false;
    std::filesystem::path store;  ///< SQLite file that keeps the results of all simulations
    /// Whether the user named the file `store`, by option --store or by $PENDULAR_STORE.
    bool store_named = false;
    /// JSON file of an earlier result, whose training runs the command uses in place of all runs of
    /// atlas and store (option --runs-of). Empty: atlas and store.
    std::optional<std::filesystem::path> runs_of;
    /// Study or file that the command reads. Empty if the command reads neither.
    std::filesystem::path study;

    /// Returns the folder for results: the folder of option --out or, without this option,
    /// STUDY/out.
    std::filesystem::path out_folder() const;
    /// Returns the path of the study, as the user typed it, for use in a command line. The path is
    /// quoted if it has characters that a shell interprets.
    std::string study_word() const;
};

/// Returns a path as an argument for a command line. The argument is quoted if the path has
/// characters that a shell interprets.
std::string shell_word(const std::filesystem::path& path);

/// Command-line options of one command of `pendular`: declares, parses and documents the options.
class Options {
  public:
    /// Begins the declaration of a command's options.
    /// @param usage usage line of the help text, without "Usage: pendular"
    /// @param about description of the command, below the usage line
    /// @param examples example commands with line ends, at the end of the help text
    /// @param takes_study whether the command needs a first argument that names a study, a file or
    ///        a folder
    Options(std::string usage, std::string about, std::string examples, bool takes_study);

    /// Adds the option --NAME of this command. `parse` stores the value of the option in `value`.
    /// The text `description`, for the help text, must state the unit of the value.
    template <typename T>
    void add(const char* name, T* value, const std::string& description,
             const ValueKind& kind = {}) {
        kinds_[name] = kind;
        sections_.back().add_options()(
            name, boost::program_options::value<T>(value)->value_name(kind.placeholder()),
            description.c_str());
    }
    /// Begins a section of the help text, for the options that are added after this call.
    void begin_section(const std::string& heading) {
        headings_.push_back(heading);
        sections_.emplace_back(heading, 100);
    }
    /// Sets the default of option --threads (0: one thread per core) and the text on this option in
    /// the help text.
    void set_threads(int by_default, std::string meaning) {
        default_threads_ = by_default, threads_meaning_ = std::move(meaning);
    }
    /// Sets the name and the meaning of the command's first argument, for the error message that
    /// this argument is missing, such as "OUT (the folder for the new study)".
    void set_first_word(std::string name_and_meaning) {
        missing_word_ = std::move(name_and_meaning);
    }
    /// Leaves common options (names without "--") out of the help text, the manual and the
    /// completion in a shell, because the command makes no use of these options. `parse` still
    /// accepts the options, so that scripts can give the same options to every command.
    void leave_out(std::set<std::string> unused) { unused_ = std::move(unused); }
    /// Sets the text on option --fidelity (settings of simulations) in the help text, for a command
    /// that makes no simulation.
    void set_fidelity(std::string meaning) { fidelity_meaning_ = std::move(meaning); }
    /// Sets the text on option --store, the file that keeps simulations, in the help text.
    void set_store(std::string meaning) { store_meaning_ = std::move(meaning); }
    /// Sets the text on option --out, the folder for results, in the help text.
    void set_out(std::string meaning) { out_meaning_ = std::move(meaning); }
    /// Adds the option --runs-of FILE, for a command whose result rests on earlier simulations.
    void offer_runs_of();
    /// Makes the command accept any number of arguments that belong to no option. If the command
    /// reads a study, these arguments follow the name of the study.
    /// @param words list in which `parse` stores these arguments
    /// @param kind kind of value that these arguments may have, such as files
    void take(std::vector<std::string>* words, ValueKind kind = {}) {
        words_ = words, words_kind_ = std::move(kind);
    }
    /// Adds the option --NAME [MINUTES], a limit of time that `parse` stores in `seconds` [s].
    /// Without the option, `seconds` is empty.
    /// @param alone limit [min] if no number follows the option; infinity: no limit
    /// @param description text for the help, which must state the default
    void add_time(const char* name, std::optional<double>* seconds, double alone,
                  const std::string& description);
    /// Adds the option --NAME without a value. `parse` sets `value` to true if the option was
    /// given, else to false.
    void add_switch(const char* name, bool* value, const std::string& description);

    /// Parses the arguments after the command's name. Stores the values of the command's own
    /// options, and returns the values of the options that every command has. If the user gave
    /// --help, prints the help text and returns nothing.
    /// @throws InputError if an option is unknown (the message names the nearest known option), if
    ///         a value or the study is missing or malformed, if there are too many arguments, or if
    ///         the file of --json or the folder for results cannot be written
    std::optional<CommonOptions> parse(const std::vector<std::string>& arguments);
    /// Whether the parsed arguments contain the option `name` (without "--").
    bool given(const std::string& name) const {
        return variables_.count(name) > 0 && !variables_[name].defaulted();
    }

  private:
    /// Arguments of the common options (which every command has), as the user typed them.
    struct CommonValues {
        std::string json, out, fidelity, store;
        /// Receives the values of the options --threads, --quiet and --all.
        CommonOptions options;
    };
    /// Declares the common options (which every command has), whose values go to `values`.
    /// @param shown true: only the common options that the help text lists are declared; false:
    ///        only the common options that the help text leaves out
    boost::program_options::options_description common_options(CommonValues& values,
                                                               bool shown) const;
    void print_help(const boost::program_options::options_description& common) const;
    CommandDeclaration declaration(const boost::program_options::options_description& common) const;

    std::string usage_, about_, examples_;
    bool takes_study_;
    /// Name and meaning of the command's first argument, for the message that this argument is
    /// missing. If the text is empty, the first argument is a study.
    std::string missing_word_;
    std::string runs_of_;  ///< value of the option --runs-of
    std::vector<std::string>* words_ = nullptr;
    ValueKind words_kind_;
    /// Kinds of value that the options of the command accept. The key is the name of the option.
    std::map<std::string, ValueKind> kinds_;
    /// Limits of time [min] that apply if no number follows an option of `add_time`. The key is the
    /// name of the option with "--". The value is the limit as text.
    std::map<std::string, std::string> times_;
    /// Default of option --threads; 0: one thread for each core of the processor.
    int default_threads_ = 0;
    /// Names of the common options that the help text leaves out, since the command makes no use of
    /// these options.
    std::set<std::string> unused_;
    /// Text on option --fidelity in the help text. If the text is empty, the help text lists the
    /// settings of simulations.
    std::string fidelity_meaning_;
    std::string store_meaning_ =
        "SQLite file that keeps the result of every simulation (default: $PENDULAR_STORE, else "
        "~/.local/share/pendular/runs.sqlite)";
    std::string threads_meaning_ = "number of simulations at a time";
    std::string out_meaning_ = "folder for results of a study (default: STUDY/out)";
    /// Headings of the sections of the help text, in the order of `sections_`.
    std::vector<std::string> headings_;
    /// Options of the command, grouped by section of the help text.
    std::list<boost::program_options::options_description> sections_;
    boost::program_options::variables_map variables_;
};

}  // namespace pendular::app
