#include "python/bindings.h"

// What the package pendular (python/pendular) is made of. Users import that package.
PYBIND11_MODULE(_core, module) {
    using namespace pendular::python;
    module.attr("__version__") = PENDULAR_VERSION;
    bind_errors(module);
    bind_studies(module);
    bind_states(module);
    bind_simulations(module);
    bind_effects(module);
    bind_forward(module);
    bind_files(module);
}
