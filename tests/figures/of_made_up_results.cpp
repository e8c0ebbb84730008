// Figures that no example has, from results made up for the purpose: nothing that one would not
// print.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/impact_report.h"
#include "reports/locus_figures.h"
#include "reports/misfit_figures.h"
#include "reports/proposal_report.h"
#include "reports/recording_figures.h"
#include "reports/simulation_figures.h"
#include "tests/support/figure_faults.h"
#include "tests/support/made_up_impact.h"

namespace pendular::figures_of_made_up_results_test {

using made_up::impact;
using made_up::one;
using testing::IsEmpty;

void expect_no_fault(const std::vector<Figure>& figures) {
    EXPECT_FALSE(figures.empty());
    for (const Figure& figure : figures)
        EXPECT_THAT(figure_check::faults_of(figure), IsEmpty());
}

TEST(FiguresOfResults, OfALongLadderWithARiseHaveNoFault) {
    Ladder ladder;
    double chi2 = 4000;
    for (const char* const effect :
         {"", "torque-offset", "capillary-shear-stress", "normal-force-offset", "lid-slip",
          "polydispersity", "rolling-resistance", "distant-bridge-force", "capillary-coulomb"}) {
        LadderStep step{.change = *effect == '\0' ? "start" : "add", .effect = effect};
        step.chi2 = chi2, step.dof = 40, step.rms_percent = {chi2 / 200, chi2 / 2000};
        step.left_out_percent = {chi2 / 180, chi2 / 1900};
        ladder.push_back(step);
        chi2 *= ladder.size() == 4 ? 2.5 : 0.5;
    }
    expect_no_fault({ladder_figure(ladder)});
    ladder.resize(1);
    ladder[0].left_out_percent.reset();
    expect_no_fault({ladder_figure(ladder)});
}

/// Readings of dry beads and of two liquid contents, with predictions that are off.
TEST(FiguresOfResults, OfAProposalHaveNoFault) {
    Proposal proposal;
    std::vector<Reading> readings;
    for (const double content : {0.0, 0.01, 0.03}) {
        for (const double stress : {300.0, 1000.0, 3000.0}) {
            readings.push_back({.condition = {.normal_stress = stress, .liquid_content = content},
                                .value = Eigen::Vector2d(0.3 * stress, 0.6)});
            readings.back().covariance = Eigen::Vector2d(1e-4 * stress * stress, 1e-6).asDiagonal();
        }
    }
    Prediction model;
    model.value.resize(2 * std::ssize(readings));
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto at = static_cast<Eigen::Index>(2 * k);
        model.value(at) = 1.05 * readings[k].value(0) - 20;
        model.value(at + 1) = 0.605;
    }
    proposal.model.fit.prediction.value = 0.99 * model.value;
    expect_no_fault({proposal_figure(proposal, readings, model)});
}

/// The bar of "wobble" is cut at the edge of the axes, where its marker of the size that matters
/// stands: its number moves aside.
TEST(FiguresOfResults, OfImpactsHaveNoFault) {
    const ImpactTable table{
        .parameters = {{.name = "friction"}},
        .fitted = one(0.3),
        .errors = one(0.01),
        .impacts = {impact("wobble", 0.52, 0, 50), impact("lid-slip", 0.2, 0, 0.5),
                    impact("drag", 0.15, 0, 0.1), impact("wall-friction", 0.4, 0.8, 0.2)},
        .groups = {}};
    const Figure figure = impact_figure(table);
    ASSERT_THAT(figure.panels.front().curves.back().x, testing::Contains(testing::Lt(-50)));
    expect_no_fault({figure});
}

TEST(FiguresOfResults, OfARunHaveNoFault) {
    dem::RunResult run;
    for (const bool wet : {false, true}) {
        if (wet)
            run.parameters.wetting = dem::Wetting{.reduced_pressure = 2, .bridge_volume = 4e-3};
        for (auto& field : run.fields) {
            field = {};
            for (int k = 1; k <= 7; ++k) {
                field.at.push_back(k / 8.0);
                field.means.push_back({0.1 * k, 0.01 * k});
            }
        }
        expect_no_fault(field_figures(run));
    }
    StoredRun stored{.id = 12, .run = run};
    for (int k = 0; k < 40; ++k)
        stored.run.trace.push_back(
            {.strain = 0.25F, .s22 = 1, .s12 = -0.3F, .solid_fraction = 0.6F});
    stored.run.strain_transient = 2;
    const auto set = [&](dem::Observable which, const Mean& mean) {
        stored.run.means[static_cast<std::size_t>(which)] = mean;
    };
    set(dem::Observable::stress_ratio, {0.3, 0.002});
    set(dem::Observable::solid_fraction, {0.6, 0.0002});
    expect_no_fault({trace_figure(stored)});
}

FileView view_of_loci() {
    FileView view;
    for (const double consolidation : {1000.0, 2000.0}) {
        YieldLocus locus;
        std::vector<double> normal, shear;
        for (const double share : {0.3, 0.5, 0.7}) {
            normal.push_back(share * consolidation);
            shear.push_back(0.1 * consolidation + 0.5 * normal.back());
            locus.points.push_back({.normal_stress = normal.back(), .shear_stress = shear.back()});
        }
        locus.points.back().at_end = true;
        locus.line = linear_yield_locus(normal, shear, {});
        locus.line->major_principal_stress = 2 * consolidation;
        view.loci.push_back(locus);
    }
    return view;
}

TEST(FiguresOfResults, OfYieldLociHaveNoFault) {
    const FileView view = view_of_loci();
    expect_no_fault(yield_locus_figures(view));
    expect_no_fault({flow_function_figure({view}).value()});
}

}  // namespace pendular::figures_of_made_up_results_test
