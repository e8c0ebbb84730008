#pragma once

#include <string>
#include <vector>

namespace pendular::app {

/// Kind of value that an option or an argument of a command accepts: text, a file, a folder, a
/// study or one of a few words. The kind determines the placeholder in the help text and the
/// completion of the value in a shell.
struct ValueKind {
    enum class Kind { none, text, file, folder, study, choice };
    Kind kind = Kind::text;
    /// Accepted words. For the kind `choice`, only these words are accepted. For the kind `file`,
    /// these words are accepted besides files, such as "-".
    std::vector<std::string> choices = {};

    /// Returns the word that stands for the value in the help text: FILE, DIR, STUDY, NAME or X.
    const char* placeholder() const;
};

/// Returns the kind of value that is a file, or one of the words `choices`, such as "-" for
/// standard output.
inline ValueKind a_file(std::vector<std::string> choices = {}) {
    return {ValueKind::Kind::file, std::move(choices)};
}
/// Returns the kind of value that is a folder.
inline ValueKind a_folder() {
    return {ValueKind::Kind::folder};
}
/// Returns the kind of value that is a study: the folder of the study, or the file study.toml in
/// the folder.
inline ValueKind a_study() {
    return {ValueKind::Kind::study};
}
/// Returns the kind of value that is one of the words `choices`.
inline ValueKind one_of(std::vector<std::string> choices) {
    return {ValueKind::Kind::choice, std::move(choices)};
}

/// Name and texts of one command-line option, as the help text shows them.
struct OptionDeclaration {
    std::string name;  ///< name of the option, without the leading hyphens
    /// Word that stands for the option's value in the help text, such as FILE, followed by the
    /// default. Empty if the option has no value.
    std::string argument;
    std::string description;  ///< meaning of the option, on one line
    /// Kind of value that the option accepts.
    ValueKind value;
};

/// Section of a command's help text: options under one heading.
struct OptionSection {
    std::string heading;
    std::vector<OptionDeclaration> options;
};

/// Declaration of a command: its texts, options and arguments. The help text, the manual page and
/// the completion in a shell are written from the declaration.
struct CommandDeclaration {
    std::string usage, about, examples;
    std::vector<OptionSection> sections;
    /// Kind of value that the command accepts as its first argument, the word after its name.
    ValueKind first_word = {ValueKind::Kind::none};
    /// Kind of value that the command accepts as each further argument.
    ValueKind other_words = {ValueKind::Kind::none};
};

/// Returns the texts, options and arguments that a command declares when the user requests its
/// help. The command itself is not carried out.
/// @param run function that carries out the command with the arguments after the command's name,
///        and returns the exit code
CommandDeclaration declaration_of(int (*run)(const std::vector<std::string>& arguments));

}  // namespace pendular::app
