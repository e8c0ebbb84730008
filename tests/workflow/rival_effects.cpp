// How effects are measured directly, in words.
#include "workflow/rival_effects.h"

#include <gtest/gtest.h>

namespace rival_effects_test {

using namespace pendular;

TEST(DirectMethods, AreThoseOfTheEffectsThatHaveOne) {
    const EffectCatalogue catalogue;
    const std::vector<std::string> effects = {"willett-bridges", "capillary-bridges",
                                              "polydispersity"};
    EXPECT_EQ(direct_methods(effects, catalogue),
              "capillary-bridges by a tensiometer; polydispersity by sieving");
    EXPECT_EQ(direct_methods({"willett-bridges"}, catalogue), "");
}

}  // namespace rival_effects_test
