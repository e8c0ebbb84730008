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

/// Work on a study that is served. All functions but `look` are called by one thread at a time.
struct StudyWork {
    /// Stamps of the study's files, without much work; called by several threads.
    std::function<StudyStamps()> look;
    /// Makes the page of the study with this version.
    std::function<StudyPage(std::size_t version, const std::stop_token&, const Listener&)> page;
    /// Stores a recording: name and content of the file.
    std::function<Answer(const std::string& name, const std::string& bytes)> store;
    /// Adds an effect to the study or drops one.
    std::function<Answer(Action, const std::string& effect, const std::stop_token&,
                         const Listener&)>
        change;
    /// Prints one line on the console.
    std::function<void(const std::string&)> print;
    /// Time between two looks at the study's files.
    std::chrono::milliseconds interval{1000};
};

/// Study that is served: makes its page again whenever its files change, stores recordings, and
/// changes effects. One thread does this work (`run`); other threads take the finished page and
/// leave requests.
class LiveStudy {
  public:
    /// @param first_page page until the first results are there, of version 0
    LiveStudy(StudyWork work, std::string first_page);
    LiveStudy(const LiveStudy&) = delete;
    LiveStudy& operator=(const LiveStudy&) = delete;

    /// Works until a stop is requested. Work in progress ends at its next clean point.
    void run(const std::stop_token& end);

    /// The last good page.
    std::shared_ptr<const std::string> page() const;
    /// JSON for open pages: `version` and time of the page, what is being computed with its share,
    /// `trouble` that keeps the page from following, and the last events.
    std::string state() const;

    /// Stores a recording and returns the answer; waits until other work has ended. The making of a
    /// page is broken off for it.
    Answer receive(std::string name, std::string bytes);
    /// Starts to add an effect to the study or to drop one, and returns at once: status 202 where
    /// the work was started, 409 while another effect is being added or dropped, 503 where too many
    /// requests wait. The outcome is later among the events of `state`.
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
    /// Notes an outcome on the console and for open pages.
    void tell_outcome(const std::string& line, const std::string& event, bool ok);
    Answer change_now(Action action, const std::string& effect, const std::stop_token& end);
    void watch(const std::stop_token& over);
    void begin(const std::string& sentence);
    /// Listener that keeps the progress for open pages.
    Listener progress();
    void add_event(const std::string& text, bool of_effect, bool ok);
    std::optional<std::future<Answer>> queue(std::function<Answer()> work);
    void end_jobs();

    const StudyWork work_;
    mutable std::mutex mutex_;  ///< guards all that follows
    std::condition_variable_any wake_;
    std::shared_ptr<const std::string> page_;
    std::size_t version_ = 0;
    std::string made_, trouble_, sentence_;
    std::optional<double> share_;
    bool working_ = false, changing_ = false, ended_ = false;
    bool stale_ = true;           ///< whether files differ from those of the last page
    StudyStamps made_from_;       ///< stamps when the last page was begun
    StudyStamps told_;            ///< stamps of the last page whose outcome was told
    std::stop_source page_stop_;  ///< breaks off the page that is being made
    std::stop_token end_;         ///< end of all work
    std::deque<Job> jobs_;
    std::deque<Happening> events_;  ///< the last ones, oldest first
    std::size_t events_so_far_ = 0;
};

}  // namespace pendular::app
