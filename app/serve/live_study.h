#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/serve/answer.h"
#include "app/serve/study_watch.h"
#include "app/study_page.h"
#include "workflow/study_change.h"

namespace pendular::app {

/// Functions by which a served study does its work. One thread at a time calls them; only `look` is
/// called by several threads at once.
struct StudyWork {
    /// Returns size, time and number of each file of the study, from which changes are found; takes
    /// little time.
    std::function<StudyStamps()> look;
    /// Computes the results of the study and returns the page that shows them, with this version
    /// number.
    std::function<StudyPage(std::size_t version, const std::stop_token&, const Listener&)> page;
    /// Stores a recording in the study, given the name and the content of its file.
    std::function<Answer(const std::string& name, const std::string& bytes)> store;
    /// Adds an effect to the study or drops one.
    std::function<Answer(Action, const std::string& effect, const std::stop_token&,
                         const Listener&)>
        change;
    /// Prints one line on the console.
    std::function<void(const std::string&)> print;
    /// Time between two checks of the study's files for changes [ms].
    std::chrono::milliseconds interval{1000};
};

/// Study that `pendular serve` shows: makes its page again whenever its files change, stores
/// recordings, and adds and drops effects. One thread does this work (`run`). Other threads take
/// the finished page and leave requests.
class LiveStudy {
  public:
    /// Prepares the work on a study; `run` begins it.
    /// @param first_page page, of version 0, that is shown until the first results are there
    LiveStudy(StudyWork work, std::string first_page);
    LiveStudy(const LiveStudy&) = delete;
    LiveStudy& operator=(const LiveStudy&) = delete;

    /// Does the work on the study until a stop is requested. Work in progress then ends at its next
    /// clean point.
    void run(const std::stop_token& end);

    /// Returns the newest page that was made without an error, as HTML.
    std::shared_ptr<const std::string> page() const;
    /// Returns JSON that open pages ask for: version and time of the newest page, what is being
    /// computed with its share, the error that keeps the page from following the files (`trouble`),
    /// and up to 20 recent events.
    std::string state() const;

    /// Stores a recording in the study and returns the answer for the browser. Waits until other
    /// work has ended; the making of a page is broken off for it. The status is that of
    /// `StudyWork::store`, 422 where storing failed, and 503 where too many requests wait or the
    /// program ends.
    /// @param name name of the file
    /// @param bytes content of the file
    Answer receive(std::string name, std::string bytes);
    /// Starts to add an effect to the study or to drop one, and returns at once. The status is 202
    /// where the work was started, 409 while another effect is being added or dropped, and 503
    /// where too many requests wait. The outcome is among the later events of `state`.
    Answer change(Action action, const std::string& effect);

  private:
    struct Happening {
        std::size_t number = 0;
        std::string time, text;
        bool of_effect = false, ok = true;
    };
    using Job = std::packaged_task<Answer()>;

    bool work_once(const std::stop_token& end);
    void make_page(const std::stop_token& end);
    void take_page(StudyPage page);
    void take_trouble(const std::string& text);
    /// Prints the outcome of making a page on the console, and adds it to the events for open
    /// pages.
    void tell_outcome(const std::string& line, const std::string& event, bool ok);
    Answer change_now(Action action, const std::string& effect, const std::stop_token& end);
    void watch(const std::stop_token& over);
    void begin(const std::string& sentence);
    /// Returns a listener that stores the progress of the running computation, which the browser
    /// pages that show the study display.
    Listener progress();
    void add_event(const std::string& text, bool of_effect, bool ok);
    std::optional<std::future<Answer>> queue(std::function<Answer()> work);
    void end_jobs();

    const StudyWork work_;
    /// Guards all members below.
    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::shared_ptr<const std::string> page_;
    std::size_t version_ = 0;
    std::string made_, trouble_, sentence_;
    std::optional<double> share_;
    bool working_ = false, changing_ = false, ended_ = false;
    /// Whether files of the study differ from those from which the last page was made.
    bool stale_ = true;
    /// Sizes and times of the study's files when the making of the newest page began.
    StudyStamps made_from_;
    /// Sizes and times of the study's files for the last page whose outcome was printed on the
    /// console.
    StudyStamps told_;
    /// Request that stops the making of the page in progress.
    std::stop_source page_stop_;
    /// Requests that all work ends.
    std::stop_token end_;
    std::deque<Job> jobs_;
    /// Recent events, the oldest first, shown on every page of the study that is open in a browser.
    std::deque<Happening> events_;
    std::size_t events_so_far_ = 0;
};

}  // namespace pendular::app
