// Effects of uneven shear are tried where the bed may be sheared unevenly, and nowhere else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/physics/planted_readings.h"

namespace uneven_candidates_test {

using namespace pendular;
using ::testing::Contains;
using ::testing::Not;

/// Names of the effects that a diagnosis tries, for the friction stated of the side walls and a gap
/// that creeps in one reading or in none.
std::vector<std::string> tried(std::optional<double> wall_friction, double gap_creep) {
    Study study = planted_study();
    study.cell->wall_friction = wall_friction;
    std::vector<Condition> all = conditions();
    all.front().gap_creep = gap_creep;
    std::vector<std::string> names;
    const StudyModelSpace models = models_of(all, study);
    for (const Candidate& candidate : models.candidates())
        names.push_back(candidate.name);
    return names;
}

TEST(UnevenCandidates, AreThoseOfWallsThatRubAndOfBedsThatCreep) {
    for (const char* effect : {"shear-localisation", "wall-layers"}) {
        EXPECT_THAT(tried({}, 0), Not(Contains(effect)));
        EXPECT_THAT(tried({}, -0.002), Contains(effect));
        EXPECT_THAT(tried(0.1, 0), Contains(effect));
    }
}

TEST(UnevenCandidates, AreNotThoseOfWallsWithoutFriction) {
    // The weight of a high bed gathers the shear there, and the effect of the walls is the wrong
    // one.
    EXPECT_THAT(tried(0, -0.002), Not(Contains("shear-localisation")));
}

}  // namespace uneven_candidates_test
