#pragma once

#include <cmath>

namespace pendular::dem {

/// Periodic cell of a Lees-Edwards shear flow, in bead diameters. Its lattice vectors are
/// (length, 0, 0), (offset, height, 0) and (0, 0, width): direction 1 is the flow, 2 the gradient,
/// 3 the vorticity. The offset grows with the shear and is taken modulo the length only when the
/// neighbour list is rebuilt, so that the images named in the list stay the same images.
struct Cell {
    double length = 0;
    double height = 0;
    double width = 0;
    double offset = 0;

    double volume() const { return length * height * width; }

    /// Brings the offset into [-length/2, length/2).
    void reduce_offset() { offset -= length * std::floor(offset / length + 0.5); }

    /// Moves a position into the cell by whole lattice vectors.
    void wrap(double& x, double& y, double& z) const {
        const double up = std::floor(y / height);
        y -= up * height;
        x -= up * offset;
        x -= length * std::floor(x / length);
        z -= width * std::floor(z / width);
    }
};

/// Whole lattice vectors that lead to an image: image = n1 a1 + n2 a2 + n3 a3.
struct Image {
    int n1 = 0, n2 = 0, n3 = 0;
};

/// Images as small numbers, so that a pair of the neighbour list carries one byte.
namespace image_code {
constexpr int reach = 2;
constexpr int per_direction = 2 * reach + 1;
constexpr int count = per_direction * per_direction * per_direction;
/// A place far outside the cell: pairs that only fill up the last batch never touch.
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

}  // namespace pendular::dem
