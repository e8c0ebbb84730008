#include "analysis/misfit/compare.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "calib/model/mohr_coulomb.h"
#include "data/quantities/statistics.h"
#include "data/recordings/reading_groups.h"

namespace pendular {
namespace {

/// Misfit of each condition. `misfit`: measured minus predicted values, two entries for each
/// reading; `total`: covariance of `misfit`.
std::vector<ConditionMisfit> misfit_by_condition(const std::vector<Reading>& readings,
                                                 const std::vector<ReadingMisfit>& misfits,
                                                 const Eigen::VectorXd& misfit,
                                                 const Eigen::MatrixXd& total) {
    std::vector<ConditionMisfit> groups;
    for (const auto& members : replicate_groups(readings)) {
        ConditionMisfit group{readings[members.front()].condition, members};
        Eigen::Vector2d sum = Eigen::Vector2d::Zero(), variance = Eigen::Vector2d::Zero();
        for (const std::size_t k : members) {
            group.chi2 += misfits[k].chi2.sum();
            const auto at = 2 * static_cast<Eigen::Index>(k);
            sum += misfit.segment<2>(at);
            for (const std::size_t l : members) {
                variance += total.block<2, 2>(at, 2 * static_cast<Eigen::Index>(l)).diagonal();
            }
        }
        group.normalised = sum.cwiseQuotient(variance.cwiseSqrt());
        groups.push_back(group);
    }
    return groups;
}

/// Transforms misfits into uncorrelated misfits of variance 1 that are as close to the normalised
/// misfits as possible; their squares are non-negative parts of chi2:
///     R^(-1/2) V^(-1/2) e,   Sigma = V^(1/2) R V^(1/2),  V diagonal.
/// Source: Kessy, Lewin and Strimmer, Am. Stat. 72 (2018) 309, ZCA-cor whitening.
Eigen::VectorXd whitened_alike(const Eigen::VectorXd& misfit, const Eigen::MatrixXd& covariance) {
    const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd correlation = scale.asDiagonal() * covariance * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(correlation);
    return modes.operatorInverseSqrt() * scale.cwiseProduct(misfit);
}

std::vector<FileMisfit> misfit_by_file(const std::vector<ReadingMisfit>& misfits) {
    std::vector<FileMisfit> files;
    for (const ReadingMisfit& misfit : misfits) {
        const std::string& file = misfit.reading.origin.file;
        auto known = std::ranges::find(files, file, &FileMisfit::file);
        if (known == files.end()) {
            known = files.insert(known, {file});
        }
        ++known->readings;
        known->chi2 += misfit.chi2.sum();
    }
    return files;
}

}  // namespace

double freedom_behind(std::span<const Reading> readings) {
    std::map<std::pair<std::size_t, double>, double> shares;
    for (const Reading& reading : readings) {
        for (const Eigen::Index o : {0, 1}) {
            shares[{2 * reading.scatter_group + static_cast<std::size_t>(o),
                    reading.scatter_freedom(o)}] += 0.5 / static_cast<double>(readings.size());
        }
    }
    double inverse = 0;
    for (const auto& [group, share] : shares) {
        inverse += share * share / group.second;
    }
    return inverse > 0 ? 1 / inverse : INFINITY;
}

double Misfit::p() const {
    if (dof <= 0) return 1;
    return std::isfinite(freedom) ? fisher_f_tail(chi2 / dof, static_cast<double>(dof), freedom)
                                  : chi_squared_tail(chi2, dof);
}

std::array<double, 2> rms_percent(const std::vector<Reading>& readings,
                                  const Eigen::VectorXd& values) {
    std::array<double, 2> result{};
    for (std::size_t k = 0; k < readings.size(); ++k) {
        for (const std::size_t o : {0, 1}) {
            const double predicted = values(static_cast<Eigen::Index>(2 * k + o));
            result[o] +=
                std::pow(predicted / readings[k].value(static_cast<Eigen::Index>(o)) - 1, 2) /
                static_cast<double>(readings.size());
        }
    }
    for (double& rms : result) {
        rms = 100 * std::sqrt(rms);
    }
    return result;
}

Comparison compare(const std::vector<Reading>& readings, const Prediction& prediction,
                   int parameters, std::size_t fitted) {
    const Measured measured = stack(readings);
    const Eigen::MatrixXd total = measured.covariance + prediction.covariance;
    const Eigen::VectorXd misfit = measured.value - prediction.value;
    const Eigen::VectorXd terms = whitened_alike(misfit, total).cwiseAbs2();
    Comparison result;
    const auto split = 2 * static_cast<Eigen::Index>(fitted);
    const std::span all(readings);
    const auto known = [](std::span<const Reading> of) {
        return 2 * static_cast<int>(of.size()) -
               static_cast<int>(std::ranges::count_if(of, &Reading::fraction_unknown));
    };
    result.fitted = {terms.head(split).sum(), known(all.first(fitted)) - parameters,
                     freedom_behind(all.first(fitted))};
    result.predicted = {terms.tail(terms.size() - split).sum(),
                        known(all.subspan(fitted)),
                        freedom_behind(all.subspan(fitted))};
    result.total = {result.fitted.chi2 + result.predicted.chi2,
                    result.fitted.dof + result.predicted.dof, freedom_behind(all)};
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(2 * k);
        const Eigen::Vector2d errors = total.diagonal().segment<2>(at).cwiseSqrt();
        result.readings.push_back({readings[k], prediction.value.segment<2>(at),
                                   prediction.covariance.block<2, 2>(at, at), terms.segment<2>(at),
                                   misfit.segment<2>(at).cwiseQuotient(errors)});
        for (std::size_t observable = 0; observable < 2; ++observable) {
            const auto i = at + static_cast<Eigen::Index>(observable);
            result.by_observable[observable] += terms(i);
        }
    }
    result.rms_percent = rms_percent(readings, prediction.value);
    result.by_condition = misfit_by_condition(readings, result.readings, misfit, total);
    result.by_file = misfit_by_file(result.readings);
    return result;
}

namespace {

/// Standard uncertainty of a directly measured parameter, in its unit, by the errors of the
/// instrument that the fit takes into account; 0 without any.
double stated_error_of(const DirectMeasurement& direct, const Fit& fit) {
    double variance = 0;
    for (const InstrumentError& each : fit.instrument) {
        if (!each.counts) continue;
        variance += std::pow(
            direct.change_by({.name = each.name, .standard = each.standard, .unit = each.unit}), 2);
    }
    return std::sqrt(variance);
}

}  // namespace

Comparison compare(const Calibration& c) {
    Comparison result =
        compare(c.readings, c.prediction, static_cast<int>(c.parameters.size()), c.fitted);
    const int cohesions = fitted_cohesions(c.model, c.grains, c.liquid);
    (c.fitted < c.readings.size() ? result.predicted : result.fitted).dof -= cohesions;
    result.total.dof -= cohesions;
    const double of_readings = result.fitted.chi2;
    double of_direct = 0;
    bool shared = false;
    for (const DirectMeasurement& direct : c.direct) {
        result.direct.push_back({direct, predicted_value(direct, c.parameters, c.fit.parameters),
                                 stated_error_of(direct, c.fit)});
        of_direct += std::pow(result.direct.back().normalised(), 2);
        shared |= result.direct.back().predicted_error > 0;
    }
    // An error that the readings share with a direct measurement is in both.
    if (shared) of_direct = c.fit.chi2 - of_readings;
    for (Misfit* misfit : {&result.fitted, &result.total}) {
        misfit->chi2 += of_direct;
        misfit->dof += static_cast<int>(c.direct.size());
    }
    return result;
}

}  // namespace pendular
