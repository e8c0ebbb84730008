#include "data/recordings/nines.h"

#include <algorithm>
#include <cmath>

namespace pendular {

bool is_of_nines(double value) {
    for (const double mark : {999.0, 9999.0, 99999.0, 999999.0, 999.9, 999.99, 9999.9, 9999.99})
        if (std::abs(value) == mark) return true;
    return false;
}

std::vector<std::size_t> marks_of_nines(const std::vector<double>& values) {
    constexpr double far = 3;  // chosen: no transient exceeds all else by so much
    std::vector<std::size_t> marks;
    double least = 0, largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (is_of_nines(values[i])) {
            marks.push_back(i);
        } else if (std::isfinite(values[i])) {
            least = std::min(least, values[i]);
            largest = std::max(largest, std::abs(values[i]));
        }
    }
    if (2 * marks.size() > values.size()) marks.clear();
    std::erase_if(marks, [&](std::size_t i) {
        return !(std::abs(values[i]) > far * largest || (values[i] < 0 && least >= 0));
    });
    return marks;
}

}  // namespace pendular
