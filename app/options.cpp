#include "app/options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <thread>

#include "data/input_error.h"
#include "data/quantities/nearest.h"
#include "sim/runs/store/run_store.h"
#include "workflow/study_input.h"

namespace pendular::app {
namespace {

namespace po = boost::program_options;

std::vector<std::string> option_names(const po::options_description& options) {
    std::vector<std::string> names;
    for (const auto& option : options.options()) {
        names.push_back("--" + option->long_name());
    }
    return names;
}

bool is_number(const std::string& word) {
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size();
}

/// Arguments in which each of the options `times` has its value in the same word, as in
/// "--confirm=5": the number that follows it or, where none does, the value in `times`. Boost would
/// take any word that follows for the value.
std::vector<std::string> with_attached_times(const std::vector<std::string>& arguments,
                                             const std::map<std::string, std::string>& times) {
    std::vector<std::string> result;
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        result.push_back(arguments[k]);
        const auto alone = times.find(arguments[k]);
        if (alone != times.end()) {
            const bool number = k + 1 < arguments.size() && is_number(arguments[k + 1]);
            result.back() += "=" + (number ? arguments[++k] : alone->second);
        }
    }
    return result;
}

}  // namespace

std::uint64_t checked_seed(std::int64_t seed) {
    if (seed < 0) {
        throw InputError(fmt::format("--seed {}: a seed is 0 or more", seed));
    }
    return static_cast<std::uint64_t>(seed);
}

void demand_table(const std::filesystem::path& file, const std::string& first) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error) ||
        std::filesystem::file_size(file, error) == 0) {
        return;
    }
    std::string begin(first.size(), '\0');
    std::ifstream(file, std::ios::binary).read(begin.data(), std::ssize(begin));
    if (begin != first) {
        throw InputError(fmt::format(
            "{} holds something other than such a table; nothing was written: name another file",
            file.string()));
    }
}

void demand_writable(const std::filesystem::path& path, const std::string& option, bool folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    if (path.empty()) {
        throw InputError(fmt::format("{} needs a name", option));
    }
    if (fs::exists(path, error) && fs::is_directory(path, error) != folder) {
        throw InputError(fmt::format("option {} needs {}, but '{}' is {}", option,
                                     folder ? "a folder" : "a file", path.string(),
                                     folder ? "a file" : "a folder"));
    }
    fs::path there = fs::absolute(path, error);
    while (!fs::exists(there, error) && there.has_relative_path()) {
        there = there.parent_path();
    }
    if (there != fs::absolute(path, error) && !fs::is_directory(there, error)) {
        throw InputError(fmt::format("{} {} cannot be written: {} is no folder", option,
                                     path.string(), there.string()));
    }
    if (access(there.c_str(), W_OK) != 0) {
        throw InputError(fmt::format("{} {} cannot be written: {}", option, path.string(),
                                     std::strerror(errno)));
    }
}

namespace {

/// First character of a file that is no blank; empty where the file is missing, empty or no regular
/// file.
std::optional<char> first_character(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    std::ifstream stream(file, std::ios::binary);
    char first = 0;
    return stream >> first ? std::optional(first) : std::nullopt;
}

/// @throws InputError where the file exists and holds something else than JSON, a recording for
///         example
void demand_json(const std::filesystem::path& file, const std::string& option) {
    const auto first = first_character(file);
    if (first && *first != '{' && *first != '[') {
        throw InputError(
            fmt::format("{} {}: that file holds something other than JSON; nothing was written: "
                        "name another file",
                        option, file.string()));
    }
}

}  // namespace

std::string shell_word(const std::filesystem::path& path) {
    const std::string text = path.string();
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) || c >= 0x80 ||
               std::string_view("_-./,+=:@%").find(char(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, plain)) return text;
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string CommonOptions::study_word() const {
    return shell_word(study);
}

std::filesystem::path CommonOptions::out_folder() const {
    return out ? *out : study_folder(study) / "out";
}

Options::Options(std::string usage, std::string about, std::string examples, bool takes_study)
    : usage_(std::move(usage)),
      about_(std::move(about)),
      examples_(std::move(examples)),
      takes_study_(takes_study) {
    begin_section("Options");
}

void Options::add_switch(const char* name, bool* value, const std::string& description) {
    sections_.back().add_options()(name, po::bool_switch(value), description.c_str());
}

void Options::add_time(const char* name, std::optional<double>* seconds, double alone,
                       const std::string& description) {
    const std::string option = std::string("--") + name;
    times_[option] = fmt::format("{}", alone);
    const std::string shown = std::isinf(alone) ? "no limit" : fmt::format("{:g}", alone);
    sections_.back().add_options()(
        name,
        po::value<double>()
            ->implicit_value(alone, shown)
            ->value_name("MINUTES")
            ->notifier([seconds, option](double minutes) {
                if (!(minutes >= 0)) {
                    throw InputError(
                        fmt::format("{} {}: minutes of 0 or more are needed", option, minutes));
                }
                *seconds = 60 * minutes;
            }),
        description.c_str());
}

void Options::print_help(const po::options_description& common) const {
    std::cout << "Usage: pendular " << usage_ << "\n\n" << about_ << "\n\n";
    for (const auto& section : sections_) {
        if (!section.options().empty()) {
            std::cout << section << '\n';
        }
    }
    std::cout << common << "\nExamples:\n" << examples_;
}

namespace {

/// Where `parse` puts the declaration of a command in place of printing its help text; null: the
/// help text is printed.
thread_local CommandDeclaration* requested_declaration = nullptr;

/// First word of most commands and its meaning, for the message that it is missing.
const char* const standard_missing_word = "STUDY, the folder of a study or its file study.toml,";

/// Names of the fidelities with the settings of each, for the help text.
std::string fidelity_text() {
    std::string text = "size and accuracy of the simulations";
    for (const Fidelity& each : fidelities()) {
        text += fmt::format(
            "; {}: {} beads, stiffness number {:g}, inertial number {:g} or more, averages over a "
            "strain of {:g}",
            each.name, each.grains, each.stiffness_number, each.lowest_inertial_number,
            each.strain);
    }
    return text;
}

std::vector<std::string> fidelity_names() {
    std::vector<std::string> names;
    for (const Fidelity& each : fidelities()) {
        names.push_back(each.name);
    }
    return names;
}

/// Values of the first word of a command, from the usage line.
ValueKind first_word_of(const std::string& usage) {
    const auto has = [&](const char* word) { return usage.find(word) != std::string::npos; };
    if (has(" FILE")) return a_file();
    return has(" STUDY") ? a_study() : a_folder();
}

}  // namespace

CommandDeclaration declaration_of(int (*run)(const std::vector<std::string>& arguments)) {
    CommandDeclaration result;
    requested_declaration = &result;
    run({"--help"});
    requested_declaration = nullptr;
    return result;
}

const char* ValueKind::placeholder() const {
    switch (kind) {
        case Kind::file:
            return "FILE";
        case Kind::folder:
            return "DIR";
        case Kind::study:
            return "STUDY";
        case Kind::choice:
            return "NAME";
        default:
            return "X";
    }
}

CommandDeclaration Options::declaration(const po::options_description& common) const {
    CommandDeclaration result{.usage = usage_, .about = about_, .examples = examples_};
    const std::map<std::string, ValueKind> kinds_of_common = {
        {"json", a_file({"-"})},
        {"out", a_folder()},
        {"store", a_file()},
        {"fidelity", one_of(fidelity_names())}};
    const auto add = [&](const po::options_description& options, const std::string& heading,
                         const std::map<std::string, ValueKind>& kinds) {
        if (options.options().empty()) return;
        result.sections.push_back({.heading = heading});
        for (const auto& option : options.options()) {
            const std::string& name = option->long_name();
            const bool number_may_follow = times_.contains("--" + name);
            const bool takes_value = !number_may_follow && option->semantic()->max_tokens() > 0;
            const auto known = kinds.find(name);
            const ValueKind value = known != kinds.end() ? known->second : ValueKind();
            result.sections.back().options.push_back(
                {name,
                 number_may_follow || takes_value ? option->format_parameter() : std::string(),
                 option->description(), takes_value ? value : ValueKind{ValueKind::Kind::none}});
        }
    };
    auto heading = headings_.begin();
    for (const auto& section : sections_) {
        add(section, *heading++, kinds_);
    }
    add(common, "Common options", kinds_of_common);
    if (takes_study_) result.first_word = first_word_of(usage_);
    if (words_) (takes_study_ ? result.other_words : result.first_word) = words_kind_;
    if (words_ && !takes_study_) result.other_words = a_file();
    return result;
}

std::optional<CommonOptions> Options::parse(const std::vector<std::string>& words_given) {
    const std::vector<std::string> arguments = with_attached_times(words_given, times_);
    CommonOptions result;
    std::string json, out, fidelity, store, study;
    po::options_description common("Common options", 100);
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    common.add_options()(
        "json", po::value(&json)->value_name("FILE"),
        "file for the result as JSON; '-': standard output, which then holds nothing else")(
        "out", po::value(&out)->value_name("DIR"), out_meaning_.c_str())(
        "fidelity", po::value(&fidelity)->default_value("standard")->value_name("NAME"),
        fidelity_text().c_str())("store", po::value(&store)->value_name("FILE"),
                                 "SQLite file that keeps the result of every simulation (default: "
                                 "$PENDULAR_STORE, else ~/.local/share/pendular/runs.sqlite)")(
        "threads",
        po::value(&result.threads)
            ->default_value(default_threads_ > 0 ? default_threads_ : cores,
                            default_threads_ > 0 ? std::to_string(default_threads_) : "cores")
            ->value_name("N"),
        threads_meaning_.c_str())("quiet", po::bool_switch(&result.quiet),
                                  "print no progress on standard error")(
        "all", po::bool_switch(&result.all), "print all rows of tables and all notes")(
        "help", "print this text");
    po::options_description all, hidden;
    std::vector<std::string> words;
    if (takes_study_) {
        hidden.add_options()("named-study", po::value(&study));
    }
    hidden.add_options()("words", po::value(&words));
    po::options_description visible;
    for (const auto& section : sections_) {
        visible.add(section);
    }
    visible.add(common);
    all.add(visible).add(hidden);
    po::positional_options_description positional;
    positional.add("named-study", takes_study_ ? 1 : 0);
    if (words_) {
        positional.add("words", -1);
    }
    try {
        po::store(po::command_line_parser(arguments)
                      .options(all)
                      .positional(positional)
                      .style(po::command_line_style::default_style &
                             ~po::command_line_style::allow_guessing)
                      .run(),
                  variables_);
        po::notify(variables_);
    } catch (const po::unknown_option& error) {
        const std::string name = error.get_option_name();
        throw InputError(fmt::format("unknown option '{}'; {}", name,
                                     did_you_mean(name, option_names(visible))));
    } catch (const po::too_many_positional_options_error&) {
        throw InputError(fmt::format("too many arguments; usage: pendular {}", usage_));
    } catch (const po::error& error) {
        throw InputError(fmt::format("{}; see: pendular {} --help", error.what(),
                                     usage_.substr(0, usage_.find(' '))));
    }
    if (variables_.count("help") > 0) {
        if (requested_declaration) {
            *requested_declaration = declaration(common);
        } else {
            print_help(common);
        }
        return std::nullopt;
    }
    if (words_) {
        *words_ = words;
    }
    if (takes_study_ && study.empty()) {
        throw InputError(fmt::format("{} is missing; usage: pendular {}",
                                     missing_word_.empty() ? standard_missing_word : missing_word_,
                                     usage_));
    }
    if (result.threads < 1) {
        throw InputError(
            fmt::format("--threads {}: at least one thread is needed", result.threads));
    }
    result.study = study;
    result.fidelity = fidelity_named(fidelity);
    if (variables_.count("json") > 0) {
        result.json = json;
        if (json != "-") {
            demand_writable(json, "--json", false);
            demand_json(json, "--json");
            std::error_code error;
            if (takes_study_ && std::filesystem::equivalent(json, study, error)) {
                throw InputError(fmt::format(
                    "--json {}: that is what the command reads; name another file", json));
            }
        }
    }
    result.store_named = !store.empty() || std::getenv("PENDULAR_STORE");
    result.store = store.empty() ? RunStore::standard_file() : std::filesystem::path(store);
    if (variables_.count("out") > 0) {
        result.out = out;
        demand_writable(*result.out, "--out", true);
    }
    if (takes_study_ && std::filesystem::exists(study)) {
        demand_writable(result.out_folder(), "--out", true);
    }
    return result;
}

}  // namespace pendular::app
