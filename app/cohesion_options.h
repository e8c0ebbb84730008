#pragma once

#include "app/options.h"
#include "calib/fit/cohesion_lines.h"

namespace pendular::app {

/// Options of the lines from which the cohesion follows: --lowest-reduced-pressure and
/// --cohesion-inertial-number.
class CohesionLineOptions {
  public:
    /// @param otherwise effect of leaving the options out, for the help: "as calibrated"; empty:
    ///        the defaults of `CohesionOptions`
    CohesionLineOptions(Options& options, const std::string& otherwise = {});
    /// Whether the command line has one of the options.
    static bool given(const Options& options);
    /// Returns the stated options in place of those of `otherwise`.
    /// @throws InputError if one is out of its range
    CohesionOptions stated(const Options& options, CohesionOptions otherwise = {}) const;

  private:
    double lowest_reduced_pressure_ = lowest_cohesion_pressure, inertial_number_ = 0;
};

}  // namespace pendular::app
