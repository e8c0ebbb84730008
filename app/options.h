#pragma once

#include <boost/program_options.hpp>
#include <cstdint>
#include <filesystem>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/runs/fidelity.h"

namespace pendular::app {

/// Seed of random numbers as the user gave it.
/// @throws InputError if it is negative
std::uint64_t checked_seed(std::int64_t seed);

/// Checks before long work that a path can be written, as a folder if `folder`, else as a file.
/// @throws InputError where it cannot, naming the option
void demand_writable(const std::filesystem::path& path, const std::string& option, bool folder);

/// Options that every command takes.
struct CommonOptions {
    std::optional<std::string> json;  ///< file, or "-" for standard output
    std::optional<std::filesystem::path> out;
    Fidelity fidelity;
    int threads = 1;
    bool quiet = false;
    bool all = false;  ///< every row of every table and every note
    std::filesystem::path store;
    bool store_named = false;     ///< the user named it, by --store or $PENDULAR_STORE
    std::filesystem::path study;  ///< empty for commands without one

    /// Folder for results: --out, else STUDY/out.
    std::filesystem::path out_folder() const;
};

/// Declares, parses and documents the options of one command.
class Options {
  public:
    /// `takes_study`: one word that names a study or another file.
    /// `usage` is the line after "Usage: pendular", `about` and `examples` frame the help text.
    Options(std::string usage, std::string about, std::string examples, bool takes_study);

    /// Adds an option of this command; its description names the unit.
    template <typename T>
    void add(const char* name, T* value, const std::string& description) {
        sections_.back().add_options()(
            name, boost::program_options::value<T>(value)->value_name("X"), description.c_str());
    }
    /// Puts the options that are added from here on under a new heading.
    void begin_section(const std::string& heading) { sections_.emplace_back(heading, 100); }
    /// Sets the description of --threads and its default; 0: all cores.
    void set_threads(int by_default, std::string meaning) {
        default_threads_ = by_default, threads_meaning_ = std::move(meaning);
    }
    /// Sets the description of --out.
    void set_out(std::string meaning) { out_meaning_ = std::move(meaning); }
    /// Takes any number of words that belong to no option, after the study where there is one.
    void take(std::vector<std::string>* words) { words_ = words; }
    void add_switch(const char* name, bool* value, const std::string& description);

    /// Parses the arguments. Empty: help was asked for and printed.
    /// @throws InputError for anything unknown (with the nearest known option), missing or
    /// malformed
    std::optional<CommonOptions> parse(const std::vector<std::string>& arguments);
    /// Whether the user gave this option.
    bool given(const std::string& name) const {
        return variables_.count(name) > 0 && !variables_[name].defaulted();
    }

  private:
    void print_help(const boost::program_options::options_description& common) const;

    std::string usage_, about_, examples_;
    bool takes_study_;
    std::vector<std::string>* words_ = nullptr;
    int default_threads_ = 0;  ///< 0: one per core
    std::string threads_meaning_ = "number of runs at a time";
    std::string out_meaning_ = "folder for results of a study (default: STUDY/out)";
    std::list<boost::program_options::options_description> sections_;  ///< this command's options
    boost::program_options::variables_map variables_;
};

}  // namespace pendular::app
