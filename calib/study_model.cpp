#include "calib/study_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "calib/calibration.h"
#include "calib/effect_model.h"
#include "calib/known_range.h"
#include "calib/rumpf.h"

namespace pendular {
namespace {

/// Names the readings whose predictions the known runs do not support.
void note_unsupported(const EmulatedSimulation& simulation, Calibration& c) {
    constexpr std::size_t most_named = 5;
    const KnownRange known(simulation.emulator());
    std::vector<std::string> readings;
    for (const Reading& reading : c.readings) {
        const FlowState state = simulation.state_of(c.fit.parameters(0), reading.condition);
        if (const std::string why = known.why_unsupported(state); !why.empty()) {
            const auto file = std::filesystem::path(reading.origin.file).filename().string();
            const std::string place = reading.step > 0
                                          ? fmt::format("{} step {}", file, reading.step)
                                          : fmt::format("{}:{}", file, reading.origin.line);
            readings.push_back(
                fmt::format("{} ({})", to_string(Position{file, reading.origin.line, 0}), why));
        }
    }
    if (readings.empty()) {
        return;
    }
    const std::size_t count = readings.size(), named = std::min(count, most_named);
    readings.resize(named);
    c.notes.push_back(
        fmt::format("The known runs do not support the predictions of {} of {} readings: {}{}. {}.",
                    count, c.readings.size(), fmt::join(readings, "; "),
                    count > named ? fmt::format("; and {} more", count - named) : "",
                    simulation.orders_more()
                        ? "More runs there help ('pendular campaign'), or leave these readings out"
                        : "'pendular calibrate' without --no-confirm simulates there"));
}

}  // namespace

StudyModel::StudyModel(const Study& study, const std::vector<Condition>& conditions,
                       const Fidelity& fidelity, std::uint64_t seed, Workers workers,
                       const std::optional<KnownRuns>& known) {
    catalogue_ = std::make_unique<EffectCatalogue>(study);
    effects_ = catalogue_->active(study);
    if (known) {
        auto emulated = std::make_unique<EmulatedSimulation>(study, conditions, fidelity, seed,
                                                             std::move(workers), *known);
        emulated_ = emulated.get();
        simulation_ = std::move(emulated);
    } else {
        auto direct = std::make_unique<DirectSimulation>(study, conditions, fidelity, seed,
                                                         std::move(workers));
        simulated_ = direct.get();
        simulation_ = std::move(direct);
    }
    model_ = simulation_.get();
    if (study.model.base == "rumpf") {
        closure_ = std::make_unique<RumpfModel>(*simulation_, study, terms_of(effects_));
        model_ = closure_.get();
    }
    flow_ = model_;
    if (!effects_.empty()) {
        std::vector<const Effect*> of_flow = effects_;
        std::erase_if(of_flow, [](const Effect* effect) { return effect->of_instrument(); });
        with_grain_effects_ = std::make_unique<EffectModel>(*model_, study, of_flow);
        with_effects_ = std::make_unique<EffectModel>(*model_, study, effects_);
        flow_ = with_grain_effects_.get();
        model_ = with_effects_.get();
    }
    direct_ = direct_measurements(study, *catalogue_);
    model_->predict_for(conditions);
    model_->predict_direct(direct_);
}

StudyModel::StudyModel(const Study& study, const Calibration& c)
    : StudyModel(study, conditions_of(c.readings), c.fidelity, c.seed, {},
                 c.scales ? std::optional(KnownRuns{c.runs, *c.scales, false}) : std::nullopt) {
    if (simulated_) {
        simulated_->restore(c.runs, c.surface_centre);
    }
}

Eigen::VectorXd StudyModel::flow_parameters(const Eigen::VectorXd& parameters) const {
    const std::vector<Parameter>&all = model_->parameters(), &own = flow_->parameters();
    Eigen::VectorXd values(std::ssize(own));
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const std::string& name = own[static_cast<std::size_t>(k)].name;
        values(k) = parameters(std::ranges::find(all, name, &Parameter::name) - all.begin());
    }
    return values;
}

std::vector<Condition> StudyModel::imposed(const Eigen::VectorXd& parameters,
                                           const std::vector<Condition>& conditions) const {
    return with_grain_effects_
               ? with_grain_effects_->imposed(flow_parameters(parameters), conditions)
               : conditions;
}

void StudyModel::note_in(Calibration& c) const {
    if (simulated_) {
        c.surface_centre = simulated_->centre();
    } else {
        c.scales = emulated_->emulator().scales();
        c.orders = emulated_->orders();
        note_unsupported(*emulated_, c);
    }
}

}  // namespace pendular
