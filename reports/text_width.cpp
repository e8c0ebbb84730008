#include "reports/text_width.h"

#include <array>
#include <string_view>

namespace pendular {
namespace {

/// Advance widths of the characters from the blank on, in thousandths of the size. Source: DejaVu
/// Sans 2.37, table hmtx.
constexpr std::array<int, 95> widths = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
/// Widths taken for all other letters and for signs such as "±"; those of brackets and dashes
/// differ, by less than a character.
constexpr int of_letters = 640, of_signs = 838;

bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// Width of the character that begins at `at`, in thousandths of the size.
int width_of(std::string_view text, std::size_t at) {
    const auto code = static_cast<unsigned char>(text[at]);
    if (code < ' ') return 0;
    if (code < 0x7F) return widths[code - ' '];
    if (code == 0xCC || code == 0xCD) return 0;  // an accent over the character before
    const bool sign = code == 0xE2 || text.substr(at, 2) == "±" || text.substr(at, 2) == "×";
    return sign ? of_signs : of_letters;
}

/// Reads a text in gnuplot's markup: groups in braces, `_` and `^` before a group or a character,
/// and escapes.
class Reader {
  public:
    explicit Reader(std::string_view text) : text_(text) {}

    /// Width up to the end of the text or of the group, in thousandths of the size.
    double width(double scale) {
        double sum = 0;
        while (at_ < text_.size() && text_[at_] != '}') {
            sum += width_of_next(scale);
        }
        return sum;
    }

  private:
    double width_of_next(double scale) {
        constexpr double of_script = 0.8;  // gnuplot's
        const char c = text_[at_];
        if (c == '_' || c == '^') {
            ++at_;
            return at_ < text_.size() ? width_of_next(of_script * scale) : 0;
        }
        if (c == '{') {
            ++at_;
            const double group = width(scale);
            ++at_;
            return group;
        }
        if (c == '\\' && at_ + 1 < text_.size()) ++at_;
        const double one = scale * width_of(text_, at_++);
        while (at_ < text_.size() && continues_character(text_[at_]))
            ++at_;
        return one;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

double text_width(const std::string& text, double size) {
    constexpr double thousandth = 1e-3;
    return thousandth * Reader(text).width(1) * size / dots_of_inch;
}

}  // namespace pendular
