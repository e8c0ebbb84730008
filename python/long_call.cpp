#include "python/long_call.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "sim/dem/simulation_error.h"

namespace py = pybind11;

namespace pendular::python {
namespace {

using namespace std::chrono_literals;

/// Time between two looks at signals: below what a user notices after Ctrl-C.
constexpr auto patience = 50ms;

/// Event, as Python is told of it.
struct Told {
    const char* kind;
    std::string text;
    std::size_t done, total;
};

Told told(const Event& event) {
    switch (event.kind) {
        case Event::Kind::note:
            return {"note", event.text, 0, 0};
        case Event::Kind::runs:
            return {"runs", event.text, event.runs.runs_done, event.runs.runs};
        case Event::Kind::refits:
            return {"refits", event.text, event.number, event.total};
        case Event::Kind::round:
            return {"round", event.text, event.number, 0};
        default:
            return {"stage", event.text, 0, 0};
    }
}

/// Work in a thread of its own, and what it has told so far.
class Waited {
  public:
    explicit Waited(const LongWork& work)
        : thread_([this, &work](const std::stop_token& stop) { work_through(work, stop); }) {}

    /// Waits until the work has ended or told something, at most `patience`, and returns what it
    /// has told.
    std::deque<Told> wait() {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, patience, [&] { return ended_ || !events_.empty(); });
        return std::exchange(events_, {});
    }
    bool ended() {
        const std::lock_guard lock(mutex_);
        return ended_ && events_.empty();
    }
    /// Asks the work to stop and waits until it has.
    void stop() {
        thread_.request_stop();
        thread_.join();
    }
    const std::exception_ptr& failure() const { return failure_; }

  private:
    void work_through(const LongWork& work, const std::stop_token& stop) {
        try {
            work(stop, [this](const Event& event) {
                const std::lock_guard lock(mutex_);
                events_.push_back(told(event));
                changed_.notify_one();
            });
        } catch (...) {
            failure_ = std::current_exception();
        }
        const std::lock_guard lock(mutex_);
        ended_ = true;
        changed_.notify_one();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Told> events_;
    bool ended_ = false;
    std::exception_ptr failure_;
    std::jthread thread_;  ///< last member: ends before the others are destroyed
};

/// Tells Python of events and looks at signals.
/// @throws py::error_already_set where either raises an exception
void attend(const std::deque<Told>& events, const py::object& on_event) {
    if (!on_event.is_none()) {
        for (const Told& each : events)
            on_event(each.kind, each.text, each.done, each.total);
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// Adds what is kept of interrupted work to an exception of Python.
void add_note(const py::error_already_set& raised, const std::exception_ptr& failure) {
    try {
        if (failure) std::rethrow_exception(failure);
    } catch (const dem::Interrupted& interrupted) {
        if (py::hasattr(raised.value(), "add_note"))  // from Python 3.11 on
            raised.value().attr("add_note")(interrupted.what());
    } catch (...) {
        // The exception of Python says why the work ended.
    }
}

}  // namespace

void run_long(const py::object& on_event, const LongWork& work) {
    Waited waited(work);
    while (!waited.ended()) {
        std::deque<Told> events;
        {
            const py::gil_scoped_release release;
            events = waited.wait();
        }
        try {
            attend(events, on_event);
        } catch (const py::error_already_set& raised) {
            {
                const py::gil_scoped_release release;
                waited.stop();
            }
            add_note(raised, waited.failure());
            throw;
        }
    }
    {
        const py::gil_scoped_release release;
        waited.stop();
    }
    if (waited.failure()) std::rethrow_exception(waited.failure());
}

}  // namespace pendular::python
