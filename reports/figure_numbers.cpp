#include "reports/draw_figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "data/files/csv.h"
#include "reports/figure.h"

namespace pendular {
namespace {

using Names = std::vector<std::vector<std::string>>;

/// Names along a panel's x axis, or those of another panel where this panel shows none: among
/// panels one above the other only the lowest shows the names.
const Names& names_along(const Panel& panel, const Figure& figure) {
    const auto shows = [](const std::vector<std::string>& name) { return !name.empty(); };
    if (std::ranges::any_of(panel.x_names, shows)) {
        return panel.x_names;
    }
    const auto other = std::ranges::find_if(figure.panels, [&](const Panel& each) {
        return each.x_names.size() == panel.x_names.size() &&
               std::ranges::any_of(each.x_names, shows);
    });
    return other == figure.panels.end() ? panel.x_names : other->x_names;
}

/// Whether rows of a figure have names, which a column of the table states.
bool has_rows(const Figure& figure) {
    return std::ranges::any_of(figure.panels,
                               [](const Panel& panel) { return !panel.y_names.empty(); });
}

/// Whether a figure has cells, whose values a column of the table states.
bool has_cells(const Figure& figure) {
    return std::ranges::any_of(figure.panels, [](const Panel& panel) {
        return std::ranges::any_of(
            panel.curves, [](const Curve& curve) { return curve.style == Curve::Style::cells; });
    });
}

/// Whether points have errors of x, which a column of the table states.
bool has_x_errors(const Figure& figure) {
    return std::ranges::any_of(figure.panels, [](const Panel& panel) {
        return std::ranges::any_of(panel.curves,
                                   [](const Curve& curve) { return !curve.x_error.empty(); });
    });
}

/// Writes the CSV rows of one panel.
class PanelRows {
  public:
    PanelRows(const Figure& figure, const Panel& panel)
        : panel_(panel),
          names_(names_along(panel, figure)),
          number_(static_cast<std::size_t>(&panel - figure.panels.data()) + 1),
          rows_(has_rows(figure)),
          cells_(has_cells(figure)),
          x_errors_(has_x_errors(figure)) {}

    std::string text() {
        for (const Reference& r : panel_.references) {
            const std::string value = fmt::format("{}", r.value);
            add(r.label, r.vertical ? value : "", r.vertical ? "" : value,
                fmt::format("{}", r.error), "");
        }
        for (const Curve& curve : panel_.curves) {
            for (std::size_t k = 0; k < curve.x.size() && curve.in_table; ++k) {
                add(curve.label, fmt::format("{}", curve.x[k]), fmt::format("{}", curve.y[k]),
                    curve.y_error.empty() ? "" : fmt::format("{}", curve.y_error[k]),
                    name_at(curve.x[k]), row_at(curve.y[k]),
                    curve.style == Curve::Style::cells ? fmt::format("{}", curve.shade[k]) : "",
                    curve.x_error.empty() ? "" : fmt::format("{}", curve.x_error[k]));
            }
        }
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (!named_.contains(k)) {
                add("", fmt::format("{}", k + 1), "", "", name(k));
            }
        }
        return text_;
    }

  private:
    /// Name of the row at the whole number nearest to `y`; empty where there is none.
    std::string row_at(double y) const {
        if (!(y >= 0.5)) return "";
        const auto row = static_cast<std::size_t>(std::round(y)) - 1;
        return row < panel_.y_names.size() ? unescaped(panel_.y_names[row]) : "";
    }
    std::string name(std::size_t k) const {
        return unescaped(fmt::format("{}", fmt::join(names_[k], "")));
    }
    /// Name at the whole number nearest to `x`; empty where there is none.
    std::string name_at(double x) {
        const double nearest = std::round(x) - 1;
        if (!(nearest >= 0) || nearest >= static_cast<double>(names_.size())) {
            return "";
        }
        named_.insert(static_cast<std::size_t>(nearest));
        return name(static_cast<std::size_t>(nearest));
    }
    void add(const std::string& curve, const std::string& x, const std::string& y,
             const std::string& error, const std::string& x_name, const std::string& y_name = "",
             const std::string& value = "", const std::string& x_error = "") {
        text_ +=
            fmt::format("{},{},{},{},{},{},{},{}\n", number_, csv_text_cell(unescaped(curve)), x, y,
                        error, csv_text_cell(x_name), csv_text_cell(unescaped(panel_.x_label)),
                        csv_text_cell(unescaped(panel_.y_label)));
        if (rows_) text_.insert(text_.size() - 1, "," + csv_text_cell(y_name));
        if (cells_) text_.insert(text_.size() - 1, "," + value);
        if (x_errors_) text_.insert(text_.size() - 1, "," + x_error);
    }

    const Panel& panel_;
    const Names& names_;
    std::size_t number_;
    bool rows_, cells_, x_errors_;
    std::set<std::size_t> named_;  ///< indices of the names with a point
    std::string text_;
};

}  // namespace

std::string numbers_table(const Figure& figure) {
    std::string text = "panel,curve,x,y,y_error,x_name,x_label,y_label";
    if (has_rows(figure)) text += ",y_name";
    if (has_cells(figure)) text += ",value";
    if (has_x_errors(figure)) text += ",x_error";
    text += '\n';
    for (const Panel& panel : figure.panels) {
        text += PanelRows(figure, panel).text();
    }
    return text;
}

}  // namespace pendular
