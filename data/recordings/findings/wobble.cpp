#include "data/recordings/findings/wobble.h"

#include <cmath>

namespace pendular {

std::vector<Remark> wobble_tests(const std::string& file, const std::vector<RecordedStep>& steps) {
    std::vector<Remark> tests;
    for (const RecordedStep& step : steps) {
        for (const PeriodicColumn& column : step.periodic) {
            const double mean = std::abs(column.mean);
            for (const Harmonic& h : column.harmonics)
                tests.push_back({.kind = Remark::Kind::wobble,
                                 .quantity = column.quantity,
                                 .files = {file},
                                 .step = step.number,
                                 .size = h.amplitude,
                                 .size_error = h.standard_error,
                                 .relative = h.amplitude / mean,
                                 .relative_error = h.standard_error / mean,
                                 .period = 1.0 / h.per_turn,
                                 .p = h.p,
                                 .corrected = step.beyond_whole_turns > 0 && h.per_turn == 1});
        }
    }
    return tests;
}

}  // namespace pendular
