#include "reports/figure.h"

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "data/text_file.h"

namespace pendular {
namespace {

namespace fs = std::filesystem;

/// gnuplot string in double quotes.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    }
    return result + '"';
}

std::string block_name(std::size_t panel, std::size_t curve) {
    return fmt::format("$d{}_{}", panel, curve);
}

/// All data as named blocks, so that every terminal draws the same.
std::string data_blocks(const Figure& figure) {
    std::string text;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        for (std::size_t c = 0; c < figure.panels[p].curves.size(); ++c) {
            const Curve& curve = figure.panels[p].curves[c];
            text += block_name(p, c) + " << EOD\n";
            for (std::size_t k = 0; k < curve.x.size(); ++k) {
                const double error = curve.y_error.empty() ? 0 : curve.y_error[k];
                text += fmt::format("{} {} {} {} {}\n", curve.x[k], curve.y[k], error,
                                    curve.y[k] - error, curve.y[k] + error);
            }
            text += "EOD\n";
        }
    }
    return text;
}

/// Range of one axis over all that a panel shows, with a margin.
std::pair<double, double> range(const Panel& panel, bool along_x) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto include = [&](double value) {
        if (std::isfinite(value)) {
            low = std::min(low, value), high = std::max(high, value);
        }
    };
    for (const auto& curve : panel.curves) {
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            const double error = along_x || curve.y_error.empty() ? 0 : curve.y_error[k];
            include((along_x ? curve.x[k] : curve.y[k]) - error);
            include((along_x ? curve.x[k] : curve.y[k]) + error);
        }
    }
    for (const auto& reference : panel.references) {
        if (reference.vertical == along_x) {
            include(reference.value - reference.error);
            include(reference.value + reference.error);
        }
    }
    if (!(low < high)) {
        // One value only: it stands in the middle.
        const double middle = std::isfinite(low) ? low : 0,
                     reach = middle == 0 ? 1e-3 : 0.5 * std::abs(middle);
        return {middle - reach, middle + reach};
    }
    if (along_x && !panel.diagonal && high - low < 0.2 * std::max(std::abs(low), std::abs(high))) {
        // Set points that scatter by a few per cent were one set point.
        const double middle = 0.5 * (low + high);
        return {0.8 * middle, 1.2 * middle};
    }
    if (along_x && panel.log_x) {
        return {low / 1.3, high * 1.3};
    }
    const double margin = 0.08 * (high - low);
    // Values that cannot be negative keep their natural zero.
    return {low >= 0 && low < margin ? 0 : low - margin, high + margin};
}

/// A reference as an object behind the data, its error as a shaded band.
std::string reference_object(const Reference& r, int number, std::pair<double, double> x,
                             std::pair<double, double> y) {
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
        "set arrow {} from first {},{} to {},{} nohead back linewidth 1.5 dashtype 2 "
        "linecolor rgb '{}'\n",
        number, a, c, b, d, r.colour);
    return text;
}

std::string plot_term(const Curve& curve, const std::string& block) {
    const std::string title = curve.label.empty() ? "notitle" : "title " + quoted(curve.label);
    switch (curve.style) {
        case Curve::Style::band:
            return fmt::format(
                "{} using 1:4:5 with filledcurves fillcolor rgb '{}' fillstyle solid 0.2 noborder "
                "{}",
                block, curve.colour, title);
        case Curve::Style::line:
            return fmt::format("{} using 1:2 with lines linewidth 2 linecolor rgb '{}' {}", block,
                               curve.colour, title);
        case Curve::Style::points:
            break;
    }
    const std::string look = fmt::format(
        "pointtype {} pointsize 0.9 linewidth 1.3 linecolor rgb '{}'", curve.symbol, curve.colour);
    return curve.y_error.empty()
               ? fmt::format("{} using 1:2 with points {} {}", block, look, title)
               : fmt::format("{} using 1:2:3 with yerrorbars {} {}", block, look, title);
}

/// Tics at 1, 2 and 5 of each decade: a logarithmic axis often shows little more than one decade.
std::string tics_1_2_5(std::pair<double, double> range) {
    std::vector<std::string> tics;
    const int first = static_cast<int>(std::floor(std::log10(range.first)));
    const int last = static_cast<int>(std::ceil(std::log10(range.second)));
    const bool wide = last - first > 3;
    for (int decade = first; decade <= last; ++decade) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            if (!wide || digit == 1.0) {
                tics.push_back(fmt::format("{:g}", digit * std::pow(10.0, decade)));
            }
        }
    }
    return fmt::format("{}", fmt::join(tics, ", "));
}

std::string panel_script(const Figure& figure, std::size_t p) {
    const Panel& panel = figure.panels[p];
    const auto x = panel.x_range.value_or(range(panel, true));
    auto y = range(panel, false);
    if (panel.y_least > 0) {
        y = {std::min(y.first, -panel.y_least), std::max(y.second, panel.y_least)};
    }
    y.second += panel.headroom / (1 - panel.headroom) * (y.second - y.first);
    const auto both = std::pair(std::min(x.first, y.first), std::max(x.second, y.second));
    const auto [xr, yr] = panel.diagonal ? std::pair(both, both) : std::pair(x, y);
    std::string text = "unset object\nunset arrow\nunset logscale\nset format x '%g'\n";
    text += panel.log_x ? "set logscale x\nset xtics (" + tics_1_2_5(xr) + ")\n"
                        : "set xtics autofreq\n";
    text +=
        fmt::format("set xlabel {}\nset ylabel {}\n", quoted(panel.x_label), quoted(panel.y_label));
    text += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", xr.first, xr.second, yr.first,
                        yr.second);
    text += panel.key.empty() ? std::string("unset key\n")
                              : fmt::format("set key {} samplen 2\n", panel.key);
    text += "set lmargin 11\nset rmargin 3\n";
    int number = 1;
    std::vector<std::string> terms;
    for (const auto& reference : panel.references) {
        text += reference_object(reference, number++, xr, yr);
        if (!reference.label.empty()) {
            terms.push_back(
                fmt::format("NaN with lines linewidth 1.5 dashtype 2 linecolor rgb '{}' title {}",
                            reference.colour, quoted(reference.label)));
        }
    }
    if (panel.diagonal) {
        text += fmt::format(
            "set arrow {} from first {},{} to {},{} nohead back linecolor rgb '#888888'\n",
            number++, xr.first, xr.first, xr.second, xr.second);
    }
    if (panel.zero_line) {
        text += fmt::format(
            "set arrow {} from first {},0 to {},0 nohead back linecolor rgb '#888888'\n", number++,
            xr.first, xr.second);
    }
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        terms.push_back(plot_term(panel.curves[c], block_name(p, c)));
    }
    return text + fmt::format("plot {}\n", fmt::join(terms, ", "));
}

std::string page_script(const Figure& figure) {
    const std::size_t n = figure.panels.size();
    std::string text =
        fmt::format("set multiplot layout {},{} title {} font ',13'\n", figure.stacked ? n : 1,
                    figure.stacked ? 1 : n, quoted(figure.title));
    for (std::size_t p = 0; p < n; ++p) {
        text += panel_script(figure, p);
    }
    return text + "unset multiplot\nunset output\n";
}

void write_numbers(const Figure& figure, const fs::path& file) {
    const auto cell = [](const std::string& text) {
        return text.find_first_of(",\"") == std::string::npos ? text : '"' + text + '"';
    };
    std::string text = "panel,curve,x,y,y_error\n";
    for (const auto& panel : figure.panels) {
        text += fmt::format("# {} against {}\n", panel.y_label, panel.x_label);
        const auto number = static_cast<std::size_t>(&panel - figure.panels.data()) + 1;
        for (const auto& r : panel.references) {
            text += fmt::format("{},{},{},{},{}\n", number, cell(r.label),
                                r.vertical ? fmt::format("{}", r.value) : "",
                                r.vertical ? "" : fmt::format("{}", r.value), r.error);
        }
        for (const auto& curve : panel.curves) {
            for (std::size_t k = 0; k < curve.x.size(); ++k) {
                text += fmt::format(
                    "{},{},{},{},{}\n", number, cell(curve.label), curve.x[k], curve.y[k],
                    curve.y_error.empty() ? "" : fmt::format("{}", curve.y_error[k]));
            }
        }
    }
    write_whole(file, text);
}

}  // namespace

namespace {

/// A file format gnuplot draws, and how a file of it that was written whole ends.
struct Format {
    std::string_view extension, terminal;
    double dots_per_inch;  ///< 0: sizes are in inches
    std::string_view end;
};
constexpr Format formats[] = {
    {"svg", "svg enhanced font 'DejaVu Sans,12' background rgb 'white' size", 96, "</svg>"},
    {"png",
     "pngcairo enhanced font 'DejaVu Sans,12' fontscale 1.5 linewidth 1.5 pointscale 1.5 size", 160,
     "IEND"},
    {"pdf", "pdfcairo enhanced font 'DejaVu Sans,12' fontscale 0.9 size", 0, "%%EOF"}};

/// Where a drawing is made before it takes its name.
fs::path unfinished(const fs::path& folder, const Figure& figure, const Format& format) {
    return folder / fmt::format(".{}.{}", figure.name, format.extension);
}

std::string size_of(const Figure& figure, const Format& format) {
    const auto panels = static_cast<double>(figure.panels.size());
    const double width = figure.stacked ? 6.0 : 5.2 * panels,
                 height = figure.stacked ? 4.1 * panels : 4.6;
    return format.dots_per_inch > 0
               ? fmt::format("{},{}", width * format.dots_per_inch, height * format.dots_per_inch)
               : fmt::format("{}in,{}in", width, height);
}

bool written_whole(const fs::path& file, std::string_view end) {
    std::ifstream stream(file, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    const std::string_view tail = std::string_view(content).substr(
        content.size() - std::min<std::size_t>(content.size(), 32));
    return tail.find(end) != std::string_view::npos;
}

/// Sends everything to gnuplot and waits for it to end. Its warnings are for whoever draws, not for
/// the user.
void run_gnuplot(const Figure& figure, const fs::path& folder) {
    Gnuplot gnuplot("gnuplot 2>/dev/null");
    gnuplot << "set encoding utf8\nset border linewidth 1.2\nset tics nomirror\nset grid linecolor "
               "rgb '#e4e4e4'\n"
            << "set samples 2\n"
            << data_blocks(figure);
    for (const auto& format : formats) {
        gnuplot << "set terminal " << format.terminal << ' ' << size_of(figure, format)
                << "\nset output " << quoted(unfinished(folder, figure, format).string()) << '\n'
                << page_script(figure);
    }
}

}  // namespace

void draw(const Figure& figure, const fs::path& folder) {
    fs::create_directories(folder);
    write_numbers(figure, folder / (figure.name + ".csv"));
    run_gnuplot(figure, folder);
    const bool whole = std::ranges::all_of(formats, [&](const Format& format) {
        return written_whole(unfinished(folder, figure, format), format.end);
    });
    for (const auto& format : formats) {
        const fs::path drawn = unfinished(folder, figure, format);
        std::error_code ignored;
        whole ? fs::rename(drawn, folder / fmt::format("{}.{}", figure.name, format.extension),
                           ignored)
              : static_cast<void>(fs::remove(drawn, ignored));
    }
    if (!whole) {
        throw std::runtime_error(
            fmt::format("gnuplot could not draw {}; is gnuplot installed, and is there space on "
                        "the disk?",
                        (folder / figure.name).string()));
    }
}

}  // namespace pendular
