#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <stop_token>
#include <utility>

#include "workflow/listener.h"

namespace pendular::python {

/// Work that `run_long` carries out without the lock of the interpreter. It must touch no object of
/// Python.
using LongWork = std::function<void(const std::stop_token& stop, const Listener& listener)>;

/// Carries out work in a thread of its own while the calling thread waits for it, without the lock
/// of the interpreter, so that other threads of Python go on.
///
/// Python handles Ctrl-C only between two of its instructions and in its main thread. The waiting
/// thread therefore asks for signals every `patience`. Where one raises an exception, such as
/// KeyboardInterrupt, the work is asked to stop and waited for; the exception is then raised, with
/// the text of `dem::Interrupted`, which says what is kept, as a note.
/// @param on_event called with (kind, text, done, total) for each event of the work, in the calling
///        thread; None: no calls. An exception that it raises stops the work.
void run_long(const pybind11::object& on_event, const LongWork& work);

/// Returns the result of such work.
template <typename Work>
auto long_call(const pybind11::object& on_event, const Work& work) {
    std::optional<decltype(work(std::stop_token(), Listener()))> result;
    run_long(on_event, [&](const std::stop_token& stop, const Listener& listener) {
        result.emplace(work(stop, listener));
    });
    return std::move(*result);
}

}  // namespace pendular::python
