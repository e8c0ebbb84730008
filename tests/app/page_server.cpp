// The server of a study over HTTP, with work that the test does in place of diagnoses.
#include "app/serve/page_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
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

/// Sockets that are connected to a port and send a part of a request, or nothing.
class HalfOpen {
  public:
    HalfOpen(int port, int count, const std::string& sent) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        for (int k = 0; k < count; ++k) {
            sockets_.push_back(socket(AF_INET, SOCK_STREAM, 0));
            EXPECT_EQ(connect(sockets_.back(), reinterpret_cast<const sockaddr*>(&address),
                              sizeof address),
                      0);
            EXPECT_EQ(send(sockets_.back(), sent.data(), sent.size(), 0), std::ssize(sent));
        }
    }
    ~HalfOpen() {
        for (const int each : sockets_)
            close(each);
    }

  private:
    std::vector<int> sockets_;
};

// The server of httplib with its own settings takes 15 s behind 60 idle connections, and longer
// behind those that have begun a request.
TEST_F(PageServerTest, AnswersWithinTwoSecondsBehindConnectionsThatAskNothing) {
    for (const char* const sent : {"", "GET / HTTP/1.1\r\nHost: 127"}) {
        for (const int count : {60, 300}) {
            const HalfOpen others(server.address().port, count, sent);
            const auto start = std::chrono::steady_clock::now();
            const auto answer = client.Get(path(""));
            const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
            ASSERT_TRUE(answer) << sent << count;
            EXPECT_EQ(answer->status, 200);
            EXPECT_LT(spent.count(), 2) << sent << count;
        }
    }
}

// 6 bytes and 200 ranges of them would be a multipart answer of some 20 kB.
TEST_F(PageServerTest, SendsThePageOnceWhateverRangesAreAskedFor) {
    std::string ranges = "bytes=0-";
    for (int k = 0; k < 200; ++k)
        ranges += ",0-";
    const auto answer = client.Get(path(""), {{"Range", ranges}});
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 200);
    EXPECT_EQ(answer->body, "a page");
}

TEST_F(PageServerTest, SharesItsPortWithNoOther) {
    EXPECT_THROW(PageServer(server.address().port), InputError);
}

}  // namespace app_page_server_test
