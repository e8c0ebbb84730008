#pragma once

#include <memory>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/direct_measurement.h"
#include "sim/catalogue/effect_catalogue.h"

namespace pendular {

/// A study with the effects that it names looked up. A value: copies share the catalogue, which is
/// constructed once.
class ResolvedStudy {
  public:
    /// Converts implicitly: there is one way to resolve a study.
    /// @throws InputError for an effect that the study writes or lists, and for a direct
    ///         measurement, that cannot be used
    ResolvedStudy(Study study);
    /// Returns the study after a change of its text; its written effects stay unchanged.
    /// @throws InputError likewise
    ResolvedStudy changed_to(Study changed) const;

    const Study& study() const { return study_; }
    operator const Study&() const { return study_; }

    /// All effects that there are for the study.
    const EffectCatalogue& catalogue() const { return *catalogue_; }
    /// The effects that the study lists, in its order. They live as long as any copy of this.
    const std::vector<const Effect*>& effects() const { return effects_; }
    /// The direct measurements that the study states.
    const std::vector<DirectMeasurement>& direct() const { return direct_; }

  private:
    ResolvedStudy(Study study, std::shared_ptr<const EffectCatalogue> catalogue);

    Study study_;
    std::shared_ptr<const EffectCatalogue> catalogue_;
    std::vector<const Effect*> effects_;
    std::vector<DirectMeasurement> direct_;
};

}  // namespace pendular
