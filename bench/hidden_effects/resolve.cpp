#include "bench/hidden_effects/resolve.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <random>
#include <sstream>

#include "analysis/design/next_measurement.h"
#include "bench/hidden_effects/rig.h"
#include "bench/hidden_effects/walk.h"
#include "data/files/csv.h"
#include "data/files/text_file.h"
#include "data/files/write_whole.h"
#include "data/quantities/number.h"
#include "workflow/rivals.h"
#include "workflow/study_diagnosis.h"
#include "workflow/study_input.h"

namespace pendular::bench {
namespace {

Rig rig_of_laboratory(const LabPlan& plan) {
    const auto grains = [&](double mass) { return mass / plan.grains.density; };
    return {.normal_stress = {120, 5000},
            .inertial_number = Span{5e-3, 0.08},
            .liquid_contents = {0, 0.004, 0.014, 0.04},
            .bead_volumes = {grains(20e-3), grains(60e-3), grains(150e-3)},
            .repeats = 6,
            // The empty cell turned, and the tare.
            .direct = {{.effect = "torque-offset", .error = "0.1 mN m"},
                       {.effect = "normal-force-offset", .error = "20 mN"}}};
}

/// One study on which measurements go on.
class Campaign {
  public:
    Campaign(const Truth& truth, const LabResult& laboratory, int study, const Workers& workers,
             const std::filesystem::path& folder)
        : truth_(truth), plan_(laboratory.plan), study_(study), workers_(workers), folder_(folder) {
        write_whole_folder(folder, recordings_with_noise(laboratory, truth, study));
    }
    ~Campaign() { std::filesystem::remove_all(folder_); }
    Campaign(const Campaign&) = delete;
    Campaign& operator=(const Campaign&) = delete;

    void diagnose() {
        input_ = read_input(folder_);
        found_ =
            diagnose_study(input_->study, input_->measurements, {.fidelity = truth_fidelity()});
    }
    const Diagnosis& diagnosis() const { return found_.diagnosis; }

    std::vector<FittedModel> rivals() const { return rivals_of(found_); }
    std::vector<Point> points() const {
        std::vector<Point> points = points_of(rig_of_laboratory(plan_), input_->study, 100);
        std::erase_if(points, [&](const Point& point) {
            return !point.direct &&
                   !found_.models
                        ->why_unsupported(found_.diagnosis.base.fit.parameters(0), point.condition)
                        .empty();
        });
        return points;
    }
    Series series(const std::vector<Point>& points, int most_readings) const {
        Rig rig = rig_of_laboratory(plan_);
        rig.readings = most_readings;
        rig.repeats = std::min(rig.repeats, most_readings);
        const auto rivals = this->rivals();
        const Eigen::Vector2d noise = relative_errors(found_.readings);
        return next_series(separating_plans(rivals, points, noise, rig.repeats), rivals, points,
                           noise, rig);
    }

    /// Records so many readings at a point, with noise of their own.
    void measure(const Point& point, int readings) {
        if (point.direct) return measure_directly(*point.direct, readings);
        const Condition& at = point.condition;
        LabPlan plan = plan_;
        // Of its own at every measurement, and in none of the worlds.
        plan.seed =
            1000 * (1 + static_cast<std::uint64_t>(study_)) + static_cast<std::uint64_t>(measured_);
        plan.replicates = readings;
        plan.inertial_numbers = {at.inertial_number};
        plan.cell.bead_volume = at.bead_volume.value_or(plan.cell.bead_volume);
        plan.dry_normal_stresses = {at.dry() ? at.normal_stress : 1000};
        plan.wet_normal_stresses = {at.normal_stress};
        plan.liquid_contents.clear();
        if (!at.dry()) plan.liquid_contents = {at.liquid_content};
        if (at.dry()) {
            std::erase_if(plan.effects, [](const ActiveEffect& active) {
                return active.effect->touches == Touches::wet;
            });
        }
        const LabResult more = simulate_lab(plan, workers_);
        const auto files = recordings_with_noise(more, truth_, study_ + 1000 * ++measured_);
        std::string entries;
        for (const LabRecording& recording : more.recordings) {
            if ((recording.liquid_content == 0) != at.dry()) continue;
            const std::string name = fmt::format("more_{}_{}", measured_, recording.file);
            write_whole(folder_ / name, files.at(recording.file));
            entries += fmt::format(
                "[[recording]]\nfile = \"{}\"\nliquid_content = {}\nbead_mass = \"{:.7g} g\"\n\n",
                name, at.liquid_content, 1e3 * plan.cell.bead_volume * plan.grains.density);
        }
        add_to_study(entries);
    }

  private:
    /// Measures what the truth has of a parameter, or that it has none.
    void measure_directly(const DirectMeasurement& direct, int times) {
        const std::string effect = direct.parameter.substr(0, direct.parameter.find('.'));
        double truth = direct.neutral;
        for (const ActiveEffect& active : truth_.hidden) {
            if (active.effect->name == effect) truth = active.values.front();
        }
        std::mt19937_64 random(noise_seed(truth_, study_ + 1000 * ++measured_));
        std::normal_distribution<double> error(0, direct.standard_error);
        std::string entries;
        for (int k = 0; k < times; ++k) {
            entries += fmt::format(
                "[[direct]]\neffect = \"{0}\"\nvalue = \"{1} {3}\"\nerror = \"{2} {3}\"\n\n",
                effect, truth + error(random), direct.standard_error, direct.unit);
        }
        add_to_study(entries);
    }
    void add_to_study(const std::string& entries) const {
        std::string study = read_text(folder_ / "study.toml");
        study.insert(study.find("[model]"), entries);
        write_whole(folder_ / "study.toml", study);
    }

    const Truth& truth_;
    LabPlan plan_;
    int study_;
    const Workers& workers_;
    std::filesystem::path folder_;
    int measured_ = 0;
    std::optional<StudyInput> input_;
    StudyDiagnosis found_;
};

/// Whether readings tell one rival from all others.
bool tells_apart(const Series& series, std::size_t rival, std::size_t rivals) {
    const auto with_it = std::ranges::count_if(series.separated, [&](const auto& pair) {
        return pair.first == rival || pair.second == rival;
    });
    return static_cast<std::size_t>(with_it) + 1 == rivals;
}

/// First forecast of `next` about the truth.
void ask_next(const Campaign& campaign, const Truth& truth, int most_measurements,
              Resolution& result) {
    const auto rivals = campaign.rivals();
    const auto found =
        std::ranges::find(rivals, truth.hidden.front().effect->name, &FittedModel::name);
    result.among = found != rivals.end();
    result.separable = result.among &&
                       tells_apart(campaign.series(campaign.points(), most_measurements),
                                   static_cast<std::size_t>(found - rivals.begin()), rivals.size());
}

}  // namespace

std::vector<Resolution> resolve(const Truth& truth, const LabResult& laboratory, int study,
                                Policy policy, int most_measurements, const Workers& workers,
                                const std::filesystem::path& folder) {
    Campaign campaign(truth, laboratory, study, workers, folder);
    campaign.diagnose();
    if (campaign.diagnosis().verdict != Verdict::indistinguishable) return {};
    Resolution result{.truth = truth.name,
                      .study = study,
                      .policy = policy,
                      .rivals = campaign.diagnosis().confidence_set.size()};
    if (policy == Policy::next) ask_next(campaign, truth, most_measurements, result);
    std::mt19937_64 random(static_cast<std::uint64_t>(study) + 17);
    while (result.separable && campaign.diagnosis().verdict == Verdict::indistinguishable &&
           result.measurements < most_measurements) {
        const std::vector<Point> points = campaign.points();
        const int left = most_measurements - result.measurements;
        if (policy == Policy::next) {
            const Series series = campaign.series(points, left);
            if (series.steps.empty()) break;
            for (const Series::Step& step : series.steps) {
                campaign.measure(points[step.point], step.readings);
            }
            result.measurements += series.readings();
        } else {
            std::uniform_int_distribution<std::size_t> any(0, points.size() - 1);
            campaign.measure(points[any(random)], 1);
            ++result.measurements;
        }
        campaign.diagnose();
    }
    const Diagnosis& d = campaign.diagnosis();
    result.verdict = to_string(d.verdict);
    result.named = d.effects;
    result.right =
        d.verdict == Verdict::missing && d.effects.size() == truth.hidden.size() &&
        std::ranges::all_of(d.effects, [&](const auto& name) { return truth.hides(name); });
    return {result};
}

std::vector<Resolution> read_resolutions(const std::filesystem::path& file) {
    std::vector<Resolution> resolutions;
    if (!std::filesystem::exists(file)) return resolutions;
    const Table table = read_table(file);
    if (table.header.cells.size() != 10) {
        throw InputError({file.string()}, "is not of this version; move it away");
    }
    for (const Row& row : table.rows) {
        const auto text = [&](std::size_t k) { return row.cells.at(k).text; };
        const auto number = [&](std::size_t k) { return parse_number(text(k)).value_or(0); };
        std::istringstream named(text(8));
        resolutions.push_back({.truth = text(0),
                               .study = static_cast<int>(number(1)),
                               .policy = text(2) == "next" ? Policy::next : Policy::random,
                               .rivals = static_cast<std::size_t>(number(3)),
                               .among = number(4) == 1,
                               .separable = number(5) == 1,
                               .measurements = static_cast<int>(number(6)),
                               .verdict = text(7),
                               .named = {std::istream_iterator<std::string>(named), {}},
                               .right = number(9) == 1});
    }
    return resolutions;
}

void write_resolutions(const std::filesystem::path& file,
                       const std::vector<Resolution>& resolutions) {
    std::string text =
        "truth,study,policy,rivals,among,separable,measurements,verdict,named,right\n";
    for (const Resolution& r : resolutions) {
        text +=
            fmt::format("{},{},{},{},{:d},{:d},{},{},{},{:d}\n", r.truth, r.study,
                        r.policy == Policy::next ? "next" : "random", r.rivals, r.among,
                        r.separable, r.measurements, r.verdict, fmt::join(r.named, " "), r.right);
    }
    write_whole(file, text);
}

}  // namespace pendular::bench
