#include "app/terminal.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>

#include "app/command.h"
#include "data/files/printable.h"
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

}  // namespace

void print_line(std::FILE* stream, std::string_view text) {
    fmt::print(stream, "{}\n", printable(text));
    std::fflush(stream);
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
    } catch (const std::bad_alloc&) {
        print_error("pendular failed: ", "the memory is not enough for this command");
        return program_failed;
    } catch (const std::exception& error) {
        print_error("pendular failed: ", error.what());
        return program_failed;
    }
}

}  // namespace pendular::app
