#include "reports/page/page_bytes.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace pendular {

void Bytes::add_floats(const Eigen::VectorXd& values) {
    for (const double value : values) {
        add(static_cast<float>(value));
    }
}

void Bytes::add_scaled(const Eigen::VectorXd& values) {
    const double scale = values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
    add(static_cast<float>(scale));
    for (const double value : values) {
        add(static_cast<std::int16_t>(scale > 0 ? std::lround(32767 * value / scale) : 0));
    }
}

std::string Bytes::base64() const {
    using namespace boost::archive::iterators;
    using Encoder = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
    std::string text(Encoder(bytes_.begin()), Encoder(bytes_.end()));
    text.append((3 - bytes_.size() % 3) % 3, '=');
    return text;
}

void Bytes::append(const void* value, std::size_t size) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    std::memcpy(bytes_.data() + at, value, size);
}

std::string page_text(std::string text) {
    for (std::size_t at = 0; (at = text.find("+-", at)) != std::string::npos;) {
        text.replace(at, 2, "±");
    }
    return text;
}

}  // namespace pendular
