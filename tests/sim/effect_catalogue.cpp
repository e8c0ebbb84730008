// Which effects there are for a study, and which of them apply to it.
#include "sim/catalogue/effect_catalogue.h"

#include <stdexcept>

#include "tests/support/golden.h"

namespace pendular::effect_catalogue_test {

const std::string grains = grains_table, cell = cell_table(), readings = points_table;
const std::string liquid = "[liquid]\nsurface_tension = \"20 mN/m\"\ncontact_angle = \"0 deg\"\n";
const std::string empty_cell = "[cell]\ninner_radius = \"21 mm\"\nouter_radius = \"45 mm\"\n";
const std::string drag =
    "[[effect]]\nname = \"speed-drag\"\nparameter = \"drag\"\nunit = \"mN m s\"\nlower = -5\n"
    "upper = 5\ntorque = \"torque + drag*angular_velocity\"\n";

class Catalogue : public testing::Test {
  protected:
    Study read(const std::string& content) {
        folder_.write("points.csv", "a\n1\n");
        folder_.write("study.toml", content);
        return read_study(folder_.path());
    }
    std::vector<std::string> active(const std::string& content) {
        const Study study = read(content);
        const EffectCatalogue catalogue(study);
        std::vector<std::string> names;
        for (const Effect* effect : catalogue.active(study))
            names.push_back(effect->name);
        return names;
    }
    std::string active_error(const std::string& content) {
        return input_error([&] { active(content); });
    }

    TemporaryFolder folder_;
};

/// An effect that does nothing in particular.
Effect acting(Change change, Touches touches = Touches::all) {
    return {.name = "acting", .change = std::move(change), .touches = touches};
}

TEST_F(Catalogue, TakesEffectsOfAProgramUnderNamesThatAreFree) {
    const Study study = read(grains + cell + readings + drag);
    Effect own =
        acting(ChangeInstrument{.show = [](CellState shown, const Values&) { return shown; }});
    own.name = "my-drift";
    const EffectCatalogue catalogue(study, {own});
    EXPECT_EQ(catalogue.find("my-drift").name, "my-drift");
    EXPECT_TRUE(catalogue.is_written(catalogue.find("my-drift")));
    for (const char* taken : {"torque-offset", "speed-drag"}) {
        own.name = taken;
        EXPECT_THROW(EffectCatalogue(study, {own}), InputError) << taken;
    }
}

TEST_F(Catalogue, HasTheBuiltInEffectsWithoutAStudy) {
    const EffectCatalogue catalogue;
    EXPECT_EQ(catalogue.all().size(), built_in_effects().size());
    EXPECT_EQ(catalogue.find("torque-offset").name, "torque-offset");
    EXPECT_FALSE(catalogue.is_written(catalogue.find("torque-offset")));
}

TEST_F(Catalogue, HasTheEffectsAStudyWrites) {
    const Study study = read(grains + readings + drag);
    const EffectCatalogue catalogue(study);
    EXPECT_EQ(catalogue.all().size(), built_in_effects().size() + 1);
    EXPECT_TRUE(catalogue.is_written(catalogue.find("speed-drag")));
}

TEST_F(Catalogue, NamesTheNearestEffect) {
    const Study study = read(grains + readings + drag);
    const EffectCatalogue catalogue(study);
    const auto message = [&](const std::string& name) -> std::string {
        try {
            catalogue.find(name);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    expect_told({message("torque-ofset"), message("sped-drag")});
}

TEST_F(Catalogue, RefusesTheNameOfABuiltInEffect) {
    std::string text = drag;
    text.replace(text.find("speed-drag"), 10, "torque-offset");
    expect_told({active_error(grains + readings + text)});
}

TEST_F(Catalogue, RefusesAWrittenEffectThatIsNotSwitchedOnToo) {
    expect_told({active_error(grains + readings + drag + "height = \"height + 1\"\n")});
}

TEST_F(Catalogue, GivesTheListedEffectsInTheirOrder) {
    EXPECT_EQ(active(grains + cell + readings + drag +
                     "[model]\neffects = [\"torque-offset\", \"speed-drag\"]\n"),
              (std::vector<std::string>{"torque-offset", "speed-drag"}));
    EXPECT_TRUE(active(grains + readings + drag).empty());
}

TEST_F(Catalogue, RefusesUnknownAndUselessEffectsAtTheirPlaceInTheList) {
    const std::string list = "[model]\neffects = [\"torque-offset\", \"torque-ofset\"]\n";
    expect_told(
        {active_error(grains + cell + readings + list), active_error(grains + readings + list)});
}

TEST_F(Catalogue, KnowsWhatInstrumentEffectsNeed) {
    const Effect offset = built_in_effect("torque-offset");
    expect_told({why_not(offset, read(grains + readings)).value_or(""),
                 why_not(offset, read(grains + empty_cell + readings)).value_or("")});
    EXPECT_EQ(why_not(offset, read(grains + cell + readings)), std::nullopt);
    EXPECT_EQ(why_not(offset, read(grains + empty_cell + readings + "bead_mass = \"60 g\"\n")),
              std::nullopt);
}

// A table has a column for the reason in two or three words.
TEST_F(Catalogue, NamesAnObstacleInAFewWords) {
    const auto brief = [&](const std::string& name, const std::string& text) {
        const auto found = obstacle(built_in_effect(name), read(grains + text));
        return found ? found->brief : "none";
    };
    const std::string lines = liquid + readings + "[model]\nbase = \"mohr-coulomb\"\n";
    EXPECT_EQ(brief("torque-offset", readings), "needs [cell]");
    EXPECT_EQ(brief("torque-offset", empty_cell + readings), "needs bead_mass");
    EXPECT_EQ(brief("torque-offset", cell + readings), "none");
    EXPECT_EQ(brief("contact-angle", readings), "needs [liquid]");
    EXPECT_EQ(brief("contact-stress", liquid + readings), "not for base dem");
    EXPECT_EQ(brief("contact-stress", lines), "none");
    EXPECT_EQ(brief("contact-angle", lines), "after rumpf-cohesion");
    EXPECT_EQ(brief("peak-strength", readings), "needs failure points");
}

TEST_F(Catalogue, KnowsWhatWetAndDryEffectsNeed) {
    const Effect wet = acting(dem::ChangePairs{}, Touches::wet);
    const Effect dry = acting(ChangeFlow{}, Touches::dry);
    const auto why = [&](const Effect& effect, const std::string& text) {
        return why_not(effect, read(grains + text)).value_or("");
    };
    expect_told({why(wet, readings), why(wet, liquid + readings + "liquid_content = 0\n")});
    EXPECT_EQ(why(wet, liquid + readings), "");  // a column may say so
    EXPECT_EQ(why(wet, liquid + readings + "liquid_content = 0.03\n"), "");
    expect_told({why(dry, liquid + readings + "liquid_content = 0.03\n")});
    EXPECT_EQ(why(dry, readings), "");
}

TEST_F(Catalogue, KnowsWhichBaseAnEffectBelongsTo) {
    const Study dem = read(grains + readings),
                rumpf = read(grains + readings + "[model]\nbase = \"rumpf\"\n");
    using closures::Level;
    const auto why = [](Level level, const Study& study) {
        return why_not(acting(ChangeClosure{.level = level}), study).value_or("");
    };
    EXPECT_EQ(why(Level::strength2, rumpf), "");
    expect_told({why(Level::strength2, dem), why(Level::rumpf, dem), why(Level::rumpf, rumpf),
                 why(Level::strength3, rumpf)});
    for (const Study& study : {dem, rumpf}) {
        EXPECT_EQ(why_not(acting(ChangeFlow{}), study), std::nullopt);
        EXPECT_EQ(why_not(acting(dem::ChangePairs{}), study), std::nullopt);
        EXPECT_EQ(why_not(acting(ChangeCondition{}), study), std::nullopt);
    }
}

// With the base "mohr-coulomb" only levels can be added at first, and no level below one listed.
TEST_F(Catalogue, LetsTheLadderOfClosuresBeClimbed) {
    using closures::Level;
    Study study = read(grains + liquid + readings + "[model]\nbase = \"mohr-coulomb\"\n");
    const auto why = [&](const std::string& name) {
        return why_not(built_in_effect(name), study).value_or("");
    };
    EXPECT_EQ(level_of(study), Level::mohr_coulomb);
    EXPECT_EQ(why("rumpf-cohesion"), "");
    EXPECT_EQ(why("contact-stress"), "");
    expect_told({why("contact-angle")});
    study.model.effects.push_back({"capillary-shear-stress", {}});
    EXPECT_EQ(level_of(study), Level::strength2);
    EXPECT_EQ(why("capillary-shear-stress"), "");
    EXPECT_EQ(why("capillary-normal-stress"), "");
    EXPECT_EQ(why("contact-angle"), "");
    expect_told({why("rumpf-cohesion")});
    study.model.effects.push_back({"rumpf-cohesion", {}});
    EXPECT_EQ(why("rumpf-cohesion"), "") << "a listed level below another one changes nothing";
    EXPECT_EQ(level_of(study), Level::strength2);
}

}  // namespace pendular::effect_catalogue_test
