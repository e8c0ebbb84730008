// Calibrates a study, says what its model lacks, and prints both.
#include <pendular/session.h>
#include <cstdio>

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: calibrate STUDY\n", stderr);
        return 2;
    }
    try {
        const pendular::v1::Session session(arguments[1], {.fidelity = "quick"});
        const auto fit = session.calibrate();
        for (const auto& parameter : fit.parameters) {
            std::printf("%s = %.4f +- %.4f %s\n", parameter.name.c_str(), parameter.value,
                        parameter.standard_error, parameter.unit.c_str());
        }
        for (const auto& doubt : fit.doubts) {
            std::printf("do not use this value: %s\n", doubt.c_str());
        }
        const auto verdict = session.diagnose();
        std::printf("%s: chi2 = %.1f for %d\n", verdict.verdict.c_str(), verdict.chi2,
                    verdict.degrees_of_freedom);
        for (const auto& effect : verdict.effects) {
            std::printf("  %s\n", effect.c_str());
        }
    } catch (const pendular::v1::InputError& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 2;
    }
}
