#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/manual.h"

namespace pendular::app {
namespace {

const char* const bash_head =
    R"(# Completes words of 'pendular' in bash. Generated from the options of its commands.

# Sets COMPREPLY to words of a list, files, folders or studies that begin as the word at hand.
_pendular_complete() {
  local kind=$1 words=$2 word=$3
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  case $kind in
    file) mapfile -O ${#COMPREPLY[@]} -t COMPREPLY < <(compgen -f -- "$word") ;;
    folder) mapfile -O ${#COMPREPLY[@]} -t COMPREPLY < <(compgen -d -- "$word") ;;
    study) mapfile -O ${#COMPREPLY[@]} -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X '!*.toml' -- "$word") ;;
    *) return ;;
  esac
  compopt -o filenames 2>/dev/null
}

_pendular() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
  COMPREPLY=()
  [[ $word == '=' ]] && word=
  [[ $previous == '=' ]] && previous=${COMP_WORDS[COMP_CWORD-2]}
)";

const char* bash_kind(const ValueKind& value) {
    switch (value.kind) {
        case ValueKind::Kind::file:
            return "file";
        case ValueKind::Kind::folder:
            return "folder";
        case ValueKind::Kind::study:
            return "study";
        default:
            return "word";
    }
}

std::string complete(const ValueKind& value) {
    return fmt::format("_pendular_complete {} '{}' \"$word\"", bash_kind(value),
                       fmt::join(value.choices, " "));
}

/// Lines that complete the value of an option, one for each option that has one.
std::string bash_values(const DeclaredCommand& command) {
    std::string text;
    for (const OptionDeclaration& option : command.options()) {
        if (option.value.kind == ValueKind::Kind::none) continue;
        const std::string action =
            option.value.kind == ValueKind::Kind::text ? ":" : complete(option.value);
        text += fmt::format("    '{} --{}') {}; return ;;\n", command.name, option.name, action);
    }
    return text;
}

std::string bash_options(const DeclaredCommand& command) {
    std::vector<std::string> names;
    for (const OptionDeclaration& option : command.options()) {
        names.push_back("--" + option.name);
    }
    return fmt::format("    {}) _pendular_complete word '{}' \"$word\" ;;\n", command.name,
                       fmt::join(names, " "));
}

/// Lines that complete words that belong to no option: the first one by its kind, others by
/// theirs.
std::string bash_words(const DeclaredCommand& command) {
    const auto& [first, others] =
        std::pair(command.declaration.first_word, command.declaration.other_words);
    std::string text = fmt::format("    {})\n", command.name);
    if (others.kind != ValueKind::Kind::none) {
        text += fmt::format("      ((COMP_CWORD > 2)) && {}\n", complete(others));
    }
    if (first.kind != ValueKind::Kind::none) {
        text += fmt::format("      ((${{#COMPREPLY[@]}})) || {}\n", complete(first));
    }
    return text + "      ;;\n";
}

}  // namespace

std::string bash_completion(const std::vector<DeclaredCommand>& commands) {
    std::string values, options, words;
    std::vector<std::string> names;
    for (const DeclaredCommand& command : commands) {
        names.push_back(command.name);
        values += bash_values(command);
        options += bash_options(command);
        words += bash_words(command);
    }
    return bash_head +
           fmt::format(
               "  if ((COMP_CWORD == 1)); then\n"
               "    _pendular_complete word '{} --help --version' \"$word\"\n    return\n  fi\n"
               "  case \"${{COMP_WORDS[1]}} $previous\" in\n{}  esac\n"
               "  if [[ $word == -* ]]; then\n    case ${{COMP_WORDS[1]}} in\n{}    esac\n"
               "    return\n  fi\n"
               "  case ${{COMP_WORDS[1]}} in\n{}  esac\n}}\n\n"
               "complete -F _pendular pendular\n",
               fmt::join(names, " "), values, options, words);
}

}  // namespace pendular::app
