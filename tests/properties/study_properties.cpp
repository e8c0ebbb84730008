// Laws of what is read and written, for studies, tables and stores that nobody thought of:
// rapidcheck makes them. Seeds are fixed (RC_PARAMS, tests/CMakeLists.txt), so that a failure
// repeats.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "data/quantities/units.h"
#include "data/recordings/measurements.h"
#include "data/study/study.h"
#include "data/study/study_edit.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_store.h"
#include "sim/runs/store/run_table.h"
#include "tests/support/data_support.h"

namespace pendular::properties_test {

namespace fs = std::filesystem;

/// A number of ordinary size with at most six digits, so that its text reads back as the same
/// number.
rc::Gen<double> ordinary(double from, double to) {
    return rc::gen::map(rc::gen::inRange(0, 1'000'000),
                        [=](int k) { return from + (to - from) * k / 1e6; });
}

/// Spellings of a unit with the unit's size in SI.
using Spellings = std::vector<std::pair<std::string, double>>;

const Spellings lengths = {{"m", 1}, {"mm", 1e-3}, {"um", 1e-6}, {"cm", 1e-2}, {"µm", 1e-6}};
const Spellings densities = {{"kg/m^3", 1}, {"g/cm^3", 1e3}, {"kg m-3", 1}, {"g/l", 1}};
const Spellings pressures = {{"Pa", 1}, {"kPa", 1e3}, {"mbar", 1e2}, {"N/m^2", 1}};

rc::Gen<std::pair<std::string, double>> spelling(const Spellings& spellings) {
    return rc::gen::elementOf(spellings);
}

RC_GTEST_PROP(StudyProperty, QuantitiesAreReadBackInEveryUnit, ()) {
    const double diameter = *ordinary(1e-5, 1e-2), density = *ordinary(100, 9000);
    const auto [length, metres] = *spelling(lengths);
    const auto [unit, factor] = *spelling(densities);
    const TemporaryFolder folder;
    folder.write("points.csv", "normal_stress [Pa]\n1\n");
    folder.write("study.toml", fmt::format("[grains]\ndiameter = \"{} {}\"\ndensity = \"{} {}\"\n"
                                           "[[readings]]\nfile = \"points.csv\"\n",
                                           diameter / metres, length, density / factor, unit));
    const Study study = read_study(folder.path());
    RC_ASSERT(std::abs(study.grains.diameter / diameter - 1) < 1e-12);
    RC_ASSERT(std::abs(study.grains.density / density - 1) < 1e-12);
}

/// A list of effects as people lay it out, and the text around it.
rc::Gen<std::string> study_text() {
    return rc::gen::exec([] {
        std::vector<std::string> names = {"lid-slip", "grain-weight", "bead-loss"};
        std::erase_if(names, [](const std::string&) { return *rc::gen::arbitrary<bool>(); });
        const std::string quote = *rc::gen::element<std::string>("\"", "'");
        const std::string end = *rc::gen::element<std::string>("\n", "\r\n");
        const bool lines = *rc::gen::arbitrary<bool>() && !names.empty();
        const bool last_comma = *rc::gen::arbitrary<bool>() && lines;
        std::string list = "[";
        for (std::size_t k = 0; k < names.size(); ++k) {
            const bool comma = k + 1 < names.size() || last_comma;
            list += lines ? end + "  " : k > 0 ? " " : "";
            list += quote + names[k] + quote + (comma ? "," : "");
            if (lines && *rc::gen::arbitrary<bool>()) list += "  # why";
        }
        if (names.empty()) list += *rc::gen::element<std::string>("", " ", "  ");
        list += lines ? end + "]" : "]";
        const std::string comment = *rc::gen::element<std::string>("", "  # a comment");
        const std::string before = *rc::gen::element<std::string>("", "base = \"dem\"  # yes");
        const std::string after = *rc::gen::element<std::string>("", "[grains]  # [\"");
        std::string text = "# a study, µ" + end + "[model]" + end;
        if (!before.empty()) text += before + end;
        return text + "effects = " + list + comment + end + after + end;
    });
}

RC_GTEST_PROP(StudyProperty, AnEffectAddedAndDroppedLeavesEveryByte, ()) {
    const std::string text = *study_text();
    const std::string added = with_effect(text, "study.toml", "torque-offset");
    RC_ASSERT(added != text);
    RC_ASSERT(without_effect(added, "study.toml", "torque-offset") == text);
}

/// A table of readings: for every column its name, unit and numbers.
struct Column {
    std::string name, unit;
    std::vector<double> numbers;
};

std::string table_text(const std::vector<Column>& columns, char delimiter) {
    std::string text;
    const auto row = [&](const auto& cell) {
        for (std::size_t k = 0; k < columns.size(); ++k)
            text += (k > 0 ? std::string(1, delimiter) : "") + cell(columns[k]);
        text += '\n';
    };
    row([](const Column& c) { return fmt::format("{} [{}]", c.name, c.unit); });
    for (std::size_t r = 0; r < columns.front().numbers.size(); ++r)
        row([&](const Column& c) { return fmt::format("{}", c.numbers[r]); });
    return text;
}

std::vector<Reading> readings_of(const std::string& table) {
    const TemporaryFolder folder;
    folder.write("points.csv", table);
    folder.write("study.toml", grains_table + points_table);
    const Study study = read_study(folder.path());
    return read_points(study.sources.front().files.front(), study.sources.front(), study).readings;
}

RC_GTEST_PROP(TableProperty, OrderOfColumnsUnitsAndDelimitersDoNotMatter, ()) {
    const auto rows = static_cast<std::size_t>(*rc::gen::inRange(1, 6));
    const auto numbers = [&](double from, double to) {
        return *rc::gen::container<std::vector<double>>(rows, ordinary(from, to));
    };
    const std::vector<Column> plain = {{"normal_stress", "Pa", numbers(100, 5000)},
                                       {"shear_stress", "Pa", numbers(20, 2000)},
                                       {"solid_fraction", "1", numbers(0.5, 0.64)},
                                       {"inertial_number", "1", numbers(1e-3, 0.1)}};
    std::vector<Column> other = plain;
    for (const std::size_t k : {0, 1}) {
        const auto [unit, size] = *spelling(pressures);
        other[k].unit = unit;
        for (double& number : other[k].numbers)
            number /= size;
    }
    for (std::size_t k = other.size(); k > 1; --k)
        std::swap(other[k - 1],
                  other[static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(k)))]);
    const char delimiter = *rc::gen::element(',', ';', '\t');
    const auto first = readings_of(table_text(plain, ',')),
               second = readings_of(table_text(other, delimiter));
    RC_ASSERT(first.size() == second.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
        RC_ASSERT((first[k].value - second[k].value).norm() < 1e-9 * first[k].value.norm());
        RC_ASSERT(std::abs(first[k].condition.normal_stress / second[k].condition.normal_stress -
                           1) < 1e-12);
        RC_ASSERT(first[k].condition.inertial_number == second[k].condition.inertial_number);
    }
}

/// A run that was not simulated, told from others by its seed.
dem::RunResult invented(int seed) {
    dem::RunResult run;
    run.parameters.seed = static_cast<std::uint64_t>(seed);
    run[dem::Observable::stress_ratio];
    run.means[0] = {.value = 0.1 * seed, .standard_error = 0.01};
    return run;
}

void fill(RunStore& store, const std::vector<int>& seeds) {
    for (const int seed : seeds)
        store.add(invented(seed));
}

/// Fingerprints of all runs of a store, which leave out their numbers there.
std::vector<std::string> content(const RunStore& store) {
    std::vector<std::string> prints;
    for (const StoredRun& run : store.select())
        prints.push_back(run_fingerprint(run));
    std::ranges::sort(prints);
    return prints;
}

RC_GTEST_PROP(StoreProperty, MergingIsCommutativeAndIdempotent, ()) {
    const auto seeds = rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 12));
    const std::vector<int> a = *seeds, b = *seeds;
    RunStore first(RunStore::in_memory), second(RunStore::in_memory), other(RunStore::in_memory);
    fill(first, a);
    fill(second, b);
    fill(other, a);
    const std::size_t before = first.size();
    const std::size_t added = first.merge(second);
    RC_ASSERT(first.size() == before + added);
    second.merge(other);
    RC_ASSERT(content(first) == content(second));
    RC_ASSERT(first.merge(second) == 0u);
    RC_ASSERT(first.merge(other) == 0u);
}

RC_GTEST_PROP(TableOfRunsProperty, IsReadBackAsItWasWritten, ()) {
    RunStore store(RunStore::in_memory);
    fill(store, *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 99))));
    const TemporaryFolder folder;
    write_runs(folder.path() / "runs.csv", store.select());
    RunStore again(RunStore::in_memory);
    for (const StoredRun& run : read_runs(folder.path() / "runs.csv"))
        again.add(run.run, run.physics_version);
    RC_ASSERT(content(again) == content(store));
}

}  // namespace pendular::properties_test
