#include "bench/hidden_effects/outside_shapes.h"

#include "bench/hidden_effects/design.h"

namespace pendular::bench {

void outside_shapes(const OutsideShapesOptions& options) {
    if (options.plan) write_truths(options.more_truths, planned_outside_truths({25, 60, 200}));
}

}  // namespace pendular::bench
