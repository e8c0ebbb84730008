#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "data/input_error.h"

/// Input of a fuzz target: reads nothing but these bytes. libFuzzer declares it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace pendular::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Text of an input with bytes of 0 to 127 only. The guess of the encoding of other bytes took half
/// of the time of some targets; the target `layouts` reads them.
inline std::string ascii_of(const std::uint8_t* data, std::size_t size) {
    std::string text(text_of(data, size));
    for (char& each : text)
        each = static_cast<char>(each & 0x7f);
    return text;
}

/// Folder in memory of this process, for readers that take the path of a file.
inline const std::filesystem::path& folder() {
    static const std::filesystem::path path = [] {
        const auto made =
            std::filesystem::path("/dev/shm") / ("pendular_fuzz_" + std::to_string(getpid()));
        std::filesystem::create_directories(made);
        return made;
    }();
    return path;
}

inline std::filesystem::path file_of(const std::string& name, std::string_view content) {
    std::ofstream(folder() / name, std::ios::binary) << content;
    return folder() / name;
}

/// Runs `read`, which may refuse the input as an error of the user and in no other way.
template <typename Read>
void refuse_or(const Read& read) {
    try {
        read();
    } catch (const InputError&) {
    }
}

/// Ends the program, as libFuzzer wants to see a broken promise.
inline void demand(bool promise) {
    if (!promise) __builtin_trap();
}

}  // namespace pendular::fuzz
