#include "app/serve/live_study.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ctime>
#include <exception>
#include <nlohmann/json.hpp>
#include <thread>

#include "data/input_error.h"
#include "reports/words.h"
#include "sim/dem/run.h"
#include "workflow/json/commands.h"

namespace pendular::app {
namespace {

constexpr std::size_t most_jobs = 4;     ///< requests that wait for work: each takes seconds
constexpr std::size_t most_events = 20;  ///< that are kept: what the page lists

std::string time_now() {
    return fmt::format("{:%H:%M:%S}", fmt::localtime(std::time(nullptr)));
}

/// Text of the exception that is being handled, for the user.
std::string text_of_exception() {
    try {
        throw;
    } catch (const InputError& error) {
        return error.what();
    } catch (const std::exception& error) {
        return fmt::format("Pendular failed: {}.", error.what());
    }
}

}  // namespace

LiveStudy::LiveStudy(StudyWork work, std::string first_page)
    : work_(std::move(work)), page_(std::make_shared<const std::string>(std::move(first_page))) {}

void LiveStudy::run(const std::stop_token& end) {
    const std::stop_callback break_off(end, [this] {
        const std::scoped_lock lock(mutex_);
        page_stop_.request_stop();
    });
    std::jthread watcher([this](const std::stop_token& over) { watch(over); });
    while (work_once(end)) {
    }
    end_jobs();
}

bool LiveStudy::work_once(const std::stop_token& end) {
    std::unique_lock lock(mutex_);
    end_ = end;
    wake_.wait(lock, end, [this] { return stale_ || !jobs_.empty(); });
    if (end.stop_requested()) return false;
    if (jobs_.empty()) {
        lock.unlock();
        make_page(end);
        return true;
    }
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    const StudyStamps now = work_.look();
    lock.lock();
    state_.working = false;
    stale_ = stale_ || now != made_from_;
    return true;
}

void LiveStudy::make_page(const std::stop_token& end) {
    const StudyStamps now = work_.look();
    std::stop_token stop;
    std::size_t version = 0;
    {
        const std::scoped_lock lock(mutex_);
        if (!jobs_.empty()) return;  // asked for meanwhile, and done first
        page_stop_ = {};
        if (end.stop_requested()) page_stop_.request_stop();
        stop = page_stop_.get_token();
        made_from_ = now;
        stale_ = false;
        version = state_.version + 1;
    }
    begin("Reading the study.");
    try {
        take_page(work_.page(version, stop, progress()));
    } catch (const dem::Interrupted&) {
        const std::scoped_lock lock(mutex_);
        stale_ = true;  // broken off for a change of files or a request
    } catch (const std::exception&) {
        take_trouble(text_of_exception());
    }
    const std::scoped_lock lock(mutex_);
    state_.working = false;
}

void LiveStudy::take_page(StudyPage page) {
    {
        const std::scoped_lock lock(mutex_);
        page_ = std::make_shared<const std::string>(std::move(page.html));
        ++state_.version;
        state_.made = fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::localtime(std::time(nullptr)));
        state_.trouble.clear();
    }
    tell_outcome(page.measure.empty() ? page.answer : page.answer + " " + page.measure,
                 fmt::format("{} readings. {}", page.readings, page.answer), true);
}

void LiveStudy::take_trouble(const std::string& text) {
    {
        const std::scoped_lock lock(mutex_);
        state_.trouble = text;
    }
    tell_outcome("error: " + text, text, false);
}

void LiveStudy::tell_outcome(const std::string& line, const std::string& event, bool ok) {
    std::string changes;
    {
        const std::scoped_lock lock(mutex_);
        if (told_ != StudyStamps{})
            changes = fmt::format("{}", fmt::join(changes_between(told_, made_from_), ", "));
        told_ = made_from_;
    }
    if (!changes.empty()) changes += ": ";
    add_event(changes + event, false, ok);
    work_.print(fmt::format("{} {}{}", time_now(), changes, line));
}

Answer LiveStudy::change_now(Action action, const std::string& effect, const std::stop_token& end) {
    begin(fmt::format("{} the effect {} and fitting the study.",
                      action == Action::add ? "Adding" : "Removing", effect));
    Answer answer;
    try {
        answer = work_.change(action, effect, end, progress());
    } catch (const dem::Interrupted&) {
        answer = {503, fmt::format("{} was not changed: Pendular was ended.", effect)};
    } catch (const std::exception&) {
        answer = {422, text_of_exception()};
    }
    {
        const std::scoped_lock lock(mutex_);
        state_.changing = false;
    }
    add_event(answer.text, true, answer.ok());
    work_.print(fmt::format("{} {}", time_now(), answer.text));
    return answer;
}

void LiveStudy::watch(const std::stop_token& over) {
    StudyStamps last = work_.look();
    std::unique_lock lock(mutex_);
    while (!over.stop_requested()) {
        wake_.wait_for(lock, over, work_.interval, [] { return false; });
        lock.unlock();
        StudyStamps now = work_.look();
        lock.lock();
        // Files that still change are left alone until they have been the same twice.
        if (now == last && now != made_from_) {
            stale_ = true;
            page_stop_.request_stop();
            wake_.notify_all();
        }
        last = std::move(now);
    }
}

void LiveStudy::begin(const std::string& sentence) {
    const std::scoped_lock lock(mutex_);
    state_.working = true;
    state_.sentence = sentence;
    state_.share.reset();
}

Listener LiveStudy::progress() {
    return [this](const Event& event) {
        std::string sentence = progress_sentence(event);
        if (sentence.empty()) return;
        const std::scoped_lock lock(mutex_);
        state_.sentence = std::move(sentence);
        state_.share = progress_share(event);
    };
}

void LiveStudy::add_event(const std::string& text, bool of_effect, bool ok) {
    const std::scoped_lock lock(mutex_);
    state_.events.push_back({++events_so_far_, time_now(), text, of_effect, ok});
    if (state_.events.size() > most_events) state_.events.pop_front();
}

std::shared_ptr<const std::string> LiveStudy::page() const {
    const std::scoped_lock lock(mutex_);
    return page_;
}

std::string LiveStudy::state() const {
    const std::scoped_lock lock(mutex_);
    return to_json(state_).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::optional<std::future<Answer>> LiveStudy::queue(std::function<Answer()> work) {
    if (ended_ || jobs_.size() >= most_jobs) return std::nullopt;
    Job job(std::move(work));
    std::future<Answer> answer = job.get_future();
    jobs_.push_back(std::move(job));
    page_stop_.request_stop();
    wake_.notify_all();
    return answer;
}

Answer LiveStudy::receive(std::string name, std::string bytes) {
    std::optional<std::future<Answer>> answer;
    {
        const std::scoped_lock lock(mutex_);
        answer = queue([this, name = std::move(name), bytes = std::move(bytes)]() -> Answer {
            try {
                return work_.store(name, bytes);
            } catch (const std::exception&) {
                return {422, text_of_exception()};
            }
        });
    }
    if (!answer) return {503, "Pendular is busy; send the recording again in a moment."};
    try {
        return answer->get();
    } catch (const std::future_error&) {
        return {503, "Pendular was ended before the recording was stored."};
    }
}

Answer LiveStudy::change(Action action, const std::string& effect) {
    const std::scoped_lock lock(mutex_);
    if (state_.changing)
        return {409, "Another effect is being added or removed; wait for its end."};
    if (!queue([this, action, effect] { return change_now(action, effect, end_); }))
        return {503, "Pendular is busy; try again in a moment."};
    state_.changing = true;
    return {202, fmt::format("{} {}: the study is being fitted.",
                             action == Action::add ? "Adding" : "Removing", effect)};
}

void LiveStudy::end_jobs() {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
    jobs_.clear();  // breaks the promises of their answers
}

}  // namespace pendular::app
