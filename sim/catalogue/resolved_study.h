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
    /// Resolves a study; implicit, since there is only one way to do so.
    /// @throws InputError where an effect that the study defines or lists, or a direct measurement,
    ///         cannot be used
    ResolvedStudy(Study study);
    /// Resolves `changed`, an edited copy of this study, with the catalogue of this study. The edit
    /// must not change the effects that the study defines.
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
    /// Direct measurements that the study states.
    const std::vector<DirectMeasurement>& direct() const { return direct_; }

  private:
    ResolvedStudy(Study study, std::shared_ptr<const EffectCatalogue> catalogue);

    Study study_;
    std::shared_ptr<const EffectCatalogue> catalogue_;
    std::vector<const Effect*> effects_;
    std::vector<DirectMeasurement> direct_;
};

}  // namespace pendular
