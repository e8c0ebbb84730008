// The generated pages of docs/reference are current: commands from their --help, effects from the
// registry, terms from the table of quantities. scripts/accept_reference.sh writes them anew.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>

#include "data/effect_parameter.h"
#include "data/quantities/quantity.h"
#include "sim/catalogue/effect.h"
#include "tests/support/app_support.h"

namespace app_reference_test {

using namespace pendular;

const std::filesystem::path reference =
    std::filesystem::path(PENDULAR_SOURCE_DIR) / "docs" / "reference";

void expect_current(const std::string& name, const std::string& text) {
    const auto file = reference / name;
    expect_same_text(content_of(file), text, file, text);
}

/// Table cell without characters that Markdown reads as borders.
std::string cell(std::string_view text) {
    std::string result;
    for (const char c : text) {
        result += c == '|' ? std::string("\\|") : std::string(1, c);
    }
    return result;
}

TEST(ReferencePages, OfCommandsHoldTheirHelp) {
    std::string text =
        "# Commands\n\nGenerated from `--help` of each command; `cores` is the number of the "
        "machine's "
        "cores.\n";
    for (const char* command :
         {"import", "calibrate", "compare", "diagnose", "next", "add", "drop", "effects", "predict",
          "simulate", "campaign", "runs", "virtual-lab", "reproduce", "report", "serve"}) {
        const std::string help = run_pendular(std::string(command) + " --help").output;
        text += fmt::format("\n## {}\n\n```\n{}```\n", command, help);
    }
    expect_current("commands.md", text);
}

TEST(ReferencePages, OfEffectsHoldTheRegistry) {
    std::string text =
        "# Effects\n\nGenerated from the registry of effects, `sim/effects/`. A study lists its "
        "effects in `[model]`, `effects = [...]`. On the command line, a value may have "
        "its unit, as in `\"0.1 mN m\"`; a number without a unit is in SI units.\n";
    for (const Effect& effect : built_in_effects()) {
        std::string summary = effect.summary;
        summary[0] = static_cast<char>(std::toupper(summary[0]));
        text += fmt::format("\n## {}\n\n{}.\n\n```\n{}\n```\n\n", effect.name, summary,
                            effect.equation);
        text +=
            "| parameter | bounds | value without effect | size that matters | meaning |\n"
            "|---|---|---|---|---|\n";
        for (const EffectParameter& p : effect.parameters) {
            text += fmt::format(
                "| `{}` | {} | {} | {} | {} |\n", p.name,
                p.is_switch() ? "0 (off) or 1 (on)" : printed_bounds(p),
                effect.given_by_liquid ? "value in study.toml" : printed_value(p.neutral, p),
                p.is_switch() ? "1" : printed_value(p.smallest_of_interest, p), cell(p.meaning));
        }
        text += "\n";
        for (const auto& source : effect.references) {
            text += fmt::format("- {}\n", source);
        }
    }
    expect_current("effects.md", text);
}

/// Terms of statistics and of the method, which are no quantities.
constexpr std::array<std::array<const char*, 2>, 24> other_terms = {{
    {"atlas", "the simulations that come with Pendular"},
    {"between-run scatter",
     "difference between simulations of equal parameters and different seeds beyond their standard "
     "errors"},
    {"confidence set",
     "the effect sets that explain the residuals equally well at 95 % confidence"},
    {"contact history",
     "numbers that a pair of grains keeps from step to step, such as its "
     "tangential force"},
    {"direct measurement",
     "a measurement of an effect's parameter without shearing grains, such as the torque of the "
     "empty cell"},
    {"discrepancy",
     "relative error that is expected of a model's predictions, other than that of its "
     "simulations"},
    {"effect", "a physical property of instrument, beads, liquid or grains that a model may lack"},
    {"effect set", "the effects that one model contains"},
    {"emulator", "Gaussian processes that predict simulations, trained on simulations"},
    {"fidelity", "size and accuracy of the simulations: quick, standard or paper"},
    {"filling", "beads poured into the cell once; its steps share an error"},
    {"grain", "a sphere of the simulation; beads are what the experimenter pours"},
    {"hyperparameters", "amplitudes and lengths of the emulator's Gaussian processes"},
    {"ladder step", "one state of a study's model: its effects, its fit and its errors"},
    {"lack of fit", "misfit of the means of replicates, beyond their scatter"},
    {"misfit",
     "difference between measured and predicted value over its standard error; chi2 is the "
     "sum of squares, with correlations"},
    {"power", "probability that the readings show an effect of the size that matters"},
    {"reading", "shear stress and solid fraction of one step of steady shear"},
    {"reduction of chi2", "decrease of chi2 when an effect is added to the model"},
    {"replicates", "readings at the same conditions, to 2 %"},
    {"score test", "test of an effect from the residuals, without a refit"},
    {"share imitated by the calibrated parameters",
     "share of an effect's change of the readings that a change of friction can imitate"},
    {"size that matters", "smallest size of an effect that is of interest to the user"},
    {"training simulations", "simulations on which the emulator is trained"},
}};

TEST(ReferencePages, OfTermsHoldTheTableOfQuantities) {
    std::string text =
        "# Terms\n\nGenerated from the table of quantities, `data/quantities/`, and the list of "
        "terms in `tests/app/reference.cpp`. Names are keys of JSON and headers of tables.\n\n## "
        "Quantities\n\n| term | symbol | unit | meaning |\n|---|---|---|---|\n";
    for (const Quantity& q : quantities()) {
        text += fmt::format("| `{}` | {} | {} | {} |\n", q.name, cell(q.symbol), cell(q.unit),
                            cell(q.meaning));
    }
    text += "\n## Other terms\n\n| term | meaning |\n|---|---|\n";
    for (const auto& [term, meaning] : other_terms) {
        text += fmt::format("| {} | {} |\n", term, meaning);
    }
    expect_current("terms.md", text);
}

}  // namespace app_reference_test
