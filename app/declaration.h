#pragma once

#include <string>
#include <vector>

namespace pendular::app {

/// Values that an option or a word of a command accepts, for the help text and the completion of
/// words in a shell.
struct ValueKind {
    enum class Kind { none, text, file, folder, study, choice };
    Kind kind = Kind::text;
    std::vector<std::string> choices = {};  ///< all values of a choice; values besides files

    /// Word that stands for the value in the help text.
    const char* placeholder() const;
};

/// The value is a file or one of the words `choices`, such as "-" for standard output.
inline ValueKind a_file(std::vector<std::string> choices = {}) {
    return {ValueKind::Kind::file, std::move(choices)};
}
/// The value is a folder.
inline ValueKind a_folder() {
    return {ValueKind::Kind::folder};
}
/// The value is a study: a folder or a file of its name.
inline ValueKind a_study() {
    return {ValueKind::Kind::study};
}
/// The value is one of the words `choices`.
inline ValueKind one_of(std::vector<std::string> choices) {
    return {ValueKind::Kind::choice, std::move(choices)};
}

/// An option of a command as its help text shows it.
struct OptionDeclaration {
    std::string name;         ///< without the hyphens before it
    std::string argument;     ///< placeholder of the value with its default; empty: a switch
    std::string description;  ///< text on one line
    ValueKind value;          ///< values that the option accepts
};

/// Options of a command under one heading.
struct OptionSection {
    std::string heading;
    std::vector<OptionDeclaration> options;
};

/// Declaration of a command: the texts of its help, its options and its words.
struct CommandDeclaration {
    std::string usage, about, examples;
    std::vector<OptionSection> sections;
    ValueKind first_word = {ValueKind::Kind::none};   ///< the word after the command's name
    ValueKind other_words = {ValueKind::Kind::none};  ///< words after the first one
};

/// Declaration of a command, which `run` runs with the words after its name.
CommandDeclaration declaration_of(int (*run)(const std::vector<std::string>& arguments));

}  // namespace pendular::app
