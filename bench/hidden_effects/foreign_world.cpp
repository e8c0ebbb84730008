#include "bench/hidden_effects/foreign_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "bench/hidden_effects/rig.h"
#include "data/files/csv.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular::bench {
namespace {

/// Which states a world's recordings show, by the names in states.csv.
struct Composition {
    std::string_view name;
    Truth::Kind kind;
    std::string_view hidden;  ///< effect of the catalogue, if it has one
    double friction;
    std::string_view dry, wet;  ///< empty: no wet recordings
};

constexpr std::array compositions = {
    Composition{"dry plain", Truth::Kind::complete, "", 0.11, "plain", ""},
    Composition{"dry rolling", Truth::Kind::effect, "rolling-resistance", 0.4, "rolling", ""},
    Composition{"dry adhesion", Truth::Kind::effect, "dry-adhesion", 0.11, "adhesion", ""},
    Composition{"dry polydispersity", Truth::Kind::effect, "polydispersity", 0.11, "polydispersity",
                ""},
    Composition{"wet plain", Truth::Kind::complete, "", 0.11, "plain", "wet"},
    Composition{"wet adhesion", Truth::Kind::effect, "dry-adhesion", 0.11, "adhesion", "wet"},
    Composition{"reversible bridges", Truth::Kind::effect, "reversible-bridges", 0.11, "plain",
                "wet-reversible"},
    Composition{"constant bridge force", Truth::Kind::outside, "", 0.11, "plain", "wet-constant"},
    Composition{"wet plain, dry of YADE", Truth::Kind::complete, "", 0.11, "plain-yade", "wet"}};

/// Stands for a difference that the catalogue does not have.
const Effect& effect_outside_catalogue() {
    static const Effect effect{.name = "outside-the-catalogue"};
    return effect;
}

Truth truth_of(const Composition& world) {
    Truth truth{.kind = world.kind, .name = std::string(world.name), .hidden = {}};
    truth.friction = world.friction;
    if (world.kind == Truth::Kind::effect) {
        truth.hidden = {{&built_in_effect(std::string(world.hidden)), {}}};
    } else if (world.kind == Truth::Kind::outside) {
        truth.hidden = {{&effect_outside_catalogue(), {}}};
    }
    return truth;
}

/// The table of states, by the names of its columns.
class States {
  public:
    explicit States(const std::filesystem::path& file) : table_(read_table(file)) {}

    /// Mean stress ratio and solid fraction of one recorded step; none: not simulated.
    std::optional<std::array<Mean, 2>> at(std::string_view world, const Condition& condition,
                                          int replicate) const {
        const auto found = std::ranges::find_if(table_.rows, [&](const Row& row) {
            const auto is = [&](const char* name, double value) {
                return std::abs(number(row, name) - value) < 1e-6 * std::abs(value) + 1e-12;
            };
            return row.cells[column("world")].text == world &&
                   is("normal_stress [Pa]", condition.normal_stress) &&
                   is("liquid_content [1]", condition.liquid_content) &&
                   is("inertial_number [1]", condition.inertial_number) &&
                   is("replicate", replicate);
        });
        if (found == table_.rows.end()) return {};
        return std::array{mean(*found, "stress_ratio"), mean(*found, "solid_fraction")};
    }

  private:
    std::size_t column(std::string_view name) const {
        const auto& cells = table_.header.cells;
        const auto found = std::ranges::find(cells, name, &Cell::text);
        if (found == cells.end()) {
            throw InputError({table_.file}, fmt::format("there is no column '{}'", name));
        }
        return static_cast<std::size_t>(found - cells.begin());
    }
    double number(const Row& row, std::string_view name) const {
        const std::size_t at = column(name);
        const auto value = parse_number(row.cells[at].text);
        if (!value) {
            throw InputError(table_.at(row, at),
                             fmt::format("'{}' is no number", row.cells[at].text));
        }
        return *value;
    }
    Mean mean(const Row& row, std::string_view name) const {
        return {.value = number(row, fmt::format("{} [1]", name)),
                .standard_error = number(row, fmt::format("{}_stderr [1]", name))};
    }

    Table table_;
};

/// None where a state is missing.
std::optional<LabResult> laboratory_of(const Composition& world, const States& states) {
    LabResult laboratory{.plan = rig(world.friction, 1)};
    // Its grains have the stiffness number of this fidelity.
    laboratory.plan.fidelity = fidelity_named("quick");
    if (world.wet.empty()) laboratory.plan.liquid_contents.clear();
    for (const PlannedRecording& planned : recordings_of(laboratory.plan)) {
        LabRecording recording{.file = planned.file,
                               .liquid_content = planned.liquid_content,
                               .replicate = planned.replicate,
                               .seed = planned.seed,
                               .steps = {}};
        for (const Condition& condition : planned.conditions) {
            const auto state = states.at(planned.liquid_content > 0 ? world.wet : world.dry,
                                         condition, planned.replicate);
            if (!state) return {};
            LabStep step{.condition = condition, .imposed = condition, .run = {}};
            using enum dem::Observable;
            step.run.means[static_cast<std::size_t>(stress_ratio)] = (*state)[0];
            step.run.means[static_cast<std::size_t>(solid_fraction)] = (*state)[1];
            recording.steps.push_back(std::move(step));
        }
        laboratory.recordings.push_back(std::move(recording));
    }
    return laboratory;
}

}  // namespace

std::vector<ForeignWorld> read_foreign_worlds(const std::filesystem::path& file) {
    const States states(file);
    std::vector<ForeignWorld> worlds;
    for (const Composition& world : compositions) {
        if (std::optional<LabResult> laboratory = laboratory_of(world, states)) {
            worlds.push_back({truth_of(world), std::move(*laboratory)});
        }
    }
    return worlds;
}

}  // namespace pendular::bench
