#pragma once

#include <memory>
#include <string>
#include <vector>

#include "data/study/study.h"
#include "sim/catalogue/effect_catalogue.h"
#include "sim/catalogue/shared_uncertainty.h"

namespace pendular {

/// Direct measurement of an effect's parameter, such as the drag from the torque of the empty cell,
/// or the contact angle from a drop. All values are in `unit`.
struct DirectMeasurement {
    std::string parameter;  ///< "EFFECT.PARAMETER", such as "torque-offset.torque"
    std::string unit;       ///< SI unit of the parameter
    std::string by = {};    ///< instrument or method, such as "a viscometer"; empty if unknown
    /// Value that a model without the effect assumes (`Effect::unlisted_value`): that of the
    /// study's liquid, such as its surface tension, or the value at which the effect vanishes, such
    /// as 1 for a torque gain.
    double neutral = 0;
    double value = 0;  ///< 0 if not measured yet
    double standard_error = 0;
    const Effect* effect = nullptr;  ///< whose parameter it is, valid as long as the catalogue

    /// Returns the change of the parameter by an error of one standard uncertainty, for an error
    /// that is measured directly with it, such as that of a gain; 0 for any other.
    double change_by(const SharedUncertainty& uncertainty) const;
};

/// Returns a table [[direct]] or [[rig.direct]] of study.toml as a direct measurement in SI units.
/// @throws InputError if the effect is unknown, can only be switched on or off, or does not apply
///         to the study, if a unit does not fit the parameter, or if the standard error is not
///         positive
DirectMeasurement direct_measurement(const StatedDirect& stated, const Study& study,
                                     const EffectCatalogue& catalogue);

/// Returns the direct measurements of the tables [[direct]] of study.toml, in their order and in SI
/// units.
/// @throws InputError for a table that `direct_measurement` does not accept
std::vector<DirectMeasurement> direct_measurements(const Study& study,
                                                   const EffectCatalogue& catalogue);

/// Study with its catalogue of effects, listed effects, direct measurements and shared
/// uncertainties, all checked. Copies share the catalogue.
class ResolvedStudy {
  public:
    /// Makes the catalogue and checks the listed effects and direct measurements. The conversion is
    /// implicit, since a study determines its catalogue.
    /// @throws InputError if an effect that the study defines or lists, a direct measurement, or an
    ///         uncertainty cannot be used
    /// @param further effects that a program adds to the catalogue
    ResolvedStudy(Study study, const std::vector<Effect>& further = {});
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
