#include "reports/draw_figure.h"

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "data/files/file_access.h"
#include "data/files/write_whole.h"
#include "reports/figure.h"
#include "reports/layout.h"

namespace pendular {
namespace {

namespace fs = std::filesystem;

std::string block_name(std::size_t panel, std::size_t curve) {
    return fmt::format("$d{}_{}", panel, curve);
}

bool has_line(const Curve& curve) {
    using Style = Curve::Style;
    return curve.style != Style::points && curve.style != Style::bars_across &&
           curve.style != Style::cells && curve.style != Style::scale && curve.drawn &&
           !curve.x.empty();
}

/// Gnuplot commands that define the data of lines and bands as named blocks, once for all file
/// formats.
std::string data_blocks(const Figure& figure) {
    std::string text;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        for (std::size_t c = 0; c < figure.panels[p].curves.size(); ++c) {
            const Curve& curve = figure.panels[p].curves[c];
            if (!has_line(curve)) {
                continue;
            }
            text += block_name(p, c) + " << EOD\n";
            for (std::size_t k = 0; k < curve.x.size(); ++k) {
                if (!std::isfinite(curve.x[k]) || !std::isfinite(curve.y[k])) {
                    text += "\n";  // a gap
                    continue;
                }
                const double stated = curve.y_error.empty() ? 0 : curve.y_error[k];
                const double error = std::isfinite(stated) ? stated : 0;
                text += fmt::format("{} {} {} {}\n", curve.x[k], curve.y[k], curve.y[k] - error,
                                    curve.y[k] + error);
            }
            text += "EOD\n";
        }
    }
    return text;
}

/// Gnuplot commands that draw a reference line behind the data, with its error as a shaded band.
std::string reference_object(const Reference& r, int number, const PanelPlace& place) {
    const auto [x, y] = std::pair(place.x, place.y);
    std::string text;
    if (r.error > 0) {
        const auto [x1, x2] = r.vertical ? std::pair(r.value - r.error, r.value + r.error) : x;
        const auto [y1, y2] = r.vertical ? y : std::pair(r.value - r.error, r.value + r.error);
        text += fmt::format(
            "set object {} rectangle from first {},{} to {},{} behind fillcolor rgb '{}' "
            "fillstyle solid 0.18 noborder\n",
            number, std::max(x1, x.first), std::max(y1, y.first), std::min(x2, x.second),
            std::min(y2, y.second), r.colour);
    }
    const auto [a, b] = r.vertical ? std::pair(r.value, r.value) : x;
    const auto [c, d] = r.vertical ? y : std::pair(r.value, r.value);
    text += fmt::format(
        "set arrow {} from first {},{} to {},{} nohead back linewidth {} dashtype {} "
        "linecolor rgb '{}'\n",
        number, a, c, b, d, reference_pen.width, reference_pen.dash, r.colour);
    return text;
}

std::string plot_term(const Curve& curve, const std::string& block) {
    if (curve.style == Curve::Style::band) {
        return fmt::format(
            "{} using 1:3:4 with filledcurves fillcolor rgb '{}' fillstyle transparent solid {} "
            "noborder",
            block, curve.colour, band_opacity);
    }
    const Pen pen = pen_of(curve);
    return fmt::format("{} using 1:2 with lines linewidth {} dashtype {} linecolor rgb '{}'", block,
                       pen.width, pen.dash, pen.colour);
}

/// Round number near `rough`: 1, 2 or 5 times a power of ten.
double round_step(double rough) {
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / decade;
    return decade * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

/// Width of a character of a number at an axis, and distance between two numbers [in].
constexpr double width_of_character = 0.09, between_numbers = 0.15;

/// Distance of the tics of a linear axis of this width [in], so that their numbers do not touch.
double step_of_tics(AxisRange range, double width) {
    constexpr double most = 7;  // numbers on an axis: more are not read
    const double span = range.second - range.first;
    double step = round_step(span / most);
    // Numbers have the most digits where they are no multiples of the next larger step.
    const double middle = step * std::round((range.first + span / 2) / step) + step;
    const auto characters = static_cast<double>(fmt::format("{:.6g}", middle).size());
    while (span / step * (width_of_character * characters + between_numbers) > width) {
        step = round_step(2.2 * step);  // the next of 1, 2, 5, 10
    }
    return step;
}

/// Positive round numbers at even distances in a range, about four.
std::vector<double> even_tics(AxisRange range) {
    const double step = round_step((range.second - range.first) / 4);
    std::vector<double> tics;
    const auto first = std::max(1L, std::lround(std::ceil(range.first / step)));
    for (long k = first; static_cast<double>(k) * step <= range.second; ++k) {
        tics.push_back(static_cast<double>(k) * step);
    }
    return tics;
}

/// Multiples of powers of ten in a range by these digits.
std::vector<double> multiples(AxisRange range, const std::vector<double>& digits) {
    std::vector<double> tics;
    const int first = static_cast<int>(std::floor(std::log10(range.first)));
    const int last = static_cast<int>(std::ceil(std::log10(range.second)));
    for (int decade = first; decade <= last; ++decade) {
        for (const double digit : digits) {
            const double tic = digit * std::pow(10.0, decade);
            if (tic >= range.first && tic <= range.second) tics.push_back(tic);
        }
    }
    return tics;
}

/// Whether the numbers at two tics of a logarithmic axis of this width [in] do not touch.
bool are_apart(double a, double b, AxisRange range, double width) {
    const auto width_of = [](double tic) {
        return width_of_character * static_cast<double>(fmt::format("{:g}", tic).size());
    };
    const double distance = std::log(b / a) / std::log(range.second / range.first) * width;
    return distance >= (width_of(a) + width_of(b)) / 2 + between_numbers;
}

bool have_room(const std::vector<double>& tics, AxisRange range, double width) {
    for (std::size_t k = 1; k < tics.size(); ++k) {
        if (!are_apart(tics[k - 1], tics[k], range, width)) return false;
    }
    return true;
}

/// The first tic, and those of the others that are apart from the last one kept.
std::vector<double> with_room(const std::vector<double>& tics, AxisRange range, double width) {
    std::vector<double> kept;
    for (const double tic : tics) {
        if (kept.empty() || are_apart(kept.back(), tic, range, width)) kept.push_back(tic);
    }
    return kept;
}

/// List of tics for a logarithmic axis of this width [in]: the first of several series of digits
/// times powers of ten that has four tics (if none has, three) with numbers that do not touch.
/// Where no series has, round numbers at even distances.
std::string tics_of_logarithm(AxisRange range, double width) {
    const std::vector<std::vector<double>> series = {
        {1}, {1, 3}, {1, 2, 5}, {1, 2, 3, 4, 6}, {1, 2, 3, 6}};
    std::vector<double> tics;
    for (const std::size_t enough : {4, 3}) {
        for (const std::vector<double>& digits : series) {
            if (!tics.empty()) break;
            const std::vector<double> some = multiples(range, digits);
            if (some.size() >= enough && have_room(some, range, width)) tics = some;
        }
    }
    if (tics.empty()) tics = with_room(even_tics(range), range, width);
    std::vector<std::string> texts;
    for (const double tic : tics)
        texts.push_back(fmt::format("{:g}", tic));
    return fmt::format("{}", fmt::join(texts, ", "));
}

/// Gnuplot commands for the axes of a panel and for their position on the page.
std::string axes_script(const Panel& panel, const PanelPlace& place, const Page& page) {
    constexpr double tall = 100;  // numbers above one another do not touch
    std::string text =
        "unset object\nunset arrow\nunset logscale\nunset key\nset format x '%g'\n"
        "set border 31 linewidth 1.2\nset grid xtics ytics linecolor rgb '#e4e4e4'\n"
        "set ytics nomirror autofreq format '% h'\n";
    if (panel.log_y) {
        constexpr double decades = 100;  // from here on, powers of ten are enough
        text += place.y.second > decades * place.y.first
                    ? "set logscale y\nset ytics format '10^{%T}'\n"
                    : "set logscale y\nset ytics (" + tics_of_logarithm(place.y, tall) +
                          ") format '%g'\n";
    }
    if (!panel.y_names.empty()) text += "unset ytics\n";
    if (!panel.x_names.empty()) {
        text += "unset xtics\n";
    } else if (panel.log_x) {
        text += "set logscale x\nset xtics nomirror (" +
                tics_of_logarithm(place.x, place.right - place.left) + ")\n";
    } else {
        text += fmt::format("set xtics nomirror {:.6g}\n",
                            step_of_tics(place.x, place.right - place.left));
    }
    text += fmt::format("set xlabel {}\nset ylabel {}\n", gnuplot_string(panel.x_label),
                        gnuplot_string(panel.y_label));
    text += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", place.x.first, place.x.second,
                        place.y.first, place.y.second);
    return text + fmt::format(
                      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen "
                      "{}\nset tmargin at screen {}\n",
                      place.left / page.width, place.right / page.width, place.bottom / page.height,
                      place.top / page.height);
}

std::string panel_script(const Figure& figure, std::size_t p, const Page& page) {
    const Panel& panel = figure.panels[p];
    const PanelPlace& place = page.panels[p];
    std::string text = axes_script(panel, place, page);
    int number = 1;
    for (const auto& reference : panel.references) {
        text += reference_object(reference, number++, place);
    }
    const auto grey_line = [&](double from, double to) {
        text += fmt::format(
            "set arrow {} from first {},{} to {},{} nohead back linecolor rgb '#888888'\n",
            number++, place.x.first, from, place.x.second, to);
    };
    if (panel.diagonal) {
        grey_line(place.x.first, place.x.second);
    }
    if (panel.zero_line) {
        grey_line(0, 0);
    }
    std::string terms = "NaN";
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        if (has_line(panel.curves[c])) {
            terms += ", " + plot_term(panel.curves[c], block_name(p, c));
        }
    }
    return text + fmt::format("plot {}\n", terms);
}

std::string script_of_page(const Figure& figure, const Page& page, const Ink& marks) {
    std::string text = "set multiplot\n";
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        text += panel_script(figure, p, page);
    }
    return text + marks.script(page.width, page.height) + "unset multiplot\nunset output\n";
}

/// File format that gnuplot draws. A complete file contains `end` in its last bytes.
struct Format {
    std::string_view extension, terminal;
    double dots_per_inch;  ///< resolution of the size given to gnuplot; 0: size in inches
    std::string_view end;
};
/// In all formats, texts have 9 pt on the page: the terminals of cairo take 96 dots for an inch.
constexpr Format formats[] = {
    {"svg", "svg enhanced font 'DejaVu Sans,12' background rgb 'white' size", 96, "</svg>"},
    {"png",
     "pngcairo enhanced font 'DejaVu Sans,12' fontscale 1.25 linewidth 1.5 pointscale 1.5 "
     "size",
     160, "IEND"},
    {"pdf", "pdfcairo enhanced font 'DejaVu Sans,12' fontscale 0.75 linewidth 1.6 size", 0,
     "%%EOF"}};

/// File in which gnuplot draws a figure.
fs::path drawing(const fs::path& folder, const Figure& figure, const Format& format) {
    return folder / fmt::format("{}.{}", figure.name, format.extension);
}

std::string size_of(const Page& page, const Format& format) {
    return format.dots_per_inch > 0
               ? fmt::format("{:.0f},{:.0f}", page.width * format.dots_per_inch,
                             page.height * format.dots_per_inch)
               : fmt::format("{}in,{}in", page.width, page.height);
}

/// Content of a drawing; empty if the file is missing or incomplete.
std::string complete_drawing(const fs::path& file, std::string_view end) {
    std::error_code error;
    if (!fs::exists(file, error)) return "";
    std::string content = read_bytes(file, largest_table);
    // Behind `end` follow the check sum of a PNG and line ends.
    const std::string_view tail = std::string_view(content).substr(
        content.size() - std::min<std::size_t>(content.size(), 32));
    return tail.find(end) != std::string_view::npos ? content : "";
}

/// Lets writing to a program that has ended fail, during the life of the object, instead of ending
/// this program: gnuplot may be missing.
class BrokenPipesIgnored {
  public:
    BrokenPipesIgnored() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
    BrokenPipesIgnored(const BrokenPipesIgnored&) = delete;
    BrokenPipesIgnored& operator=(const BrokenPipesIgnored&) = delete;
    ~BrokenPipesIgnored() { std::signal(SIGPIPE, before_); }

  private:
    void (*before_)(int);
};

/// Draws a figure by gnuplot into temporary files, one per format, and waits for gnuplot to end.
/// Gnuplot reads no settings of the user, and its warnings are discarded. The folder must be
/// absolute: gnuplot takes a file name that begins with '|' for a command and a leading '~' for the
/// home directory.
void run_gnuplot(const Figure& figure, const fs::path& folder) {
    const BrokenPipesIgnored ignored;
    Gnuplot gnuplot("gnuplot --default-settings 2>/dev/null");
    const Page page = page_of(figure);
    const Ink marks = marks_of(figure, page);
    gnuplot << "set encoding utf8\nset samples 2\n" << data_blocks(figure) << marks.data_blocks();
    for (const auto& format : formats) {
        gnuplot << "set terminal " << format.terminal << ' ' << size_of(page, format)
                << "\nset output " << gnuplot_string(drawing(folder, figure, format).string())
                << '\n'
                << script_of_page(figure, page, marks);
    }
}

/// Removes the elements of a list whose place `keep` does not name; an empty list stays empty.
template <typename List>
void keep_places(List& list, const std::vector<std::size_t>& keep) {
    if (list.empty()) return;
    List kept;
    for (const std::size_t k : keep)
        kept.push_back(list[k]);
    list = std::move(kept);
}

/// Curve without marks at values that are not finite. Lines keep such values, as gaps.
Curve finite(Curve curve) {
    if (has_line(curve)) return curve;
    std::vector<std::size_t> keep;
    for (std::size_t k = 0; k < curve.x.size(); ++k)
        if (std::isfinite(curve.x[k]) && std::isfinite(curve.y[k])) keep.push_back(k);
    if (keep.size() == curve.x.size()) return curve;
    keep_places(curve.y_error, keep);
    keep_places(curve.x_error, keep);
    keep_places(curve.names, keep);
    keep_places(curve.shade, keep);
    keep_places(curve.y, keep);
    keep_places(curve.x, keep);
    return curve;
}

bool has_extent(const AxisRange& range) {
    return std::isfinite(range.first) && std::isfinite(range.second) && range.first < range.second;
}

/// Figure without what gnuplot cannot draw: marks at values that are not finite, and panels without
/// an extent.
Figure drawable(Figure figure) {
    std::erase_if(figure.panels, [](const Panel& panel) {
        return (panel.x_range && !has_extent(*panel.x_range)) ||
               (panel.y_range && !has_extent(*panel.y_range));
    });
    for (Panel& panel : figure.panels) {
        std::ranges::transform(panel.curves, panel.curves.begin(),
                               [](const Curve& curve) { return finite(curve); });
        std::erase_if(panel.references, [](const Reference& reference) {
            return !std::isfinite(reference.value) || !std::isfinite(reference.error);
        });
    }
    if (figure.panels.empty()) return figure;
    const Page page = page_of(figure);
    std::vector<Panel> shown;
    for (std::size_t p = 0; p < figure.panels.size(); ++p)
        if (has_extent(page.panels[p].x) && has_extent(page.panels[p].y))
            shown.push_back(figure.panels[p]);
    figure.panels = std::move(shown);
    return figure;
}

}  // namespace

bool draw(const Figure& whole, const fs::path& folder) {
    const Figure figure = drawable(whole);
    if (figure.panels.empty()) return false;
    fs::create_directories(folder);
    write_whole(folder / (figure.name + ".csv"), numbers_table(figure));
    // A folder of its own: nobody else can have put a link there, which gnuplot would write
    // through.
    const PassingFolder drawn(fs::absolute(folder));
    run_gnuplot(figure, drawn.path());
    std::map<fs::path, std::string> files;
    for (const auto& format : formats) {
        std::string content = complete_drawing(drawing(drawn.path(), figure, format), format.end);
        if (content.empty()) {
            throw std::runtime_error(
                fmt::format("the figure {} is missing, all else is written: gnuplot could not draw "
                            "it; is gnuplot installed, and is there space on the disk?",
                            (folder / figure.name).string()));
        }
        files[drawing(folder, figure, format)] = std::move(content);
    }
    for (const auto& [file, content] : files) {
        write_whole(file, content);
    }
    return true;
}

std::vector<std::string> draw_all(const std::vector<Figure>& figures, const fs::path& folder) {
    std::vector<std::string> names;
    for (const Figure& figure : figures) {
        if (draw(figure, folder)) names.push_back(figure.name);
    }
    return names;
}

}  // namespace pendular
