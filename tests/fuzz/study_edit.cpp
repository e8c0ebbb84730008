// Edits of study.toml: an effect that is added and dropped again leaves the list as it was.
#include "data/study/study_edit.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(fuzz::text_of(data, size));
    fuzz::refuse_or([&] {
        const std::string added = with_effect(text, "study.toml", "torque-offset");
        fuzz::demand(added != text);
        without_effect(added, "study.toml", "torque-offset");
    });
    fuzz::refuse_or([&] { without_effect(text, "study.toml", "lid-slip"); });
    return 0;
}
