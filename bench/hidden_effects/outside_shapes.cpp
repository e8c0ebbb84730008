#include "bench/hidden_effects/outside_shapes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

#include "app/terminal.h"
#include "bench/hidden_effects/rig.h"
#include "bench/hidden_effects/walk.h"
#include "data/files/csv.h"
#include "data/files/write_whole.h"
#include "data/quantities/number.h"
#include "sim/runs/store/run_store.h"
#include "sim/runs/store/run_table.h"
#include "workflow/session.h"

namespace pendular::bench {
namespace {

/// Diagnosis of a study that hides an effect outside the catalogue.
struct ShapeOutcome {
    std::string truth;
    int study = 0;
    std::string verdict, effects;  ///< effects: that the verdict points at
    std::string shapes;   ///< proposals as "quantity/coordinate + quantity/coordinate | ..."
    bool stands = false;  ///< proposal 1 describes the readings
    /// RMS error of proposal 1 and of the true model [%]; both 0 where nothing is proposed.
    std::array<double, 2> rms{}, noise{};
};

bool incomplete(const ShapeOutcome& o) {
    return o.verdict != "nothing-missing" && o.verdict != "inconclusive";
}

/// RMS of shear stress and solid fraction at most a fifth above the noise.
bool fits(const ShapeOutcome& o) {
    constexpr double close = 1.2;
    return !o.shapes.empty() && o.rms[0] <= close * o.noise[0] && o.rms[1] <= close * o.noise[1];
}

/// A quantity as formulas name it.
std::string in_formulas(const std::string& quantity) {
    return quantity == "friction" ? "friction_difference" : quantity;
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(separator, at), text.size());
        parts.push_back(text.substr(at, end - at));
        at = end + separator.size();
    }
    return parts;
}

/// Whether each shape of a proposal names one of these quantities and one of these coordinates.
bool names(const std::string& proposal, const std::vector<std::string>& quantities,
           const std::vector<std::string>& coordinates) {
    const auto shapes = split(proposal, " + ");
    return !shapes.empty() && std::ranges::all_of(shapes, [&](const std::string& shape) {
        const auto parts = split(shape, "/");
        return std::ranges::any_of(quantities,
                                   [&](const auto& q) { return in_formulas(q) == parts.at(0); }) &&
               std::ranges::find(coordinates, parts.at(1)) != coordinates.end();
    });
}

struct Judged {
    bool flagged = false, proposed = false, named = false, cause = false, listed = false,
         fits = false;
};

/// `cause`: the first proposal names the quantity that truly changes, the first of `RightShape`;
/// `listed`: some proposal is right.
Judged judged(const ShapeOutcome& o, const Truth& truth) {
    const RightShape right = right_shape(truth.hidden.front().effect->name);
    const auto proposals = split(o.shapes, " | ");
    const auto is_right = [&](const std::string& proposal) {
        return names(proposal, right.quantities, right.coordinates);
    };
    Judged result{.flagged = incomplete(o), .proposed = !proposals.empty(), .fits = fits(o)};
    if (proposals.empty()) return result;
    result.named = is_right(proposals.front());
    result.cause = names(proposals.front(), {right.quantities.front()}, right.coordinates);
    result.listed = std::ranges::any_of(proposals, is_right);
    return result;
}

std::string to_string(const Proposal& proposal) {
    std::vector<std::string> shapes;
    for (const FittedShape& each : proposal.shapes) {
        const std::string& along = each.shape.profile.variable;
        shapes.push_back(each.shape.quantity.target + "/" + (along.empty() ? "none" : along));
    }
    return fmt::format("{}", fmt::join(shapes, " + "));
}

ShapeOutcome diagnosed(const Truth& truth, const LabResult& laboratory, int study,
                       const std::filesystem::path& folder, int threads) {
    write_whole_folder(folder, recordings_with_noise(laboratory, truth, study));
    const StudyInput input = read_input(folder);
    const StudyDiagnosis found =
        diagnose_study(input.study, input.measurements,
                       {.fidelity = laboratory.plan.fidelity, .threads = threads});
    ShapeOutcome outcome{.truth = truth.name,
                         .study = study,
                         .verdict = std::string(pendular::to_string(found.diagnosis.verdict)),
                         .effects = fmt::format("{}", fmt::join(found.diagnosis.effects, " "))};
    std::vector<std::string> proposals;
    std::ranges::transform(found.proposals, std::back_inserter(proposals),
                           [](const Proposal& each) { return to_string(each); });
    outcome.shapes = fmt::format("{}", fmt::join(proposals, " | "));
    if (!found.proposals.empty()) {
        const Proposal& first = found.proposals.front();
        outcome.stands = first.fits();
        outcome.rms = rms_percent(found.readings, first.model.fit.prediction.value);
        outcome.noise = noise_of(found.readings, laboratory, folder.string() + " without noise");
    }
    std::filesystem::remove_all(folder);
    return outcome;
}

std::vector<ShapeOutcome> read_shapes(const std::filesystem::path& file) {
    std::vector<ShapeOutcome> outcomes;
    if (!std::filesystem::exists(file)) return outcomes;
    for (const Row& row : read_table(file).rows) {
        const auto text = [&](std::size_t k) { return row.cells.at(k).text; };
        const auto number = [&](std::size_t k) { return parse_number(text(k)).value(); };
        outcomes.push_back({.truth = text(0),
                            .study = static_cast<int>(number(1)),
                            .verdict = text(2),
                            .effects = text(3),
                            .shapes = text(4),
                            .stands = number(5) == 1,
                            .rms = {number(6), number(7)},
                            .noise = {number(8), number(9)}});
    }
    return outcomes;
}

void write_shapes(const std::filesystem::path& file, const std::vector<ShapeOutcome>& outcomes) {
    std::string text =
        "truth,study,verdict,effects,proposals,stands,rms_shear_stress,rms_solid_fraction,"
        "noise_shear_stress,noise_solid_fraction\n";
    for (const ShapeOutcome& o : outcomes) {
        text += fmt::format("{},{},{},{},{},{:d},{:.4g},{:.4g},{:.4g},{:.4g}\n", o.truth, o.study,
                            o.verdict, o.effects, o.shapes, o.stands, o.rms[0], o.rms[1],
                            o.noise[0], o.noise[1]);
    }
    write_whole(file, text);
}

/// Counts of one row of the table.
struct Counts {
    int studies = 0, flagged = 0, proposed = 0, named = 0, cause = 0, listed = 0, fits = 0;

    void add(const Judged& j) {
        ++studies, flagged += j.flagged, proposed += j.proposed, named += j.named, cause += j.cause,
            listed += j.listed, fits += j.fits;
    }
    std::string row(const std::string& name, const std::string& size) const {
        return fmt::format("{:<32} {:>5} {:>7} {:>7} {:>8} {:>5} {:>5} {:>6} {:>6}\n", name, size,
                           studies, flagged, proposed, named, cause, listed, fits);
    }
};

class OutsideShapes {
  public:
    explicit OutsideShapes(const OutsideShapesOptions& options)
        : options_(options),
          store_(options.work / "truths.sqlite"),
          file_(options.work / "shapes.csv"),
          outcomes_(read_shapes(file_)) {
        if (store_.size() > 0) return;
        for (const auto& runs : options.runs) {
            if (!std::filesystem::exists(runs)) continue;
            for (const StoredRun& stored : read_runs(runs)) {
                store_.add(stored.run, stored.physics_version);
            }
        }
    }

    void run() {
        const auto known = read_truths(options_.truths), more = read_truths(options_.more_truths);
        for (int study = 0; study < options_.studies; ++study) {
            walk_all(known, study);
            walk_all(more, study);
        }
        if (!options_.diagnose) return;
        const std::string text = heading() + table_of("first four", known) +
                                 table_of("further, written without sight of the shapes", more);
        write_shapes(options_.results / "outside_shapes_studies.csv", outcomes_);
        write_whole(options_.results / "outside_shapes.txt", text);
        fmt::print("{}", text);
    }

  private:
    bool wanted(const Truth& truth) const {
        return truth.kind == Truth::Kind::outside &&
               (options_.only.empty() || std::ranges::any_of(options_.only, [&](const auto& name) {
                    return truth.name.starts_with(name);
                }));
    }

    void walk_all(const std::vector<Truth>& truths, int study) {
        for (std::size_t row = 0; row < truths.size(); ++row) {
            const Truth& truth = truths[row];
            const bool done = std::ranges::any_of(outcomes_, [&](const ShapeOutcome& each) {
                return each.truth == truth.name && each.study == study;
            });
            if (!wanted(truth) || done) continue;
            const LabResult made = laboratory(truth, row);
            if (!options_.diagnose) continue;
            outcomes_.push_back(
                diagnosed(truth, made, study, options_.work / "study", options_.threads));
            write_shapes(file_, outcomes_);
            const ShapeOutcome& o = outcomes_.back();
            fmt::print(stderr, "{}, study {}: {} {}: {}\n", o.truth, o.study, o.verdict, o.effects,
                       o.shapes);
        }
    }

    /// From the store, as far as it has the runs; in one of the worlds of the complete model, by
    /// the row in the table of truths.
    LabResult laboratory(const Truth& truth, std::size_t row) {
        constexpr std::size_t worlds = 10;
        LabPlan plan = rig(truth.friction, 1 + 2 * row % worlds);
        plan.effects = truth.hidden;
        return simulate_lab(plan, {options_.threads, guard_.token(), {}, &store_},
                            [](const std::string&) {});
    }

    static std::string heading() {
        return fmt::format(
            "pendular-bench outside-shapes, pendular {}: what the program proposes where an\n"
            "effect that it does not know is hidden\n"
            "v: squared length of the change in standard errors, beyond the best pair of the\n"
            "catalogue; flagged: verdict other than nothing-missing and inconclusive; named:\n"
            "proposal 1 names a right quantity along the right coordinate; cause: the quantity is\n"
            "the one that truly changes; listed: some proposal is right; fits: with proposal 1 "
            "the\n"
            "RMS of shear stress and solid fraction are at most 1.2 times those of the noise\n",
            PENDULAR_VERSION);
    }

    std::string table_of(const std::string& title, const std::vector<Truth>& truths) const {
        std::string text = fmt::format(
            "\n{}\n{:<32} {:>5} {:>7} {:>7} {:>8} {:>5} {:>5} {:>6} {:>6}\n", title, "effect", "v",
            "studies", "flagged", "proposed", "named", "cause", "listed", "fits");
        Counts all, large;
        for (const Truth& truth : truths) {
            Counts counts;
            for (const ShapeOutcome& o : outcomes_) {
                if (truth.kind != Truth::Kind::outside || o.truth != truth.name) continue;
                const Judged j = judged(o, truth);
                counts.add(j);
                all.add(j);
                if (truth.noncentrality > 59) large.add(j);
            }
            if (counts.studies == 0) continue;
            text += counts.row(truth.hidden.front().effect->name,
                               fmt::format("{:.0f}", truth.noncentrality));
        }
        return text + large.row("all of v 59 or more", "") + all.row("all", "");
    }

    const OutsideShapesOptions& options_;
    const app::InterruptGuard guard_;
    RunStore store_;
    std::filesystem::path file_;
    std::vector<ShapeOutcome> outcomes_;
};

}  // namespace

void outside_shapes(const OutsideShapesOptions& options) {
    if (options.plan) {
        write_truths(options.more_truths, planned_outside_truths({25, 60, 200}));
        return;
    }
    std::filesystem::create_directories(options.work);
    OutsideShapes(options).run();
}

}  // namespace pendular::bench
