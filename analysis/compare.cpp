#include "analysis/compare.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "data/replicates.h"

namespace pendular {
namespace {

/// `total`: the covariance of `misfit`, two entries a reading.
std::vector<ConditionMisfit> misfit_by_condition(const std::vector<Reading>& readings,
                                                 const std::vector<ReadingMisfit>& misfits,
                                                 const Eigen::VectorXd& misfit,
                                                 const Eigen::MatrixXd& total) {
    std::vector<ConditionMisfit> groups;
    for (const auto& members : condition_groups(readings)) {
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

std::vector<std::vector<std::size_t>> condition_groups(const std::vector<Reading>& readings) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto group = std::ranges::find_if(groups, [&](const auto& members) {
            return are_replicates(readings[members.front()], readings[k]);
        });
        if (group == groups.end()) {
            groups.push_back({k});
        } else {
            group->push_back(k);
        }
    }
    return groups;
}

double Misfit::p() const {
    return dof > 0 ? boost::math::cdf(boost::math::complement(boost::math::chi_squared(dof), chi2))
                   : 1.0;
}

Comparison compare(const std::vector<Reading>& readings, const Prediction& prediction,
                   int parameters, std::size_t fitted) {
    const Measured measured = stack(readings);
    const Eigen::MatrixXd total = measured.covariance + prediction.covariance;
    const Eigen::VectorXd misfit = measured.value - prediction.value;
    const Eigen::VectorXd terms = misfit.cwiseProduct(total.llt().solve(misfit));
    Comparison result;
    const auto split = 2 * static_cast<Eigen::Index>(fitted);
    result.fitted = {terms.head(split).sum(), static_cast<int>(split) - parameters};
    result.predicted = {terms.tail(terms.size() - split).sum(),
                        static_cast<int>(terms.size() - split)};
    result.total = {result.fitted.chi2 + result.predicted.chi2,
                    result.fitted.dof + result.predicted.dof};
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(2 * k);
        const Eigen::Vector2d errors = total.diagonal().segment<2>(at).cwiseSqrt();
        result.readings.push_back({readings[k], prediction.value.segment<2>(at),
                                   prediction.covariance.block<2, 2>(at, at), terms.segment<2>(at),
                                   misfit.segment<2>(at).cwiseQuotient(errors)});
        for (std::size_t observable = 0; observable < 2; ++observable) {
            const auto i = at + static_cast<Eigen::Index>(observable);
            result.by_observable[observable] += terms(i);
            result.rms_percent[observable] +=
                std::pow(prediction.value(i) / measured.value(i) - 1, 2) /
                static_cast<double>(readings.size());
        }
    }
    for (double& rms : result.rms_percent) {
        rms = 100 * std::sqrt(rms);
    }
    result.by_condition = misfit_by_condition(readings, result.readings, misfit, total);
    result.by_file = misfit_by_file(result.readings);
    return result;
}

Comparison compare(const Calibration& c) {
    Comparison result =
        compare(c.readings, c.prediction, static_cast<int>(c.parameters.size()), c.fitted);
    for (const DirectMeasurement& direct : c.direct) {
        result.direct.push_back({direct, predicted_value(direct, c.parameters, c.fit.parameters)});
        for (Misfit* misfit : {&result.fitted, &result.total}) {
            misfit->chi2 += std::pow(result.direct.back().normalised(), 2);
            ++misfit->dof;
        }
    }
    return result;
}

}  // namespace pendular
