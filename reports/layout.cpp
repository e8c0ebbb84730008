#include "reports/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/figure.h"

namespace pendular {
namespace {

// All lengths are in inches.
constexpr double title_height = 0.38, title_line = 0.24, title_character = 0.078;
constexpr double left_margin = 1.1, right_margin = 0.3, bottom_margin = 0.62, top_margin = 0.1;
constexpr double outside_key_width = 2.75;
struct Size {
    double width, height;
};
constexpr Size above_another{6.0, 3.9}, side_by_side{5.2, 4.2}, alone{6.0, 5.0}, small{4.15, 2.95};
constexpr double left_margin_unlabelled = 0.7;  ///< left margin of small panels without a y label

/// Least and greatest of the values that an axis must include.
class Extent {
  public:
    void include(double value, double error = 0) {
        for (const double end : {value - error, value + error}) {
            if (std::isfinite(end)) {
                least_ = std::min(least_, end), greatest_ = std::max(greatest_, end);
            }
        }
    }
    double least() const { return least_; }
    double greatest() const { return greatest_; }

  private:
    double least_ = std::numeric_limits<double>::infinity(), greatest_ = -least_;
};

bool has_bars(const Panel& panel) {
    return std::ranges::any_of(
        panel.curves, [](const Curve& curve) { return curve.style == Curve::Style::bars; });
}

Extent extent(const Panel& panel, bool along_x) {
    Extent extent;
    for (const auto& curve : panel.curves) {
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            along_x ? extent.include(curve.x[k])
                    : extent.include(curve.y[k], curve.y_error.empty() ? 0 : curve.y_error[k]);
            if (!along_x && !curve.from.empty()) extent.include(curve.from[k]);
        }
    }
    if (!along_x && !panel.log_y && (panel.y_from_zero || panel.zero_line || has_bars(panel))) {
        extent.include(0);
    } else if (!along_x && panel.log_y && has_bars(panel)) {
        extent.include(0.6 * extent.least());  // leaves the shortest bar visible
    }
    for (const auto& reference : panel.references) {
        if (reference.vertical == along_x) {
            extent.include(reference.value, reference.error);
        }
    }
    return extent;
}

/// Range of one axis of a panel that includes all its data and reference lines, with a margin.
AxisRange range(const Panel& panel, bool along_x) {
    const Extent shown = extent(panel, along_x);
    const double least = shown.least(), greatest = shown.greatest();
    if (!(least < greatest)) {
        // A single value is drawn in the middle of the axis.
        const double middle = std::isfinite(least) ? least : 0,
                     reach = middle == 0 ? 1e-3 : 0.5 * std::abs(middle);
        return {middle - reach, middle + reach};
    }
    if (along_x && !panel.diagonal &&
        greatest - least < 0.2 * std::max(std::abs(least), std::abs(greatest))) {
        // Values along x that scatter by a few per cent belong to one set point.
        const double middle = 0.5 * (least + greatest);
        return {0.8 * middle, 1.2 * middle};
    }
    if (along_x ? panel.log_x : panel.log_y) {
        return {least / 1.3, greatest * 1.3};
    }
    const double margin = 0.08 * (greatest - least);
    // An axis of positive values near zero begins at zero.
    return {least >= 0 && least < margin ? 0 : least - margin, greatest + margin};
}

void set_ranges(PanelPlace& place, const Panel& panel) {
    place.x = panel.x_range.value_or(range(panel, true));
    if (!panel.x_names.empty()) {
        place.x = {0.4, static_cast<double>(panel.x_names.size()) + 0.6};
    }
    place.y = panel.y_range.value_or(range(panel, false));
    if (!panel.y_names.empty()) {
        place.y = {0.4, static_cast<double>(panel.y_names.size()) + 0.6};
    }
    if (panel.y_least > 0) {
        place.y = {std::min(place.y.first, -panel.y_least),
                   std::max(place.y.second, panel.y_least)};
    }
    const double room = panel.headroom / (1 - panel.headroom);
    if (panel.log_y) {
        place.y.second *= std::pow(place.y.second / place.y.first, room);
    } else {
        place.y.second += room * (place.y.second - place.y.first);
    }
    if (panel.diagonal) {
        place.x = place.y = {std::min(place.x.first, place.y.first),
                             std::max(place.x.second, place.y.second)};
    }
    place.log_x = panel.log_x, place.log_y = panel.log_y;
}

/// Largest number of lines among the names along a panel's x axis.
std::size_t name_lines(const Panel& panel) {
    std::size_t lines = 0;
    for (const auto& name : panel.x_names) {
        lines = std::max(lines, name.size());
    }
    return lines;
}

/// Width of a panel's axes [inch] at which the names along the x axis do not touch.
double width_for_names(const Panel& panel) {
    constexpr double character = 0.092, apart = 0.12, least = 0.62;
    std::size_t longest = 0;
    for (const auto& name : panel.x_names) {
        for (const auto& line : name) {
            longest = std::max(longest, shown_characters(line));
        }
    }
    const double each = std::max(least, character * static_cast<double>(longest) + apart);
    return (static_cast<double>(panel.x_names.size()) + 0.2) * each;
}

/// Size of a panel, widened where the names along the x axes of the figure's panels need it.
Size with_names(Size size, const Panel& panel, const Figure& figure) {
    if (panel.x_names.empty()) {
        return size;
    }
    for (const auto& each : figure.panels) {
        size.width = std::max(size.width, width_for_names(each) + left_margin + right_margin);
    }
    return size;
}

/// Height of a panel whose y axis shows names, and left margin that the names need [inch].
Size with_rows(const Panel& panel) {
    constexpr double row = 0.25, character = 0.078, apart = 0.25;
    std::size_t longest = 0;
    for (const auto& name : panel.y_names) {
        longest = std::max(longest, shown_characters(name));
    }
    const double rows = row * (static_cast<double>(panel.y_names.size()) + 0.2);
    return {.width = character * static_cast<double>(longest) + apart,
            .height = rows / (1 - panel.headroom) + top_margin + bottom_margin};
}

double bottom_of(const Panel& panel) {
    return panel.x_names.empty() ? bottom_margin
                                 : 0.12 + name_line * static_cast<double>(name_lines(panel) + 1) *
                                              (name_lines(panel) > 0);
}

}  // namespace

PaperPoint PanelPlace::at(double value_x, double value_y) const {
    const auto share = [](double value, AxisRange range, bool logarithmic) {
        return logarithmic ? std::log(value / range.first) / std::log(range.second / range.first)
                           : (value - range.first) / (range.second - range.first);
    };
    return {left + share(value_x, x, log_x) * (right - left),
            bottom + share(value_y, y, log_y) * (top - bottom)};
}

namespace {

/// Title with line ends after commas or blanks, so that no line is wider than the page [inch] if
/// there is a place to break it.
std::string wrapped_title(const std::string& title, double page_width) {
    const auto most = static_cast<std::size_t>(page_width / title_character);
    if (shown_characters(title) <= most) return title;
    for (const std::string_view mark : {", ", " "}) {
        // Search for the last mark before which the text fits on the page.
        for (std::size_t at = title.rfind(mark); at != std::string::npos && at > 0;
             at = title.rfind(mark, at - 1)) {
            const std::size_t end = at + mark.size() - 1;
            if (shown_characters(title.substr(0, end)) > most) continue;
            return title.substr(0, end) + "\n" + wrapped_title(title.substr(end + 1), page_width);
        }
    }
    return title;
}

}  // namespace

Page page_of(const Figure& figure) {
    const Size usual = figure.panels.size() == 1 ? alone
                       : figure.stacked          ? above_another
                       : figure.small            ? small
                                                 : side_by_side;
    Page page;
    double left = 0, depth = title_height;
    for (const auto& panel : figure.panels) {
        Size cell = with_names(usual, panel, figure);
        cell.height += bottom_of(panel) - bottom_margin;
        double margin =
            figure.small && panel.y_label.empty() ? left_margin_unlabelled : left_margin;
        if (!panel.y_names.empty()) {
            const Size rows = with_rows(panel);
            margin = rows.width;
            cell.height = rows.height + bottom_of(panel) - bottom_margin;
        }
        cell.width -= left_margin - margin;
        const double whole = cell.width + (panel.key == Key::outside ? outside_key_width : 0);
        PanelPlace place{.left = left + margin,
                         .right = left + cell.width - right_margin,
                         .bottom = -(depth + cell.height - bottom_of(panel)),
                         .top = -(depth + top_margin)};
        set_ranges(place, panel);
        page.panels.push_back(place);
        page.width = std::max(page.width, left + whole);
        page.height = std::max(page.height, depth + cell.height);
        const bool row_full = figure.columns > 0 && page.panels.size() % figure.columns == 0;
        if (figure.stacked || row_full) {
            depth += cell.height;
            left = 0;
        } else {
            left += whole;
        }
    }
    for (auto& place : page.panels) {
        // So far counted from the upper edge of the page; gnuplot counts from the lower edge.
        place.bottom += page.height;
        place.top += page.height;
    }
    page.title = wrapped_title(figure.title, page.width);
    page.height += title_line * static_cast<double>(std::ranges::count(page.title, '\n'));
    return page;
}

}  // namespace pendular
