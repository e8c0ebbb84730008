#pragma once

#include <cmath>

#include "sim/dem/vector.h"

namespace pendular::dem {

/// Periodic cell of a sheared sample (Lees-Edwards boundary conditions), in grain diameters, with
/// the lattice vectors (length, 0, 0), (offset, height, 0) and (0, 0, width). Direction 1 is the
/// flow, 2 the velocity gradient, 3 the vorticity. The offset grows with the shear; it is reduced
/// by whole cell lengths when the list of neighbouring grains is rebuilt.
struct Cell {
    double length = 0;
    double height = 0;
    double width = 0;
    double offset = 0;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(length, height, width, offset);
    }

    double volume() const { return length * height * width; }

    /// Reduces the offset to the range from -length/2 to length/2. The periodic lattice stays the
    /// same.
    void reduce_offset() { offset -= length * std::floor(offset / length + 0.5); }

    /// Returns a position in multiples of the lattice vectors [1]: from 0 to 1 inside the cell.
    Vector fractions(const Vector& r) const {
        const double up = r[1] / height;
        return {(r[0] - up * offset) / length, up, r[2] / width};
    }
    /// Returns the point inside the cell to which whole lattice vectors shift a position.
    Vector wrapped(const Vector& r) const {
        const Vector at = fractions(r);
        const double n1 = std::floor(at[0]), n2 = std::floor(at[1]), n3 = std::floor(at[2]);
        return r - Vector(n1 * length + n2 * offset, n2 * height, n3 * width);
    }
};

/// Periodic image of the cell, shifted by n1, n2 and n3 times its lattice vectors.
struct Image {
    int n1 = 0, n2 = 0, n3 = 0;

    Vector shift(const Cell& cell) const {
        return {n1 * cell.length + n2 * cell.offset, n2 * cell.height, n3 * cell.width};
    }
};

/// Codes of periodic images from 0 to 124, so that a neighbour list needs one byte per pair of
/// grains for the image of the second grain.
namespace image_code {
constexpr int reach = 2;  ///< the offset of the sheared images adds one to that of a neighbour
constexpr int per_direction = 2 * reach + 1;
constexpr int count = per_direction * per_direction * per_direction;
/// Code of placeholder pairs, which fill up the last batch of a neighbour list. It stands for a
/// position far outside the cell, so that their grains never touch.
constexpr int nowhere = count;

constexpr int of(Image image) {
    return ((image.n3 + reach) * per_direction + image.n2 + reach) * per_direction + image.n1 +
           reach;
}
constexpr Image image(int code) {
    return {code % per_direction - reach, code / per_direction % per_direction - reach,
            code / (per_direction * per_direction) - reach};
}
}  // namespace image_code

/// Velocity gradient that is imposed on a sample, in reduced units (grain diameter, grain mass and
/// imposed normal stress are 1). Direction 1 is the flow, 2 the velocity gradient, 3 the vorticity.
///     v1 = length_rate x1 + shear_rate x2,  v2 = height_rate x2,  v3 = width_rate x3
struct Flow {
    double shear_rate = 0;  ///< equal to the inertial number
    double height_rate = 0;
    double length_rate = 0;
    double width_rate = 0;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(shear_rate, height_rate, length_rate, width_rate);
    }

    /// Returns the velocity gradient times a vector: for a position, the imposed velocity there.
    [[gnu::always_inline]] Vector operator()(const Vector& r) const {
        return Vector(length_rate, height_rate, width_rate) * r + r[1] * Vector(shear_rate, 0, 0);
    }
};

}  // namespace pendular::dem
