#include "sim/closures/level.h"

namespace pendular::closures {

Level level_of_base(std::string_view base) {
    if (base == "mohr-coulomb") return Level::mohr_coulomb;
    return base == "rumpf" ? Level::strength3 : Level::simulation;
}

}  // namespace pendular::closures
