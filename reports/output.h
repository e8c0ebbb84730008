#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pendular {

/// Text that a command says, in the order in which the console prints it: an answer, lines, tables
/// (a heading with rows, of which at most `most_rows` are printed) and notes.
class Output {
  public:
    enum class Kind { answer, line, table, note };
    struct Part {
        Kind kind;
        std::vector<std::string> lines;
        std::size_t most_rows = 0;
    };

    void answer(std::string text) { add(Kind::answer, {std::move(text)}); }
    /// Adds a line; nothing for an empty text.
    void line(std::string text) {
        if (!text.empty()) add(Kind::line, {std::move(text)});
    }
    void lines(std::vector<std::string> texts) {
        for (std::string& text : texts)
            add(Kind::line, {std::move(text)});
    }
    void table(std::vector<std::string> heading_and_rows, std::size_t most_rows) {
        parts_.push_back({Kind::table, std::move(heading_and_rows), most_rows});
    }
    void note(std::string text) { add(Kind::note, {std::move(text)}); }
    void notes(const std::vector<std::string>& texts) {
        for (const std::string& text : texts)
            note(text);
    }
    void add(const Output& more) {
        parts_.insert(parts_.end(), more.parts_.begin(), more.parts_.end());
    }

    const std::vector<Part>& parts() const { return parts_; }

  private:
    void add(Kind kind, std::vector<std::string> text) {
        parts_.push_back({kind, std::move(text)});
    }

    std::vector<Part> parts_;
};

}  // namespace pendular
