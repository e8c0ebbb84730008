#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace pendular {

/// Buffer of little-endian numbers, which an HTML page embeds as base64 text.
class Bytes {
  public:
    void add(float value) { append(&value, sizeof value); }
    void add(std::int16_t value) { append(&value, sizeof value); }
    /// Adds the lowest `width` bytes (1, 2 or 4) of a number.
    void add_unsigned(std::uint32_t value, int width) {
        append(&value, static_cast<std::size_t>(width));
    }
    void add_floats(const Eigen::VectorXd& values);
    /// Adds the scale, the largest magnitude of the values, as a 32-bit float, then each value as
    /// the 16-bit integer 32767 value/scale, rounded.
    void add_scaled(const Eigen::VectorXd& values);
    std::string base64() const;

  private:
    void append(const void* value, std::size_t size);
    std::string bytes_;
};

/// Returns a text for an HTML page, with a plus-minus sign for each "+-".
std::string page_text(std::string text);

}  // namespace pendular
