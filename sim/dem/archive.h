#pragma once

#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>
#include <string>

#include "sim/dem/vector.h"

namespace pendular::dem {

template <typename Archive>
void save(Archive& archive, const Vector& v) {
    archive(cereal::binary_data(&v, sizeof v));
}
template <typename Archive>
void load(Archive& archive, Vector& v) {
    archive(cereal::binary_data(&v, sizeof v));
}

/// The bits of a state that has a `serialize` member, for a program of the same layout.
template <typename State>
std::string archived(const State& state) {
    std::ostringstream stream(std::ios::binary);
    cereal::BinaryOutputArchive archive(stream);
    archive(state);
    return std::move(stream).str();
}

/// Reads the bits back into a state of the same layout.
/// @return false where the bits are those of another layout
template <typename State>
bool restore(const std::string& bits, State& state) {
    std::istringstream stream(bits, std::ios::binary);
    cereal::BinaryInputArchive archive(stream);
    try {
        archive(state);
    } catch (const cereal::Exception&) {
        return false;
    }
    return stream.peek() == std::istringstream::traits_type::eof();
}

}  // namespace pendular::dem
