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

/// Returns the seed of random numbers that the user gave by option --seed.
/// @throws InputError for a negative seed
std::uint64_t checked_seed(std::int64_t seed);

/// Values of the command-line options that every command has, and the study that it reads.
struct CommonOptions {
    /// File to which the command writes its result as JSON, or "-" for standard output; empty: no
    /// JSON.
    std::optional<std::string> json;
    /// Folder for the results of the command, as the user gave it by --out; empty without this
    /// option.
    std::optional<std::filesystem::path> out;
    /// Settings of the simulation runs, such as the number of grains.
    Fidelity fidelity;
    /// Number of simulation runs or refits that are computed at the same time.
    int threads = 1;
    /// Whether the command prints no progress on standard error.
    bool quiet = false;
    /// Whether the command prints all rows of tables and all notes.
    bool all = false;
    std::filesystem::path store;  ///< SQLite file that keeps every simulation run
    /// Whether the user named the file `store`, by option --store or by $PENDULAR_STORE.
    bool store_named = false;
    /// Study or other file that the command reads; empty: the command reads no study or file.
    std::filesystem::path study;

    /// Folder for results: the folder of option --out or, without this option, STUDY/out.
    std::filesystem::path out_folder() const;
    /// The study as the user named it, as a word of a command line, quoted where a shell needs it.
    std::string study_word() const;
};

/// Returns a path as a word of a command line, in quotes if it has characters that a shell
/// interprets.
std::string shell_word(const std::filesystem::path& path);

/// Declares, parses and documents the command-line options of one command of `pendular`.
class Options {
  public:
    /// Begins the declaration of a command's options.
    /// @param usage the line of the help text after "Usage: pendular"
    /// @param about description of the command, after the usage line of the help text
    /// @param examples example commands, the end of the help text, with line ends
    /// @param takes_study whether the command needs one word that names a study or another file
    Options(std::string usage, std::string about, std::string examples, bool takes_study);

    /// Adds the option --NAME of this command, whose value `parse` stores in `value`. The
    /// description for the help text says in which unit the value is.
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
    /// Sets the default of option --threads (0: one thread per core) and its text in the help.
    void set_threads(int by_default, std::string meaning) {
        default_threads_ = by_default, threads_meaning_ = std::move(meaning);
    }
    /// Sets the beginning of the error message for a missing first word: the name and meaning of
    /// the word, such as "OUT, the folder for the new study,".
    void set_first_word(std::string name_and_meaning) {
        missing_word_ = std::move(name_and_meaning);
    }
    /// Leaves common options (names without "--") out of the help text, the manual and the
    /// completion of words, because the command makes no use of them. `parse` still accepts them,
    /// so that scripts can give the same options to every command.
    void leave_out(std::set<std::string> unused) { unused_ = std::move(unused); }
    /// Sets the text on option --fidelity in the help text, for a command that makes no simulation.
    void set_fidelity(std::string meaning) { fidelity_meaning_ = std::move(meaning); }
    /// Sets the text on option --store, the file that keeps simulations, in the help text.
    void set_store(std::string meaning) { store_meaning_ = std::move(meaning); }
    /// Sets the text on option --out, the folder for results, in the help text.
    void set_out(std::string meaning) { out_meaning_ = std::move(meaning); }
    /// Makes the command accept any number of words that belong to no option. If the command reads
    /// a study, these words follow the name of the study.
    /// @param words where `parse` stores these words
    /// @param kind what the words may be, such as files
    void take(std::vector<std::string>* words, ValueKind kind = {}) {
        words_ = words, words_kind_ = std::move(kind);
    }
    /// Adds the option --NAME [MINUTES], a limit of time that `parse` stores in `seconds` [s].
    /// Without the option, `seconds` is empty. If no number follows the option, `alone` is used.
    /// @param alone limit [min] where no number follows the option; infinity: no limit
    /// @param description text for the help, which must state the default
    void add_time(const char* name, std::optional<double>* seconds, double alone,
                  const std::string& description);
    /// Adds the option --NAME without a value: `parse` sets `value` to whether it was given.
    void add_switch(const char* name, bool* value, const std::string& description);

    /// Parses the words after the command's name, and stores the values of its options. Returns the
    /// values of the options that every command has. Empty where the user gave --help; the help
    /// text is then printed.
    /// @throws InputError for an unknown option (with the nearest known option), for a missing or
    ///         malformed value or study, for too many words, and for a file of --json or a folder
    ///         for results that cannot be written
    std::optional<CommonOptions> parse(const std::vector<std::string>& arguments);
    /// Whether the parsed arguments contain the option `name` (without "--").
    bool given(const std::string& name) const {
        return variables_.count(name) > 0 && !variables_[name].defaulted();
    }

  private:
    /// Texts and values of the common options as the user gives them.
    struct CommonValues {
        std::string json, out, fidelity, store;
        /// Receives the values of the options --threads, --quiet and --all.
        CommonOptions options;
    };
    /// Declares the common options, whose values go to `values`.
    /// @param shown true: options that the help text lists; false: options that it leaves out
    boost::program_options::options_description common_options(CommonValues& values,
                                                               bool shown) const;
    void print_help(const boost::program_options::options_description& common) const;
    CommandDeclaration declaration(const boost::program_options::options_description& common) const;

    std::string usage_, about_, examples_;
    bool takes_study_;
    /// Name and meaning of the command's first word, for the message that it is missing; empty: the
    /// word is a study.
    std::string missing_word_;
    std::vector<std::string>* words_ = nullptr;
    ValueKind words_kind_;
    /// Values that the options of the command accept, by the name of the option.
    std::map<std::string, ValueKind> kinds_;
    /// Times [min] that apply where no number follows an option of `add_time`, by the name of the
    /// option.
    std::map<std::string, std::string> times_;
    /// Default of option --threads; 0: one thread for each core of the processor.
    int default_threads_ = 0;
    /// Names of the common options that the help text leaves out, since the command makes no use of
    /// them.
    std::set<std::string> unused_;
    /// Meaning of option --fidelity in the help text; empty: the usual text, which lists the
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
