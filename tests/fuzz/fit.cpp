// Calibrations that are read back: fit.json, ladder.json and proposed.toml of a study's results.
#include "workflow/json/fit.h"
#include "calib/fit/measured.h"
#include "sim/catalogue/resolved_study.h"
#include "tests/fuzz/support.h"
#include "workflow/proposed_effects.h"
#include "workflow/study_input.h"

using namespace pendular;

namespace {

/// The study that the fit of the corpus was made from.
const StudyInput& input() {
    static const StudyInput read = [] {
        fuzz::file_of("points.csv",
                      "normal_stress [Pa],stress_ratio,solid_fraction,inertial_number\n"
                      "1000,0.25,0.61,0.003\n1000,0.29,0.595,0.03\n"
                      "3000,0.255,0.61,0.003\n3000,0.295,0.594,0.03\n");
        return read_input(
            fuzz::file_of("study.toml",
                          "[grains]\ndiameter = \"500 um\"\ndensity = \"1050 kg/m^3\"\n"
                          "[[readings]]\nfile = \"points.csv\"\n"));
    }();
    return read;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = fuzz::ascii_of(data, size);
    const ResolvedStudy& study = input().study;
    const Measurements& measurements = input().measurements;
    // Each reader gets texts that begin as its files do.
    fuzz::refuse_or([&] {
        if (!text.starts_with('{'))
            read_proposed(fuzz::file_of("proposed.toml", text));
        else if (text.find("rungs") != std::string::npos ||
                 text.find("ladder_steps") != std::string::npos)
            read_ladder(fuzz::file_of("ladder.json", text));
        else
            read_calibration(fuzz::file_of("fit.json", text), study, dry_first(measurements));
    });
    return 0;
}
