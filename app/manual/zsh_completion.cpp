#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/manual.h"

namespace pendular::app {
namespace {

/// Text within single quotes of zsh, where `special` characters have a backslash before them.
std::string zsh_text(const std::string& text, const std::string& special) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
            continue;
        }
        if (special.find(c) != std::string::npos) result += '\\';
        result += c;
    }
    return result;
}

/// Action of _arguments that completes a value.
std::string zsh_action(const ValueKind& value) {
    const std::string words = fmt::format("{}", fmt::join(value.choices, " "));
    switch (value.kind) {
        case ValueKind::Kind::file:
            return words.empty() ? "_files" : "{compadd -- " + words + "; _files}";
        case ValueKind::Kind::folder:
            return "_files -/";
        case ValueKind::Kind::study:
            return "_files -/ -g \"*.toml\"";
        case ValueKind::Kind::choice:
            return "(" + words + ")";
        default:
            return " ";
    }
}

std::string zsh_option(const OptionDeclaration& option) {
    const std::string description = zsh_text(option.description, "\\[]:");
    if (option.value.kind == ValueKind::Kind::none) {
        return fmt::format("        '--{}[{}]' \\\n", option.name, description);
    }
    return fmt::format("        '--{}=[{}]:{}:{}' \\\n", option.name, description,
                       option.value.placeholder(), zsh_action(option.value));
}

std::string zsh_words(const CommandDeclaration& declaration) {
    std::string text;
    if (declaration.first_word.kind != ValueKind::Kind::none) {
        text += fmt::format("        '1:{}:{}' \\\n", declaration.first_word.placeholder(),
                            zsh_action(declaration.first_word));
    }
    if (declaration.other_words.kind != ValueKind::Kind::none) {
        text += fmt::format("        '*:{}:{}' \\\n", declaration.other_words.placeholder(),
                            zsh_action(declaration.other_words));
    }
    return text;
}

}  // namespace

std::string zsh_completion(const std::vector<DeclaredCommand>& commands) {
    std::string names, cases;
    for (const DeclaredCommand& command : commands) {
        names += fmt::format("        '{}:{}'\n", command.name, zsh_text(command.summary, "\\:"));
        cases += fmt::format("      {})\n        _arguments \\\n", command.name);
        for (const OptionDeclaration& option : command.options()) {
            cases += zsh_option(option);
        }
        cases += zsh_words(command.declaration) + "        && return\n        ;;\n";
    }
    return fmt::format(
        "#compdef pendular\n"
        "# Completes words of 'pendular' in zsh. Generated from the options of its commands.\n\n"
        "_pendular() {{\n"
        "  local curcontext=\"$curcontext\" state line\n"
        "  typeset -A opt_args\n"
        "  _arguments -C '(- *)--help[the commands]' '(- *)--version[the version]' \\\n"
        "    '1:command:->command' '*::argument:->arguments' && return\n"
        "  case $state in\n"
        "    command)\n"
        "      local -a commands\n"
        "      commands=(\n{}      )\n"
        "      _describe command commands\n"
        "      return\n"
        "      ;;\n"
        "  esac\n"
        "  case $words[1] in\n{}  esac\n}}\n\n"
        "_pendular \"$@\"\n",
        names, cases);
}

}  // namespace pendular::app
