#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/figure_script.h"

namespace pendular {
namespace {

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

}  // namespace

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

}  // namespace pendular
