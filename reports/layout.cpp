#include "reports/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/figure.h"
#include "reports/text_width.h"

namespace pendular {
namespace {

// All lengths are in inches.
constexpr double title_line = 0.21, above_title = 0.06, below_title = 0.06;
constexpr double left_margin = 0.98, right_margin = 0.18, bottom_margin = 0.58, top_margin = 0.1;
constexpr double left_margin_unlabelled = 0.66;  ///< left margin without a label of the y axis
constexpr double least_axes = 1.9;  ///< width of axes below which their numbers are too few

/// Least and greatest of the values that an axis must include.
class Extent {
  public:
    /// @param positive whether only positive values can be shown: on a logarithmic axis
    explicit Extent(bool positive) : positive_(positive) {}
    void include(double value, double error = 0) {
        for (const double end : {value - error, value + error}) {
            if (std::isfinite(end) && (end > 0 || !positive_)) {
                least_ = std::min(least_, end), greatest_ = std::max(greatest_, end);
            }
        }
    }
    double least() const { return least_; }
    double greatest() const { return greatest_; }

  private:
    bool positive_;
    double least_ = std::numeric_limits<double>::infinity(), greatest_ = -least_;
};

double error_at(const std::vector<double>& errors, std::size_t k) {
    return k < errors.size() ? errors[k] : 0;
}

Extent extent(const Panel& panel, bool along_x) {
    Extent extent(along_x ? panel.log_x : panel.log_y);
    for (const auto& curve : panel.curves) {
        for (std::size_t k = 0; k < curve.x.size() && curve.drawn; ++k) {
            along_x ? extent.include(curve.x[k], error_at(curve.x_error, k))
                    : extent.include(curve.y[k], error_at(curve.y_error, k));
        }
    }
    if (!along_x && !panel.log_y && (panel.y_from_zero || panel.zero_line)) {
        extent.include(0);
    }
    for (const auto& reference : panel.references) {
        if (reference.vertical == along_x) {
            extent.include(reference.value, reference.error);
        }
    }
    return extent;
}

/// Whether the symbol of a point would reach over the left edge of an axis that begins at 0.
bool has_symbol_at_zero(const Panel& panel, double greatest) {
    constexpr double share = 0.02;  // of the axis: about the radius of a symbol
    return std::ranges::any_of(panel.curves, [&](const Curve& curve) {
        return curve.style == Curve::Style::points && curve.drawn && !curve.x.empty() &&
               std::ranges::min(curve.x) < share * greatest;
    });
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
    if (least < 0 || least >= margin) return {least - margin, greatest + margin};
    // An axis of positive values near zero begins at zero, or where a symbol there leaves the
    // numbers beside the axis clear.
    const bool at_zero = along_x && has_symbol_at_zero(panel, greatest);
    return {at_zero ? -0.5 * margin : 0, greatest + margin};
}

/// Whether texts stand above points.
bool has_texts(const Panel& panel) {
    return std::ranges::any_of(panel.curves, [](const Curve& curve) {
        return curve.style == Curve::Style::points && !curve.names.empty();
    });
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
    const double room = has_texts(panel) ? 0.12 : 0;  // a line of text over the highest point
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
    constexpr double apart = 0.1;
    double longest = 0;
    for (const auto& name : panel.x_names) {
        for (const auto& line : name) {
            longest = std::max(longest, text_width(line));
        }
    }
    return (static_cast<double>(panel.x_names.size()) + 0.2) * (longest + apart);
}

/// Left margin of a panel: what the names of its rows need, or numbers and label of the y axis.
double margin_of(const Panel& panel) {
    constexpr double apart = 0.2;
    if (panel.y_names.empty()) return panel.y_label.empty() ? left_margin_unlabelled : left_margin;
    double longest = 0;
    for (const auto& name : panel.y_names) {
        longest = std::max(longest, text_width(name));
    }
    return longest + apart;
}

double bottom_of(const Panel& panel) {
    return panel.x_names.empty() ? bottom_margin
                                 : 0.12 + name_line * static_cast<double>(name_lines(panel) + 1) *
                                              (name_lines(panel) > 0);
}

/// Height of the axes of a panel, by their width and the number of panels in a row.
double height_of(const Panel& panel, const Figure& figure, double width, std::size_t columns) {
    constexpr double row = 0.22;
    if (!panel.y_names.empty()) return row * (static_cast<double>(panel.y_names.size()) + 0.2);
    constexpr double of_one = 0.8, of_stack = 0.62, highest = 2.9;
    const bool stack = columns == 1 && figure.panels.size() > 1;
    return std::min(highest, (stack ? of_stack : of_one) * width);
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

double Page::printed_width() const {
    constexpr double rounding = 1e-6;
    return width <= column_page + rounding ? column_in_print : whole_in_print;
}

namespace {

/// Lines of a title, broken after commas or blanks, so that none is wider than the page [inch] if
/// there is a place to break it.
std::vector<std::string> title_lines(const std::string& title, double page_width) {
    if (title.empty()) return {};
    const auto fits = [&](const std::string& text) {
        return text_width(text, title_size) <= page_width - 0.1;
    };
    if (fits(title)) return {title};
    for (std::size_t at = title.rfind(' '); at != std::string::npos && at > 0;
         at = title.rfind(' ', at - 1)) {
        if (!fits(title.substr(0, at))) continue;
        std::vector<std::string> lines = title_lines(title.substr(at + 1), page_width);
        lines.insert(lines.begin(), title.substr(0, at));
        return lines;
    }
    return {title};
}

/// Columns of panels: left margins, and one width of all axes.
struct Grid {
    std::size_t columns;
    std::vector<double> margins;
    double axes;

    double left_of(std::size_t column) const {
        double left = 0;
        for (std::size_t k = 0; k < column; ++k)
            left += margins[k] + axes + right_margin;
        return left;
    }
    double width() const { return left_of(columns); }
};

Grid grid_of(const Figure& figure) {
    const std::size_t panels = figure.panels.size();
    Grid grid{.columns = figure.stacked       ? 1
                         : figure.columns > 0 ? std::min(figure.columns, panels)
                                              : panels,
              .margins = {},
              .axes = least_axes};
    grid.margins.resize(grid.columns);
    for (std::size_t p = 0; p < panels; ++p) {
        double& margin = grid.margins[p % grid.columns];
        margin = std::max(margin, margin_of(figure.panels[p]));
        grid.axes = std::max(grid.axes, width_for_names(figure.panels[p]));
    }
    const double page = grid.columns == 1 ? column_page : wide_page;
    const double missing = page - grid.width();
    grid.axes += std::max(0.0, missing / static_cast<double>(grid.columns));
    return grid;
}

/// Places a figure's parts from the top of the page down. Heights are negative until the height of
/// the page is known.
class PageMaker {
  public:
    explicit PageMaker(const Figure& figure) : figure_(figure), grid_(grid_of(figure)) {
        page_.width = grid_.width();
        page_.title = title_lines(figure.title, page_.width);
        if (!page_.title.empty()) {
            depth_ =
                above_title + below_title + title_line * static_cast<double>(page_.title.size());
        }
    }

    Page page() {
        const auto keyed = std::ranges::count_if(figure_.panels, &Panel::key);
        for (std::size_t p = 0; p < figure_.panels.size() && keyed == 1; ++p) {
            if (figure_.panels[p].key) depth_ += place_key(p, key_inset, page_.width);
        }
        for (std::size_t p = 0; p < figure_.panels.size(); p += grid_.columns) {
            place_row(p, keyed > 1);
        }
        page_.height = depth_;
        for (auto& place : page_.panels)
            place.bottom += depth_, place.top += depth_;
        for (auto& key : page_.keys)
            key.corner.y += depth_;
        return page_;
    }

  private:
    static constexpr double key_inset = 0.12;

    /// Places the key of a panel between two edges, and returns its height.
    double place_key(std::size_t p, double left, double right) {
        KeyLayout layout = key_layout(figure_.panels[p], right - left);
        if (layout.rows == 0) return 0;
        page_.keys.push_back({p, {left, -depth_}, layout});
        return layout.height();
    }

    void place_row(std::size_t first, bool with_keys) {
        const std::size_t end = std::min(first + grid_.columns, figure_.panels.size());
        double key = 0, highest = 0, lowest = 0, heading = 0;
        for (std::size_t p = first; p < end; ++p) {
            const double left = grid_.left_of(p - first);
            if (with_keys && figure_.panels[p].key) {
                const double right = left + grid_.margins[p - first] + grid_.axes;
                key = std::max(key, place_key(p, left + key_inset, right));
            }
            highest =
                std::max(highest, height_of(figure_.panels[p], figure_, grid_.axes, grid_.columns));
            lowest = std::max(lowest, bottom_of(figure_.panels[p]));
            if (!figure_.panels[p].heading.empty()) heading = heading_line;
        }
        const double top = depth_ + key + heading + top_margin;
        for (std::size_t p = first; p < end; ++p) {
            const double left = grid_.left_of(p - first) + grid_.margins[p - first];
            PanelPlace place{
                .left = left,
                .right = left + grid_.axes,
                .bottom = -(top + height_of(figure_.panels[p], figure_, grid_.axes, grid_.columns)),
                .top = -top};
            set_ranges(place, figure_.panels[p]);
            page_.panels.push_back(place);
        }
        depth_ = top + highest + lowest;
    }

    const Figure& figure_;
    Grid grid_;
    Page page_;
    double depth_ = 0;  ///< from the top of the page [inch]
};

}  // namespace

Page page_of(const Figure& figure) {
    return PageMaker(figure).page();
}

}  // namespace pendular
