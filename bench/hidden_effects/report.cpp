#include "bench/hidden_effects/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <functional>
#include <map>

#include "bench/hidden_effects/judgement.h"
#include "data/files/write_whole.h"
#include "data/quantities/statistics.h"
#include "reports/draw_figure.h"
#include "reports/figure.h"
#include "sim/lab/virtual_recording.h"

namespace pendular::bench {
namespace {

/// v (1 - cos^2) up to which an effect cannot be named alone.
constexpr double hardly_separated = 4;
/// From which on it is in 9 of 10 studies whose scatter is known from 18 degrees of freedom: the
/// best of 20 tests is significant at 2.5 % from t = 3.82 on, not from 3.23 as where errors are
/// known, and (3.82 + 1.28)^2 = 26.
constexpr double far_separated = 26;

using Test = std::function<bool(const LabStudy&)>;

Studies those(const Studies& studies, const Test& test) {
    Studies result;
    std::ranges::copy_if(studies, std::back_inserter(result), test);
    return result;
}

std::string percent(double share) {
    return fmt::format("{:.1f} %", 100 * share);
}

/// "12 of 20 (60.0 %; 36.1 to 80.9 %)", with the 95 % interval of Clopper and Pearson.
std::string rate(const Studies& studies, const Test& test) {
    const auto of = static_cast<double>(studies.size());
    if (studies.empty()) return "none measured";
    const auto count = static_cast<double>(std::ranges::count_if(studies, test));
    using Law = boost::math::binomial_distribution<>;
    return fmt::format("{:.0f} of {:.0f} ({}; {} to {})", count, of, percent(count / of),
                       percent(Law::find_lower_bound_on_p(of, count, 0.025)),
                       percent(Law::find_upper_bound_on_p(of, count, 0.025)));
}

bool single(const LabStudy& s) {
    return s.truth->kind == Truth::Kind::effect;
}
bool of_catalogue(const LabStudy& s) {
    return s.truth->kind != Truth::Kind::outside;
}
/// The noncentrality that was wanted: 10, 25, 60, or 0 for a switch, which has the one it has.
double wanted(const LabStudy& s) {
    const auto at = s.truth->name.rfind(" at ");
    return at == std::string::npos ? 0 : std::stod(s.truth->name.substr(at + 4));
}

std::vector<std::string> rows_of(const std::vector<Truth>& truths, const Studies& studies) {
    std::vector<std::string> rows;
    for (const Truth& truth : truths) {
        if (std::ranges::any_of(studies, [&](const LabStudy& s) { return s.truth == &truth; })) {
            rows.push_back(truth.name);
        }
    }
    return rows;
}

double median_of(const Studies& studies, const std::function<double(const LabStudy&)>& value) {
    std::vector<double> values;
    std::ranges::transform(studies, std::back_inserter(values), value);
    return values.empty() ? NAN : median(values);
}

/// As many studies of each truth but the complete one, so that none counts for more.
Studies as_many_of_each(const Studies& all) {
    std::map<const Truth*, int> count;
    for (const LabStudy& s : all) {
        if (!s.truth->hidden.empty()) ++count[s.truth];
    }
    const auto fewest =
        std::ranges::min_element(count, {}, [](const auto& entry) { return entry.second; });
    return those(all, [&](const LabStudy& s) {
        return s.truth->hidden.empty() || s.outcome->study < fewest->second;
    });
}

/// The figures that the benchmark is for, each with how it is counted: with as many studies of each
/// truth, but for effects that ought to be named alone, of which all count.
std::vector<std::string> figures_of(const Studies& every) {
    const Studies all = as_many_of_each(every);
    std::vector<std::string> lines;
    const auto add = [&](const std::string& what, const std::string& value) {
        lines.push_back(fmt::format("{:<78} {}", what, value));
    };
    const auto complete =
        those(all, [](const LabStudy& s) { return s.truth->kind == Truth::Kind::complete; });
    const auto catalogue = those(all, of_catalogue);
    add("false alarms, of complete laboratories", rate(complete, alarms));
    add("confidently wrong, of all laboratories of the catalogue",
        rate(catalogue, confidently_wrong));
    add("confidence set holds the truth, of all laboratories of the catalogue",
        rate(catalogue, [](const LabStudy& s) { return s.outcome->set_has_truth; }));
    add("  of those with something hidden, where it was noticed",
        rate(those(catalogue,
                   [](const LabStudy& s) { return !s.truth->hidden.empty() && alarms(s); }),
             [](const LabStudy& s) { return s.outcome->set_has_truth; }));
    add("  of those and of the complete ones",
        rate(those(catalogue,
                   [](const LabStudy& s) { return s.truth->hidden.empty() || alarms(s); }),
             [](const LabStudy& s) { return s.outcome->set_has_truth; }));
    const auto noticed =
        those(catalogue, [](const LabStudy& s) { return !s.truth->hidden.empty() && alarms(s); });
    add("  median size of the set there",
        fmt::format("{:g}", median_of(noticed, [](const LabStudy& s) {
                        return static_cast<double>(s.outcome->set_size);
                    })));
    add("verdict missing with complete: false, which names a true effect",
        rate(those(catalogue,
                   [](const LabStudy& s) {
                       return verdict_is(s, "missing") && !s.outcome->complete;
                   }),
             points_at_truth));
    for (const double v : {10.0, 25.0, 60.0}) {
        const auto here =
            those(all, [&](const LabStudy& s) { return single(s) && wanted(s) == v; });
        add(fmt::format("noticed at noncentrality {:g}", v), rate(here, alarms));
    }
    const auto large = [](const LabStudy& s) {
        return single(s) && (wanted(s) == 60 || (wanted(s) == 0 && s.truth->noncentrality >= 60));
    };
    const auto strong = those(all, large);
    const auto apart = those(every, [](const LabStudy& s) { return s.truth->well_separated(); });
    add("right single verdict from noncentrality 60 on, v (1 - cos^2) >= 15", rate(apart, right));
    add("  or indistinguishable, with the truth in it", rate(apart, [](const LabStudy& s) {
            return right(s) || (verdict_is(s, "indistinguishable") && points_at_truth(s));
        }));
    const auto far =
        those(apart, [](const LabStudy& s) { return s.truth->separation >= far_separated; });
    add("  the same, v (1 - cos^2) >= 26", rate(far, right));
    const auto alike =
        those(strong, [](const LabStudy& s) { return s.truth->separation <= hardly_separated; });
    add("indistinguishable with the truth in it, v (1 - cos^2) <= 4",
        rate(alike, [](const LabStudy& s) {
            return verdict_is(s, "indistinguishable") && points_at_truth(s);
        }));
    add("truths outside the catalogue: flagged unknown or suspect-measurement",
        rate(those(all, [](const LabStudy& s) { return s.truth->kind == Truth::Kind::outside; }),
             flagged));
    const auto outside =
        those(all, [](const LabStudy& s) { return s.truth->kind == Truth::Kind::outside; });
    const auto faulty = [](const LabStudy& s) { return !s.outcome->faults.empty(); };
    add("  or import names a fault of the recordings",
        rate(outside, [&](const LabStudy& s) { return flagged(s) || faulty(s); }));
    add("  noticed at all, by diagnose or import",
        rate(outside, [&](const LabStudy& s) { return alarms(s) || faulty(s); }));
    add("import names a fault of the recordings of complete laboratories", rate(complete, faulty));
    const auto refitted = those(all, [](const LabStudy& s) {
        return single(s) && s.outcome->predicted_reduction && s.outcome->refitted_reduction;
    });
    add("foretold drop of chi2 within max(20 %, 4) of the refitted one",
        rate(refitted, [](const LabStudy& s) {
            const double actual = *s.outcome->refitted_reduction;
            return std::abs(*s.outcome->predicted_reduction - actual) <=
                   std::max(0.2 * actual, 4.0);
        }));
    const auto fitted = those(all, [](const LabStudy& s) { return s.outcome->added.has_value(); });
    const auto added = those(fitted, [](const LabStudy& s) { return !s.truth->hidden.empty(); });
    const auto nothing_added =
        those(fitted, [](const LabStudy& s) { return s.truth->hidden.empty(); });
    add("after add of what a right verdict names: the error of conditions left out fell",
        rate(those(added, right), [](const LabStudy& s) {
            const auto& a = *s.outcome->added;
            const auto size = [](const std::array<double, 2>& rms) {
                return std::hypot(rms[0] / torque_scatter, rms[1] / solid_fraction_scatter);
            };
            return size(a.left_out_after) < size(a.left_out_before);
        }));
    add("after add of what is hidden, where the set has it: p of chi2 above 0.01",
        rate(added, [](const LabStudy& s) { return s.outcome->added->p > 0.01; }));
    const auto add_floor = [&](const char* name, std::array<double, 2> Outcome::Added::*floor) {
        for (const auto& [k, observable] :
             {std::pair(0u, "shear stress"), {1u, "solid fraction"}}) {
            const auto over = [&](const LabStudy& s) {
                return s.outcome->added->rms_after[k] / ((*s.outcome->added).*floor)[k];
            };
            const auto near = [&](const LabStudy& s) { return over(s) <= 1.2; };
            add(fmt::format("  median RMS error over {}, {}", name, observable),
                fmt::format("{:.3f}", median_of(added, over)));
            add("    at most a fifth above it", rate(added, near));
            add("    of complete laboratories, which need no effect", rate(nothing_added, near));
        }
    };
    add_floor("the noise of these readings", &Outcome::Added::noise);
    add_floor("the scatter of replicates", &Outcome::Added::scatter);
    return lines;
}

/// Lines on the result of further measurements, by the way they were chosen. `next` says itself
/// where its rig does not tell the truth from all others; the same studies count for the random
/// choice.
std::vector<std::string> resolved_lines(const std::vector<Resolution>& resolutions) {
    std::vector<std::string> lines;
    const auto hopeless = [&](const Resolution& r) {
        return std::ranges::any_of(resolutions, [&](const Resolution& other) {
            return other.policy == Policy::next && other.truth == r.truth &&
                   other.study == r.study && !other.separable;
        });
    };
    for (const Policy policy : {Policy::next, Policy::random}) {
        std::vector<Resolution> here;
        std::ranges::copy_if(resolutions, std::back_inserter(here), [&](const Resolution& r) {
            return r.policy == policy && !hopeless(r);
        });
        const auto right = static_cast<double>(std::ranges::count_if(here, &Resolution::right));
        std::vector<double> measurements;
        for (const Resolution& r : here) {
            if (r.right) measurements.push_back(r.measurements);
        }
        lines.push_back(fmt::format(
            "{:<78} {}",
            fmt::format("told apart, and rightly, within 12 further measurements chosen by {}",
                        policy == Policy::next ? "next" : "chance"),
            here.empty() ? "none measured"
                         : fmt::format("{:.0f} of {} ({}), median of measurements {:g}", right,
                                       here.size(), percent(right / here.size()),
                                       measurements.empty() ? NAN : median(measurements))));
    }
    const auto count = [&](const auto& test) {
        return std::ranges::count_if(
            resolutions, [&](const Resolution& r) { return r.policy == Policy::next && test(r); });
    };
    const auto add = [&](const char* what, std::ptrdiff_t studies) {
        lines.push_back(fmt::format("{:<78} {}", what, studies));
    };
    add("  left out: studies in which next said that its rig does not tell it from all others",
        count([](const Resolution& r) { return r.among && !r.separable; }));
    add("  left out: studies in which what is hidden was not among the rivals",
        count([](const Resolution& r) { return !r.among; }));
    return lines;
}

std::vector<std::string> table_of(const std::vector<Truth>& truths, const Studies& all) {
    std::vector<std::string> lines = {fmt::format(
        "{:<40} {:>6} {:>8} {:>8} {:>9} {:>8} {:>9} {:>10}  {}", "truth", "v", "v(1-c^2)",
        "studies", "noticed", "right", "in set", "wrong", "most like, by the emulator")};
    for (const Truth& truth : truths) {
        const auto here = those(all, [&](const LabStudy& s) { return s.truth == &truth; });
        if (here.empty()) continue;
        const auto count = [&](const Test& test) { return std::ranges::count_if(here, test); };
        lines.push_back(fmt::format(
            "{:<40} {:>6.3g} {:>8} {:>8} {:>9} {:>8} {:>9} {:>10}  {}", truth.name,
            truth.noncentrality,
            truth.kind == Truth::Kind::effect ? fmt::format("{:.2g}", truth.separation) : "",
            here.size(), count(alarms), count(right),
            count([](const LabStudy& s) { return s.outcome->set_has_truth; }),
            count(confidently_wrong), truth.most_like));
    }
    return lines;
}

/// Shares of what was said of single effects, by noncentrality.
void draw_shares(const Studies& all, const std::filesystem::path& folder) {
    Figure figure{.name = "hidden_effects",
                  .title = "Single hidden effects: what the verdict said",
                  .panels = {}};
    Panel panel{.x_label = "noncentrality v after refitting the friction",
                .y_label = "share of laboratories [%]",
                .key = true,
                .y_range = std::pair(0.0, 100.0)};
    const std::vector<std::tuple<std::string, Test, std::string>> kinds = {
        {"noticed", alarms, "#000000"},
        {"truth in the confidence set", [](const LabStudy& s) { return s.outcome->set_has_truth; },
         "#0072B2"},
        {"right and alone", right, "#009E73"},
        {"confidently wrong", confidently_wrong, "#D55E00"}};
    for (const auto& [label, test, colour] : kinds) {
        Curve points{.label = label, .colour = colour};
        Curve line{
            .label = label, .style = Curve::Style::dotted_line, .colour = colour, .in_key = false};
        for (const double v : {0.0, 10.0, 25.0, 60.0}) {
            const auto here = those(all, [&](const LabStudy& s) {
                return v == 0 ? s.truth->kind == Truth::Kind::complete
                              : single(s) && wanted(s) == v;
            });
            if (here.empty()) continue;
            const double share = static_cast<double>(std::ranges::count_if(here, test)) /
                                 static_cast<double>(here.size());
            points.x.push_back(v);
            points.y.push_back(100 * share);
            points.y_error.push_back(
                100 * std::sqrt(share * (1 - share) / static_cast<double>(here.size())));
        }
        line.x = points.x, line.y = points.y;
        panel.curves.push_back(line);
        panel.curves.push_back(points);
    }
    figure.panels.push_back(panel);
    draw(figure, folder);
}

}  // namespace

void write_report(const std::vector<Truth>& truths, const std::vector<Outcome>& outcomes,
                  const std::vector<Resolution>& resolutions, const std::filesystem::path& folder) {
    Studies all;
    for (const Truth& truth : truths) {
        for (const Outcome& outcome : outcomes) {
            if (outcome.truth == truth.name) all.push_back({&truth, &outcome});
        }
    }
    const auto rows = rows_of(truths, all);
    write_confusion(folder / "hidden_effects_confusion.csv", rows, all);
    write_outcomes(folder / "hidden_effects_studies.csv", outcomes);
    std::string text = fmt::format(
        "pendular-bench hidden-effects, pendular {}: {} studies of {} of {} truths\n"
        "Counts with their 95 % interval. Studies of one truth differ in the noise of the "
        "instrument; "
        "its simulations are\nof few worlds, so that studies are no independent trials of "
        "these. All rates but those of effects\nthat ought to be named alone count as many "
        "studies of each truth.\n\n",
        PENDULAR_VERSION, all.size(), rows.size(), truths.size());
    write_resolutions(folder / "hidden_effects_next.csv", resolutions);
    for (const auto& lines :
         {figures_of(all), resolved_lines(resolutions), {""}, table_of(truths, all)}) {
        text += fmt::format("{}\n", fmt::join(lines, "\n"));
    }
    write_whole(folder / "hidden_effects.txt", text);
    fmt::print("{}", text);
    draw_shares(as_many_of_each(all), folder);
}

}  // namespace pendular::bench
