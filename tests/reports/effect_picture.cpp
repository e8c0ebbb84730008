// Pictures of effects follow from what the effects say of themselves.
#include "reports/page/effect_picture.h"

#include <set>

#include "tests/support/golden.h"

namespace pendular::reports_effect_picture_test {

using testing::HasSubstr;
using testing::Not;

constexpr const char* accent = "var(--accent, #0b62a4)";

TEST(EffectPictures, MarkSomethingForEachEffect) {
    for (const Effect& effect : built_in_effects()) {
        const std::string svg = cell_picture(effect);
        EXPECT_THAT(svg, HasSubstr(accent)) << effect.name;
        EXPECT_THAT(svg, HasSubstr("aria-label=\"" + effect.name + ": ")) << effect.name;
        EXPECT_THAT(svg, Not(HasSubstr("nan"))) << effect.name;
    }
}

TEST(EffectPictures, TellEffectsOfDifferentKindsApart) {
    std::set<std::string> drawings;
    const auto& all = built_in_effects();
    for (const char* name :
         {"wall-friction", "torque-offset", "normal-force-gain", "height-offset", "lid-slip",
          "bead-loss", "liquid-loss", "grain-weight", "shear-stress-gain", "rolling-resistance",
          "dry-adhesion", "polydispersity", "unequal-bridges", "viscous-bridges",
          "rupture-distance", "reversible-bridges", "capillary-coulomb", "willett-bridges",
          "peak-strength"}) {
        const std::string svg = cell_picture(effect_named(all, name));
        EXPECT_TRUE(drawings.insert(svg.substr(svg.find('>'))).second) << name;
    }
}

TEST(EffectPictures, SayWhatTheInstrumentShowsChanged) {
    const auto& all = built_in_effects();
    expect_told({cell_picture_in_words(effect_named(all, "wall-friction")),
                 cell_picture_in_words(effect_named(all, "height-offset"))});
}

TEST(EffectPictures, OfAUsersEffectNeedNothingMore) {
    const Effect effect{.name = "own <effect>",
                        .summary = "a \"user\" wrote it",
                        .parameters = {{.name = "size", .upper = 0.5, .smallest_of_interest = 0.1}},
                        .change = ChangeInstrument{.show = [](CellState shown, const Values& v) {
                            shown.normal_force *= 1 + v["size"];
                            return shown;
                        }}};
    const std::string svg = cell_picture(effect);
    EXPECT_THAT(svg, HasSubstr("own &lt;effect&gt;: a &quot;user&quot; wrote it. Changed: normal "
                               "force"));
    EXPECT_THAT(svg, Not(HasSubstr("<effect>")));
}

/// Picture of changes of the stress ratio by 3 % and of the solid fraction by these [10^-3].
std::string picture_of(const std::vector<double>& of_fraction) {
    const std::vector<double> pressures = {1, 2, 4};
    Panel ratio{.log_x = true}, fraction{.log_x = true};
    ratio.curves = {{.style = Curve::Style::line, .x = pressures, .y = {3, 2, 1}}};
    fraction.curves = {{.style = Curve::Style::line, .x = pressures, .y = of_fraction}};
    return change_picture({.panels = {ratio, fraction}, .columns = 1});
}

TEST(EffectPictures, ShowNoRoundingErrorsAsAChange) {
    const std::string svg = picture_of({1e-13, -2e-13, 1e-13});
    EXPECT_THAT(svg, HasSubstr(">0<"));
    EXPECT_THAT(svg, HasSubstr("+3 %"));
    EXPECT_THAT(svg, Not(HasSubstr("e-1")));
    EXPECT_THAT(picture_of({-150, -20, -1}), HasSubstr("-0.15"));
}

}  // namespace pendular::reports_effect_picture_test
