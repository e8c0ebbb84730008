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

#include "app/serve/received_recording.h"
#include "app/serve/study_watch.h"
#include "app/study_page.h"
#include "workflow/json/commands.h"
#include "workflow/study_change.h"

namespace pendular::app {

/// Functions that `LiveStudy` calls. Several threads may call `look` at once; only the thread of
/// `LiveStudy::run` calls the other functions.
struct StudyWork {
    /// Finds changed files of the study; must take little time.
    std::function<StudyStamps()> look;
    /// Computes the study and returns its page, which gets the number `version`.
    std::function<StudyPage(std::size_t version, const std::stop_token&, const Listener&)> page;
    /// Stores a recording in the study, given the name and the content of its file.
    std::function<Answer(const std::string& name, const std::string& bytes)> store;
    /// Adds an effect to the study's model or drops it.
    std::function<Answer(Action, const std::string& effect, const std::stop_token&,
                         const Listener&)>
        change;
    std::function<void(const std::string&)> print;  ///< prints one line on the console
    std::chrono::milliseconds interval{1000};       ///< between two calls of `look`
};

/// Study that `pendular serve` shows in browsers. Makes the HTML page of the study again whenever
/// files of the study change, stores recordings, and adds and drops effects. One thread carries out
/// these tasks (`run`); all others fetch the finished page and queue requests.
class LiveStudy {
  public:
    /// No computation begins before `run`.
    /// @param first_page HTML page, of version 0, that is shown until the first results exist
    LiveStudy(StudyWork work, std::string first_page);
    LiveStudy(const LiveStudy&) = delete;
    LiveStudy& operator=(const LiveStudy&) = delete;

    /// Makes pages and carries out queued requests until a stop is requested. The computation in
    /// progress then ends as soon as it can end without half-written files.
    void run(const std::stop_token& end);

    /// Returns the newest page that was made without an error, as HTML.
    std::shared_ptr<const std::string> page() const;
    /// Returns the JSON that an open page requests from the server: version and time of the newest
    /// page, name and finished share of the computation in progress, the error that prevented a
    /// newer page (`trouble`), and up to 20 recent events.
    std::string state() const;

    /// Stores a recording in the study. Waits until earlier requests have been carried out. If a
    /// page is being made, this work is interrupted and begins again afterwards.
    /// @return answer of `StudyWork::store`; HTTP status 422 if it throws, 503 if too many requests
    ///         wait or the program ends
    Answer receive(std::string name, std::string bytes);
    /// Starts to add or to drop an effect, and returns at once. The outcome will be among the
    /// events that `state` returns.
    /// @return HTTP status 202 if the change was queued, 409 if another effect is being added or
    ///         dropped, 503 if too many requests wait or the program ends
    Answer change(Action action, const std::string& effect);

  private:
    using Job = std::packaged_task<Answer()>;

    bool work_once(const std::stop_token& end);
    void make_page(const std::stop_token& end);
    void take_page(StudyPage page);
    void take_trouble(const std::string& text);
    /// Reports the making of a page: `line` on the console, `event` in the list of the page.
    void tell_outcome(const std::string& line, const std::string& event, bool ok);
    Answer change_now(Action action, const std::string& effect, const std::stop_token& end);
    void watch(const std::stop_token& over);
    void begin(const std::string& sentence);
    /// Returns a listener that stores the progress for `state`.
    Listener progress();
    void add_event(const std::string& text, bool of_effect, bool ok);
    std::optional<std::future<Answer>> queue(std::function<Answer()> work);
    void end_jobs();

    const StudyWork work_;
    mutable std::mutex mutex_;  ///< guards all members below
    std::condition_variable_any wake_;
    std::shared_ptr<const std::string> page_;
    PageState state_;
    bool ended_ = false;
    bool stale_ = true;      ///< whether files have changed since the last page, or there is none
    StudyStamps made_from_;  ///< files when the newest page was begun
    StudyStamps told_;  ///< files at the last `tell_outcome`, which names those that changed since
    std::stop_source page_stop_;  ///< stops the making of the page in progress
    std::stop_token end_;         ///< of `run`: ends all computations
    std::deque<Job> jobs_;
    std::size_t events_so_far_ = 0;
};

}  // namespace pendular::app
