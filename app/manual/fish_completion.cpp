#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/manual.h"

namespace pendular::app {
namespace {

const char* const fish_head =
    R"(# Completes words of 'pendular' in fish. Generated from the options of its commands.

# Whether the command of the line at hand is the given one.
function __pendular_command
    set -l words (commandline -opc)
    test (count $words) -gt 1; and test "$words[2]" = $argv[1]
end

# Whether the line at hand has no command yet.
function __pendular_no_command
    test (count (commandline -opc)) -eq 1
end

complete -c pendular -f
complete -c pendular -n __pendular_no_command -l help -d 'the commands'
complete -c pendular -n __pendular_no_command -l version -d 'the version'
)";

/// Text within single quotes of fish.
std::string fish_text(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

/// Switches of `complete` for the values that an option or a word accepts.
std::string fish_values(const ValueKind& value) {
    const std::string words = fmt::format("{}", fmt::join(value.choices, " "));
    switch (value.kind) {
        case ValueKind::Kind::file:
            return words.empty() ? " -F" : fmt::format(" -F -a '{}'", words);
        case ValueKind::Kind::folder:
            return " -f -a '(__fish_complete_directories)'";
        case ValueKind::Kind::study:
            return " -f -k -a '(__fish_complete_suffix .toml)'";
        case ValueKind::Kind::choice:
            return fmt::format(" -f -a '{}'", words);
        default:
            return " -f";
    }
}

std::string fish_words(const std::string& condition, const ValueKind& words) {
    if (words.kind == ValueKind::Kind::none) return "";
    return fmt::format("complete -c pendular {}{}\n", condition, fish_values(words));
}

}  // namespace

std::string fish_completion(const std::vector<DeclaredCommand>& commands) {
    std::string text = fish_head;
    for (const DeclaredCommand& command : commands) {
        const std::string condition = fmt::format("-n '__pendular_command {}'", command.name);
        text += fmt::format("\ncomplete -c pendular -n __pendular_no_command -a {} -d '{}'\n",
                            command.name, fish_text(command.summary));
        text += fish_words(condition, command.declaration.first_word);
        text += fish_words(condition, command.declaration.other_words);
        for (const OptionDeclaration& option : command.options()) {
            text += fmt::format("complete -c pendular {} -l {} -d '{}'", condition, option.name,
                                fish_text(option.description));
            if (option.value.kind != ValueKind::Kind::none) {
                text += " -r" + fish_values(option.value);
            }
            text += '\n';
        }
    }
    return text;
}

}  // namespace pendular::app
