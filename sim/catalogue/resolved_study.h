#pragma once

#include <memory>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/direct_measurement.h"
#include "sim/catalogue/effect_catalogue.h"

namespace pendular {

/// A study together with its catalogue of effects, the effects that it lists and its direct
/// measurements, all checked. Copies share the catalogue, which is constructed once.
class ResolvedStudy {
  public:
    /// Constructs the study's catalogue of effects, and checks the effects that the study lists and
    /// its direct measurements. The conversion is implicit, since a study has only one catalogue.
    /// @throws InputError where an effect that the study defines or lists, or a direct measurement,
    ///         cannot be used
    ResolvedStudy(Study study);
    /// Returns `changed`, an edited copy of this study, with this study's catalogue of effects and
    /// its own listed effects and direct measurements, checked. The edit must not change the
    /// effects that the user defines in study.toml.
    /// @throws InputError where an effect that `changed` lists, or a direct measurement, cannot be
    ///         used
    ResolvedStudy changed_to(Study changed) const;

    const Study& study() const { return study_; }
    operator const Study&() const { return study_; }

    /// All effects available to the study, built-in and user-defined.
    const EffectCatalogue& catalogue() const { return *catalogue_; }
    /// Effects that the study lists, in the order of its list. The pointers are valid as long as
    /// any copy of this object exists.
    const std::vector<const Effect*>& effects() const { return effects_; }
    /// Measurements of effect parameters made without shearing the grains, as the study states them
    /// in its [[direct]] tables; SI units.
    const std::vector<DirectMeasurement>& direct() const { return direct_; }

  private:
    ResolvedStudy(Study study, std::shared_ptr<const EffectCatalogue> catalogue);

    Study study_;
    std::shared_ptr<const EffectCatalogue> catalogue_;
    std::vector<const Effect*> effects_;
    std::vector<DirectMeasurement> direct_;
};

}  // namespace pendular
