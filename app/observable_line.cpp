#include "app/observable_line.h"

#include <fmt/format.h>

#include "data/quantities/quantity.h"
#include "reports/with_error.h"

namespace pendular::app {

std::string observable_line(dem::Observable which, const Mean& mean) {
    const Quantity& about = quantity(dem::observable_names[static_cast<std::size_t>(which)]);
    return fmt::format("  {:<32} {:<22} {}", about.name,
                       with_error(mean.value, mean.standard_error), about.meaning);
}

}  // namespace pendular::app
