#include "app/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <boost/program_options.hpp>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <thread>

#include "data/input_error.h"
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
      takes_study_(takes_study),
      variables_(std::make_unique<po::variables_map>()) {
    begin_section("Options");
}
Options::~Options() = default;

template <typename T>
void Options::add(const char* name, T* value, const std::string& description,
                  const ValueKind& kind) {
    kinds_[name] = kind;
    sections_.back().add_options()(name, po::value<T>(value)->value_name(kind.placeholder()),
                                   description.c_str());
}
template void Options::add(const char*, std::string*, const std::string&, const ValueKind&);
template void Options::add(const char*, double*, const std::string&, const ValueKind&);
template void Options::add(const char*, int*, const std::string&, const ValueKind&);

void Options::begin_section(const std::string& heading) {
    headings_.push_back(heading);
    sections_.emplace_back(heading, 100);
}

bool Options::given(const std::string& name) const {
    return variables_->count(name) > 0 && !(*variables_)[name].defaulted();
}

void Options::offer_runs_of() {
    add("runs-of", &runs_of_,
        "JSON file of an earlier result, such as out/fit.json, to repeat: train the emulator on "
        "the "
        "simulations which that result rests on, and on no others (default: all simulations of "
        "atlas and store that suit the study)",
        a_file());
}

void Options::add_switch(const char* name, bool* value, const std::string& description) {
    sections_.back().add_options()(name, po::bool_switch(value), description.c_str());
}

void Options::add_time(const char* name, std::optional<double>* seconds, double alone,
                       const std::string& description) {
    const std::string option = std::string("--") + name;
    times_[option] = fmt::format("{}", alone);
    sections_.back().add_options()(
        name,
        po::value<double>()->value_name("[MINUTES]")->notifier([seconds, option](double minutes) {
            if (!(minutes >= 0)) {
                throw InputError(
                    fmt::format("{} {}: the minutes must not be negative", option, minutes));
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
const char* const standard_missing_word = "STUDY (the folder of a study or its file study.toml)";

/// Names of the fidelities with the settings of each, one line per fidelity, for the help text.
std::string fidelity_text() {
    std::string text =
        "size and accuracy of the simulations; predictions below the lowest inertial number are "
        "extrapolated";
    for (const Fidelity& each : fidelities()) {
        text += fmt::format(
            "\n{} {} grains, stiffness number {:g}, lowest inertial number {:g}, "
            "averages over a strain of {:g}",
            each.name + ':', each.grains, each.stiffness_number, each.lowest_inertial_number,
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

/// Text with "; " in place of line ends.
std::string on_one_line(const std::string& text) {
    std::string line;
    for (const char c : text) {
        line += c == '\n' ? "; " : std::string{c};
    }
    return line;
}

/// Values of the first word of a command, from the usage line.
ValueKind first_word_of(const std::string& usage) {
    const auto has = [&](const char* word) { return usage.find(word) != std::string::npos; };
    if (has(" FILE")) return a_file();
    return has(" STUDY") ? a_study() : a_folder();
}

}  // namespace

CommandDeclaration declaration_of(int (*run)(const std::vector<std::string>& arguments)) {
    const struct Reset {
        ~Reset() { requested_declaration = nullptr; }  // also where `run` throws
    } reset;
    CommandDeclaration result;
    requested_declaration = &result;
    run({"--help"});
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
                 on_one_line(option->description()),
                 takes_value ? value : ValueKind{ValueKind::Kind::none}});
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

po::options_description Options::common_options(CommonValues& values, bool shown) const {
    po::options_description options("Common options", 100);
    const auto add = [&](const char* name, const po::value_semantic* value,
                         const std::string& meaning) {
        std::unique_ptr<const po::value_semantic> owner(value);
        if (unused_.contains(name) == shown) return;
        options.add(
            boost::make_shared<po::option_description>(name, owner.release(), meaning.c_str()));
    };
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const int threads = default_threads_ > 0 ? default_threads_ : cores;
    add("json", po::value(&values.json)->value_name("FILE"),
        "file for the result as JSON; '-': standard output, which then holds nothing else");
    add("out", po::value(&values.out)->value_name("DIR"), out_meaning_);
    add("fidelity", po::value(&values.fidelity)->default_value("standard")->value_name("NAME"),
        fidelity_meaning_.empty() ? fidelity_text() : fidelity_meaning_);
    add("store", po::value(&values.store)->value_name("FILE"), store_meaning_);
    add("threads",
        po::value(&values.options.threads)
            ->default_value(threads, default_threads_ > 0 ? std::to_string(threads) : "cores")
            ->value_name("N"),
        threads_meaning_);
    add("quiet", po::bool_switch(&values.options.quiet), "print no progress messages");
    add("all", po::bool_switch(&values.options.all), "print all rows of tables and all notes");
    add("help", new po::untyped_value(true), "print this text");
    return options;
}

/// Stores the values of the options, and passes them on to their variables.
/// @param visible options whose names a message may suggest
void Options::store(const std::vector<std::string>& arguments, const po::options_description& all,
                    const po::options_description& visible,
                    const po::positional_options_description& positional) {
    try {
        po::store(po::command_line_parser(arguments)
                      .options(all)
                      .positional(positional)
                      .style(po::command_line_style::default_style &
                             ~po::command_line_style::allow_guessing)
                      .run(),
                  *variables_);
        po::notify(*variables_);
    } catch (const po::unknown_option& error) {
        const std::string name = error.get_option_name();
        throw InputError(fmt::format("unknown option '{}'; {}", name,
                                     did_you_mean(name, option_names(visible))));
    } catch (const po::too_many_positional_options_error&) {
        throw InputError(fmt::format("too many arguments; usage: pendular {}", usage_));
    } catch (const po::invalid_option_value& error) {
        // Only numbers are converted, so that the value in quotes is not a number.
        const std::string text = error.what();
        const auto begin = text.find('\''), end = text.find('\'', begin + 1);
        throw InputError(fmt::format("{}: {} is not a valid number; see: pendular {} --help",
                                     error.get_option_name(), text.substr(begin, end + 1 - begin),
                                     usage_.substr(0, usage_.find(' '))));
    } catch (const po::error& error) {
        throw InputError(fmt::format("{}; see: pendular {} --help", error.what(),
                                     usage_.substr(0, usage_.find(' '))));
    }
}

void Options::check_json_file(const std::string& json, const std::string& study) const {
    demand_writable(json, "--json", false);
    demand_json(json, "--json");
    std::error_code error;
    if (takes_study_ && std::filesystem::equivalent(json, study, error)) {
        throw InputError(
            fmt::format("--json {}: that is what the command reads; name another file", json));
    }
}

CommonOptions Options::checked(const CommonValues& values, const std::string& study) const {
    CommonOptions result = values.options;
    if (takes_study_ && study.empty()) {
        throw InputError(fmt::format("argument {} is not given; usage: pendular {}",
                                     missing_word_.empty() ? standard_missing_word : missing_word_,
                                     usage_));
    }
    if (result.threads < 1) {
        throw InputError(
            fmt::format("--threads {}: at least one thread is needed", result.threads));
    }
    result.study = study;
    result.fidelity = fidelity_named(values.fidelity);
    if (variables_->count("json") > 0) {
        result.json = values.json;
        if (values.json != "-") check_json_file(values.json, study);
    }
    if (given("runs-of")) result.runs_of = runs_of_;
    result.store_named = !values.store.empty() || std::getenv("PENDULAR_STORE");
    result.store =
        values.store.empty() ? RunStore::standard_file() : std::filesystem::path(values.store);
    if (variables_->count("out") > 0) {
        result.out = values.out;
        demand_writable(*result.out, "--out", true);
    }
    std::error_code unknown;  // set for a link to itself, for example
    if (takes_study_ && std::filesystem::exists(study, unknown)) {
        demand_writable(result.out_folder(), "--out", true);
    }
    return result;
}

std::optional<CommonOptions> Options::parse(const std::vector<std::string>& words_given) {
    const std::vector<std::string> arguments = with_attached_times(words_given, times_);
    std::string study;
    CommonValues values;
    const po::options_description common = common_options(values, true),
                                  unused = common_options(values, false);
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
    all.add(visible).add(unused).add(hidden);
    po::positional_options_description positional;
    positional.add("named-study", takes_study_ ? 1 : 0);
    if (words_) {
        positional.add("words", -1);
    }
    store(arguments, all, visible, positional);
    if (variables_->count("help") > 0) {
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
    return checked(values, study);
}

}  // namespace pendular::app
