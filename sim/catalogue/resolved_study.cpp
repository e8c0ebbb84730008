#include "sim/catalogue/resolved_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "data/quantities/units.h"

namespace pendular {
namespace {

const Effect& effect_of(const StatedDirect& stated, const Study& study,
                        const EffectCatalogue& catalogue) {
    const Effect* effect = nullptr;
    try {
        effect = &catalogue.find(stated.effect);
    } catch (const std::invalid_argument& error) {
        throw InputError(stated.effect_position, fmt::format("'effect': {}", error.what()));
    }
    if (const auto why = why_not(*effect, study))
        throw InputError(stated.effect_position, fmt::format("'effect': {}", *why));
    // No effect has several fitted parameters so far.
    if (std::ranges::count_if(effect->parameters, &EffectParameter::is_fitted) != 1)
        throw InputError(stated.effect_position,
                         fmt::format("'effect': {} is a switch without a size that could be "
                                     "measured; leave this entry out",
                                     effect->name));
    return *effect;
}

double in_si(const char* key, const std::string& text, const Position& position, const Unit& unit) {
    try {
        return quantity_in_si(text, unit);
    } catch (const std::invalid_argument& error) {
        throw InputError(position, fmt::format("'{}': {}", key, error.what()));
    }
}

}  // namespace

double DirectMeasurement::change_by(const SharedUncertainty& uncertainty) const {
    if (!effect || !uncertainty.is_fitted_by(*effect)) return 0;
    const bool relative = uncertainty.unit == "1" && unit != "1";
    return relative ? uncertainty.standard * neutral : uncertainty.standard;
}

DirectMeasurement direct_measurement(const StatedDirect& stated, const Study& study,
                                     const EffectCatalogue& catalogue) {
    const Effect& effect = effect_of(stated, study, catalogue);
    const EffectParameter& p = effect.parameters.front();
    const Unit unit(p.unit);
    DirectMeasurement direct{.parameter = fmt::format("{}.{}", effect.name, p.name),
                             .unit = p.unit,
                             .by = effect.directly,
                             .neutral = effect.unlisted_value(study.liquid),
                             .effect = &effect};
    if (!stated.value.empty())
        direct.value = in_si("value", stated.value, stated.value_position, unit);
    direct.standard_error = in_si("error", stated.error, stated.error_position, unit);
    if (!(direct.standard_error > 0))
        throw InputError(stated.error_position,
                         "'error': must be positive; give the standard error of the measurement");
    return direct;
}

std::vector<DirectMeasurement> direct_measurements(const Study& study,
                                                   const EffectCatalogue& catalogue) {
    std::vector<DirectMeasurement> all;
    for (const StatedDirect& stated : study.direct) {
        all.push_back(direct_measurement(stated, study, catalogue));
    }
    return all;
}

ResolvedStudy::ResolvedStudy(Study study, const std::vector<Effect>& further)
    : ResolvedStudy(study, std::make_shared<EffectCatalogue>(study, further)) {}

ResolvedStudy::ResolvedStudy(Study study, std::shared_ptr<const EffectCatalogue> catalogue)
    : study_(std::move(study)),
      catalogue_(std::move(catalogue)),
      effects_(catalogue_->active(study_)),
      direct_(direct_measurements(study_, *catalogue_)),
      uncertainties_(shared_uncertainties(study_)) {}

ResolvedStudy ResolvedStudy::changed_to(Study changed) const {
    return {std::move(changed), catalogue_};
}

}  // namespace pendular
