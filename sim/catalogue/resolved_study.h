#pragma once

#include <memory>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/direct_measurement.h"
#include "sim/catalogue/effect_catalogue.h"
#include "sim/catalogue/shared_uncertainty.h"

namespace pendular {

/// Study with its catalogue of effects, listed effects, direct measurements and shared
/// uncertainties, all checked. Copies
/// share the catalogue.
class ResolvedStudy {
  public:
    /// Makes the catalogue and checks the listed effects and direct measurements. The conversion is
    /// implicit, since a study determines its catalogue.
    /// @throws InputError if an effect that the study defines or lists, a direct measurement, or an
    ///         uncertainty cannot be used
    ResolvedStudy(Study study);
    /// Returns an edited study with the catalogue of this one, so the edit must not change the
    /// effects that the user defines in study.toml.
    /// @throws InputError if an effect that `changed` lists, or a direct measurement, cannot be
    ///         used
    ResolvedStudy changed_to(Study changed) const;

    const Study& study() const { return study_; }
    operator const Study&() const { return study_; }

    const EffectCatalogue& catalogue() const { return *catalogue_; }
    /// Returns the listed effects, in their order; valid as long as any copy of this object exists.
    const std::vector<const Effect*>& effects() const { return effects_; }
    /// Returns the direct measurements of the tables [[direct]], in SI units.
    const std::vector<DirectMeasurement>& direct() const { return direct_; }

    /// Returns the uncertainties of what all readings share (`shared_uncertainties`).
    const std::vector<SharedUncertainty>& uncertainties() const { return uncertainties_; }

  private:
    ResolvedStudy(Study study, std::shared_ptr<const EffectCatalogue> catalogue);

    Study study_;
    std::shared_ptr<const EffectCatalogue> catalogue_;
    std::vector<const Effect*> effects_;
    std::vector<DirectMeasurement> direct_;
    std::vector<SharedUncertainty> uncertainties_;
};

}  // namespace pendular
