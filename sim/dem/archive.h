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

/// Returns the bytes of a state that has a `serialize` member. Only a program of the same memory
/// layout can read them (`restore`).
template <typename State>
std::string archived(const State& state) {
    std::ostringstream stream(std::ios::binary);
    cereal::BinaryOutputArchive archive(stream);
    archive(state);
    return std::move(stream).str();
}

/// Reads a state from the bytes that `archived` returned.
/// @return false where the bytes are too few or too many for this state
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
