#include "app/terminal.h"

#include <fmt/format.h>

#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "app/command.h"
#include "data/files/text_file.h"
#include "data/input_error.h"
#include "sim/dem/run.h"

namespace pendular::app {
namespace {

constexpr std::size_t longest_error = 4000;  ///< largest length of a message [bytes]

/// A long text without its middle, which is cut between characters of UTF-8 or shows as bytes.
std::string shortened(std::string_view text) {
    if (text.size() <= longest_error) return std::string(text);
    const std::size_t part = longest_error / 2;
    return fmt::format("{} ... {}", text.substr(0, part), text.substr(text.size() - part));
}

std::atomic<bool> reader_left = false;

}  // namespace

void print_line(std::FILE* stream, std::string_view text) {
    const std::string line = fmt::format("{}\n", printable(text));
    const bool written =
        std::fwrite(line.data(), 1, line.size(), stream) == line.size() && std::fflush(stream) == 0;
    if (!written && errno == EPIPE) reader_left = true;
}

bool reader_has_left() {
    return reader_left;
}

void print_error(std::string_view prefix, std::string_view message) {
    print_line(stderr, fmt::format("{}{}", prefix, shortened(message)));
}

int report_exception() {
    try {
        throw;
    } catch (const InputError& error) {
        print_error("error: ", error.what());
        return wrong_input;
    } catch (const std::domain_error& error) {
        // Readings that are impossible with the effects of the study; the text says what to do.
        print_error("error: ", error.what());
        return wrong_input;
    } catch (const dem::Interrupted& interruption) {
        print_error("\n", interruption.what());
        return interrupted;
    } catch (const std::filesystem::filesystem_error& error) {
        // What the user named cannot be followed: a link to itself, a name that is too long.
        print_error("error: ", fmt::format("{}: {}: check this path and its links",
                                           error.path1().string(), error.code().message()));
        return wrong_input;
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::broken_pipe) {  // from fmt::print
            reader_left = true;
            return done;
        }
        print_error("pendular failed: ", error.what());
        return program_failed;
    } catch (const std::bad_alloc&) {
        print_error("pendular failed: ", "the memory is not enough for this command");
        return program_failed;
    } catch (const std::exception& error) {
        print_error("pendular failed: ", error.what());
        return program_failed;
    }
}

namespace {

/// Longest time for work to end at a clean point.
constexpr std::chrono::seconds patience_with_work{20};

std::atomic<int> signals_seen{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

extern "C" void note_signal(int) {
    if (signals_seen.fetch_add(1) > 0) {
        _exit(interrupted);
    }
}

}  // namespace

InterruptGuard::InterruptGuard() {
    std::signal(SIGINT, note_signal);
    std::signal(SIGTERM, note_signal);
    std::signal(SIGHUP, note_signal);
    // A signal handler must not request the stop itself; this thread does.
    watcher_ = std::jthread([this](const std::stop_token& end) {
        while (!end.stop_requested() && signals_seen == 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        if (signals_seen == 0) return;
        stop_.request_stop();
        // Work that does not check the token is ended too, which is safe: files are written as a
        // whole or not at all.
        const auto last = std::chrono::steady_clock::now() + patience_with_work;
        while (!end.stop_requested() && std::chrono::steady_clock::now() < last) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        if (!end.stop_requested()) {
            _exit(interrupted);
        }
    });
}

}  // namespace pendular::app
