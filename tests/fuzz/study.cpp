// study.toml, with the effects and direct measurements that it states.
#include "data/study/study.h"
#include "sim/catalogue/resolved_study.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto points = fuzz::file_of("points.csv", "normal_stress [Pa]\n1000\n");
    const auto file = fuzz::file_of("study.toml", fuzz::text_of(data, size));
    fuzz::refuse_or([&] { const ResolvedStudy study(read_study(file)); });
    return 0;
}
