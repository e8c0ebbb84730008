#pragma once

#include <string>
#include <vector>

namespace pendular::app {

/// Kind of value that an option or an argument of a command accepts. It determines the placeholder
/// in the help text and the completion of the value in a shell.
struct ValueKind {
    enum class Kind { none, text, file, folder, study, choice };
    Kind kind = Kind::text;
    /// Accepted words: the only ones for the kind `choice`; for `file` besides files, such as "-".
    std::vector<std::string> choices = {};

    /// Returns the word that stands for the value in the help text: FILE, DIR, STUDY, NAME or X.
    const char* placeholder() const;
};

/// Returns the kind of value that is a file or one of the words `choices`, such as "-".
inline ValueKind a_file(std::vector<std::string> choices = {}) {
    return {ValueKind::Kind::file, std::move(choices)};
}
inline ValueKind a_folder() {
    return {ValueKind::Kind::folder};
}
/// Returns the kind of value that is a study: its folder, or the study.toml in it.
inline ValueKind a_study() {
    return {ValueKind::Kind::study};
}
inline ValueKind one_of(std::vector<std::string> choices) {
    return {ValueKind::Kind::choice, std::move(choices)};
}

/// One command-line option, as the help text shows it.
struct OptionDeclaration {
    std::string name;  ///< without the leading hyphens
    /// Placeholder of the value in the help text, followed by the default; empty: no value.
    std::string argument;
    std::string description;  ///< on one line
    ValueKind value;
};

/// Section of a command's help text: options under one heading.
struct OptionSection {
    std::string heading;
    std::vector<OptionDeclaration> options;
};

/// Texts, options and arguments of a command, from which the help text, the manual page and the
/// completion in a shell are written.
struct CommandDeclaration {
    std::string usage, about, examples;
    std::vector<OptionSection> sections;
    ValueKind first_word = {ValueKind::Kind::none};   ///< the word after the command's name
    ValueKind other_words = {ValueKind::Kind::none};  ///< each further argument
};

/// Returns the declaration that a command makes when the user requests its help. The command itself
/// is not carried out.
/// @param run function of the command (`Command::run`)
CommandDeclaration declaration_of(int (*run)(const std::vector<std::string>& arguments));

}  // namespace pendular::app
