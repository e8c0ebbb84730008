#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace pendular {

/// Numbers of a page as bytes, little-endian, which a page embeds in base64.
class Bytes {
  public:
    void add(float value) { append(&value, sizeof value); }
    void add(std::int16_t value) { append(&value, sizeof value); }
    /// Adds the lowest `width` bytes of a number.
    void add_unsigned(std::uint32_t value, int width) {
        append(&value, static_cast<std::size_t>(width));
    }
    void add_floats(const Eigen::VectorXd& values);
    /// Adds the largest magnitude as a scale, then all values as 16-bit parts of it.
    void add_scaled(const Eigen::VectorXd& values);
    std::string base64() const;

  private:
    void append(const void* value, std::size_t size);
    std::string bytes_;
};

}  // namespace pendular
