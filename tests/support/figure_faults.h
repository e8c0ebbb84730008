#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <set>

#include "data/files/file_access.h"
#include "reports/draw_figure.h"
#include "reports/figure_style.h"
#include "reports/key.h"
#include "reports/layout.h"
#include "tests/support/app_support.h"
#include "tests/support/drawn_texts.h"

namespace pendular::figure_check {

// What a rheologist would not print: found from the description of a figure, the layout of its page
// and the texts in the SVG that gnuplot draws.

/// Straight line or symbol on the page [inch] that no text may cover.
struct Mark {
    PaperPoint from, to;
    double reach = 0;  ///< of a symbol about its place [inch]
    const Curve* curve = nullptr;
};

/// Whether a line meets a box (Liang and Barsky 1984).
inline bool meets(const Mark& mark, Box box) {
    box = {box.left - mark.reach, box.bottom - mark.reach, box.right + mark.reach,
           box.top + mark.reach};
    const double dx = mark.to.x - mark.from.x, dy = mark.to.y - mark.from.y;
    double enter = 0, leave = 1;
    for (const auto& [step, room] :
         {std::pair(-dx, mark.from.x - box.left), std::pair(dx, box.right - mark.from.x),
          std::pair(-dy, mark.from.y - box.bottom), std::pair(dy, box.top - mark.from.y)}) {
        if (step == 0 && room < 0) return false;
        if (step < 0) enter = std::max(enter, room / step);
        if (step > 0) leave = std::min(leave, room / step);
    }
    return enter <= leave;
}

inline bool is_line(const Curve& curve) {
    using Style = Curve::Style;
    return curve.style == Style::line || curve.style == Style::dotted_line ||
           curve.style == Style::dashed_line;
}

/// Ends of the error bar of a value on an axis; on a logarithmic one, cut where it is not positive.
inline std::pair<double, double> bar_ends(double value, const std::vector<double>& errors,
                                          std::size_t k, AxisRange axis, bool log) {
    const double error = k < errors.size() && std::isfinite(errors[k]) ? errors[k] : 0;
    return {log ? std::max(value - error, std::min(value, axis.first)) : value - error,
            value + error};
}

/// Finds the faults of one figure.
class Inspector {
  public:
    Inspector(const Figure& figure, const std::string& svg)
        : figure_(figure), page_(page_of(figure)), texts_(drawn_texts(svg, page_.height)) {}

    std::vector<std::string> faults() {
        for (std::size_t p = 0; p < figure_.panels.size(); ++p) {
            look_at_marks(p);
            look_at_labels(p);
            look_at_errors(p);
            look_at_series(p);
        }
        look_at_texts();
        look_at_keys();
        look_at_size();
        return {faults_.begin(), faults_.end()};
    }

  private:
    void add(const std::string& fault) { faults_.insert(figure_.name + ": " + fault); }

    /// A place of data that must lie within the axes.
    void expect_inside(const PanelPlace& place, double x, double y, const std::string& label) {
        const PaperPoint at = place.at(x, y);
        const Box frame{place.left, place.bottom, place.right, place.top};
        if (std::isfinite(at.x) && std::isfinite(at.y) &&
            Box{at.x, at.y, at.x, at.y}.within(frame, 0.01))
            return;
        add(fmt::format("'{}' lies outside the axes at ({:.4g}, {:.4g})", label, x, y));
    }

    /// A line or band through fewer than two points is not seen.
    void expect_visible(const Curve& curve) {
        const bool line = is_line(curve) || curve.style == Curve::Style::band;
        if (!line || curve.x.empty() || guides(curve)) return;
        const auto finite = [](double value) { return std::isfinite(value); };
        if (curve.drawn && std::ranges::count_if(curve.y, finite) < 2)
            add(fmt::format("'{}' has a single point, through which no line is seen", curve.label));
    }

    void look_at_marks(std::size_t p) {
        const PanelPlace& place = page_.panels[p];
        for (const Curve& curve : figure_.panels[p].curves) {
            expect_visible(curve);
            for (std::size_t k = 0; k < curve.x.size() && curve.drawn; ++k) {
                if (!std::isfinite(curve.x[k]) || !std::isfinite(curve.y[k])) continue;
                look_at_point(place, curve, k);
            }
        }
        for (const Reference& r : figure_.panels[p].references) {
            const PaperPoint low = place.at(r.vertical ? r.value : place.x.first,
                                            r.vertical ? place.y.first : r.value),
                             high = place.at(r.vertical ? r.value : place.x.second,
                                             r.vertical ? place.y.second : r.value);
            expect_inside(place, r.vertical ? r.value : place.x.first,
                          r.vertical ? place.y.first : r.value, r.label);
            marks_.push_back({low, high});
        }
    }

    void look_at_point(const PanelPlace& place, const Curve& curve, std::size_t k) {
        const double x = curve.x[k], y = curve.y[k];
        const PaperPoint at = place.at(x, y);
        if (curve.style == Curve::Style::bars_across) {
            if (k >= curve.names.size()) expect_inside(place, x, y, curve.label);
            return;
        }
        const auto [left, right] = bar_ends(x, curve.x_error, k, place.x, place.log_x);
        const auto [low, high] = bar_ends(y, curve.y_error, k, place.y, place.log_y);
        for (const auto& [a, b] : {std::pair(left, y), std::pair(right, y), std::pair(x, low),
                                   std::pair(x, high), std::pair(x, y)})
            expect_inside(place, a, b, curve.label);
        if (curve.style == Curve::Style::points) {
            constexpr double radius = 0.055;  // of a symbol of the usual area
            marks_.push_back({at, at, radius * std::sqrt(curve.area), &curve});
            marks_.push_back({place.at(left, y), place.at(right, y), 0, &curve});
            marks_.push_back({place.at(x, low), place.at(x, high), 0, &curve});
        } else if (is_line(curve) && k > 0 && std::isfinite(curve.y[k - 1])) {
            marks_.push_back({place.at(curve.x[k - 1], curve.y[k - 1]), at, 0, &curve});
        }
    }

    void look_at_labels(std::size_t p) {
        const Panel& panel = figure_.panels[p];
        const auto look = [&](const std::string& label, bool named) {
            static const char* const dimensionless[] = {"stress ratio",
                                                        "solid fraction",
                                                        "inertial number",
                                                        "inverse reduced pressure",
                                                        "reduced pressure",
                                                        "reduced cohesion",
                                                        "liquid content",
                                                        "intergranular friction",
                                                        "bridge volume",
                                                        "reduction of χ^2",
                                                        "rise of χ^2",
                                                        "χ^2 per",
                                                        "10^3 ×",
                                                        "size of the effect/",
                                                        "distance from no effect/",
                                                        "residual/",
                                                        "measured solid fraction",
                                                        "predicted solid fraction",
                                                        "run order",
                                                        "row of"};
            const bool known = std::ranges::any_of(
                dimensionless, [&](const char* name) { return label.starts_with(name); });
            if (label.find('[') == std::string::npos && !known && !(named && label.empty()))
                add(fmt::format("axis '{}' has no unit", label));
        };
        // In a grid, a panel may share the label of the first one in its row.
        const bool shared = figure_.columns > 1 && p % figure_.columns > 0;
        look(panel.x_label, !panel.x_names.empty());
        look(panel.y_label, !panel.y_names.empty() || shared);
    }

    void look_at_errors(std::size_t p) {
        const Panel& panel = figure_.panels[p];
        const bool both = panel.x_uncertain && panel.y_names.empty();
        for (const Curve& curve : panel.curves) {
            if (curve.style != Curve::Style::points) continue;
            const bool rows = !panel.y_names.empty();
            if ((both && curve.x_error.empty() != curve.y_error.empty()) ||
                (rows && !curve.y_error.empty()) || (!panel.x_uncertain && !curve.x_error.empty()))
                add(fmt::format("'{}' has its error bars on the wrong axis", curve.label));
            const bool promised = curve.in_key && curve.label.find("±") != std::string::npos;
            if (promised && !curve.x.empty() && curve.y_error.empty() && curve.x_error.empty())
                add(fmt::format("'{}' has no error bars", curve.label));
        }
    }

    // Key entries and curves.

    std::vector<KeyEntry> entries() const {
        std::vector<KeyEntry> all;
        for (const KeyPlace& key : page_.keys) {
            for (const KeyEntry& entry : key_entries(figure_.panels[key.panel]))
                all.push_back(entry);
        }
        return all;
    }
    static bool same_kind(const Curve& a, const Curve& b) {
        if (is_line(a)) return is_line(b);
        return a.style == b.style &&
               (a.style != Curve::Style::points || a.symbol.filling == b.symbol.filling);
    }
    static bool same_look(const Curve& a, const Curve& b) {
        return same_kind(a, b) && a.colour == b.colour &&
               (a.style != Curve::Style::points || a.symbol == b.symbol) &&
               (!is_line(a) || pen_of(a).dash == pen_of(b).dash);
    }
    /// Whether an entry names the series of a curve by its colour.
    static bool names_series(const Curve& entry, const Curve& curve) {
        if (entry.style == Curve::Style::scale)
            return std::ranges::find(entry.colours, curve.colour) != entry.colours.end();
        return entry.colour == curve.colour;
    }
    static bool is_kind_entry(const Curve& entry) {
        return entry.x.empty() && entry.colour == explaining_colour;
    }
    /// Whether an entry tells what a shape means, as in the figures of Badetti et al. (2018).
    static bool explains_shape(const Curve& entry, const Curve& curve) {
        return entry.x.empty() && entry.colour == shape_colour && entry.style == curve.style &&
               entry.symbol.shape == curve.symbol.shape;
    }
    static bool explains_kind(const Curve& entry, const Curve& curve) {
        if (explains_shape(entry, curve)) return true;
        // "measured (hollow: model at the readings)" stands for both fillings.
        const bool both =
            entry.style == curve.style && entry.label.find("hollow") != std::string::npos;
        return is_kind_entry(entry) && (same_kind(entry, curve) || both ||
                                        (curve.style == Curve::Style::band && entry.banded));
    }
    static bool explains(const Curve& entry, const Curve& curve) {
        return same_look(entry, curve) ||
               (curve.style == Curve::Style::band && entry.banded && entry.colour == curve.colour);
    }

    /// Whether a line only leads the eye from point to point.
    static bool guides(const Curve& curve) {
        return is_line(curve) && !curve.in_table && !curve.in_key;
    }

    bool explained(const Curve& curve) const {
        bool kind = false, series = false;
        for (const KeyEntry& entry : entries()) {
            if (!entry.curve) continue;
            if (explains(*entry.curve, curve)) return true;
            if (guides(curve) && entry.curve->style == Curve::Style::points &&
                entry.curve->colour == curve.colour)
                return true;
            kind = kind || explains_kind(*entry.curve, curve);
            series = series || names_series(*entry.curve, curve);
        }
        return kind && series;
    }

    void look_at_series(std::size_t p) {
        const Panel& panel = figure_.panels[p];
        std::vector<const Curve*> drawn;
        for (const Curve& curve : panel.curves)
            if (curve.drawn && !curve.x.empty()) drawn.push_back(&curve);
        // The axes name a single series.
        const bool alone = drawn.size() <= 1 && panel.references.empty();
        for (const Curve* const curve : drawn) {
            if (!alone && !explained(*curve))
                add(fmt::format("'{}' is not in the key", curve->label));
        }
        for (const Reference& r : panel.references) {
            const auto known = [&](const KeyEntry& e) { return !e.curve && e.colour == r.colour; };
            if (!alone && !r.label.empty() && std::ranges::none_of(entries(), known))
                add(fmt::format("'{}' is not in the key", r.label));
        }
    }

    /// Whether something is drawn that an entry of a key explains.
    bool is_drawn(const Curve& entry) const {
        if (!entry.x.empty()) return true;
        std::set<std::string> colours;
        bool found = false;
        for (const Panel& panel : figure_.panels) {
            for (const Curve& curve : panel.curves) {
                if (curve.x.empty() || !curve.drawn) continue;
                colours.insert(curve.colour);
                found = found || explains(entry, curve) || explains_kind(entry, curve) ||
                        (entry.marked && entry.colour == curve.colour);
            }
        }
        if (entry.style != Curve::Style::scale) return found;
        return std::ranges::all_of(entry.colours,
                                   [&](const std::string& c) { return colours.contains(c); });
    }

    void look_at_keys() {
        constexpr std::size_t most_entries = 8;
        for (const KeyPlace& key : page_.keys) {
            const std::vector<KeyEntry> here = key_entries(figure_.panels[key.panel]);
            if (here.size() > most_entries) add(fmt::format("a key has {} entries", here.size()));
            for (const KeyEntry& entry : here) {
                if (entry.curve && !is_drawn(*entry.curve))
                    add(fmt::format("nothing is drawn for '{}' of the key", entry.label));
            }
            look_at_greys(here);
        }
    }

    void look_at_greys(const std::vector<KeyEntry>& here) {
        constexpr double least = 10;  // of 100, the step at which neighbouring greys are told apart
        for (std::size_t a = 0; a < here.size(); ++a) {
            for (std::size_t b = a + 1; b < here.size(); ++b) {
                if (told_by_shape(here[a], here[b])) continue;
                if (std::abs(lightness(here[a]) - lightness(here[b])) < least)
                    add(fmt::format("'{}' and '{}' are one in grey", here[a].label, here[b].label));
            }
        }
    }
    static bool told_by_shape(const KeyEntry& a, const KeyEntry& b) {
        if (!a.curve || !b.curve) return a.curve || b.curve || a.vertical != b.vertical;
        if (a.curve->marked != b.curve->marked || a.curve->banded != b.curve->banded) return true;
        if (is_line(*a.curve) && is_line(*b.curve))
            return pen_of(*a.curve).dash != pen_of(*b.curve).dash;
        if (a.curve->style != b.curve->style) return true;
        return a.curve->style == Curve::Style::points &&
               (a.curve->symbol != b.curve->symbol || a.curve->area != b.curve->area);
    }
    /// Lightness L* (CIE 1976) of the sample of an entry on white paper.
    static double lightness(const KeyEntry& entry) {
        const std::string& colour = entry.curve ? entry.curve->colour : entry.colour;
        const double opacity =
            entry.curve && entry.curve->style == Curve::Style::bars_across ? bar_opacity : 1;
        double luminance = 0;
        constexpr double weights[] = {0.2126, 0.7152, 0.0722};
        for (std::size_t k = 0; k < 3; ++k) {
            const double channel = std::stoi(colour.substr(1 + 2 * k, 2), nullptr, 16) / 255.0;
            const double mixed = 1 - opacity + opacity * channel;
            luminance += weights[k] * (mixed <= 0.04045 ? mixed / 12.92
                                                        : std::pow((mixed + 0.055) / 1.055, 2.4));
        }
        return 116 * std::cbrt(std::max(luminance, 0.008856)) - 16;
    }

    // Texts.

    /// Whether a text belongs into the bar or cell that it stands in.
    bool belongs(const DrawnText& text) const {
        for (const Panel& panel : figure_.panels) {
            for (const Curve& curve : panel.curves) {
                if (curve.style != Curve::Style::points &&
                    std::ranges::find(curve.names, text.text) != curve.names.end())
                    return true;
            }
        }
        return false;
    }

    void look_at_texts() {
        const Box page{0, 0, page_.width, page_.height};
        for (std::size_t a = 0; a < texts_.size(); ++a) {
            const DrawnText& text = texts_[a];
            if (!text.box.within(page, 0.02)) add(fmt::format("'{}' leaves the page", text.text));
            for (std::size_t b = a + 1; b < texts_.size(); ++b) {
                if (text.box.overlaps(texts_[b].box))
                    add(fmt::format("'{}' and '{}' overlap", text.text, texts_[b].text));
            }
            for (const Mark& mark : marks_) {
                const Box core{text.box.left + 0.01, text.box.bottom + 0.01, text.box.right - 0.01,
                               text.box.top - 0.01};
                if (meets(mark, core))
                    add(fmt::format("'{}' and '{}' overlap", text.text,
                                    mark.curve ? mark.curve->label : "a line"));
            }
            look_at_frames(text);
        }
    }
    void look_at_frames(const DrawnText& text) {
        for (const PanelPlace& place : page_.panels) {
            const Box frame{place.left, place.bottom, place.right, place.top};
            if (text.box.overlaps(frame) && !text.box.within(frame, 0))
                add(fmt::format("'{}' crosses the frame", text.text));
        }
    }

    void look_at_size() {
        constexpr double least = 5, points_of_inch = 72, mm_of_inch = 25.4;
        const double scale = page_.printed_width() / mm_of_inch / page_.width;
        for (const DrawnText& text : texts_) {
            const double printed = text.size / dots_of_inch * points_of_inch * scale;
            if (printed < least)
                add(fmt::format("'{}' has {:.1f} pt at {} mm", text.text, printed,
                                page_.printed_width()));
        }
    }

    const Figure& figure_;
    Page page_;
    std::vector<DrawnText> texts_;
    std::vector<Mark> marks_;
    std::set<std::string> faults_;
};

/// Draws a figure, and returns what a rheologist would not print: lines of a single point, data or
/// texts outside the axes or the page, texts over texts or marks, series without an entry in a key
/// and entries without a series, error bars on the wrong axis, axes without units, keys of more
/// than eight entries, texts of less than 5 pt in print, entries that differ in colour alone and
/// not in its lightness.
inline std::vector<std::string> faults_of(const Figure& figure) {
    const TemporaryFolder folder;
    if (!draw(figure, folder.path())) return {};
    return Inspector(figure, content_of(folder.path() / (figure.name + ".svg"))).faults();
}

}  // namespace pendular::figure_check
