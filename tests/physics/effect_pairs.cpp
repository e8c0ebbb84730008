// Which effects look alike: cosines of what they do to the readings of a study, with the friction
// fitted away. docs/validation.md has the table that this prints.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>

#include "tests/support/effect_study.h"

namespace effect_pairs_test {

using namespace pendular;

/// Change of the readings by an effect over their errors: its derivative, or its change where it is
/// a switch, with what the friction can do taken out; of length 1.
struct Signature {
    Eigen::VectorXd direction;
    double share_imitated = 0;  ///< rho^2: share of it that friction takes over
};

/// 1 % in shear stress, 0.2 % in solid fraction.
Eigen::VectorXd errors_of(const Eigen::VectorXd& values) {
    Eigen::VectorXd errors = 0.01 * values;
    for (Eigen::Index k = 1; k < values.size(); k += 2) {
        errors(k) = 0.002 * values(k);
    }
    return errors;
}

Signature signature_of(const std::string& name, bool dry_only = false) {
    const Effect& effect = built_in_effect(name);
    const ModelOfReadings without = laboratory().with({}), with_it = laboratory().with({&effect});
    const Eigen::VectorXd friction = Eigen::VectorXd::Constant(1, planted_friction);
    const Prediction plain = without.predict(friction, PredictionPart::slopes);
    Eigen::VectorXd g;
    if (effect.is_switch()) {
        g = with_it.predict(friction, PredictionPart::slopes).value - plain.value;
    } else {
        // A secant over the smallest effect of interest: at neutral the derivative of some is zero.
        Eigen::VectorXd at(2);
        const EffectParameter& p = effect.parameters.front();
        at << planted_friction, effect.given_by_liquid ? 20.6e-3 + p.smallest_of_interest
                                                       : p.neutral + p.smallest_of_interest;
        g = with_it.predict(at, PredictionPart::slopes).value - plain.value;
    }
    const Eigen::VectorXd inverse = errors_of(plain.value).cwiseInverse();
    g = inverse.cwiseProduct(g);
    Eigen::VectorXd j = inverse.cwiseProduct(plain.jacobian.col(0));
    if (dry_only) {
        const auto all = conditions();
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (!all[k].dry()) {
                g.segment<2>(2 * static_cast<Eigen::Index>(k)).setZero();
                j.segment<2>(2 * static_cast<Eigen::Index>(k)).setZero();
            }
        }
    }
    j.normalize();
    const double whole = g.squaredNorm();
    g -= j * j.dot(g);
    return {g.normalized(), 1 - g.squaredNorm() / whole};
}

double cosine(const std::string& a, const std::string& b, bool dry_only = false) {
    return std::abs(signature_of(a, dry_only).direction.dot(signature_of(b, dry_only).direction));
}

TEST(EffectsAlike, AreThoseThatRheologistsKnow) {
    // The surface tension and the contact angle change F0 alone: nothing on the rig tells them
    // apart.
    EXPECT_GT(cosine("contact-angle", "capillary-bridges"), 0.9999);
    // Half the weight of 60 g is a normal force of -0.29 N.
    EXPECT_GT(cosine("grain-weight", "normal-force-offset"), 0.999);
    // At a constant gap a zero error and lost beads are one factor on the solid fraction.
    EXPECT_GT(cosine("height-offset", "bead-loss"), 0.999);
    EXPECT_GT(cosine("torque-offset", "normal-force-offset", true), 0.98);
    // A factor on the torque, on the solid fraction, sizes, walls: at one bead mass much the same.
    EXPECT_GT(cosine("torque-gain", "wall-friction"), 0.93);
    EXPECT_GT(cosine("bead-loss", "polydispersity"), 0.95);
    // Dry, a load cell that shows too little is a torque transducer that shows too much, but for the
    // inertial number that the true force changes; and cross-talk adds a stress ratio.
    EXPECT_GT(cosine("torque-gain", "normal-force-gain", true), 0.95);
    EXPECT_GT(cosine("torque-gain", "cross-talk", true), 0.95);
    // Rolling resistance does what friction does, but for a hundredth part.
    EXPECT_GT(signature_of("rolling-resistance").share_imitated, 0.95);
    // These change other things.
    EXPECT_LT(cosine("torque-offset", "height-offset"), 0.7);
    EXPECT_LT(cosine("torque-gain", "contact-angle"), 0.9);
}

TEST(EffectsAlike, AreTabled) {
    std::vector<std::pair<std::string, Signature>> all;
    for (const Effect& effect : built_in_effects()) {
        if (!effect.of_closure() && predictable(effect)) {
            all.emplace_back(effect.name, signature_of(effect.name));
        }
    }
    std::printf("| pair | cosine |\n|---|---|\n");
    for (std::size_t a = 0; a < all.size(); ++a) {
        ASSERT_TRUE(all[a].second.direction.allFinite()) << all[a].first;
        for (std::size_t b = 0; b < a; ++b) {
            const double c = std::abs(all[a].second.direction.dot(all[b].second.direction));
            EXPECT_LE(c, 1 + 1e-9);
            if (c > 0.9) {
                std::printf("| %s / %s | %.4f |\n", all[b].first.c_str(), all[a].first.c_str(), c);
            }
        }
    }
    std::printf("\n| effect | absorbed by friction |\n|---|---|\n");
    for (const auto& [name, signature] : all) {
        std::printf("| %s | %.3f |\n", name.c_str(), signature.share_imitated);
    }
}

}  // namespace effect_pairs_test
