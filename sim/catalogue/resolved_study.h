#pragma once

#include <memory>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/direct_measurement.h"
#include "sim/catalogue/effect_catalogue.h"

namespace pendular {

/// Study with the catalogue of all effects available to the study, the effects that the study lists
/// and the direct measurements of effect parameters, all checked. Copies share the catalogue, which
/// is made once.
class ResolvedStudy {
  public:
    /// Makes the study's catalogue of effects, and checks the effects that the study lists and its
    /// direct measurements of effect parameters. The conversion from `Study` is implicit, since a
    /// study determines its catalogue.
    /// @throws InputError if an effect that the study defines or lists, or a direct measurement,
    ///         cannot be used
    ResolvedStudy(Study study);
    /// Returns an edited study with the catalogue of effects of this study. The effects that the
    /// edited study lists and its direct measurements are checked. The edit must not change the
    /// effects that the user defines in study.toml.
    /// @param changed the edited study
    /// @throws InputError if an effect that `changed` lists, or a direct measurement, cannot be
    ///         used
    ResolvedStudy changed_to(Study changed) const;

    const Study& study() const { return study_; }
    operator const Study&() const { return study_; }

    /// Returns all effects available to the study, built-in and user-defined.
    const EffectCatalogue& catalogue() const { return *catalogue_; }
    /// Returns the effects that the study lists, in the order of the list. The pointers are valid
    /// as long as any copy of this object exists.
    const std::vector<const Effect*>& effects() const { return effects_; }
    /// Returns the direct measurements of effect parameters (made without shearing grains) that the
    /// study states in its tables [[direct]], in SI units.
    const std::vector<DirectMeasurement>& direct() const { return direct_; }

  private:
    ResolvedStudy(Study study, std::shared_ptr<const EffectCatalogue> catalogue);

    Study study_;
    std::shared_ptr<const EffectCatalogue> catalogue_;
    std::vector<const Effect*> effects_;
    std::vector<DirectMeasurement> direct_;
};

}  // namespace pendular
