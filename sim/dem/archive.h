#pragma once

#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/vector.hpp>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

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

/// Reader of the bytes that `cereal::BinaryOutputArchive` wrote. It throws cereal::Exception if the
/// bytes state that a container has more elements than the remaining bytes can contain;
/// `cereal::BinaryInputArchive` would instead allocate memory for all stated elements.
class ByteReader : public cereal::InputArchive<ByteReader, cereal::AllowEmptyClassElision> {
  public:
    explicit ByteReader(std::string_view bytes) : InputArchive(this), bytes_(bytes) {}

    std::size_t left() const { return bytes_.size(); }
    void demand(std::size_t count) const {
        if (count > left()) throw cereal::Exception("the bytes are too few");
    }
    void take(void* to, std::size_t count) {
        demand(count);
        if (count > 0) std::memcpy(to, bytes_.data(), count);
        bytes_.remove_prefix(count);
    }

  private:
    std::string_view bytes_;  ///< not read yet
};

template <typename Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
void load(ByteReader& reader, Number& number) {
    if constexpr (std::is_same_v<Number, bool>) {
        std::uint8_t byte = 0;
        reader.take(&byte, sizeof byte);
        number = byte != 0;  // a byte other than 0 and 1 is not a valid bool
    } else {
        reader.take(&number, sizeof number);
    }
}
template <typename T>
void load(ByteReader& reader, cereal::BinaryData<T>& data) {
    reader.take(data.data, data.size);
}
template <typename T>
void load(ByteReader& reader, cereal::NameValuePair<T>& pair) {
    reader(pair.value);
}
template <typename T>
void load(ByteReader& reader, cereal::SizeTag<T>& tag) {
    reader(tag.size);
    reader.demand(tag.size);  // each element takes at least one byte
}
template <typename T, typename Allocator>
void load(ByteReader& reader, std::vector<T, Allocator>& elements) {
    cereal::size_type size = 0;
    reader(cereal::make_size_tag(size));
    elements.clear();
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
        if (size > reader.left() / sizeof(T)) throw cereal::Exception("the bytes are too few");
        elements.resize(size);
        reader.take(elements.data(), size * sizeof(T));
    } else {
        // Elements are read one by one, so that no memory is taken for elements beyond the bytes.
        for (; size > 0; --size) {
            T element = T();
            reader(element);
            elements.push_back(std::move(element));
        }
    }
}

/// Returns an object, such as the state of a run, as bytes. cereal must be able to save the object,
/// for example by a member function `serialize`. `restore` can read the bytes only if the machine's
/// byte order and the memory layout of the saved types are unchanged.
template <typename State>
std::string archived(const State& state) {
    std::ostringstream stream(std::ios::binary);
    cereal::BinaryOutputArchive archive(stream);
    archive(state);
    return std::move(stream).str();
}

/// Restores an object from the bytes of `archived`.
/// @return false if the bytes are too few, too many or invalid for the object, which may then be
///         changed in part
template <typename State>
bool restore(std::string_view bytes, State& state) {
    ByteReader reader(bytes);
    try {
        reader(state);
    } catch (const cereal::Exception&) {
        return false;
    }
    return reader.left() == 0;
}

}  // namespace pendular::dem

/// Tells cereal that `ByteReader` reads what `cereal::BinaryOutputArchive` writes.
template <>
struct cereal::traits::detail::get_output_from_input<pendular::dem::ByteReader> {
    using type = cereal::BinaryOutputArchive;
};
