#include "app/manual/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <sstream>

#include "app/command.h"

namespace pendular::app {

std::vector<OptionDeclaration> DeclaredCommand::options() const {
    std::vector<OptionDeclaration> all;
    for (const OptionSection& section : declaration.sections) {
        all.insert(all.end(), section.options.begin(), section.options.end());
    }
    return all;
}

std::vector<DeclaredCommand> declared_commands() {
    std::vector<DeclaredCommand> result;
    for (const CommandGroup& group : command_groups()) {
        for (const Command& command : group.commands) {
            result.push_back({std::string(command.name), std::string(command.summary),
                              group.heading, declaration_of(command.run)});
        }
    }
    return result;
}

namespace {

/// Text that roff prints as it is, in one line: hyphens that can be copied, no commands.
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '\\':
                result += "\\e";
                break;
            case '-':
                result += "\\-";
                break;
            case '\'':
                result += "\\(aq";
                break;
            case '^':
                result += "\\(ha";
                break;
            case '~':
                result += "\\(ti";
                break;
            case '`':
                result += "\\(ga";
                break;
            default:
                result += c;
        }
    }
    return result.starts_with('.') ? "\\&" + result : result;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

std::size_t indentation(const std::string& line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

/// Where the second column of an indented line begins; npos without one.
std::size_t second_column(const std::string& line) {
    const auto gap = line.find("  ", indentation(line));
    return gap == std::string::npos ? gap : line.find_first_not_of(' ', gap);
}

using Lines = std::vector<std::string>;

constexpr std::size_t deep = 6;  ///< indentation of a line that continues a second column

/// Whether indented lines are a list: each has two columns or continues the second one.
bool is_list(const Lines& lines) {
    return indentation(lines.front()) < deep && std::ranges::all_of(lines, [](const auto& line) {
               return indentation(line) >= deep || second_column(line) != std::string::npos;
           });
}

std::string as_list(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) {
        if (indentation(line) >= deep) {
            text += roff(line.substr(indentation(line))) + '\n';
            continue;
        }
        const std::size_t column = second_column(line);
        std::string term = line.substr(indentation(line), column - indentation(line));
        term.erase(term.find_last_not_of(' ') + 1);
        text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(term), roff(line.substr(column)));
    }
    return text;
}

std::string as_written(const Lines& lines) {
    std::string text = ".nf\n";
    for (const std::string& line : lines) {
        text += roff(line) + '\n';
    }
    return text + ".fi\n";
}

/// Whether a line ends a paragraph: its sentence ends though the next word would have had room.
bool ends_paragraph(const std::string& line, const std::string& next) {
    constexpr std::size_t width = 88;
    return line.ends_with('.') && line.size() + 1 + next.find(' ') < width;
}

/// Paragraphs of a text: lines that begin with a space are a list, or stay as they are written.
std::string paragraphs(const std::string& text) {
    std::string result;
    const Lines lines = lines_of(text);
    bool begins = false;
    for (std::size_t k = 0; k < lines.size();) {
        if (lines[k].starts_with(' ')) {
            const auto end =
                std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(k), lines.end(),
                             [](const auto& line) { return !line.starts_with(' '); });
            const Lines block(lines.begin() + static_cast<std::ptrdiff_t>(k), end);
            const bool list = is_list(block);
            if (!list && !result.empty()) result += ".PP\n";  // not directly below a heading
            result += list ? as_list(block) : as_written(block);
            k += block.size();
            begins = true;
            continue;
        }
        if (lines[k].empty()) {
            begins = true;
        } else {
            if (begins) result += ".PP\n";
            result += roff(lines[k]) + '\n';
            begins = k + 1 < lines.size() && ends_paragraph(lines[k], lines[k + 1]);
        }
        ++k;
    }
    return result;
}

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text;
}

std::string title(const std::string& name, const std::string& summary, const ManHeading& heading) {
    return fmt::format(
        ".\\\" Generated from the help texts of the program.\n"
        ".TH {} 1 {} \"Pendular {}\" \"Pendular\"\n.SH NAME\n{} \\- {}\n",
        roff(upper(name)), heading.date, heading.version, roff(name), roff(summary));
}

std::string options_of(const CommandDeclaration& declaration) {
    std::string text;
    for (const OptionSection& section : declaration.sections) {
        text += fmt::format(".SH {}\n", roff(upper(section.heading)));
        for (const OptionDeclaration& option : section.options) {
            text += fmt::format(".TP\n\\fB\\-\\-{}\\fR", roff(option.name));
            // format_parameter of a switch is empty.
            if (!option.argument.empty()) text += fmt::format(" \\fI{}\\fR", roff(option.argument));
            text += '\n' + roff(option.description) + '\n';
        }
    }
    return text;
}

}  // namespace

std::string man_page_of_program(const std::vector<DeclaredCommand>& commands,
                                const ManHeading& heading) {
    std::string text =
        title("pendular", "calibrate and diagnose models of granular rheometry", heading);
    text += ".SH SYNOPSIS\n\\fBpendular\\fR \\fICOMMAND\\fR [\\fIoptions\\fR]\n.SH DESCRIPTION\n";
    text += paragraphs(program_texts.about) + ".SH COMMANDS\n";
    const char* last = "";
    for (const DeclaredCommand& command : commands) {
        if (std::strcmp(last, command.heading) != 0) {
            text += fmt::format(".SS {}\n", roff(command.heading));
        }
        last = command.heading;
        text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(command.name), roff(command.summary));
    }
    text += ".SH EXAMPLES\n";
    text +=
        paragraphs(std::string("A study is a folder with a file study.toml. A first session:\n") +
                   program_texts.session);
    text += ".SH EXIT STATUS\n" + paragraphs(program_texts.exit_codes) + ".SH SEE ALSO\n";
    for (const DeclaredCommand& command : commands) {
        const bool last_one = &command == &commands.back();
        text += fmt::format(".BR pendular\\-{} (1){}\n", roff(command.name), last_one ? "" : ",");
    }
    return text;
}

std::string man_page_of(const DeclaredCommand& command, const ManHeading& heading) {
    const CommandDeclaration& declaration = command.declaration;
    return title("pendular-" + command.name, command.summary, heading) +
           fmt::format(".SH SYNOPSIS\n\\fBpendular\\fR {}\n.SH DESCRIPTION\n",
                       roff(declaration.usage)) +
           paragraphs(declaration.about) + options_of(declaration) + ".SH EXAMPLES\n" +
           paragraphs(declaration.examples) + ".SH EXIT STATUS\n" +
           paragraphs(program_texts.exit_codes) + ".SH SEE ALSO\n.BR pendular (1)\n";
}

}  // namespace pendular::app
