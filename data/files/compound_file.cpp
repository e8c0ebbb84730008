#include "data/files/compound_file.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "data/files/little_endian.h"

namespace pendular {
namespace {

constexpr std::uint32_t last_sector = 0xFFFF'FFFA;  ///< larger numbers have other meanings

/// Sectors of a compound file. Each sector has a successor in an allocation table; a stream is a
/// chain of them. Chains that turn back end after as many sectors as there are.
class Sectors {
  public:
    explicit Sectors(std::string_view bytes) : bytes_(bytes) {
        const unsigned shift = two_bytes(bytes, 30);
        size_ = shift == 12 ? 4096 : 512;
        read_table();
    }

    /// Content of the stream that begins with a sector, at most so many bytes.
    std::string stream(std::uint32_t sector, std::size_t most) const {
        std::string content;
        for (std::size_t steps = 0; sector < next_.size() && steps < next_.size(); ++steps) {
            if (content.size() >= most) break;
            content += content_of(sector);
            sector = next_[sector];
        }
        content.resize(std::min(content.size(), most));
        return content;
    }

  private:
    std::string_view content_of(std::uint32_t sector) const {
        const std::size_t begin = (std::size_t(sector) + 1) * size_;
        return begin < bytes_.size() ? bytes_.substr(begin, size_) : std::string_view();
    }

    /// Adds the part of the allocation table that a sector holds.
    void add_to_table(std::uint32_t sector) {
        const std::string_view part = content_of(sector);
        for (std::size_t i = 0; i + 4 <= part.size() && next_.size() < most_sectors(); i += 4)
            next_.push_back(four_bytes(part, i));
    }

    std::size_t most_sectors() const { return bytes_.size() / size_; }

    void read_table() {
        constexpr std::size_t in_header = 109;  // sectors of the table that the header lists
        for (std::size_t i = 0; i < in_header; ++i)
            if (const std::uint32_t sector = four_bytes(bytes_, 76 + 4 * i); sector <= last_sector)
                add_to_table(sector);
        // The others stand in further sectors, each of which ends with the number of the next.
        std::uint32_t list = four_bytes(bytes_, 68);
        for (std::size_t steps = 0; list <= last_sector && steps < most_sectors(); ++steps) {
            const std::string_view part = content_of(list);
            if (part.size() < size_) break;
            for (std::size_t i = 0; i + 4 < size_; i += 4)
                if (const std::uint32_t sector = four_bytes(part, i); sector <= last_sector)
                    add_to_table(sector);
            list = four_bytes(part, size_ - 4);
        }
    }

    std::string_view bytes_;
    std::size_t size_;
    std::vector<std::uint32_t> next_;
};

/// Entry of the directory: a stream, a folder, or the root.
struct Entry {
    std::string name;  ///< in capitals
    unsigned kind;     ///< 2: stream, 5: root
    std::uint32_t left, right, child, first, size;
};

constexpr std::size_t entry_size = 128;

Entry entry_at(std::string_view directory, std::size_t index) {
    const std::string_view text = directory.substr(index * entry_size, entry_size);
    std::string name;
    for (std::size_t i = 0; i + 2 < std::min<std::size_t>(two_bytes(text, 64), 64); i += 2)
        if (const unsigned letter = two_bytes(text, i); letter >= 0x20 && letter < 0x7F)
            name += static_cast<char>(letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter);
    return {name,
            static_cast<unsigned char>(text[66]),
            four_bytes(text, 68),
            four_bytes(text, 72),
            four_bytes(text, 76),
            four_bytes(text, 116),
            four_bytes(text, 120)};
}

/// Short streams share the stream of the root, in parts of 64 bytes that have a table of their own.
std::string short_stream(const std::string& all, const std::string& table, const Entry& entry) {
    constexpr std::size_t size = 64;
    const std::size_t parts = table.size() / 4;
    std::uint32_t part = entry.first;
    std::string content;
    for (std::size_t steps = 0; part < parts && steps < parts; ++steps) {
        if (content.size() >= entry.size) break;
        if (std::size_t(part) * size < all.size())
            content += all.substr(std::size_t(part) * size, size);
        part = four_bytes(table, 4 * std::size_t(part));
    }
    content.resize(std::min<std::size_t>(content.size(), entry.size));
    return content;
}

}  // namespace

bool is_compound_file(std::string_view bytes) {
    return bytes.starts_with("\xD0\xCF\x11\xE0");
}

std::map<std::string, std::string> streams_of(std::string_view bytes) {
    std::map<std::string, std::string> streams;
    const Sectors sectors(bytes);
    const std::string directory = sectors.stream(four_bytes(bytes, 48), bytes.size());
    const std::size_t entries = directory.size() / entry_size;
    if (entries == 0) return streams;
    const Entry root = entry_at(directory, 0);
    const std::string shared = sectors.stream(root.first, bytes.size()),
                      table = sectors.stream(four_bytes(bytes, 60), bytes.size());
    const std::uint32_t shortest = four_bytes(bytes, 56);
    // The entries of a folder are a tree; a damaged one may turn back.
    std::vector<std::uint32_t> open = {root.child};
    std::vector<bool> seen(entries);
    // Two streams of the whole file at most: no chain is read again and again.
    for (std::size_t room = 2 * bytes.size(); !open.empty();) {
        const std::uint32_t index = open.back();
        open.pop_back();
        if (index >= entries || seen[index]) continue;
        seen[index] = true;
        const Entry entry = entry_at(directory, index);
        open.insert(open.end(), {entry.left, entry.right});
        constexpr unsigned stream = 2;
        if (entry.kind != stream || streams.contains(entry.name) || entry.size > room) continue;
        room -= entry.size;
        streams[entry.name] = entry.size < shortest ? short_stream(shared, table, entry)
                                                    : sectors.stream(entry.first, entry.size);
    }
    return streams;
}

}  // namespace pendular
