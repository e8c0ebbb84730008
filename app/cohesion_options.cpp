#include "app/cohesion_options.h"

#include <fmt/format.h>

namespace pendular::app {
namespace {

const char* const pressure = "lowest-reduced-pressure";
const char* const rate = "cohesion-inertial-number";

}  // namespace

CohesionLineOptions::CohesionLineOptions(Options& options, const std::string& otherwise) {
    const auto or_default = [&](const std::string& text) {
        return otherwise.empty() ? text : otherwise;
    };
    options.add(pressure, &lowest_reduced_pressure_,
                fmt::format("fit the cohesion only to points with at least this reduced pressure "
                            "P* = a^2 s22/F0 [1], with grain diameter a, normal stress s22 and "
                            "pull-off force F0 of a bridge (default: {})",
                            or_default(fmt::format("{}", lowest_cohesion_pressure))));
    options.add(rate, &inertial_number_,
                fmt::format("inertial number [1] to which the model brings readings before the "
                            "cohesion is fitted; 0: the quasi-static limit (default: {})",
                            or_default("that of the wet readings if they share one, else 0")));
}

bool CohesionLineOptions::given(const Options& options) {
    return options.given(pressure) || options.given(rate);
}

CohesionOptions CohesionLineOptions::stated(const Options& options,
                                            CohesionOptions otherwise) const {
    if (options.given(pressure)) otherwise.lowest_reduced_pressure = lowest_reduced_pressure_;
    if (options.given(rate)) otherwise.inertial_number = inertial_number_;
    check_options(otherwise);
    return otherwise;
}

}  // namespace pendular::app
