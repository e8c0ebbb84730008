// The server of a study over HTTP, with work that the test does in place of diagnoses.
#include "app/serve/page_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include <atomic>
#include <thread>

#include "app/serve/received_recording.h"
#include "data/input_error.h"

namespace app_page_server_test {

using namespace pendular;
using namespace pendular::app;
using testing::HasSubstr;

class PageServerTest : public testing::Test {
  protected:
    PageServerTest() : server(0), client("127.0.0.1", server.address().port) {
        server.start(study);
        client.set_default_headers({{"X-Pendular-Token", server.address().token}});
    }
    std::string path(const std::string& rest) const {
        return "/" + server.address().token + "/" + rest;
    }
    int post(const std::string& rest, const std::string& body, const char* type = "text/csv") {
        const auto answer = client.Post(path(rest), body, type);
        return answer ? answer->status : -1;
    }

    std::atomic<std::size_t> bytes_stored{0};
    LiveStudy study{{.look = [] { return StudyStamps{}; },
                     .page = [](std::size_t, const std::stop_token&,
                                const Listener&) { return StudyPage{.html = "a page"}; },
                     .store = [this](const std::string& name, const std::string& bytes) -> Answer {
                         bytes_stored += bytes.size();
                         return {201, name};
                     },
                     .change = [](Action, const std::string&, const std::stop_token&,
                                  const Listener&) -> Answer {
                         return {200, ""};
                     },
                     .print = [](const std::string&) {}},
                    "a page"};
    std::jthread thread{[this](const std::stop_token& end) { study.run(end); }};
    PageServer server;
    httplib::Client client;
};

TEST_F(PageServerTest, HandsOutThePageWithSafeHeaders) {
    const auto answer = client.Get(path(""));
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->body, "a page");
    EXPECT_THAT(answer->get_header_value("Content-Security-Policy"),
                HasSubstr("default-src 'none'"));
    EXPECT_EQ(answer->get_header_value("X-Content-Type-Options"), "nosniff");
    EXPECT_EQ(answer->get_header_value("Referrer-Policy"), "no-referrer");
    EXPECT_EQ(answer->get_header_value("Cache-Control"), "no-store");
    const auto refused = client.Get("/");
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->status, 403);
    EXPECT_EQ(refused->get_header_value("X-Content-Type-Options"), "nosniff");
}

TEST_F(PageServerTest, ReceivesRecordingsUpToALimit) {
    EXPECT_EQ(post("recording?name=a.csv", "12345"), 201);
    EXPECT_EQ(bytes_stored, 5u);
    EXPECT_EQ(post("recording?name=a.csv", std::string(largest_received, '1')), 201);
    EXPECT_EQ(post("recording?name=a.csv", std::string(largest_received + 1, '1')), 413);
    EXPECT_EQ(post("recording?name=a.csv", "1", "multipart/form-data; boundary=x"), 415);
    EXPECT_EQ(post("change?action=calibrate", ""), 400);
    EXPECT_EQ(bytes_stored, 5u + largest_received);
}

TEST_F(PageServerTest, ReceivesNoMoreThanTheLimitOfALengthThatIsNotStated) {
    const std::string part(1 << 20, '1');
    std::size_t sent = 0;
    client.Post(
        path("recording?name=a.csv"),
        [&](std::size_t, httplib::DataSink& sink) {
            sent += part.size();
            if (sent > largest_received + 2 * part.size()) sink.done();
            return sink.write(part.data(), part.size());
        },
        "text/csv");
    EXPECT_EQ(bytes_stored, 0u);
}

TEST_F(PageServerTest, AnswersManyBrowsersAtOnce) {
    std::vector<std::jthread> browsers;
    std::atomic<int> pages{0}, stored{0};
    for (int k = 0; k < 3; ++k) {
        browsers.emplace_back([&] {
            httplib::Client own("127.0.0.1", server.address().port);
            own.set_default_headers({{"X-Pendular-Token", server.address().token}});
            for (int n = 0; n < 10; ++n) {
                pages += own.Get(path(""))->status == 200 ? 1 : 0;
                own.Get(path("state"));
                stored += own.Post(path("recording?name=a"), "1", "text/csv")->status == 201;
            }
        });
    }
    browsers.clear();
    EXPECT_EQ(pages, 30);
    EXPECT_EQ(stored, 30);
}

TEST_F(PageServerTest, SharesItsPortWithNoOther) {
    EXPECT_THROW(PageServer(server.address().port), InputError);
}

}  // namespace app_page_server_test
