#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "reports/ink.h"

namespace pendular {

/// Entry of a key: a text and the curve or reference line whose style it explains.
struct KeyEntry {
    std::string label;
    const Curve* curve = nullptr;  ///< null: a reference line, drawn in `colour`
    std::string colour = {};
    bool vertical = false;  ///< whether the reference line is
};

/// Returns the entries of a panel in their order: reference lines, then curves. Entries with the
/// same text and sample appear once. The panel must outlive the result.
std::vector<KeyEntry> key_entries(const Panel& panel);

/// Places of the entries of a key, in as many columns as its width holds.
struct KeyLayout {
    std::vector<double> columns;  ///< widths [inch]
    std::size_t rows = 0;

    double height() const;  ///< [inch]; 0 without entries
};
/// @param width room for the key on the page [inch]
KeyLayout key_layout(const Panel& panel, double width);

/// Draws the key of a panel.
/// @param corner upper left corner on the page [inch]
void draw_key(Ink& ink, const Panel& panel, const KeyLayout& layout, PaperPoint corner);

}  // namespace pendular
