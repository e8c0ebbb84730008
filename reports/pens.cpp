#include "reports/pens.h"

namespace pendular {

Pen pen_of(const Curve& curve) {
    if (!curve.dash.empty()) return {curve.colour, 1.5 * curve.weight, curve.dash};
    switch (curve.style) {
        case Curve::Style::dotted_line:
            return {curve.colour, 1.5 * curve.weight, "(2,3)"};
        case Curve::Style::dashed_line:
            return {curve.colour, 1.1 * curve.weight, "(10,4,2,4)"};
        default:
            return {curve.colour, 1.8 * curve.weight};
    }
}

}  // namespace pendular
