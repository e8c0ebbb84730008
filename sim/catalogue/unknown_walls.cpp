#include "sim/catalogue/unknown_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "data/sheared_layer.h"
#include "data/wall_layers.h"

namespace pendular {
namespace {

constexpr const char* effect_of_friction = "shear-localisation";
constexpr const char* effect_of_layers = "wall-layers";

/// Root mean square of what walls mobilise whose friction is anything from 0 to the largest [1],
/// 0.088: the same as of a wall of friction 0.15.
double rms_mobilised() {
    constexpr int parts = 300;  // the integral changes by less than 1e-4 of itself with more
    double squares = 0;
    for (int k = 0; k < parts; ++k) {
        const double friction = largest_unknown_wall_friction * (k + 0.5) / parts;
        squares += std::pow(mobilised(friction), 2) / parts;
    }
    return std::sqrt(squares);
}

UnknownOfWalls of_friction() {
    const auto effect =
        std::ranges::find(built_in_effects(), std::string(effect_of_friction), &Effect::name);
    return {std::string(unknown_wall_friction), rms_mobilised(), &*effect};
}

UnknownOfWalls of_layers() {
    // `wall-layers` itself is a switch, of which no share can be fitted.
    static const Effect share = {.name = effect_of_layers,
                                 .summary = {},
                                 .equation = {},
                                 .parameters = {{.name = "error", .lower = 0, .upper = 1}},
                                 .change = ChangeInstrument{[](CellState state, const Values& v) {
                                     const double width = state.width() / state.diameter;
                                     state.torque *=
                                         1 - v["error"] * strength_lost_beside_walls(width);
                                     return state;
                                 }}};
    constexpr double of_0_to_1 = std::numbers::inv_sqrt3;
    return {share.name, of_0_to_1, &share};
}

bool knows_wall_friction(const Study& study) {
    return study.cell->wall_friction ||
           std::ranges::any_of(study.instrument.stated, is_of_wall_friction,
                               &StatedUncertainty::name) ||
           std::ranges::any_of(study.direct, [](const StatedDirect& each) {
               return is_of_wall_friction(each.effect) && !each.value.empty();
           });
}

}  // namespace

bool is_of_wall_friction(const std::string& effect) {
    return effect == effect_of_friction || effect == "wall-friction";
}

bool is_unknown_of_walls(std::string_view error) {
    return error == unknown_wall_friction || error == effect_of_layers;
}

std::vector<UnknownOfWalls> unknown_of_walls(const Study& study) {
    if (!study.cell) return {};
    const double width = study.cell->outer_radius - study.cell->inner_radius;
    if (!walls_are_close(width / study.grains.diameter)) return {};
    std::vector<UnknownOfWalls> all;
    if (!knows_wall_friction(study)) all.push_back(of_friction());
    all.push_back(of_layers());
    return all;
}

}  // namespace pendular
