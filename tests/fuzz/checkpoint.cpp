// Files of checkpoints: the seal is made to fit, so that the content is looked at.
#include <fmt/format.h>
#include <boost/crc.hpp>

#include "sim/dem/checkpoint.h"
#include "tests/fuzz/support.h"

using namespace pendular;

namespace {

std::string sealed(std::string_view content) {
    boost::crc_optimal<64, 0x42f0e1eba9ea3693, ~0ull, ~0ull, true, true> crc;
    crc.process_bytes(content.data(), content.size());
    return fmt::format("pendular checkpoint, format {}\nchecksum {:016x} of {} bytes\n{}",
                       dem::Checkpoint::format, crc.checksum(), content.size(), content);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return -1;
    const std::string_view content = fuzz::text_of(data + 1, size - 1);
    const auto file =
        fuzz::file_of("checkpoint", data[0] % 2 ? sealed(content) : std::string(content));
    const dem::Checkpoint checkpoint(file);
    fuzz::refuse_or([&] { checkpoint.read("friction = 0.1\n"); });
    return 0;
}
