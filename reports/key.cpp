#include "reports/key.h"

#include <algorithm>
#include <numeric>

#include "reports/pens.h"
#include "reports/text_width.h"

namespace pendular {
namespace {

// All lengths are in inches.
constexpr double line_spacing = 0.19, below_key = 0.06;
constexpr double sample_width = 0.36, sample_gap = 0.08, between_columns = 0.22;

double width_of(const KeyEntry& entry) {
    return sample_width + sample_gap + text_width(entry.label) + between_columns;
}

/// Widths of `count` columns that hold the entries one below the other, column after column.
std::vector<double> widths(const std::vector<KeyEntry>& entries, std::size_t count) {
    const std::size_t rows = (entries.size() + count - 1) / count;
    std::vector<double> columns((entries.size() + rows - 1) / rows);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        columns[k / rows] = std::max(columns[k / rows], width_of(entries[k]));
    }
    return columns;
}

Outline box(PaperPoint low, PaperPoint high) {
    return {low, {high.x, low.y}, high, {low.x, high.y}, low};
}

void draw_scale(Ink& ink, const Curve& scale, PaperPoint left) {
    constexpr double half_height = 0.055;
    const double each = sample_width / static_cast<double>(scale.colours.size());
    for (std::size_t k = 0; k < scale.colours.size(); ++k) {
        const double from = left.x + static_cast<double>(k) * each;
        ink.area(box({from, left.y - half_height}, {from + each, left.y + half_height}),
                 scale.colours[k]);
    }
}

void draw_symbol(Ink& ink, const Curve& curve, PaperPoint left) {
    ink.symbol(curve.symbol, {left.x + sample_width / 2, left.y}, symbol_area * curve.area,
               curve.colour);
}

/// Draws the sample of an entry, beginning at `left`.
void draw_sample(Ink& ink, const KeyEntry& entry, PaperPoint left) {
    const double right = left.x + sample_width, y = left.y;
    const Outline stroke{left, {right, y}};
    if (!entry.curve) {
        constexpr double half_height = 0.08;
        const double middle = (left.x + right) / 2;
        const Outline upright{{middle, y - half_height}, {middle, y + half_height}};
        ink.line(entry.vertical ? upright : stroke,
                 {entry.colour, reference_pen.width, reference_pen.dash});
        return;
    }
    const Curve& curve = *entry.curve;
    constexpr double half_band = 0.055;
    const Outline band = box({left.x, y - half_band}, {right, y + half_band});
    switch (curve.style) {
        case Curve::Style::points:
            draw_symbol(ink, curve, left);
            break;
        case Curve::Style::line:
        case Curve::Style::dotted_line:
        case Curve::Style::dashed_line:
            if (curve.banded) ink.area(band, curve.colour, band_opacity);
            ink.line(stroke, pen_of(curve));
            if (curve.marked) draw_symbol(ink, curve, left);
            break;
        case Curve::Style::band:
            ink.area(band, curve.colour, band_opacity);
            break;
        case Curve::Style::bars_across:
        case Curve::Style::cells:
            ink.area(band, curve.colour, bar_opacity);
            break;
        case Curve::Style::scale:
            draw_scale(ink, curve, left);
            break;
    }
}

/// Whether two entries have the same text and sample.
bool alike(const KeyEntry& a, const KeyEntry& b) {
    if (a.label != b.label || !a.curve != !b.curve) return false;
    if (!a.curve) return a.colour == b.colour && a.vertical == b.vertical;
    return a.curve->style == b.curve->style && a.curve->colour == b.curve->colour &&
           a.curve->symbol == b.curve->symbol && a.curve->dash == b.curve->dash;
}

}  // namespace

std::vector<KeyEntry> key_entries(const Panel& panel) {
    std::vector<KeyEntry> entries;
    const auto add = [&](const KeyEntry& entry) {
        const bool known = std::ranges::any_of(
            entries, [&](const KeyEntry& other) { return alike(entry, other); });
        if (!entry.label.empty() && !known) entries.push_back(entry);
    };
    for (const auto& reference : panel.references) {
        add({reference.label, nullptr, reference.colour, reference.vertical});
    }
    for (const auto& curve : panel.curves) {
        if (curve.in_key && curve.drawn) add({curve.label, &curve});
    }
    return entries;
}

double KeyLayout::height() const {
    return rows == 0 ? 0 : line_spacing * static_cast<double>(rows) + below_key;
}

KeyLayout key_layout(const Panel& panel, double width) {
    const std::vector<KeyEntry> entries = key_entries(panel);
    if (entries.empty()) return {};
    std::size_t count = entries.size();
    std::vector<double> columns = widths(entries, count);
    const auto whole = [&] {
        return std::accumulate(columns.begin(), columns.end(), -between_columns);
    };
    while (count > 1 && whole() > width) {
        columns = widths(entries, --count);
    }
    return {columns, (entries.size() + columns.size() - 1) / columns.size()};
}

void draw_key(Ink& ink, const Panel& panel, const KeyLayout& layout, PaperPoint corner) {
    const std::vector<KeyEntry> entries = key_entries(panel);
    PaperPoint at = corner;
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const std::size_t row = k % layout.rows;
        if (k > 0 && row == 0) at.x += layout.columns[k / layout.rows - 1];
        at.y = corner.y - line_spacing * (static_cast<double>(row) + 0.5);
        draw_sample(ink, entries[k], at);
        ink.text(entries[k].label, {at.x + sample_width + sample_gap, at.y}, false);
    }
}

}  // namespace pendular
