// The store of runs: nothing lost, nothing doubled, whoever writes and whatever breaks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <fstream>
#include <random>
#include <set>
#include <thread>

#include "sim/runs/ensemble.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_columns.h"
#include "sim/runs/store/run_store.h"
#include "sim/runs/store/run_table.h"
#include "sim/runs/store/store_file.h"
#include "tests/support/golden.h"

namespace pendular::sim_store_test {

dem::RunParameters small(std::uint64_t seed) {
    return {.friction = 0.2,
            .inertial_number = 0.1,
            .stiffness_number = 300,
            .grains = 64,
            .strain = 0.5,
            .seed = seed};
}

/// A run as large as those of calibrations, without the work.
dem::RunResult invented(std::uint64_t seed, bool wet = false) {
    dem::RunResult run{.parameters = small(seed)};
    if (wet) {
        run.parameters.wetting = {.reduced_pressure = 3, .bridge_volume = 0.002};
    }
    std::mt19937_64 random(seed);
    for (Mean& mean : run.means) {
        mean.value = std::generate_canonical<double, 53>(random);
        mean.standard_error = 0.01 * mean.value;
        mean.correlation_samples = 7;
    }
    run.covariance = -1.25e-7;
    run.steps = 12345;
    run.wall_seconds = 1.5;
    run.steady = true;
    run.trace.assign(400, {0.02F, 1, 1, 1, -0.3F, 0.6F, 5, 0, 0.01F});
    run.final_state.cell = {10, 10, 10, 1};
    run.final_state.grains.assign(1000, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    return run;
}

/// Every column but time is the same.
void expect_same(const dem::RunResult& one, const dem::RunResult& other) {
    for (const RunColumn& column : run_columns()) {
        EXPECT_EQ(column.get(one), column.get(other)) << column.name;
    }
}

std::string integrity(const std::filesystem::path& file) {
    sqlite3* database = nullptr;
    std::string answer = "not opened";
    if (sqlite3_open(file.c_str(), &database) == SQLITE_OK) {
        sqlite3_exec(
            database, "PRAGMA integrity_check",
            [](void* to, int, char** values, char**) {
                *static_cast<std::string*>(to) = values[0];
                return 0;
            },
            &answer, nullptr);
    }
    sqlite3_close(database);
    return answer;
}

TEST(RunStore, GivesRunsBackWhole) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "deep" / "runs.sqlite";
    const dem::RunResult dry = invented(1), wet = invented(2, true);
    {
        RunStore store(file);
        EXPECT_TRUE(store.add(dry));
        EXPECT_TRUE(store.add(wet));
        EXPECT_FALSE(store.add(dry));
    }
    const RunStore store(file, true);
    EXPECT_EQ(store.size(), 2u);
    for (const dem::RunResult& run : {dry, wet}) {
        const auto found = store.find(run.parameters);
        ASSERT_TRUE(found);
        expect_same(*found, run);
    }
    const StoredRun whole = store.get(2);
    EXPECT_EQ(whole.run.trace, wet.trace);
    EXPECT_EQ(whole.run.final_state.grains, wet.final_state.grains);
    EXPECT_EQ(whole.run.final_state.cell.offset, 1);
    EXPECT_EQ(whole.physics_version, dem::physics_version);
    EXPECT_THROW(store.get(3), InputError);
}

TEST(RunStore, TellsRunsApartByAllThatDeterminesThem) {
    const TemporaryFolder folder;
    RunStore store(folder.path() / "runs.sqlite");
    store.add(invented(1));
    const auto without = [&](auto change) {
        dem::RunParameters p = small(1);
        change(p);
        return !store.find(p);
    };
    EXPECT_FALSE(without([](auto&) {}));
    EXPECT_TRUE(without([](auto& p) { p.friction = std::nextafter(p.friction, 1); }));
    EXPECT_TRUE(without([](auto& p) { p.inertial_number *= 2; }));
    EXPECT_TRUE(without([](auto& p) { p.stiffness_number *= 2; }));
    EXPECT_TRUE(without([](auto& p) { p.poisson_ratio = 0.2; }));
    EXPECT_TRUE(without([](auto& p) { p.damping = 0.5; }));
    EXPECT_TRUE(without([](auto& p) { p.grains = 65; }));
    EXPECT_TRUE(without([](auto& p) { p.strain = 1; }));
    EXPECT_TRUE(without([](auto& p) { p.seed = 2; }));
    EXPECT_TRUE(without([](auto& p) { p.start = 2; }));
    EXPECT_TRUE(without([](auto& p) { p.wetting.emplace(); }));
    EXPECT_TRUE(without([](auto& p) { p.effects = {{"polydispersity", {0.1}}}; }));
    EXPECT_TRUE(without([](auto& p) { p.precision = {{dem::Observable::stress_ratio, 0.01}}; }));
    EXPECT_FALSE(store.find(small(1), 2));  // two threads round otherwise
    // A version of the physics of its own.
    EXPECT_TRUE(store.add(invented(1), dem::physics_version + 1));
    EXPECT_EQ(store.size(), 2u);
}

TEST(RunStore, FindsTheNearestFlow) {
    const TemporaryFolder folder;
    RunStore store(folder.path() / "runs.sqlite");
    const auto add = [&](std::uint64_t seed, bool wet, auto change) {
        dem::RunResult run = invented(seed, wet);
        change(run);
        store.add(run);
    };
    EXPECT_FALSE(store.nearest(small(1)));
    add(1, false, [](auto& run) { run.parameters.friction = 0.5; });
    add(2, false, [](auto& run) { run.parameters.inertial_number = 0.2; });
    add(3, false, [](auto& run) { run.crystallised = true; });
    add(4, false, [](auto& run) { run.parameters.grains = 65; });
    add(5, false, [](auto& run) { run.final_state = {}; });
    add(6, true, [](auto&) {});
    const auto found = store.nearest(small(9));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->run.parameters.seed, 2u);
    EXPECT_EQ(found->run.final_state.grains.size(), 1000u);
    dem::RunParameters wet = small(9);
    wet.wetting = {.reduced_pressure = 1, .bridge_volume = 0.002};
    EXPECT_EQ(store.nearest(wet)->run.parameters.seed, 6u);
}

TEST(RunStore, SavesRunsThatAreThere) {
    const TemporaryFolder folder;
    RunStore store(folder.path() / "runs.sqlite");
    store.add(invented(5));  // what no simulation would find
    const auto value = [&](const Workers& workers) {
        return run_all({small(5)}, workers).front()[dem::Observable::stress_ratio].value;
    };
    const double real = value({});
    EXPECT_EQ(value({.store = &store}), invented(5)[dem::Observable::stress_ratio].value);
    EXPECT_EQ(value({.store = &store, .reads_store = false}), real);
    run_all({small(6), small(7)}, {.threads = 2, .store = &store});
    EXPECT_EQ(store.size(), 3u);
    EXPECT_GT(store.get(store.select().back().id).run.trace.size(), 40u);
}

TEST(RunStore, LosesNothingToAHundredKills) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "runs.sqlite";
    { const RunStore store(file); }
    struct Writer {
        pid_t process = 0;
        int acknowledged = -1;  // where it says which seed is stored
        std::uint64_t first = 0;
    };
    const auto start = [&](std::uint64_t first) {
        int ends[2];
        EXPECT_EQ(pipe(ends), 0);
        const pid_t process = fork();
        if (process == 0) {
            close(ends[0]);
            RunStore store(file);
            for (std::uint64_t seed = first;; ++seed) {
                store.add(invented(seed));
                if (write(ends[1], &seed, sizeof seed) < 0) {
                    _exit(1);
                }
            }
        }
        close(ends[1]);
        return Writer{process, ends[0], first};
    };
    std::set<std::uint64_t> acknowledged;
    const auto kill_one = [&](Writer& writer) {
        kill(writer.process, SIGKILL);
        waitpid(writer.process, nullptr, 0);
        for (std::uint64_t seed; read(writer.acknowledged, &seed, sizeof seed) == sizeof seed;) {
            acknowledged.insert(seed);
            writer.first = seed + 1;
        }
        close(writer.acknowledged);
    };
    std::array<Writer, 3> writers = {start(1), start(1'000'000), start(2'000'000)};
    std::mt19937 random(11);
    for (int kills = 0; kills < 100; ++kills) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10 + random() % 30));
        Writer& writer = writers[random() % 3];
        kill_one(writer);
        writer = start(writer.first);  // at the run it was at: stored or not, it may not be doubled
    }
    for (Writer& writer : writers) {
        kill_one(writer);
    }
    EXPECT_EQ(integrity(file), "ok");
    const RunStore store(file, true);
    std::set<std::uint64_t> stored;
    for (const StoredRun& run : store.select()) {
        EXPECT_TRUE(stored.insert(run.run.parameters.seed).second);
    }
    EXPECT_TRUE(std::ranges::includes(stored, acknowledged));
    EXPECT_LE(stored.size(), acknowledged.size() + 103);  // stored, but killed before saying so
    EXPECT_GT(acknowledged.size(), 100u);
    for (const std::uint64_t seed : {*acknowledged.begin(), *acknowledged.rbegin()}) {
        expect_same(*store.find(small(seed)), invented(seed));
    }
    std::printf("%zu runs stored, %zu acknowledged\n", stored.size(), acknowledged.size());
}

TEST(RunStore, KeepsItsRunsWhenTheDiskIsFull) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "runs.sqlite";
    const auto said = folder.path() / "said";
    const pid_t process = fork();
    if (process == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        RunStore store(file);
        const rlimit most{400'000, 400'000};
        setrlimit(RLIMIT_FSIZE, &most);
        std::uint64_t seed = 1;
        try {
            for (;; ++seed) {
                store.add(invented(seed));
            }
        } catch (const std::runtime_error& error) {
            std::ofstream(said) << seed << ' ' << error.what();
        }
        _exit(0);
    }
    waitpid(process, nullptr, 0);
    std::uint64_t failed = 0;
    std::string message;
    std::ifstream stream(said);
    stream >> failed;
    std::getline(stream, message);
    expect_told({message});
    EXPECT_GT(failed, 3u);
    EXPECT_EQ(integrity(file), "ok");
    RunStore store(file, true);
    EXPECT_EQ(store.size(), failed - 1);
    EXPECT_TRUE(store.add(invented(failed)));
}

TEST(RunStore, RefusesWhatIsNoStore) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& name) {
        try {
            RunStore(folder.path() / name, true).select();
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    folder.write("text", std::string(5000, 'x'));
    expect_told({refusal("text"), refusal("nothing")});
    const auto database = [&](const std::string& name, const std::string& commands) {
        sqlite3* made = nullptr;
        sqlite3_open((folder.path() / name).c_str(), &made);
        sqlite3_exec(made, commands.c_str(), nullptr, nullptr, nullptr);
        sqlite3_close(made);
    };
    database("other", "CREATE TABLE photographs (name TEXT)");
    expect_told({refusal("other")});
    { RunStore store(folder.path() / "newer"); }
    database("newer", "PRAGMA user_version = 2");
    expect_told({refusal("newer")});
    {
        RunStore store(folder.path() / "cut");
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            store.add(invented(seed));
        }
    }
    const auto cut = folder.path() / "cut";
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) / 2);
    expect_told({refusal("cut")});
    RunStore store(folder.path() / "good");
    EXPECT_THROW(store.select("frction = 1"), InputError);
}

TEST(RunStore, RefusesAConditionThatFailsOnlyOnRuns) {
    RunStore store(RunStore::in_memory);
    store.add(invented(1));
    // Found by the fuzz target `condition`: both are SQL without an error.
    for (const char* condition : {"load_extension(1)", "abs(-9223372036854775807 - 1)"})
        EXPECT_THROW(store.select(condition), InputError) << condition;
    EXPECT_EQ(store.size(), 1u);
}

// SQLite by itself takes "crystalized" for a text, which is false, so that NOT selects every run.
TEST(RunStore, RefusesAnUnknownColumnInDoubleQuotes) {
    RunStore store(RunStore::in_memory);
    store.add(invented(1));
    expect_told({input_error([&] { store.numbers("NOT \"crystalized\""); })});
    EXPECT_EQ(store.numbers("NOT \"crystallised\"").size(), 1u);
}

// 400 runs, each with each with each with each: 3e10 rows.
TEST(RunStore, EndsAConditionThatJoinsTheRunsWithThemselves) {
    RunStore store(RunStore::in_memory);
    for (std::uint64_t seed = 0; seed < 400; ++seed)
        store.add(invented(seed));
    expect_told({input_error(
        [&] { store.numbers("(SELECT count(*) FROM runs a, runs b, runs c, runs d) > 1"); })});
    EXPECT_EQ(store.numbers("id > 0").size(), 400u);
}

TEST(RunStore, LearnsColumnsItDoesNotHaveYet) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "runs.sqlite";
    { RunStore(file).add(invented(1)); }
    sqlite3* database = nullptr;
    sqlite3_open(file.c_str(), &database);
    EXPECT_EQ(sqlite3_exec(database, "ALTER TABLE runs DROP COLUMN bond_order", nullptr, nullptr,
                           nullptr),
              SQLITE_OK);
    sqlite3_close(database);
    RunStore store(file);
    EXPECT_TRUE(store.find(small(1)));
    EXPECT_TRUE(store.add(invented(2)));
    EXPECT_EQ(store.select("bond_order IS NULL").size(), 1u);
}

TEST(RunStore, ReadsAndContinuesAStoreOfVersion020) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "runs.sqlite";
    std::filesystem::copy(PENDULAR_SOURCE_DIR "/tests/data/stores/runs-0.2.0.sqlite", file);
    RunStore store(file);
    const auto runs = store.select();
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0].physics_version, 1);
    EXPECT_DOUBLE_EQ(runs[0].run.parameters.friction, 0.1);
    EXPECT_NEAR(runs[0].run[dem::Observable::stress_ratio].value, 0.323180700962276, 1e-14);
    // The run itself can be continued from: time series and final state are read.
    const StoredRun whole = store.get(runs[1].id);
    EXPECT_FALSE(whole.run.trace.empty());
    EXPECT_EQ(whole.run.final_state.grains.size(), 100u);
    EXPECT_EQ(store.find(runs[0].run.parameters).has_value(),
              dem::physics_version == runs[0].physics_version);
    EXPECT_TRUE(store.add(invented(1)));
    EXPECT_EQ(RunStore(file, true).size(), 3u);
}

TEST(RunTable, IsReadBackAsItWasWritten) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "runs.csv";
    std::vector<StoredRun> runs = {{1, dem::physics_version, invented(1)},
                                   {2, 7, invented(2, true)}};
    dem::RunResult failed{.parameters = small(3), .failure = "blew up, \"at once\""};
    failed.parameters.precision = {{dem::Observable::stress_ratio, 0.003},
                                   {dem::Observable::solid_fraction, 1e-4}};
    runs.push_back({3, dem::physics_version, failed});
    runs.back().run.means[0].standard_error = std::numeric_limits<double>::infinity();
    write_runs(file, runs);
    const auto back = read_runs(file);
    ASSERT_EQ(back.size(), runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k) {
        EXPECT_EQ(back[k].physics_version, runs[k].physics_version);
        expect_same(back[k].run, runs[k].run);
        EXPECT_EQ(run_description(back[k].run.parameters), run_description(runs[k].run.parameters));
    }
}

TEST(RunStore, KeepsEffectsToTheLastBit) {
    const TemporaryFolder folder;
    dem::RunResult run = invented(1, true);
    run.parameters.effects = {{"rolling-resistance", {0.1 + 1e-17}},
                              {"viscous-bridges", {std::nextafter(1.0 / 3, 1)}},
                              {"willett-bridges", {1}}};
    {
        RunStore store(folder.path() / "runs.sqlite");
        store.add(run);
        store.add(invented(1, true));
        EXPECT_EQ(store.size(), 2u);
    }
    const RunStore store(folder.path() / "runs.sqlite", true);
    const auto found = store.find(run.parameters);
    ASSERT_TRUE(found);
    expect_same(*found, run);
    EXPECT_EQ(found->parameters.effects, run.parameters.effects);
    auto other = run.parameters;
    other.effects[1].values[0] = 1.0 / 3;
    EXPECT_FALSE(store.find(other));
    EXPECT_EQ(store.select("effects IS NULL").size(), 1u);
    EXPECT_EQ(store.select("effects LIKE '%willett%'").size(), 1u);
    // The same through a table.
    write_runs(folder.path() / "runs.csv", store.select());
    const auto back = read_runs(folder.path() / "runs.csv");
    ASSERT_EQ(back.size(), 2u);
    EXPECT_EQ(back[0].run.parameters.effects, run.parameters.effects);
    expect_same(back[0].run, run);
}

TEST(RunTable, IsReadWithoutTheColumnOfEffects) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "runs.csv";
    write_runs(file, {{1, dem::physics_version, invented(1)}});
    std::ifstream stream(file);
    std::string header, row;
    std::getline(stream, header);
    std::getline(stream, row);
    // As an older program wrote it.
    const auto before =
        std::count(header.begin(),
                   header.begin() + static_cast<std::ptrdiff_t>(header.find(",effects,") + 1), ',');
    header.replace(header.find(",effects,"), 9, ",");
    std::size_t at = 0;
    for (auto k = before; k > 0; --k) {
        at = row.find(',', at) + 1;
    }
    row.erase(at, row.find(',', at) + 1 - at);
    folder.write("runs.csv", header + "\n" + row + "\n");
    const auto back = read_runs(file);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_TRUE(back[0].run.parameters.effects.empty());
    expect_same(back[0].run, invented(1));
}

TEST(RunTable, PointsToWhatIsWrong) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "runs.csv";
    write_runs(file, {{1, dem::physics_version, invented(1)}});
    std::ifstream stream(file);
    const std::string good{std::istreambuf_iterator<char>(stream), {}};
    const auto refusal = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        folder.write("runs.csv", text);
        try {
            read_runs(file);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    expect_told(
        {refusal(",friction,", ",frction,"), refusal(",64,", ",many,"), refusal(",64,", ",12,")});
}

TEST(Blob, IsRefusedWhereItIsCutSpoiledOrExpandsTooFar) {
    const std::string bytes = "positions and velocities of grains, 0.25 0.5 0.75";
    const std::string packed = compressed(bytes);
    EXPECT_EQ(expanded(packed), bytes);
    EXPECT_EQ(expanded(compressed("")), "");
    for (std::size_t length = 0; length < packed.size(); ++length)
        EXPECT_THROW(expanded(packed.substr(0, length)), std::runtime_error) << length;
    std::string spoiled = packed;
    spoiled.back() ^= 1;  // of the checksum
    EXPECT_THROW(expanded(spoiled), std::runtime_error);
    EXPECT_THROW(expanded(compressed(std::string(10'000'000, 'x'))), std::runtime_error);
}

}  // namespace pendular::sim_store_test
