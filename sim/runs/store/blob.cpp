#include "sim/runs/store/blob.h"

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <stdexcept>

namespace pendular {
namespace {

namespace io = boost::iostreams;

template <typename Filter>
std::string through(const Filter& filter, const std::string& bytes) {
    std::string result;
    io::filtering_istream stream;
    stream.push(filter);
    stream.push(io::array_source(bytes.data(), bytes.size()));
    try {
        io::copy(stream, io::back_inserter(result));
    } catch (const io::zlib_error& error) {
        throw std::runtime_error(std::string("compressed bytes are corrupt: ") + error.what());
    }
    return result;
}

}  // namespace

std::string compressed(const std::string& bytes) {
    return through(io::zlib_compressor(), bytes);
}
std::string expanded(const std::string& bytes) {
    return through(io::zlib_decompressor(), bytes);
}

}  // namespace pendular
