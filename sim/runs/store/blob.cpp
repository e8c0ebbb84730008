#include "sim/runs/store/blob.h"

#include <array>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <ios>
#include <limits>
#include <stdexcept>

namespace pendular {
namespace {

namespace io = boost::iostreams;

/// Bytes that result from passing other bytes through a filter.
/// @param most largest number of bytes of the result
/// @throws std::runtime_error for corrupt bytes, and for a result that is longer
template <typename Filter>
std::string through(const Filter& filter, const std::string& bytes, std::size_t most) {
    std::string result;
    io::filtering_istream stream;
    stream.push(filter);
    stream.push(io::array_source(bytes.data(), bytes.size()));
    std::array<char, 65536> part{};
    stream.exceptions(std::ios::badbit);
    try {
        while (stream.read(part.data(), part.size()) || stream.gcount() > 0) {
            result.append(part.data(), static_cast<std::size_t>(stream.gcount()));
            if (result.size() > most) {
                throw std::runtime_error("compressed bytes expand to more than a state can have");
            }
        }
    } catch (const std::ios::failure& error) {
        throw std::runtime_error(std::string("compressed bytes are corrupt: ") + error.what());
    }
    return result;
}

constexpr std::size_t most_expansion = 100;  ///< states of grains compress to about half

}  // namespace

std::string compressed(const std::string& bytes) {
    return through(io::zlib_compressor(), bytes, std::numeric_limits<std::size_t>::max());
}
std::string expanded(const std::string& bytes) {
    return through(io::zlib_decompressor(), bytes, most_expansion * bytes.size() + 65536);
}

}  // namespace pendular
