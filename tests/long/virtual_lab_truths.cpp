// Twenty virtual laboratories of friction 0.15, through recordings and import: does the calibration
// find the friction back, and are the wet readings then predicted without any further parameter?
#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "data/files/write_whole.h"
#include "data/recordings/measurements.h"
#include "sim/lab/virtual_lab.h"
#include "sim/lab/virtual_study.h"

namespace virtual_lab_truths_test {

using namespace pendular;

constexpr int laboratories = 20, fewest_found = 17, laboratories_with_wet = 3;
constexpr double truth = 0.15;
/// At these inertial numbers the solver is fast and the fit the same. With 400 beads a run orders
/// now and then, which packs it 0.0005 more densely than the laboratory's.
const Fidelity fidelity{"small", 600, 500, 0.03, 6};
/// Half of the friction's variance may come from simulation: the reported error must be right then
/// too, and the fits are fast.
const CalibrationOptions options{.largest_enlargement = 0.4};

LabPlan plan_of(std::uint64_t seed) {
    LabPlan plan;
    plan.friction = truth;
    plan.inertial_numbers = {0.03, 0.1};
    plan.fidelity = fidelity;
    plan.seed = seed;
    if (seed > laboratories_with_wet) {
        plan.liquid_contents = {};
    }
    return plan;
}

/// The study folder of a laboratory, imported as a user would.
std::pair<Study, Measurements> recorded(const LabPlan& plan, int threads) {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("pendular_virtual_lab_" + std::to_string(plan.seed));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    for (const auto& [name, text] : study_files(simulate_lab(plan, {.threads = threads}))) {
        write_whole(folder / name, text);
    }
    const Study study = read_study(folder);
    auto result = std::pair(study, read_measurements(study));
    std::filesystem::remove_all(folder);
    return result;
}

TEST(VirtualLaboratories, AreCalibratedBackAndPredictedWet) {
    const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    int found = 0;
    double square = 0, wet_chi2 = 0;
    int wet_dof = 0;
    for (int k = 1; k <= laboratories; ++k) {
        const auto seed = static_cast<std::uint64_t>(k);
        const auto [study, measurements] = recorded(plan_of(seed), threads);
        // The same seed on purpose: the fit's runs must differ from the laboratory's all the same.
        const Calibration c = calibrate_study(
            study, measurements, {.fidelity = fidelity, .seed = seed, .options = options},
            {.threads = threads});
        const Misfit wet = compare(c).predicted;
        const double z = (c.fit.parameters(0) - truth) / c.fit.standard_error(0);
        std::printf("laboratory %d: %.4f +- %.4f, z = %+.2f, chi2 %.1f for %d", k,
                    c.fit.parameters(0), c.fit.standard_error(0), z, c.fit.chi2, c.fit.dof);
        if (wet.dof > 0) {
            std::printf("; wet chi2 %.1f for %d, p = %.3g", wet.chi2, wet.dof, wet.p());
            EXPECT_GT(wet.p(), 0.01 / laboratories_with_wet);
            wet_chi2 += wet.chi2, wet_dof += wet.dof;
        }
        std::printf("\n");
        std::fflush(stdout);
        EXPECT_TRUE(c.fit.converged) << c.fit.message;
        found += std::abs(z) <= 2;
        square += z * z / laboratories;
    }
    std::printf(
        "%d of %d within 2 standard errors; scatter over reported error %.2f; wet chi2 %.1f "
        "for %d\n",
        found, laboratories, std::sqrt(square), wet_chi2, wet_dof);
    EXPECT_GE(found, fewest_found);
    EXPECT_GT((Misfit{wet_chi2, wet_dof}.p()), 0.01);
}

}  // namespace virtual_lab_truths_test
