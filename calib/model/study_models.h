#pragma once

#include <memory>
#include <string>
#include <vector>

#include "calib/emulator/known_range.h"
#include "calib/emulator/known_runs.h"
#include "calib/model/assemble_model.h"
#include "calib/model/model_space.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// An effect that is no candidate, with the reason.
struct LeftAside {
    std::string effect, why;
    bool without_runs = false;  ///< it applies, but no known run includes it
};

/// The emulated model of a study, with the effects that the study lists, and every further effect
/// that applies to it as a candidate. One emulator serves all of them; no runs are ordered.
class StudyModels : public ModelSpace {
  public:
    /// @param known runs of plain grains and of grains with any effects on grains
    /// @throws InputError for a listed effect of which no run tells
    StudyModels(const ResolvedStudy& study, std::vector<Condition> conditions,
                const Fidelity& fidelity, KnownRuns known);

    const std::vector<Candidate>& candidates() const override { return candidates_; }
    std::shared_ptr<const Model> with(const EffectSet& chosen) const override;
    /// Model with this effect set for any conditions.
    std::shared_ptr<const EffectModel> predictor(const EffectSet& chosen) const;
    ChangeErrors change_errors(const EffectSet& chosen, const Eigen::VectorXd& parameters,
                               std::size_t added, double value) const override;

    /// The study's direct measurements, which its models predict after the readings.
    const std::vector<DirectMeasurement>& direct() const { return study_.direct(); }

    /// Effects that are neither listed nor candidates.
    const std::vector<LeftAside>& left_aside() const { return left_aside_; }

    /// Why the known runs do not support the readings' states at this friction, as in "reduced
    /// pressure 0.3 is below 0.5" (`KnownRange`); each reason once, without effects.
    std::vector<std::string> why_unsupported(double friction) const;
    /// Why the known runs do not support one condition; empty where they do.
    std::string why_unsupported(double friction, const Condition& condition) const;

    /// Study that lists every effect, so that runs with any of them serve as training runs.
    static Study with_all_effects(const ResolvedStudy& study);

  private:
    bool has_runs(const Effect& effect) const;
    void add_candidate(const Effect& effect);

    ResolvedStudy study_;
    std::vector<Condition> conditions_;
    std::vector<const Effect*> offered_;
    std::vector<Candidate> candidates_;
    std::vector<LeftAside> left_aside_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::unique_ptr<KnownRange> known_range_;
};

}  // namespace pendular
