// `pendular campaign` and `pendular runs`, as their users meet them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <regex>

#include <nlohmann/json.hpp>

#include "sim/dem/archive.h"
#include "sim/runs/campaign.h"
#include "sim/runs/run_checkpoints.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_columns.h"
#include "sim/runs/store/run_store.h"
#include "tests/support/app_support.h"

namespace app_campaign_test {

using pendular::RunStore;
using pendular::StoredRun;
using pendular::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;
using nlohmann::json;

const std::string eight_runs =
    "[[grid]]\nfriction = [0.1, 0.3]\ninertial_number = [0.05, 0.1]\nrepeats = 2\nbeads = 100\n"
    "strain = 1\nstiffness_number = 300\n";

/// Starts `pendular` with these words and goes on.
pid_t start_pendular(const std::string& words) {
    const pid_t child = fork();
    if (child == 0) {
        const std::string command =
            fmt::format("exec {} {} >/dev/null 2>&1", PENDULAR_PROGRAM, words);
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    return child;
}

/// Everything but times of the runs of a store, by what determines them.
std::map<std::string, std::vector<pendular::RunCell>> content_of_store(const fs::path& file) {
    std::map<std::string, std::vector<pendular::RunCell>> content;
    const RunStore store(file, true);
    for (const StoredRun& listed : store.select()) {
        auto& cells = content[pendular::run_description(listed.run.parameters)];
        for (const auto& column : pendular::run_columns()) {
            if (column.name != "wall_seconds") {
                cells.push_back(column.get(listed.run));
            }
        }
        const StoredRun whole = store.get(listed.id);
        cells.emplace_back(static_cast<double>(whole.run.trace.back().solid_fraction));
        cells.emplace_back(static_cast<double>(whole.run.final_state.grains.back()[0]));
    }
    return content;
}

/// Carries the campaign out in one go.
fs::path whole(const TemporaryFolder& folder) {
    const fs::path file = folder.path() / "whole.sqlite";
    const Outcome run =
        run_pendular(fmt::format("campaign {} --quiet --threads 2 --store {}",
                                 folder.write("runs.toml", eight_runs).string(), file.string()));
    EXPECT_EQ(run.code, 0) << run.errors;
    return file;
}

TEST(CampaignCommand, GoesOnWhereItWasStopped) {
    const TemporaryFolder folder;
    const fs::path expected = whole(folder), part = folder.path() / "part.sqlite";
    const std::string words = fmt::format("campaign {} --quiet --threads 1 --store {}",
                                          (folder.path() / "runs.toml").string(), part.string());
    // Killed once the store holds one run, two and three.
    const auto stored = [&] { return fs::exists(part) ? RunStore(part).size() : 0; };
    for (std::size_t wanted = 1; wanted <= 3; ++wanted) {
        const pid_t campaign = start_pendular(words);
        while (stored() < wanted && waitpid(campaign, nullptr, WNOHANG) == 0) {
            usleep(5000);
        }
        kill(campaign, SIGKILL);
        waitpid(campaign, nullptr, 0);
    }
    const std::size_t before = stored();
    EXPECT_GE(before, 3u);
    const Outcome last = run_pendular(words + " --json -");
    EXPECT_EQ(last.code, 0) << last.errors;
    EXPECT_EQ(json::parse(last.output)["new"], 8 - before);
    EXPECT_EQ(content_of_store(part), content_of_store(expected));
    expect_told({run_pendular(words).output});
}

// One run of some seconds, stopped by each signal: it goes on from its checkpoint,
// with the result of a run that was not stopped.
TEST(CampaignCommand, GoesOnWithinARunThatWasStopped) {
    const TemporaryFolder folder;
    const std::string file =
        folder
            .write("long.toml",
                   "[[grid]]\nfriction = 0.2\ninertial_number = 0.05\nstiffness_number = 1000\n"
                   "beads = 500\nstrain = 20\n")
            .string();
    const fs::path expected = folder.path() / "whole.sqlite", part = folder.path() / "part.sqlite",
                   unfinished = folder.path() / "part.sqlite.unfinished";
    const auto words = [&](const fs::path& store) {
        return fmt::format("campaign {} --quiet --threads 1 --store {}", file, store.string());
    };
    ASSERT_EQ(run_pendular(words(expected)).code, 0);
    EXPECT_FALSE(fs::exists(expected.string() + ".unfinished"));
    const double whole_seconds = RunStore(expected).select().front().run.wall_seconds;
    for (const int signal : {SIGINT, SIGTERM}) {
        const pid_t campaign = start_pendular(words(part));
        // Early in the run, which another load may make faster than the one before.
        usleep(static_cast<useconds_t>(0.1e6 * whole_seconds) + 300'000);
        kill(campaign, signal);
        waitpid(campaign, nullptr, 0);
        ASSERT_EQ(RunStore(part).size(), 0u) << "the run is too short to be stopped";
        ASSERT_FALSE(fs::is_empty(unfinished));
    }
    ASSERT_EQ(run_pendular(words(part)).code, 0);
    EXPECT_EQ(content_of_store(part), content_of_store(expected));
    EXPECT_FALSE(fs::exists(unfinished));
    EXPECT_TRUE(pendular::dem::archived(RunStore(part).get(1).run.trace) ==
                pendular::dem::archived(RunStore(expected).get(1).run.trace));
}

TEST(CampaignCommand, BeginsARunAnewWhoseCheckpointCannotBeRead) {
    const TemporaryFolder folder;
    const fs::path expected = whole(folder), part = folder.path() / "part.sqlite";
    const fs::path unfinished = part.string() + ".unfinished";
    const auto runs =
        pendular::read_campaign(folder.path() / "runs.toml", pendular::fidelity_named("standard"));
    fs::create_directory(unfinished);
    const pendular::RunCheckpoints checkpoints(part);
    for (const auto& run : runs)
        std::ofstream(checkpoints.file_of(run)) << "spoiled";
    ASSERT_EQ(run_pendular(fmt::format("campaign {} --quiet --store {}",
                                       (folder.path() / "runs.toml").string(), part.string()))
                  .code,
              0);
    EXPECT_EQ(content_of_store(part), content_of_store(expected));
    EXPECT_FALSE(fs::exists(unfinished));
}

TEST(CampaignCommand, TakesWhatATableDoesNotStateFromTheFidelity) {
    const TemporaryFolder folder;
    const std::string file =
        folder
            .write("few.toml",
                   "[[grid]]\nfriction = 0.2\n[[grid]]\nfriction = 0.3\nbeads = 123\n"
                   "strain = 2\nstiffness_number = 400\ninertial_number = 0.2\n")
            .string();
    const auto runs = pendular::read_campaign(file, pendular::fidelity_named("paper"));
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0].grains, 4000);
    EXPECT_EQ(runs[0].stiffness_number, 8400);
    EXPECT_EQ(runs[0].inertial_number, 1e-3);
    EXPECT_EQ(runs[0].strain, 20);
    EXPECT_EQ(runs[1].grains, 123);
    EXPECT_EQ(runs[1].stiffness_number, 400);
    EXPECT_EQ(runs[1].inertial_number, 0.2);
    EXPECT_EQ(runs[1].strain, 2);
    // The command passes the option on: the settings show in the estimated duration.
    const auto seconds = [&](const std::string& fidelity) {
        return json_of("campaign " + file + " --dry-run --fidelity " + fidelity + " --store " +
                       (folder.path() / "none.sqlite").string())["estimated_seconds"]
            .get<double>();
    };
    EXPECT_GT(seconds("paper"), 5 * seconds("quick"));
}

TEST(CampaignCommand, MayBeginTwiceAtOnce) {
    const TemporaryFolder folder;
    const fs::path expected = whole(folder), both = folder.path() / "both.sqlite";
    const std::string words = fmt::format("campaign {} --quiet --threads 1 --store {}",
                                          (folder.path() / "runs.toml").string(), both.string());
    const pid_t other = start_pendular(words);
    EXPECT_EQ(run_pendular(words).code, 0);
    int status = -1;
    waitpid(other, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(content_of_store(both), content_of_store(expected));
}

TEST(CampaignCommand, SaysHowToGoOn) {
    const TemporaryFolder folder;
    const std::string store = (folder.path() / "runs.sqlite").string();
    // The signal comes once the store is there.
    const std::string command = fmt::format(
        "{} campaign {} --quiet --store {} 2>{} & while kill -0 $! && ! test -e {}; do sleep "
        "0.02; done 2>/dev/null; kill -INT $!; wait $!",
        PENDULAR_PROGRAM, folder.write("runs.toml", "[[grid]]\nstrain = 500\n").string(), store,
        (folder.path() / "err").string(), store);
    EXPECT_EQ(WEXITSTATUS(std::system(("bash -c '" + command + "'").c_str())), 130);
    expect_told({content_of(folder.path() / "err")});
}

TEST(CampaignCommand, IsTheSameInSharesAndUnderMpi) {
    const TemporaryFolder folder;
    const fs::path expected = whole(folder), merged = folder.path() / "merged.sqlite",
                   mpi = folder.path() / "mpi.sqlite";
    const std::string file = (folder.path() / "runs.toml").string();
    std::string shares;
    for (const std::string share : {"1", "2", "3"}) {
        const std::string store = (folder.path() / share).string();
        EXPECT_EQ(run_pendular(fmt::format("campaign {} --quiet --shard {}/3 --store {}", file,
                                           share, store))
                      .code,
                  0);
        shares += " " + store;
    }
    const Outcome merge =
        run_pendular(fmt::format("runs merge{} --store {} --json -", shares, merged.string()));
    EXPECT_EQ(json::parse(merge.output)["added"], 8);
    EXPECT_EQ(content_of_store(merged), content_of_store(expected));

    // Memory that MPI keeps to its end is no leak of this program.
    const std::string started = fmt::format(
        "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ASAN_OPTIONS=detect_leaks=0 "
        "mpirun --oversubscribe -n 3 {} campaign {} --quiet --store {} >{} 2>&1",
        PENDULAR_PROGRAM, file, mpi.string(), (folder.path() / "said").string());
    EXPECT_EQ(WEXITSTATUS(std::system(started.c_str())), 0) << content_of(folder.path() / "said");
    EXPECT_THAT(content_of(folder.path() / "said"), HasSubstr("8 of 8 simulations"));
    EXPECT_EQ(content_of_store(mpi), content_of_store(expected));
}

TEST(CampaignCommand, EndsAllProcessesWhereTheManagerFails) {
    const TemporaryFolder folder;
    const std::string store = folder.write("no-store", std::string(5000, 'x')).string();
    const std::string started = fmt::format(
        "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ASAN_OPTIONS=detect_leaks=0 "
        "timeout 60 mpirun --oversubscribe -n 3 {} campaign {} --quiet --store {} >{} 2>&1",
        PENDULAR_PROGRAM, folder.write("runs.toml", eight_runs).string(), store,
        (folder.path() / "said").string());
    EXPECT_EQ(WEXITSTATUS(std::system(started.c_str())), 2);
    EXPECT_THAT(content_of(folder.path() / "said"), HasSubstr("is no store of runs"));
}

TEST(CampaignCommand, RefusesBeforeItSimulates) {
    const TemporaryFolder folder;
    const auto campaign = [&](const std::string& name, const std::string& text) {
        return "campaign " + folder.write(name, text).string() + " ";
    };
    const std::string runs = campaign("runs.toml", eight_runs);
    expect_refused({campaign("few.toml", "[[grid]]\nbeads = 12\n"),
                    campaign("gird.toml", "[[gird]]\nbeads = 100\n"), runs + "--shard 3/2",
                    runs + "--shard 2/3x", runs + "--store /"});
    EXPECT_EQ(run_pendular("campaign /nowhere.toml").code, 2);
}

// The store may be missing: --atlas reads the simulations that come with the program.
TEST(RunsCommand, ShowsAndComparesSimulationsOfTheAtlas) {
    const TemporaryFolder folder;
    const std::string no_store = " --store " + (folder.path() / "none.sqlite").string();
    const json list = json::parse(run_pendular("runs list --atlas --json -" + no_store).output);
    const json shown = json::parse(run_pendular("runs show 2 --atlas --json -" + no_store).output);
    EXPECT_EQ(shown["runs"][0], list["runs"][1]);
    const Outcome compared = run_pendular("runs compare 1 2 --atlas" + no_store);
    EXPECT_EQ(compared.code, 0) << compared.errors;
    expect_told({compared.output});
    expect_refused({"runs show 100000 --atlas" + no_store});
    EXPECT_FALSE(fs::exists(folder.path() / "none.sqlite"));
}

TEST(RunsCommand, NeverChangesTheAtlas) {
    const TemporaryFolder folder;
    const std::string store = " --store " + whole(folder).string();
    expect_refused({"runs prune --where 1 --yes --atlas" + store,
                    "runs import runs.csv --atlas" + store, "runs merge a.sqlite --atlas" + store});
    EXPECT_EQ(json_of("runs list" + store)["runs"].size(), 8u);
}

TEST(RunsCommand, LooksAfterTheStore) {
    const TemporaryFolder folder;
    const std::string store = " --store " + whole(folder).string();
    EXPECT_EQ(json_of("runs list --where \"friction = 0.1\"" + store)["runs"].size(), 4u);
    const Outcome two = run_pendular("runs compare 1 2 --json -" + store);
    EXPECT_TRUE(json::parse(two.output)["observables"].contains("stress_ratio"));

    const std::string out = " --out " + folder.path().string();
    const Outcome one = run_pendular("runs show 3 --json -" + store + out);
    EXPECT_EQ(json::parse(one.output)["runs"][0]["id"], 3);
    EXPECT_TRUE(fs::exists(folder.path() / "figures" / "run_3.png"));
    EXPECT_EQ(run_pendular("runs plot --x friction --y solid_fraction" + store + out).code, 0);
    EXPECT_TRUE(fs::exists(folder.path() / "solid_fraction_by_friction.png"));

    const std::string table = (folder.path() / "runs.csv").string(),
                      other = " --store " + (folder.path() / "other.sqlite").string();
    EXPECT_EQ(run_pendular("runs export " + table + store).code, 0);
    expect_told({run_pendular("runs import " + table + other).output});
    expect_told(
        {run_pendular("runs learn --quiet " + (folder.path() / "emulator.csv").string() + store)
             .output});
    EXPECT_THAT(content_of(folder.path() / "emulator.csv"), HasSubstr("stress_ratio"));
    expect_told({run_pendular("runs prune --where \"friction = 0.1\"" + other).output,
                 run_pendular("runs prune --yes --where \"friction = 0.1\"" + other).output});

    expect_refused({"runs" + store, "runs lst" + store, "runs show 99" + store,
                    "runs show x" + store, "runs plot --y stres_ratio" + store,
                    "runs list --where \"a b\"" + store, "runs prune" + store,
                    "runs learn" + store});
}

TEST(RunsCommand, MakesNoStoreWhereItOnlyReads) {
    const TemporaryFolder folder;
    const fs::path store = folder.path() / "nope.sqlite", table = folder.path() / "runs.csv";
    for (const std::string& words :
         {std::string("list"), std::string("show 1"), std::string("compare 1 2"),
          std::string("plot"), "export " + table.string(),
          std::string("prune --where \"crystallised\" --yes"),
          "learn " + (folder.path() / "emulator.csv").string(),
          "merge " + (folder.path() / "other.sqlite").string(),
          "import " + (folder.path() / "other.csv").string()}) {
        expect_refused(
            {"runs " + words + " --store " + store.string() + " --out " + folder.path().string()});
        EXPECT_FALSE(fs::exists(store)) << words;
        EXPECT_FALSE(fs::exists(table)) << words;
    }
}

TEST(CampaignCommand, EstimatesItsDurationWithoutMakingAStore) {
    const TemporaryFolder folder;
    const fs::path store = folder.path() / "new.sqlite";
    const std::string words =
        fmt::format("campaign {} --threads 1 --dry-run --json - --store ",
                    folder
                        .write("more.toml", eight_runs + "[[grid]]\nfriction = 0.2\nstrain = "
                                                         "2\ninertial_number = 0.05\nbeads = "
                                                         "1000\nstiffness_number = 300\n")
                        .string());
    const Outcome fresh = run_pendular(words + store.string());
    ASSERT_EQ(fresh.code, 0) << fresh.errors;
    EXPECT_FALSE(fs::exists(store));
    EXPECT_GT(json::parse(fresh.output)["estimated_seconds"], 0);
    const Outcome rest = run_pendular(words + whole(folder).string());
    const std::regex duration("about [0-9.]+ [a-z]+");
    expect_told({std::regex_replace(fresh.errors + rest.errors, duration, "about N s")});
}

TEST(Simulate, StartsFromARandomSampleWhereTheStoreHasNone) {
    const TemporaryFolder folder;
    const std::string words =
        "simulate --quiet --beads 100 --stiffness-number 300 --inertial-number 0.1 --strain 1 "
        "--json - ";
    const Outcome nearest =
        run_pendular(words + "--start nearest --store " + (folder.path() / "a.sqlite").string());
    ASSERT_EQ(nearest.code, 0) << nearest.errors;
    expect_told({without_simulated(nearest.errors)});
    const Outcome random = run_pendular(words + "--store " + (folder.path() / "b.sqlite").string());
    EXPECT_EQ(json::parse(nearest.output)["stress_ratio"],
              json::parse(random.output)["stress_ratio"]);
}

TEST(Simulate, KeepsItsRun) {
    const TemporaryFolder folder;
    const std::string store = " --store " + (folder.path() / "runs.sqlite").string();
    const std::string words =
        "simulate --quiet --beads 100 --stiffness-number 300 --inertial-number 0.1 --strain 1";
    const Outcome run = run_pendular(words + " --json -" + store);
    ASSERT_EQ(run.code, 0) << run.errors;
    const Outcome next = run_pendular(words + " --friction 0.1 --start nearest --json -" + store);
    expect_told({without_simulated(next.errors)});
    EXPECT_TRUE(json::parse(next.output).contains("start"));
    expect_refused({words + " --start 7" + store, words + " --start 1 --seed 2" + store});
    const Outcome list = run_pendular("runs list --json -" + store);
    EXPECT_EQ(json::parse(list.output)["runs"][0]["stress_ratio"],
              json::parse(run.output)["stress_ratio"]);
}

}  // namespace app_campaign_test
