// What `pendular serve` answers, stores and follows.
#include "app/serve/live_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/serve/page_routes.h"
#include "app/serve/received_recording.h"
#include "data/input_error.h"
#include "sim/dem/run.h"
#include "tests/support/app_support.h"

namespace app_serve_test {

using namespace pendular;
using namespace pendular::app;
using namespace std::chrono_literals;
using testing::ElementsAre;
namespace fs = std::filesystem;

const ServerAddress address{.port = 8080, .token = std::string(64, 'a')};

/// Request that is answered: for the page.
RequestHead good_request() {
    return {.method = "GET", .target = "/" + address.token + "/", .host = "127.0.0.1:8080"};
}

int status_of(const RequestHead& request) {
    const auto answer = check_request(request, address);
    return std::holds_alternative<Route>(answer) ? 200 : std::get<Refusal>(answer).status;
}

int status_of_path(const std::string& target) {
    RequestHead request = good_request();
    request.target = target;
    return status_of(request);
}

TEST(ServedRequest, IsAnsweredWithTokenAndHost) {
    EXPECT_EQ(std::get<Route>(check_request(good_request(), address)), Route::page);
    RequestHead request = good_request();
    request.host = "localhost:8080";
    request.target += "state?time=1";
    EXPECT_EQ(std::get<Route>(check_request(request, address)), Route::state);
    request.method = "POST";
    request.token = address.token;
    request.origin = "http://localhost:8080";
    request.target = "/" + address.token + "/recording?name=dry_1.csv";
    EXPECT_EQ(std::get<Route>(check_request(request, address)), Route::recording);
    request.target = "/" + address.token + "/change?effect=x";
    EXPECT_EQ(std::get<Route>(check_request(request, address)), Route::change);
}

TEST(ServedRequest, NeedsTheToken) {
    for (const std::string& token :
         {std::string(), std::string(63, 'a'), std::string(65, 'a'), std::string(63, 'a') + "b",
          "b" + std::string(63, 'a'), std::string(64, 'A')}) {
        EXPECT_EQ(status_of_path("/" + token + "/"), 403) << token;
    }
    EXPECT_EQ(status_of_path("/"), 403);
    EXPECT_EQ(status_of_path("/?" + address.token), 403);
}

TEST(ServedRequest, OfAnotherHostOrOriginIsRefused) {
    for (const char* host :
         {"", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:80800", "evil.example:8080",
          "localhost:8080.evil.example", "[::1]:8080", " 127.0.0.1:8080"}) {
        RequestHead request = good_request();
        request.host = host;
        EXPECT_EQ(status_of(request), 403) << host;
    }
    for (const char* origin :
         {"null", "http://evil.example", "https://127.0.0.1:8080", "http://localhost:8080"}) {
        RequestHead request = good_request();
        request.origin = origin;
        EXPECT_EQ(status_of(request), 403) << origin;
    }
}

TEST(ServedRequest, HasOneOfFewPaths) {
    const std::string own = "/" + address.token;
    for (const std::string path : {"/../x", "/..", "/%2e%2e/x", "/state%00", "/a\\b", "/state/../"})
        EXPECT_EQ(status_of_path(own + path), 400) << path;
    EXPECT_EQ(status_of_path(""), 400);
    EXPECT_EQ(status_of_path("http://127.0.0.1:8080" + own + "/"), 400);
    for (const std::string path : {"", "/study.toml", "/state/", "//", "/recording", "/change"})
        EXPECT_EQ(status_of_path(own + path), 404) << path;
}

TEST(ServedRequest, ChangesOnlyByPostWithTheTokenInAHeader) {
    RequestHead request = good_request();
    for (const char* method : {"HEAD", "PUT", "DELETE", "OPTIONS", "CONNECT", "get", ""}) {
        request.method = method;
        EXPECT_EQ(status_of(request), 405) << method;
    }
    request.method = "POST";
    request.target += "recording";
    EXPECT_EQ(status_of(request), 403);
    request.token = std::string(64, 'b');
    EXPECT_EQ(status_of(request), 403);
    request.token = address.token;
    EXPECT_EQ(status_of(request), 200);
    request.target = "/" + address.token + "/";
    EXPECT_EQ(status_of(request), 404);
}

TEST(ServedRequest, TokensAreLongAndDiffer) {
    const std::string one = new_token(), other = new_token();
    EXPECT_EQ(one.size(), 64u);
    EXPECT_EQ(one.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_NE(one, other);
}

TEST(ReceivedRecording, NamesAreOnePartOfAPath) {
    for (const char* name : {"dry_1.csv", "Probe 3 (naß).CSV", "a..b.csv", "x"})
        EXPECT_EQ(fault_of_name(name), "") << name;
    for (const std::string& name :
         {std::string(), std::string("."), std::string(".."), std::string("../x.csv"),
          std::string("/x.csv"), std::string("a\\x.csv"), std::string(".x.csv"),
          std::string("-x.csv"), std::string("x\n.csv"), std::string("x\0.csv", 6),
          std::string("\x1b[31m.csv"), std::string("\xff.csv"), std::string("x\u202e.csv"),
          std::string(201, 'x')}) {
        EXPECT_NE(fault_of_name(name), "") << name;
    }
}

/// Folder with a copy of the example of dry recordings, as a study in it.
class StoredRecording : public testing::Test {
  protected:
    StoredRecording() {
        fs::copy(PENDULAR_SOURCE_DIR "/examples/dry-recordings", study);
        fs::remove_all(study / "out");
    }
    Answer store(const std::string& name, const std::string& bytes) const {
        return store_recording(study, name, bytes);
    }
    void set_pattern(const std::string& pattern) const {
        std::string text = content_of(study / "study.toml");
        text.replace(text.find("dry_*.csv"), 9, pattern);
        std::ofstream(study / "study.toml") << text;
    }
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
            names.push_back(entry.path().lexically_relative(folder.path()).string());
        std::ranges::sort(names);
        return names;
    }

    TemporaryFolder folder;
    fs::path study = folder.path() / "study";
    std::string recording = content_of(PENDULAR_SOURCE_DIR "/examples/dry-recordings/dry_1.csv");
};

TEST_F(StoredRecording, IsStoredWhereAPatternReadsIt) {
    const Answer answer = store("dry_4.csv", recording);
    EXPECT_EQ(answer.status, 201) << answer.text;
    EXPECT_EQ(content_of(study / "dry_4.csv"), recording);
    fs::create_directory(study / "raw");
    set_pattern("raw/dry_*.csv");
    EXPECT_EQ(store("dry_5.csv", recording).status, 201);
    EXPECT_EQ(content_of(study / "raw/dry_5.csv"), recording);
}

TEST_F(StoredRecording, ReplacesNoFile) {
    const auto before = files();
    EXPECT_EQ(store("dry_1.csv", recording).status, 200);
    const Answer other = store("dry_2.csv", recording);
    EXPECT_EQ(other.status, 409);
    expect_told({other.text});
    EXPECT_NE(content_of(study / "dry_2.csv"), recording);
    fs::create_symlink("/nowhere", study / "dry_7.csv");
    EXPECT_EQ(store("dry_7.csv", recording).status, 409);
    fs::remove(study / "dry_7.csv");
    EXPECT_EQ(files(), before);
}

TEST_F(StoredRecording, IsRefusedWhereItWouldNotBeRead) {
    const auto before = files();
    const Answer unmatched = store("wet_1.csv", recording);
    EXPECT_EQ(unmatched.status, 422);
    expect_told({unmatched.text});
    const Answer broken = store("dry_4.csv", "Time [s],Torque [mN m]\n1,x\n");
    EXPECT_EQ(broken.status, 422);
    expect_told({broken.text, store("dry_4.csv", "Time [s],Torque [mN m]\n1,2\n").text});
    EXPECT_EQ(store("dry_4.csv", "").status, 422);
    EXPECT_EQ(store("dry_4.csv", std::string(100, '\0')).status, 422);
    EXPECT_EQ(store("study.toml", recording).status, 422);
    EXPECT_EQ(store("../dry_4.csv", recording).status, 400);
    EXPECT_EQ(files(), before);
}

TEST_F(StoredRecording, StaysInTheStudy) {
    fs::create_directory(folder.path() / "elsewhere");
    fs::create_directory_symlink("../elsewhere", study / "link");
    for (const std::string& pattern :
         {std::string("link/dry_*.csv"), std::string("../elsewhere/dry_*.csv"),
          (folder.path() / "elsewhere/dry_*.csv").string(), std::string("none/dry_*.csv")}) {
        set_pattern(pattern);
        const auto before = files();
        EXPECT_EQ(store("dry_4.csv", recording).status, 422) << pattern;
        EXPECT_EQ(files(), before) << pattern;
        fs::copy(PENDULAR_SOURCE_DIR "/examples/dry-recordings/study.toml", study,
                 fs::copy_options::overwrite_existing);
    }
}

TEST(StudyWatch, TellsWhatIsNewChangedAndGone) {
    TemporaryFolder folder;
    folder.write("study.toml", "[[recording]]\nfile = \"*.csv\"\n");
    folder.write("a.csv", "1");
    folder.write("b.csv", "1");
    folder.write("other.txt", "1");
    StudyWatch watch(folder.path(), folder.path() / "out");
    const StudyStamps before = watch.look();
    EXPECT_EQ(watch.look(), before);
    folder.write("b.csv", "12");
    folder.write("c.csv", "1");
    folder.write("other.txt", "12");
    fs::remove(folder.path() / "a.csv");
    EXPECT_THAT(changes_between(before, watch.look()),
                ElementsAre("c.csv is new", "b.csv has changed", "a.csv is gone"));
    const StudyStamps between = watch.look();
    folder.write("study.toml", "[[recording]\n");  // its last readable patterns are used
    EXPECT_THAT(changes_between(between, watch.look()), ElementsAre("study.toml has changed"));
}

TEST(StudyWatch, LooksAtNoFileOutsideOfTheStudy) {
    TemporaryFolder folder;
    fs::create_directory(folder.path() / "study");
    folder.write("a.csv", "1");
    folder.write("study/study.toml", "[[recording]]\nfile = \"../*.csv\"\n");
    EXPECT_EQ(StudyWatch(folder.path() / "study", folder.path()).look().inputs.size(), 1u);
}

TEST(StudyWatch, LooksAtFilesOutsideThatTheStudyAllows) {
    TemporaryFolder folder;
    fs::create_directory(folder.path() / "study");
    folder.write("a.csv", "1");
    folder.write("study/study.toml", "allow_outside = true\n[[recording]]\nfile = \"../*.csv\"\n");
    StudyWatch watch(folder.path() / "study", folder.path() / "out");
    const StudyStamps before = watch.look();
    EXPECT_EQ(before.inputs.size(), 2u);
    folder.write("b.csv", "1");
    EXPECT_THAT(changes_between(before, watch.look()), ElementsAre("b.csv is new"));
}

/// Study whose work is done by functions of the test, served in a thread.
class LiveStudyTest : public testing::Test {
  protected:
    StudyWork work() {
        return {.look =
                    [this] {
                        while (blind)
                            std::this_thread::sleep_for(1ms);
                        StudyStamps stamps;
                        stamps.inputs["s/a.csv"] = {.size = file};
                        return stamps;
                    },
                .page = [this](std::size_t version, const std::stop_token& stop,
                               const Listener& listener) { return page(version, stop, listener); },
                .store = [this](const std::string& name, const std::string&) -> Answer {
                    while (blocked)
                        std::this_thread::sleep_for(1ms);
                    ++file;
                    return {201, name};
                },
                .change = [this](Action, const std::string& effect, const std::stop_token&,
                                 const Listener&) -> Answer {
                    if (effect == "unknown") throw InputError("unknown effect");
                    ++file;
                    return {200, effect + " added"};
                },
                .print =
                    [this](const std::string& line) {
                        const std::scoped_lock lock(mutex);
                        lines.push_back(line.substr(9));  // without the time
                    },
                .interval = 20ms};
    }
    StudyPage page(std::size_t version, const std::stop_token& stop, const Listener& listener) {
        ++begun;
        tell(listener, {.kind = Event::Kind::refits, .text = "scan", .number = 1, .total = 4});
        while (slow && !stop.stop_requested())
            std::this_thread::sleep_for(1ms);
        if (stop.stop_requested()) throw dem::Interrupted();
        if (broken) throw InputError({"a.csv", 2, 3}, "is wrong; mend it");
        return {
            .html = "page " + std::to_string(version), .answer = "Fits.", .measure = "Measure."};
    }
    void begin() {
        study = std::make_unique<LiveStudy>(work(), "waiting");
        thread = std::jthread([this](const std::stop_token& end) { study->run(end); });
    }
    nlohmann::json state() const { return nlohmann::json::parse(study->state()); }
    template <typename Condition>
    void wait_for(const Condition& condition) {
        const auto end = std::chrono::steady_clock::now() + 20s;
        while (!condition() && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(1ms);
        EXPECT_TRUE(condition());
    }
    void wait_for_version(int version) {
        wait_for([&] { return state()["version"] == version; });
    }
    std::vector<std::string> printed() {
        const std::scoped_lock lock(mutex);
        return lines;
    }

    std::atomic<int> file{1}, begun{0};
    std::atomic<bool> broken{false}, slow{false}, blocked{false}, blind{false};
    std::mutex mutex;
    std::vector<std::string> lines;
    std::unique_ptr<LiveStudy> study;
    std::jthread thread;
};

TEST_F(LiveStudyTest, MakesItsPageAgainWhenAFileChanges) {
    begin();
    wait_for_version(1);
    EXPECT_EQ(*study->page(), "page 1");
    ++file;
    wait_for_version(2);
    EXPECT_EQ(*study->page(), "page 2");
    wait_for([&] { return printed().size() == 2; });
    EXPECT_THAT(printed(), ElementsAre("Fits. Measure.", "a.csv has changed: Fits. Measure."));
    EXPECT_EQ(begun, 2);
}

TEST_F(LiveStudyTest, KeepsTheLastGoodPageWhileAFileIsBroken) {
    begin();
    wait_for_version(1);
    broken = true;
    ++file;
    wait_for([&] { return state()["trouble"] == "a.csv:2:3: is wrong; mend it"; });
    EXPECT_EQ(*study->page(), "page 1");
    broken = false;
    ++file;
    wait_for_version(2);
    EXPECT_EQ(state()["trouble"], "");
    EXPECT_THAT(printed(),
                testing::Contains("a.csv has changed: error: a.csv:2:3: is wrong; mend it"));
}

TEST_F(LiveStudyTest, ShowsProgressAndBreaksOffForAChangeOfFiles) {
    slow = true;
    begin();
    wait_for([&] { return state()["share"] == 0.25; });
    EXPECT_EQ(state()["sentence"], "Diagnosis, scan: 4 fits to do.");
    EXPECT_EQ(state()["working"], true);
    ++file;
    wait_for([&] { return begun == 2; });
    slow = false;
    wait_for_version(1);
}

TEST_F(LiveStudyTest, StoresARecordingAndReadsIt) {
    slow = true;
    begin();
    wait_for([&] { return begun == 1; });
    EXPECT_EQ(study->receive("b.csv", "1").text, "b.csv");  // breaks off the page
    slow = false;
    wait_for_version(1);
    EXPECT_EQ(study->receive("c.csv", "1").status, 201);
    wait_for_version(2);
}

TEST_F(LiveStudyTest, StoresFirstWhatArrivesJustBeforeAPageIsBegun) {
    blind = slow = true;
    begin();
    std::atomic<int> status{0};
    const std::jthread browser([&] { status = study->receive("b.csv", "1").status; });
    std::this_thread::sleep_for(50ms);  // the recording waits, the page is not begun
    blind = false;
    wait_for([&] { return status == 201; });
    slow = false;
    wait_for_version(1);
}

TEST_F(LiveStudyTest, ChangesOneEffectAtATime) {
    begin();
    wait_for_version(1);
    EXPECT_EQ(study->change(Action::add, "x").status, 202);
    wait_for_version(2);
    EXPECT_EQ(study->change(Action::add, "unknown").status, 202);
    wait_for([&] { return state()["events"].size() >= 4; });
    const auto events = state()["events"];
    EXPECT_EQ(events[1]["text"], "x added");
    EXPECT_EQ(events[3]["text"], "unknown effect");
    EXPECT_EQ(events[3]["ok"], false);
    EXPECT_EQ(state()["changing"], false);
}

TEST_F(LiveStudyTest, EndsDuringWorkAndAnswersThoseWhoWait) {
    slow = true;
    begin();
    wait_for([&] { return begun >= 1; });
    thread.request_stop();
    thread.join();
    EXPECT_EQ(study->receive("b.csv", "1").status, 503);
    EXPECT_EQ(study->change(Action::add, "x").status, 503);
    EXPECT_EQ(*study->page(), "waiting");
}

TEST_F(LiveStudyTest, LetsFewRequestsWait) {
    blocked = true;
    begin();
    std::atomic<int> stored{0}, refused{0};
    std::vector<std::jthread> browsers;
    for (int k = 0; k < 8; ++k) {
        browsers.emplace_back(
            [&] { ++(study->receive("b.csv", "1").status == 503 ? refused : stored); });
    }
    wait_for([&] { return refused >= 3; });  // one is at work, four wait
    blocked = false;
    browsers.clear();
    EXPECT_EQ(stored + refused, 8);
    EXPECT_GE(stored, 4);
}

TEST_F(LiveStudyTest, IsAskedByManyThreadsAtOnce) {
    begin();
    std::vector<std::jthread> browsers;
    std::atomic<int> stored{0};
    for (int k = 0; k < 4; ++k) {
        browsers.emplace_back([&] {
            for (int n = 0; n < 25; ++n) {
                stored += study->receive("b.csv", "1").status == 201 ? 1 : 0;
                EXPECT_FALSE(study->page()->empty());
                EXPECT_TRUE(state()["version"].is_number());
            }
        });
    }
    browsers.clear();
    EXPECT_EQ(stored, 100);
}

TEST(Serve, RefusesWhatIsNoStudyAndWrongOptions) {
    const TemporaryFolder folder;
    expect_refused({"serve " + folder.path().string()});
    const std::string study = PENDULAR_SOURCE_DIR "/examples/dry-recordings";
    expect_refused({"serve " + study + " --port 65536", "serve " + study + " --switches 9"});
}

}  // namespace app_serve_test
