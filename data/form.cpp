#include "data/form.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/input_error.h"
#include "data/quantities/nearest.h"

namespace pendular {

const std::vector<std::string>& form_names() {
    static const std::vector<std::string> names = {"derived", "as_printed"};
    return names;
}

const std::string& to_string(Form form) {
    return form_names()[static_cast<std::size_t>(form)];
}

Form form_named(std::string_view name) {
    const auto found = std::ranges::find(form_names(), name);
    if (found == form_names().end()) {
        throw InputError(
            fmt::format("unknown form '{}'; {}", name, did_you_mean(name, form_names())));
    }
    return static_cast<Form>(found - form_names().begin());
}

}  // namespace pendular
