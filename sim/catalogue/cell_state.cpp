#include "sim/catalogue/cell_state.h"

#include <numbers>

#include "data/grains.h"

namespace pendular {

double CellState::area() const {
    return std::numbers::pi * (outer_radius * outer_radius - inner_radius * inner_radius);
}

double CellState::weight() const {
    return bead_volume * density * gravity;
}

}  // namespace pendular
