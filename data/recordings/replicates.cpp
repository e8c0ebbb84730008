#include "data/recordings/measurements.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "data/quantities/statistics.h"
#include "data/recordings/replicate_table.h"

namespace pendular {
namespace {

/// Relative standard error [1] of readings for which neither replicates nor the user tell one.
/// Chosen: answers say that it is assumed, and the diagnosis then never says that nothing is
/// missing.
constexpr double assumed_error = 0.02;
/// Relative variances [1] below this are rounding errors of the arithmetic; the error is unknown.
constexpr double no_error = 1e-12;
/// Smallest widening of standard errors [1] for which a note recommends more replicates: exceeded
/// with two degrees of freedom (2.3), not with three (1.7).
constexpr double worth_a_note = 2;

/// Prior of the error of a filling: half the scatter of a step [1], with the weight of one measured
/// difference between fillings (degrees of freedom).
constexpr double usual_filling = 0.5, usual_freedom = 1;
/// Filling errors count as significant if files differ so much by chance with a probability below
/// this: about 5 % for both observables together.
constexpr double hint_of_fillings = 0.03;

/// Errors that the user states count as too small if replicates scatter so much more by chance with
/// a probability below this: 5 % for both observables together.
constexpr double unlikely_scatter = 0.025;
/// They count as too large if replicates agree so well by chance with a probability below this: 1 %
/// for both observables together. Stricter than the other side of the test, since the errors stay
/// as stated: only what is said about them changes, which must not contradict honest errors.
constexpr double unlikely_agreement = 0.005;
/// Smallest stated error over the scatter [1] that is reported. Chosen: an error known to half its
/// size is usual, and many replicates make smaller differences significant.
constexpr double far_too_large = 1.5;

/// Factor [1] on a standard error that was estimated with these degrees of freedom, so that two
/// widened standard errors cover 95 %, as two known standard errors do: Student's quantile over the
/// normal quantile.
double widening(double freedom) {
    return students_t_quantile(normal_below(2), freedom) / 2;
}

double widened(double freedom) {
    return std::isfinite(freedom) && freedom > 0 ? std::pow(widening(freedom), 2) : 1;
}

/// Variances that a table states for a reading; 0 where it states none.
Eigen::Vector2d stated_variance(const Reading& reading) {
    Eigen::Vector2d stated = Eigen::Vector2d::Zero();
    for (const Eigen::Index o : {0, 1}) {
        if (reading.within_run_only || reading.unstated[static_cast<std::size_t>(o)]) continue;
        stated(o) = reading.covariance(o, o);
    }
    return stated;
}

/// Comparison of the scatter of replicates with the errors that the user states for them.
struct StatedErrorTest {
    double chi2 = 0, freedom = 0;
    /// Added to `chi2` before it is called too small: replicates may agree because they are
    /// rounded.
    double chi2_of_rounding = 0;

    bool too_small() const {
        return freedom > 0 && chi_squared_tail(chi2, freedom) < unlikely_scatter;
    }
    /// Probability that replicates agree at least so well by chance.
    double p_of_agreement() const {
        return freedom > 0 ? 1 - chi_squared_tail(chi2 + chi2_of_rounding, freedom) : 1;
    }
    bool too_large() const {
        return p_of_agreement() < unlikely_agreement &&
               freedom > far_too_large * far_too_large * (chi2 + chi2_of_rounding);
    }
};

/// Estimates the scatter between replicates and adds it to the covariances of the readings.
class Pooling {
  public:
    explicit Pooling(Measurements& all)
        : all_(all), readings_(all.readings), table_(replicate_table(all.readings)) {
        apart_.variance.assign(readings_.size(), Eigen::Vector2d::Zero());
        for (std::size_t k = 0; k < readings_.size(); ++k) {
            readings_[k].scatter_group = table_.cluster_of[k];
            stated_.push_back(stated_variance(readings_[k]));
        }
        for (const auto& group : table_.groups) {
            for (const std::size_t k : group)
                readings_[k].replicates = static_cast<int>(group.size());
        }
        all_.scatter.reference_stress = table_.reference_stress;
    }

    void by_replicates() {
        weigh_rounding(table_, readings_);
        apart_ = set_far_replicates_apart(table_, readings_);
        weigh_rounding(table_, readings_);  // again, without far replicates
        append(all_.remarks, apart_.remarks);
        find_load_exponents();
        estimate_fillings();
        estimate_steps();
        apply();
    }
    void by_statement(const StatedScatter& stated) {
        estimate_steps(true);  // makes the groups; their scatter is replaced
        for (auto& group : all_.scatter.groups) {
            group.excess = stated.step.cwiseAbs2().asDiagonal();
            group.mean_square = stated.step.cwiseAbs2();
            group.freedom.setConstant(INFINITY);
        }
        all_.scatter.correlation_freedom = INFINITY;
        for (const Eigen::Index o : {0, 1}) {
            auto& filling = all_.scatter.filling[static_cast<std::size_t>(o)];
            filling = {.variance = stated.filling(o) * stated.filling(o),
                       .freedom_between = INFINITY};
        }
        all_.scatter.stated = true;
        apply();
    }

  private:
    void find_load_exponents();
    void estimate_fillings();
    void estimate_steps(bool scatter_is_stated = false);
    void estimate_correlation();
    void apply();
    void add_steps(std::size_t reading);
    void add_filling(std::size_t reading);
    void keep_stated_filling(std::size_t reading);
    void note_errors_below_rounding();
    bool is_unknown(std::size_t reading, Eigen::Index observable) const;
    void assume_missing_errors();
    void note_few_replicates();

    ScatterSums sums_of(std::size_t cluster, Eigen::Index observable) const {
        const auto o = static_cast<std::size_t>(observable);
        return analyse_scatter(table_.clusters[cluster].values[o],
                               all_.scatter.load_exponent(observable),
                               all_.scatter.filling[o].freedom_between > 0 ||
                                   apart_.unlike.contains({cluster, observable}));
    }
    /// Whether the user states the error of an observable at all readings of a cluster.
    bool all_stated(std::size_t cluster, Eigen::Index observable) const {
        for (std::size_t k = 0; k < readings_.size(); ++k) {
            if (table_.cluster_of[k] == cluster && !(stated_[k](observable) > 0)) return false;
        }
        return true;
    }
    StatedErrorTest test_stated(Eigen::Index observable, const std::vector<MeanSquare>& own,
                                const std::vector<double>& stated) const;
    double rounding_between(std::size_t cluster, Eigen::Index observable) const;
    void note_test(Eigen::Index observable, const StatedErrorTest& test);
    /// Whether the scatter of an observable was estimated or stated for any group of the study.
    bool known(Eigen::Index observable) const {
        return std::ranges::any_of(
            all_.scatter.groups, [&](const auto& group) { return group.freedom(observable) > 0; });
    }

    Measurements& all_;
    std::vector<Reading>& readings_;
    ReplicateTable table_;
    FarReplicates apart_;
    /// Variances given with each reading, rounding included; 0 if none was given.
    std::vector<Eigen::Vector2d> stated_;
};

void Pooling::find_load_exponents() {
    // The scatter of both observables depends on load for the same reason, so the two are tested
    // together, at a significance of 0.2 %: quantile of chi2 with two degrees of freedom. An
    // exponent that is due to chance makes the errors at high load far too small.
    constexpr double enough = 12.4;
    std::array<LoadExponent, 2> found;
    for (const Eigen::Index o : {0, 1}) {
        std::vector<std::vector<ReplicatedValue>> sets;
        for (const ReplicateCluster& cluster : table_.clusters)
            sets.push_back(cluster.values[static_cast<std::size_t>(o)]);
        found[static_cast<std::size_t>(o)] = load_exponent(sets);
    }
    if (found[0].evidence + found[1].evidence < enough) return;
    for (const Eigen::Index o : {0, 1}) {
        all_.scatter.load_exponent(o) = found[static_cast<std::size_t>(o)].value;
        all_.scatter.load_exponent_error(o) = found[static_cast<std::size_t>(o)].standard_error;
    }
}

/// Whether files differ by more than their steps explain, by an F test.
bool files_differ(const ReplicateScatter::Filling& filling) {
    if (!(filling.within > 0)) return filling.between > 0;
    return fisher_f_tail(filling.between / filling.within, filling.freedom_between,
                         filling.freedom_within) < hint_of_fillings;
}

/// Adds the prior of the filling error to the mean square between files and to its degrees of
/// freedom, since a few fillings hardly determine their scatter.
void temper(ReplicateScatter::Filling& filling) {
    const double usual = filling.within * (1 + filling.steps * usual_filling * usual_filling);
    filling.between = (filling.freedom_between * filling.between + usual_freedom * usual) /
                      (filling.freedom_between + usual_freedom);
    filling.freedom_between += usual_freedom;
}

void Pooling::estimate_fillings() {
    for (const Eigen::Index o : {0, 1}) {
        ReplicateScatter::Filling filling{.steps = 0};
        for (std::size_t c = 0; c < table_.clusters.size(); ++c) {
            const ScatterSums sums =
                analyse_scatter(table_.clusters[c].values[static_cast<std::size_t>(o)],
                                all_.scatter.load_exponent(o));
            filling.within += sums.within;
            filling.freedom_within += sums.freedom_within;
            if (apart_.unlike.contains({c, o})) continue;
            filling.between += sums.between;
            filling.freedom_between += sums.freedom_between;
            filling.steps += sums.steps;
        }
        if (filling.freedom_within > 0) filling.within /= filling.freedom_within;
        if (filling.freedom_between > 0) {
            filling.between /= filling.freedom_between;
            filling.steps /= filling.freedom_between;
            const bool seen = files_differ(filling);
            temper(filling);
            // Widened as by Student's t: readings of few fillings would otherwise have too much
            // weight in a fit.
            filling.variance = widened(filling.freedom_between) *
                               std::max(0.0, (filling.between - filling.within) / filling.steps);
            // The variance of filling errors that are not significant is treated as known: tests
            // that allowed for every size that a few fillings do not exclude would have hardly any
            // power.
            if (!seen) filling.freedom_between = INFINITY;
        }
        all_.scatter.filling[static_cast<std::size_t>(o)] = filling;
    }
}

/// Mean relative variance of the rounding of a cluster's replicates [1].
double Pooling::rounding_between(std::size_t cluster, Eigen::Index o) const {
    const auto& values = table_.clusters[cluster].values[static_cast<std::size_t>(o)];
    double sum = 0;
    for (const ReplicatedValue& value : values) {
        const Reading& reading = readings_[value.reading];
        sum += std::pow(reading.resolution(o) / reading.value(o), 2) / 12;
    }
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

/// @param own mean square between the replicates of each cluster
/// @param stated mean of the variances that the user states for each cluster
StatedErrorTest Pooling::test_stated(Eigen::Index o, const std::vector<MeanSquare>& own,
                                     const std::vector<double>& stated) const {
    StatedErrorTest test;
    for (std::size_t c = 0; c < own.size(); ++c) {
        // A table may state an error that its fillings share and none besides.
        if (own[c].freedom == 0 || !all_stated(c, o) || !(stated[c] > 0)) continue;
        // Solid fractions that are equal to the last digit were assumed, as in a table of stresses.
        if (o == 1 && own[c].value == 0) continue;
        test.chi2 += own[c].freedom * own[c].value / stated[c];
        test.chi2_of_rounding += own[c].freedom * rounding_between(c, o) / stated[c];
        test.freedom += own[c].freedom;
    }
    return test;
}

/// Notes that stated errors are too small or too large for the scatter of replicates.
void Pooling::note_test(Eigen::Index o, const StatedErrorTest& test) {
    if (!test.too_small() && !test.too_large()) return;
    const double scatter = test.chi2 + (test.too_large() ? test.chi2_of_rounding : 0);
    all_.remarks.push_back(
        {.kind = test.too_small() ? Remark::Kind::errors_below_scatter
                                  : Remark::Kind::errors_above_scatter,
         .quantity = o == 0 ? "shear_stress" : "solid_fraction",
         .relative = std::sqrt(scatter / test.freedom),
         .p = test.too_small() ? chi_squared_tail(test.chi2, test.freedom) : test.p_of_agreement(),
         .freedom = test.freedom});
}

void Pooling::estimate_steps(bool scatter_is_stated) {
    ReplicateScatter& scatter = all_.scatter;
    scatter.groups.assign(table_.clusters.size(), {});
    for (std::size_t c = 0; c < table_.clusters.size(); ++c) {
        std::vector<std::string>& files = scatter.groups[c].files;
        for (const std::size_t file : table_.clusters[c].files)
            // `table_.files` has a table once for each of its fillings.
            if (std::ranges::count(files, table_.files[file]) == 0)
                files.push_back(table_.files[file]);
    }
    for (const Eigen::Index o : {0, 1}) {
        std::vector<MeanSquare> own;
        std::vector<double> within_runs;
        double run_variance = 0, freedom = 0;
        for (std::size_t c = 0; c < table_.clusters.size(); ++c) {
            const ScatterSums sums = sums_of(c, o);
            const double nu = sums.freedom_within;
            own.push_back({nu > 0 ? sums.within / nu : 0, nu});
            within_runs.push_back(nu > 0 ? sums.run_variance / nu : NAN);
            run_variance += sums.run_variance;
            freedom += nu;
        }
        if (freedom == 0) continue;
        const std::vector<MeanSquare> shrunk = moderated(own);
        // The scatter within a run is only a part of a reading's error. An error that the user
        // states is meant to be all of it, and few replicates cannot refute it by chance.
        const StatedErrorTest test = test_stated(o, own, within_runs);
        const bool too_small = test.too_small();
        if (!scatter_is_stated) note_test(o, test);
        for (std::size_t c = 0; c < table_.clusters.size(); ++c) {
            const double within = own[c].freedom > 0 ? within_runs[c] : run_variance / freedom;
            const bool known = !too_small && all_stated(c, o);
            scatter.groups[c].excess(o, o) = known ? 0 : std::max(0.0, shrunk[c].value - within);
            scatter.groups[c].mean_square(o) = shrunk[c].value;
            scatter.groups[c].freedom(o) = shrunk[c].freedom;
        }
    }
    estimate_correlation();
}

void Pooling::estimate_correlation() {
    ReplicateScatter& scatter = all_.scatter;
    double product = 0, squares0 = 0, squares1 = 0, freedom = 0;
    for (std::size_t c = 0; c < table_.clusters.size(); ++c) {
        const auto& values = table_.clusters[c].values;
        if (values[0].size() != values[1].size()) continue;
        const ScatterSums ratio = sums_of(c, 0), fraction = sums_of(c, 1);
        product += ratio.left_over.dot(fraction.left_over);
        squares0 += std::max(0.0, ratio.within - ratio.run_variance);
        squares1 += std::max(0.0, fraction.within - fraction.run_variance);
        freedom += ratio.freedom_within;
    }
    if (!(squares0 > 0 && squares1 > 0)) return;
    // Errors that the user states, which explain the scatter, are known with their correlation.
    const bool estimated = std::ranges::any_of(readings_, &Reading::within_run_only) ||
                           std::ranges::any_of(scatter.groups, [](const auto& group) {
                               return group.excess(0, 0) > 0 && group.excess(1, 1) > 0;
                           });
    if (!estimated) return;
    scatter.correlation_freedom = freedom;
    // Shrunk by (freedom - 1)/(freedom + 1): one pair tells no correlation.
    const double correlation = std::clamp(
        product / std::sqrt(squares0 * squares1) * (freedom - 1) / (freedom + 1), -0.99, 0.99);
    for (auto& group : scatter.groups) {
        group.excess(0, 1) = group.excess(1, 0) =
            correlation * std::sqrt(group.excess(0, 0) * group.excess(1, 1));
    }
}

/// Adds a covariance relative to the values of (stress ratio, solid fraction) [1] to a reading:
/// `wide` to its covariance, the difference from `estimated` to `widened_by`.
void add_scatter(Reading& reading, const Eigen::Matrix2d& estimated, const Eigen::Matrix2d& wide) {
    const Eigen::Matrix2d scale = reading.value.asDiagonal();
    reading.covariance += scale * wide * scale;
    reading.widened_by += scale * (wide - estimated) * scale;
}

void Pooling::add_steps(std::size_t k) {
    const ReplicateScatter& scatter = all_.scatter;
    Reading& reading = readings_[k];
    const auto& group = scatter.groups[reading.scatter_group];
    const double load = std::clamp(reading.condition.normal_stress / scatter.reference_stress,
                                   table_.least_load, table_.greatest_load);
    Eigen::Vector2d shape, widening;
    for (const Eigen::Index o : {0, 1}) {
        shape(o) = std::pow(load, -scatter.load_exponent(o));
        widening(o) = std::sqrt(widened(group.freedom(o)));
        // For readings without stated error and excess scatter, the error still rests on the
        // replicates that show this, so it has their degrees of freedom. Errors given with a
        // reading are known if they explain the scatter.
        const bool estimated =
            group.excess(o, o) > 0 || (!(stated_[k](o) > 0) && group.freedom(o) > 0);
        reading.scatter_freedom(o) = estimated ? group.freedom(o) : INFINITY;
    }
    Eigen::Matrix2d step = shape.asDiagonal() * group.excess * shape.asDiagonal();
    // An error that was not stated is at least the scatter between replicates at its load, even if
    // the scatter within a run is smaller.
    for (const Eigen::Index o : {0, 1}) {
        const double least = group.mean_square(o) * shape(o) * shape(o);
        const double more = least - relative_variance(reading, o) - step(o, o);
        if (!(stated_[k](o) > 0)) step(o, o) += std::max(0.0, more);
    }
    add_scatter(reading, step, widening.asDiagonal() * step * widening.asDiagonal());
    const Eigen::Matrix2d own = apart_.variance[k].asDiagonal();
    add_scatter(reading, own, own);
}

/// Numbers the errors of a filling that a table states as those of recordings, one table's apart
/// from another's; `covariance` contains them.
void Pooling::keep_stated_filling(std::size_t k) {
    std::vector<SharedError>& shared = readings_[k].shared;
    std::erase_if(shared, [](const SharedError& error) { return error.of_rounding; });
    for (SharedError& error : shared)
        error.source = 2 * table_.file_of[k] + error.source % 2;
}

void Pooling::add_filling(std::size_t k) {
    Reading& reading = readings_[k];
    if (!reading.within_run_only) return keep_stated_filling(k);
    reading.shared.clear();
    for (const Eigen::Index o : {0, 1}) {
        const auto& filling = all_.scatter.filling[static_cast<std::size_t>(o)];
        if (!(filling.variance > 0)) continue;
        const double size = reading.value(o) * std::sqrt(filling.variance);
        SharedError error{.source = 2 * table_.file_of[k] + static_cast<std::size_t>(o)};
        error.size(o) = size;
        reading.covariance(o, o) += size * size;
        reading.shared.push_back(error);
    }
}

void Pooling::apply() {
    for (std::size_t k = 0; k < readings_.size(); ++k) {
        add_steps(k);
        add_filling(k);
    }
    note_errors_below_rounding();
    assume_missing_errors();
    add_rounding(table_, stated_, readings_);
    note_few_replicates();
}

void Pooling::note_errors_below_rounding() {
    std::size_t count = 0;
    for (std::size_t k = 0; k < readings_.size(); ++k) {
        const Eigen::Array2d rounding = readings_[k].resolution.array().square() / 12;
        count += (stated_[k].array() > 0 && stated_[k].array() < rounding).any();
    }
    if (count == 0) return;
    all_.remarks.push_back(
        {.kind = Remark::Kind::errors_below_rounding, .count = count, .of = readings_.size()});
}

void Pooling::note_few_replicates() {
    double fewest = INFINITY;
    for (const Reading& reading : readings_) {
        for (const Eigen::Index o : {0, 1}) {
            if (reading.widened_by(o, o) > 0) fewest = std::min(fewest, reading.scatter_freedom(o));
        }
    }
    if (!std::isfinite(fewest) || widening(fewest) < worth_a_note) return;
    all_.remarks.push_back(
        {.kind = Remark::Kind::few_replicates, .size = fewest, .relative = widening(fewest)});
}

/// Whether nothing tells the error of a reading: neither a statement nor the scatter of replicates.
/// Its digits do not: they only limit how small the error can be. Replicates that agree in all
/// their digits do tell that the error is no larger than the rounding.
bool Pooling::is_unknown(std::size_t k, Eigen::Index o) const {
    if (o == 1 && readings_[k].condition.gap_creep != 0) return false;
    if (!known(o) && !(stated_[k](o) > 0)) return true;
    const bool rounded = readings_[k].resolution(o) > 0;
    return relative_variance(readings_[k], o) <= no_error && !rounded;
}

void Pooling::assume_missing_errors() {
    std::size_t assumed = 0;
    std::array<bool, 2> of = {};
    for (std::size_t k = 0; k < readings_.size(); ++k) {
        Reading& reading = readings_[k];
        for (const Eigen::Index o : {0, 1}) {
            if (!is_unknown(k, o)) continue;
            reading.covariance(o, o) += std::pow(assumed_error * reading.value(o), 2);
            reading.error_assumed = of[static_cast<std::size_t>(o)] = true;
        }
        assumed += reading.error_assumed;
    }
    if (assumed == 0) return;
    Remark note{.kind = Remark::Kind::assumed_errors, .count = assumed, .of = readings_.size()};
    if (of[0] != of[1]) note.quantity = of[0] ? "shear_stress" : "solid_fraction";
    all_.remarks.push_back(std::move(note));
}

}  // namespace

void pool_replicates(Measurements& measurements, const std::optional<StatedScatter>& stated) {
    Pooling pooling(measurements);
    stated ? pooling.by_statement(*stated) : pooling.by_replicates();
    measurements.remarks = decide(std::move(measurements.remarks), false);
}

}  // namespace pendular
