#include "reports/direct_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/design/point.h"
#include "reports/diagnosis_table.h"
#include "reports/with_error.h"

namespace pendular {
namespace {

/// Largest standard error with which a deviation of this size is seen.
double deciding_error(double deviation) {
    return std::abs(deviation) / std::sqrt(telling_directly);
}

/// Text of a standard error, rounded down to two digits.
std::string at_most(double error, const std::string& unit) {
    if (!(error > 0)) return with_unit(0, unit);
    const double digit = std::pow(10, std::floor(std::log10(error)) - 1);
    return with_unit(std::floor(error / digit) * digit, unit);
}

/// End of a sentence on the standard error `needed` of a direct measurement: whether it reaches it.
std::string reached(const Effect& effect, double needed) {
    if (effect.reachable_error == 0) return "";
    const bool decides = effect.reachable_error <= needed;
    return fmt::format("; {}, which the measurement reaches, {} enough",
                       with_unit(effect.reachable_error, effect.parameters.front().unit),
                       decides ? "is" : "is not");
}

/// Largest standard error of a direct measurement that, entered into study.toml, makes the readings
/// show the effect at its smallest size of interest. The readings lack a noncentrality of
/// n ((d/s)^2 - 1), with n their own at this size s and d the smallest size that they show; the
/// measurement brings (s/error)^2. Where n is not known, that of a measurement by itself.
double needed_to_rule_out(const StudyDiagnosis& d, const Effect& effect) {
    const double size = effect.parameters.front().smallest_of_interest;
    const Finding& finding = finding_of(d.diagnosis, *d.models, effect.name);
    const ScoreTest& test = finding.test;
    if (!test.seen() || !(test.length > 0) || !std::isfinite(finding.detectable))
        return deciding_error(size);
    const double own = std::pow(std::max(0.0, test.information), 2) / test.length;
    const double lacking = own * (std::pow(finding.detectable / size, 2) - 1);
    // A tenth less: the value that is found shifts the fit a little.
    constexpr double margin = 0.9;
    return lacking > 0 ? margin * size / std::sqrt(lacking) : deciding_error(size);
}

}  // namespace

std::string value_to_expect(const StudyDiagnosis& d, const ResolvedStudy& resolved,
                            const Effect& effect, const std::vector<FittedModel>& models) {
    const StudyModelSpace& space = *d.models;
    for (const FittedModel& each : models) {
        if (each.suspect) continue;
        auto at = d.diagnosis.base.fit.parameters.size();
        for (const std::size_t k : each.chosen) {
            const Candidate& candidate = space.candidates()[k];
            if (candidate.name == effect.name && candidate.free_parameters() > 0 &&
                at < each.fit.parameters.size()) {
                const EffectParameter& p = candidate.parameters.front();
                const double value = each.fit.parameters(at), error = each.fit.standard_error(at);
                const double without = effect.unlisted_value(resolved.study().liquid);
                return fmt::format(
                    " If it is the cause, expect {} ({}; without the effect {}); a clearly "
                    "different value speaks against it. A standard error of {} or less decides{}.",
                    with_error(value, error, p.unit), p.meaning, with_unit(without, p.unit),
                    at_most(deciding_error(value - without), p.unit),
                    reached(effect, deciding_error(value - without)));
            }
            at += static_cast<Eigen::Index>(candidate.free_parameters());
        }
    }
    return "";
}

std::string error_to_rule_out(const StudyDiagnosis& d, const ResolvedStudy& resolved,
                              const Effect& effect) {
    const EffectParameter& p = effect.parameters.front();
    if (p.is_switch()) return "";
    const double needed = needed_to_rule_out(d, effect);
    return fmt::format(
        " A standard error of {} or less shows, together with the readings, whether the {} differs "
        "from {} by {}{}.",
        at_most(needed, p.unit), p.meaning,
        with_unit(effect.unlisted_value(resolved.study().liquid), p.unit, 3),
        with_unit(p.smallest_of_interest, p.unit), reached(effect, needed));
}

}  // namespace pendular
