#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/declaration.h"
#include "sim/runs/run_settings.h"

// Boost.Program_options is included in options.cpp alone: it takes seconds to compile.

namespace pendular::app {

/// Checks, before a long computation, that a folder or a file can be written. Creates nothing.
/// @throws InputError if `path` is empty or cannot be written; the message names `option`, the
///         command-line option that gave the path
void demand_writable(const std::filesystem::path& path, const std::string& option, bool folder);

/// Checks that writing a table to `file` replaces nothing but an earlier table, whose first
/// characters are `first`. A missing or empty file is accepted.
/// @throws InputError if the file contains anything else, such as a recording
void demand_table(const std::filesystem::path& file, const std::string& first);

/// Checks that writing JSON to `file` replaces nothing but JSON, by its first character. A missing
/// or empty file is accepted.
/// @throws InputError if the file is something else, such as a recording; the message names
///         `option`
void demand_json(const std::filesystem::path& file, const std::string& option);

}  // namespace pendular::app

namespace boost::program_options {

class options_description;
class positional_options_description;
class variables_map;

}  // namespace boost::program_options

namespace pendular::app {

/// Checks and returns the seed that the user gave by option --seed.
/// @throws InputError for a negative seed
std::uint64_t checked_seed(std::int64_t seed);

/// Values of the command-line options that every command has, and the study that it reads.
struct CommonOptions {
    std::optional<std::string> json;           ///< file for the result, "-": standard output
    std::optional<std::filesystem::path> out;  ///< folder for results (option --out)
    Fidelity fidelity;
    int threads = 1;              ///< number of simulations or refits at the same time
    bool quiet = false;           ///< whether no progress is printed on standard error
    bool all = false;             ///< whether all rows of tables and all notes are printed
    std::filesystem::path store;  ///< SQLite file that keeps the results of all simulations
    /// Whether the user named the file `store`, by option --store or by $PENDULAR_STORE.
    bool store_named = false;
    /// JSON file of an earlier result, whose training runs are used in place of all runs of atlas
    /// and store (option --runs-of).
    std::optional<std::filesystem::path> runs_of;
    std::filesystem::path study;  ///< study or file that the command reads; may be empty

    /// Returns the folder of option --out or, without this option, STUDY/out.
    std::filesystem::path out_folder() const;
    /// Returns the path of the study, as the user typed it, as a `shell_word`.
    std::string study_word() const;
};

/// Returns a path as an argument for a command line, quoted if it has characters that a shell
/// interprets.
std::string shell_word(const std::filesystem::path& path);

/// Command-line options of one command of `pendular`: declares, parses and documents the options.
class Options {
  public:
    /// Begins the declaration of a command's options.
    /// @param usage usage line of the help text, without "Usage: pendular"
    /// @param about description of the command, below the usage line
    /// @param examples example commands with line ends, at the end of the help text
    /// @param takes_study whether the command needs a first argument: a study, a file or a folder
    Options(std::string usage, std::string about, std::string examples, bool takes_study);
    ~Options();

    /// Adds the option --NAME, whose value `parse` stores in `value`. The text `description`, for
    /// the help text, must state the unit of the value. Types: those instantiated in options.cpp.
    template <typename T>
    void add(const char* name, T* value, const std::string& description,
             const ValueKind& kind = {});
    /// Begins a section of the help text, for the options that are added after this call.
    void begin_section(const std::string& heading);
    /// Sets the default of option --threads (0: one thread per core) and its text in the help.
    void set_threads(int by_default, std::string meaning) {
        default_threads_ = by_default, threads_meaning_ = std::move(meaning);
    }
    /// Sets what the error message says where the command's first argument is missing, such as "OUT
    /// (the folder for the new study)".
    void set_first_word(std::string name_and_meaning) {
        missing_word_ = std::move(name_and_meaning);
    }
    /// Leaves common options (names without "--") out of the help text, the manual and the
    /// completion, because the command makes no use of them. `parse` still accepts them, so that
    /// scripts can give the same options to every command.
    void leave_out(std::set<std::string> unused) { unused_ = std::move(unused); }
    /// Sets the help on --fidelity, for a command that makes no simulation.
    void set_fidelity(std::string meaning) { fidelity_meaning_ = std::move(meaning); }
    /// Sets the help on --store.
    void set_store(std::string meaning) { store_meaning_ = std::move(meaning); }
    /// Sets the help on --out.
    void set_out(std::string meaning) { out_meaning_ = std::move(meaning); }
    /// Adds the option --runs-of FILE, for a command whose result rests on earlier simulations.
    void offer_runs_of();
    /// Makes `parse` store any number of arguments that belong to no option in `words`. They follow
    /// the name of the study, if the command reads one.
    void take(std::vector<std::string>* words, ValueKind kind = {}) {
        words_ = words, words_kind_ = std::move(kind);
    }
    /// Adds the option --NAME [MINUTES], a limit of time that `parse` stores in `seconds` [s].
    /// Without the option, `seconds` is empty.
    /// @param alone limit [min] if no number follows the option; infinity: no limit
    /// @param description text for the help, which must state the default
    void add_time(const char* name, std::optional<double>* seconds, double alone,
                  const std::string& description);
    /// Adds the option --NAME without a value. `parse` sets `value` to whether it was given.
    void add_switch(const char* name, bool* value, const std::string& description);

    /// Parses the arguments after the command's name. Stores the values of the command's own
    /// options, and returns those of the common options. With --help, prints the help text and
    /// returns nothing.
    /// @throws InputError if an option is unknown (the message names the nearest known option), if
    ///         a value or the study is missing or malformed, if there are too many arguments, or if
    ///         the file of --json or the folder for results cannot be written
    std::optional<CommonOptions> parse(const std::vector<std::string>& arguments);
    /// Whether the parsed arguments contain the option `name` (without "--").
    bool given(const std::string& name) const;

  private:
    /// Common options as the user typed them.
    struct CommonValues {
        std::string json, out, fidelity, store;
        CommonOptions options;  ///< receives --threads, --quiet and --all
    };
    /// @param shown true: the common options that the help text lists; false: those that it leaves
    ///        out
    boost::program_options::options_description common_options(CommonValues& values,
                                                               bool shown) const;
    void store(const std::vector<std::string>& arguments,
               const boost::program_options::options_description& all,
               const boost::program_options::options_description& visible,
               const boost::program_options::positional_options_description& positional);
    void check_json_file(const std::string& json, const std::string& study) const;
    /// Checked values of the common options.
    CommonOptions checked(const CommonValues& values, const std::string& study) const;
    void print_help(const boost::program_options::options_description& common) const;
    CommandDeclaration declaration(const boost::program_options::options_description& common) const;

    std::string usage_, about_, examples_;
    bool takes_study_;
    std::string missing_word_;  ///< see `set_first_word`; empty: the first argument is a study
    std::string runs_of_;       ///< value of the option --runs-of
    std::vector<std::string>* words_ = nullptr;
    ValueKind words_kind_;
    std::map<std::string, ValueKind> kinds_;  ///< by name of the option
    /// Limits [min] as text if no number follows an option of `add_time`, by its name with "--".
    std::map<std::string, std::string> times_;
    int default_threads_ = 0;       ///< 0: one thread for each core
    std::set<std::string> unused_;  ///< see `leave_out`
    std::string fidelity_meaning_;  ///< empty: the help text lists the settings
    std::string store_meaning_ =
        "SQLite file that keeps the result of every simulation (default: $PENDULAR_STORE, else "
        "~/.local/share/pendular/runs.sqlite)";
    std::string threads_meaning_ = "number of simulations at a time";
    std::string out_meaning_ = "folder for results of a study (default: STUDY/out)";
    std::vector<std::string> headings_;  ///< of `sections_`
    std::list<boost::program_options::options_description> sections_;
    std::unique_ptr<boost::program_options::variables_map> variables_;
};

}  // namespace pendular::app
