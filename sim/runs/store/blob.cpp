#include "sim/runs/store/blob.h"

#include <zlib.h>

#include <array>
#include <stdexcept>

namespace pendular {
namespace {

constexpr std::size_t most_expansion = 100;  ///< states of grains compress to about half

Bytef* as_bytes(const char* text) {
    return reinterpret_cast<Bytef*>(const_cast<char*>(text));  // zlib does not write to its input
}

[[noreturn]] void refuse_corrupt() {
    throw std::runtime_error("compressed bytes are corrupt");
}

}  // namespace

std::string compressed(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    if (compress(as_bytes(result.data()), &size, as_bytes(bytes.data()), bytes.size()) != Z_OK) {
        throw std::runtime_error("bytes cannot be compressed");  // memory is exhausted
    }
    result.resize(size);
    return result;
}

std::string expanded(const std::string& bytes) {
    const std::size_t most = most_expansion * bytes.size() + 65536;
    z_stream stream{};
    stream.next_in = as_bytes(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    if (inflateInit(&stream) != Z_OK) refuse_corrupt();
    const struct Ended {
        z_stream* stream;
        ~Ended() { inflateEnd(stream); }
    } ended{&stream};
    std::string result;
    std::array<char, 65536> part{};
    for (int state = Z_OK; state != Z_STREAM_END;) {
        stream.next_out = as_bytes(part.data());
        stream.avail_out = static_cast<uInt>(part.size());
        state = inflate(&stream, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END) refuse_corrupt();
        result.append(part.data(), part.size() - stream.avail_out);
        if (result.size() > most) {
            throw std::runtime_error("compressed bytes expand to more than a state can have");
        }
    }
    return result;
}

}  // namespace pendular
