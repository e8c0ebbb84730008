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

/// Functions that `LiveStudy` calls to watch a study for changes, to compute the page of the study,
/// and to change the study. Several threads may call `look` at once. Only the thread of
/// `LiveStudy::run` calls the other functions.
struct StudyWork {
    /// Function that returns size, time of change and inode number of each file of the study, by
    /// which changed files are found. The function must take little time.
    std::function<StudyStamps()> look;
    /// Function that computes the results of the study and returns the page that shows the results.
    /// `version` becomes the version number of the page.
    std::function<StudyPage(std::size_t version, const std::stop_token&, const Listener&)> page;
    /// Function that stores a recording in the study, given the name and the content of the
    /// recording's file, and returns the answer for the browser.
    std::function<Answer(const std::string& name, const std::string& bytes)> store;
    /// Function that adds a physical effect to the study's model or drops an effect, and returns
    /// the answer for the browser.
    std::function<Answer(Action, const std::string& effect, const std::stop_token&,
                         const Listener&)>
        change;
    /// Function that prints one line on the console.
    std::function<void(const std::string&)> print;
    /// Time between two checks of the study's files for changes [ms].
    std::chrono::milliseconds interval{1000};
};

/// Study (recordings and study.toml) that `pendular serve` shows in browsers. The object makes the
/// HTML page of the study again whenever files of the study change, stores recordings, and adds and
/// drops physical effects. One thread carries out these tasks (`run`). All further threads fetch
/// the finished page and queue requests.
class LiveStudy {
  public:
    /// Stores the functions that do the work, and the first page. No computation begins before
    /// `run`.
    /// @param first_page HTML page, of version 0, that is shown until the first results exist
    LiveStudy(StudyWork work, std::string first_page);
    LiveStudy(const LiveStudy&) = delete;
    LiveStudy& operator=(const LiveStudy&) = delete;

    /// Makes pages and carries out queued requests until a stop is requested. The computation in
    /// progress then ends as soon as it can end without half-written files.
    void run(const std::stop_token& end);

    /// Returns the newest page that was made without an error, as HTML.
    std::shared_ptr<const std::string> page() const;
    /// Returns the JSON that the study's page requests from the server while the page is open in a
    /// browser. The JSON contains the version and time of the newest page, the name and the
    /// finished share of the computation in progress, the error that prevented a newer page
    /// (`trouble`), and up to 20 recent events.
    std::string state() const;

    /// Stores a recording in the study and returns the answer for the browser. Waits until earlier
    /// requests have been carried out. If a page is being made, this work is interrupted and begins
    /// again afterwards.
    /// @param name name of the recording's file
    /// @param bytes content of the recording's file
    /// @return answer of `StudyWork::store`; HTTP status 422 if `StudyWork::store` throws, 503 if
    ///         too many requests wait or the program ends
    Answer receive(std::string name, std::string bytes);
    /// Starts to add an effect to the study or to drop an effect, and returns at once. Once the
    /// change has been made or has failed, the outcome is among the events that `state` returns.
    /// @return answer with the HTTP status 202 if the change was queued, 409 if another effect is
    ///         being added or dropped, 503 if too many requests wait or the program ends
    Answer change(Action action, const std::string& effect);

  private:
    struct RecentEvent {
        std::size_t number = 0;
        std::string time, text;
        bool of_effect = false, ok = true;
    };
    using Job = std::packaged_task<Answer()>;

    bool work_once(const std::stop_token& end);
    void make_page(const std::stop_token& end);
    void take_page(StudyPage page);
    void take_trouble(const std::string& text);
    /// Reports the outcome of making a page: prints `line` on the console, and adds `event` to the
    /// recent events that the page in the browser lists.
    /// @param ok whether the page was made
    void tell_outcome(const std::string& line, const std::string& event, bool ok);
    Answer change_now(Action action, const std::string& effect, const std::stop_token& end);
    void watch(const std::stop_token& over);
    void begin(const std::string& sentence);
    /// Returns a listener (callback for progress reports) that stores the progress of the
    /// computation, so that the study's page can show the progress in browsers.
    Listener progress();
    void add_event(const std::string& text, bool of_effect, bool ok);
    std::optional<std::future<Answer>> queue(std::function<Answer()> work);
    void end_jobs();

    const StudyWork work_;
    /// Mutex that guards all members declared after `mutex_`.
    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::shared_ptr<const std::string> page_;
    std::size_t version_ = 0;
    std::string made_, trouble_, sentence_;
    std::optional<double> share_;
    bool working_ = false, changing_ = false, ended_ = false;
    /// Whether a new page must be made: files of the study have changed since the last page was
    /// made, or no page has been made.
    bool stale_ = true;
    /// Sizes and times of change of the study's files when the making of the newest page began.
    StudyStamps made_from_;
    /// Sizes and times of change of the study's files to which the last call of `tell_outcome`
    /// referred. The next call names the files that have changed since then.
    StudyStamps told_;
    /// Source of the request that stops the making of the page in progress.
    std::stop_source page_stop_;
    /// Stop token of `run`. A request to stop ends all computations.
    std::stop_token end_;
    std::deque<Job> jobs_;
    /// Recent events, the oldest first, shown on every page of the study that is open in a browser.
    std::deque<RecentEvent> events_;
    std::size_t events_so_far_ = 0;
};

}  // namespace pendular::app
