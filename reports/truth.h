#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// The truth behind a virtual laboratory's recordings, for people and scripts: what was planned,
/// and of every step its condition and its run, with everything needed to repeat it. The program
/// never reads it.
nlohmann::ordered_json to_json(const LabResult& result);

}  // namespace pendular
