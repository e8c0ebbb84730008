#include "reports/sensor_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "data/annular_cell.h"
#include "reports/proposal_report.h"
#include "reports/with_error.h"

namespace pendular {
namespace {

/// Smallest and largest of the values that an instrument shows at the readings.
struct Range {
    double least = INFINITY, most = -INFINITY;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    bool known() const { return least <= most; }
    /// Text of the range: ", between 2.1 mN m and 80 mN m", or " of about 12 mm".
    std::string after_noun(const std::string& unit) const {
        constexpr double narrow = 1.1;  // one check weight serves the whole range: chosen
        return most < narrow * least ? " of about " + with_unit(std::midpoint(least, most), unit)
                                     : ", " + text(unit);
    }
    std::string text(const std::string& unit) const {
        return fmt::format("between {} and {}", with_unit(least, unit), with_unit(most, unit));
    }
};

Range range_of(const std::string& target, const std::vector<Reading>& readings,
               const Study& study) {
    Range range;
    for (const Reading& each : readings) {
        if (target == "height") {
            if (each.condition.height) range.add(*each.condition.height);
        } else if (study.cell) {
            range.add(target == "torque" ? torque(each.value(0), *study.cell)
                                         : normal_force(each.condition.normal_stress, *study.cell));
        }
    }
    return range;
}

/// Sensor with what is known to check it.
struct SensorCheck {
    const char *sensor, *standard, *unit;
};

SensorCheck check_for(const std::string& target) {
    if (target == "torque") {
        return {"torque transducer", "known torques, such as weights on a lever", "N m"};
    }
    if (target == "normal_force") return {"load cell", "known weights", "N"};
    return {"gap sensor", "gauge blocks", "m"};
}

/// Circumstance of the readings with which a change varies and that a check has to repeat; empty
/// for none.
std::string circumstance(const FittedShape* change, const std::string& target,
                         const std::vector<Reading>& readings, const Study& study) {
    const std::string variable = change ? change->shape.profile.variable : "";
    if (variable == "normal_stress" && target == "torque") {
        const Range range = range_of("normal_force", readings, study);
        return range.known() ? ", at normal forces " + range.text("N") : "";
    }
    if (variable == "angular_velocity") return ", at rest and at the speeds of the readings";
    if (variable == "time") return ", at the beginning and at the end of a day";
    return "";
}

/// Sentence on the error to expect of the sensor; empty where nothing is known of it.
std::string expected(const SensorCheck& check, const FittedShape* change, double too_large) {
    if (change) {
        return fmt::format(" If the {} is the cause, {}.", check.sensor,
                           phrase_on(*change, "the true value"));
    }
    if (too_large == 0) return "";
    return fmt::format(" If the {} is the cause, it shows {:.2g} % too {}.", check.sensor,
                       100 * std::abs(too_large), too_large < 0 ? "little" : "much");
}

}  // namespace

std::string sensor_check(const std::string& target, const std::vector<Reading>& readings,
                         const Study& study, const FittedShape* change, double too_large) {
    const SensorCheck check = check_for(target);
    const Range range = range_of(target, readings, study);
    return fmt::format(
        "Check the {} with {}{}{}.{} If it shows wrong values, correct {}.", check.sensor,
        check.standard, range.known() ? range.after_noun(check.unit) + " (as in the readings)" : "",
        circumstance(change, target, readings, study), expected(check, change, too_large),
        too_large == 0 ? "the recordings that were taken with it"
                       : "the suspect recordings, and others only if it was wrong then already");
}

}  // namespace pendular
