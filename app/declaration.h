#pragma once

#include <string>
#include <vector>

namespace pendular::app {

/// Kind of values that an option, or a word after a command's name, accepts: text, a file, a
/// folder, a study or one of a few words. It determines the placeholder in the help text and the
/// completion of the value in a shell.
struct ValueKind {
    enum class Kind { none, text, file, folder, study, choice };
    Kind kind = Kind::text;
    /// Words that are accepted: all of them for `choice`; words besides files for `file`, such as
    /// "-".
    std::vector<std::string> choices = {};

    /// Word that stands for the value in the help text: FILE, DIR, STUDY, NAME or X.
    const char* placeholder() const;
};

/// Value that is a file, or one of the words `choices`, such as "-" for standard output.
inline ValueKind a_file(std::vector<std::string> choices = {}) {
    return {ValueKind::Kind::file, std::move(choices)};
}
/// Value that is a folder.
inline ValueKind a_folder() {
    return {ValueKind::Kind::folder};
}
/// Value that is a study: its folder, or the file study.toml in it.
inline ValueKind a_study() {
    return {ValueKind::Kind::study};
}
/// Value that is one of the words `choices`.
inline ValueKind one_of(std::vector<std::string> choices) {
    return {ValueKind::Kind::choice, std::move(choices)};
}

/// Name and texts of one command-line option, as the help text shows them.
struct OptionDeclaration {
    std::string name;  ///< name of the option, without the leading hyphens
    /// Word that stands for the option's value in the help text, with the default; empty: the
    /// option has no value.
    std::string argument;
    std::string description;  ///< meaning of the option, on one line
    /// Kind of values that the option accepts.
    ValueKind value;
};

/// Options of a command that are listed under one heading of the help text.
struct OptionSection {
    std::string heading;
    std::vector<OptionDeclaration> options;
};

/// Declaration of a command, from which its help text, its manual page and its completion in a
/// shell are written: texts, options, and words after its name.
struct CommandDeclaration {
    std::string usage, about, examples;
    std::vector<OptionSection> sections;
    /// Values that the first word after the command's name may have.
    ValueKind first_word = {ValueKind::Kind::none};
    /// Values that the words after the first one may have.
    ValueKind other_words = {ValueKind::Kind::none};
};

/// Returns texts and options of a command, as `run` declares them when the user requests its help.
/// Does not carry out the command.
/// @param run function that carries out the command with the words after its name, and returns its
///        exit code
CommandDeclaration declaration_of(int (*run)(const std::vector<std::string>& arguments));

}  // namespace pendular::app
