#include "sim/dem/snapshot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "data/files/write_whole.h"
#include "sim/dem/separations.h"
#include "sim/dem/series.h"

namespace pendular::dem {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view units =
    "reduced units: grain diameter, grain mass and imposed normal stress are 1";

/// Returns the number behind the first occurrence of `words` in a line; empty if there is none.
template <typename Number>
std::optional<Number> number_after(std::string_view line, std::string_view words) {
    const auto at = line.find(words);
    if (at == std::string_view::npos) return {};
    line.remove_prefix(at + words.size());
    Number value{};
    const auto fault = std::from_chars(line.data(), line.data() + line.size(), value).ec;
    return fault == std::errc{} ? std::optional(value) : std::nullopt;
}

std::string text_of(const Vector& v) {
    return fmt::format("{:.10g} {:.10g} {:.10g}", v[0], v[1], v[2]);
}

/// Adds the contacts and bridges of one pair list to a snapshot. Each line starts at the position
/// of the first grain inside the cell.
void add_pairs(const ShearCell& sample, const Pairs& list, Snapshot& snapshot) {
    const auto visit = [&](std::size_t k, const Vector& separation) {
        const bool touching = list.root[k] > 0, bridge = list.bridge[k] > 0;
        if (!touching && !bridge) {
            return;
        }
        auto& first = snapshot.grains[static_cast<std::size_t>(list.first[k])];
        auto& second = snapshot.grains[static_cast<std::size_t>(list.second[k])];
        first.contacts += touching;
        second.contacts += touching;
        const double gap = gap_of(sample.grains(), list, k, separation);
        const PairSizes sizes = sample.grains().sizes(static_cast<std::size_t>(list.first[k]),
                                                      static_cast<std::size_t>(list.second[k]));
        snapshot.pairs.push_back(
            {.from = first.position,
             .to = first.position + separation,
             .normal_force =
                 contact_of(sample.grains(), list, k, sample.material().modulus).elastic,
             .bridge_force = bridge ? sample.effects().attraction(
                                          touching ? std::min(gap, 0.0) : gap, sizes.diameter,
                                          sample.material(), sample.bridges(), list.history_of(k))
                                    : 0,
             .touching = touching});
    };
    for_each_pair(sample.grains(), sample.cell(), list, visit);
}

/// Returns a VTK <DataArray> with one line per item.
template <typename Items, typename Text>
std::string data_array(const std::string& type, const std::string& name, int components,
                       const Items& items, const Text& text) {
    std::string array = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
        "format=\"ascii\">\n",
        type, name, components);
    for (const auto& item : items) {
        array += text(item);
        array += '\n';
    }
    return array + "</DataArray>\n";
}

/// Returns the VTK connectivity and offsets of `cells` cells with `size` successive points each.
std::string topology(const std::string& kind, std::size_t cells, std::size_t size) {
    std::string connectivity, offsets;
    for (std::size_t k = 0; k < cells; ++k) {
        for (std::size_t point = k * size; point < (k + 1) * size; ++point) {
            connectivity += fmt::format("{} ", point);
        }
        connectivity += '\n';
        offsets += fmt::format("{}\n", (k + 1) * size);
    }
    return fmt::format(
        "<{0}>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n{1}"
        "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n{2}"
        "</DataArray>\n</{0}>\n",
        kind, connectivity, offsets);
}

std::string poly_data(const Snapshot& s, const std::string& counts, const std::string& body) {
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<!-- pendular, {}; strain {:.10g}, time {:.10g} -->\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n"
        "<Piece {}>\n{}</Piece>\n</PolyData>\n</VTKFile>\n",
        units, s.strain, s.time, counts, body);
}

}  // namespace

Snapshot snapshot_of(const ShearCell& sample, double strain) {
    Snapshot s{.step = sample.steps(),
               .time = strain / sample.shear_rate(),
               .strain = strain,
               .cell = sample.cell()};
    s.cell.reduce_offset();
    const Grains& grains = sample.grains();
    for (std::size_t i = 0; i < grains.size(); ++i) {
        const Vector place = s.cell.wrapped(grains.position(i));
        s.grains.push_back({.id = grains.number[i] + 1,
                            .radius = 0.5 * grains.diameter(i),
                            .position = place,
                            .velocity = grains.velocity(i) + sample.flow()(place),
                            .angular_velocity = grains.angular_velocity(i)});
    }
    add_pairs(sample, sample.pairs().narrow(), s);
    add_pairs(sample, sample.pairs().distant(), s);
    return s;
}

std::string dump_frame(const Snapshot& s) {
    const Cell& cell = s.cell;
    std::string text = fmt::format(
        "ITEM: UNITS\n{}\nITEM: TIME\n{:.10g}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n"
        "ITEM: BOX BOUNDS xy xz yz pp pp pp\n",
        units, s.time, s.step, s.grains.size());
    text +=
        fmt::format("{} {} {}\n0 {} 0\n0 {} 0\n", std::min(0.0, cell.offset),
                    cell.length + std::max(0.0, cell.offset), cell.offset, cell.height, cell.width);
    text +=
        "ITEM: ATOMS id type radius x y z vx vy vz angular_velocity_x angular_velocity_y "
        "angular_velocity_z coordination\n";
    for (const auto& grain : s.grains) {
        text +=
            fmt::format("{} 1 {} {} {} {} {}\n", grain.id, grain.radius, text_of(grain.position),
                        text_of(grain.velocity), text_of(grain.angular_velocity), grain.contacts);
    }
    return text;
}

std::string grains_vtp(const Snapshot& s) {
    const auto of_beads = [&](const char* type, const char* name, int components,
                              const auto& text) {
        return data_array(type, name, components, s.grains, text);
    };
    using Grain = Snapshot::Grain;
    return poly_data(
        s,
        fmt::format("NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" "
                    "NumberOfStrips=\"0\" NumberOfPolys=\"0\"",
                    s.grains.size()),
        "<PointData>\n" +
            of_beads("Int32", "id", 1, [](const Grain& b) { return fmt::format("{}", b.id); }) +
            of_beads("Float64", "radius", 1,
                     [](const Grain& b) { return fmt::format("{}", b.radius); }) +
            of_beads("Float64", "velocity", 3, [](const Grain& b) { return text_of(b.velocity); }) +
            of_beads("Float64", "angular_velocity", 3,
                     [](const Grain& b) { return text_of(b.angular_velocity); }) +
            of_beads("Int32", "coordination", 1,
                     [](const Grain& b) { return fmt::format("{}", b.contacts); }) +
            "</PointData>\n<Points>\n" +
            of_beads("Float64", "Points", 3, [](const Grain& b) { return text_of(b.position); }) +
            "</Points>\n" + topology("Verts", s.grains.size(), 1));
}

std::string pairs_vtp(const Snapshot& s) {
    const auto of_pairs = [&](const char* type, const char* name, int components,
                              const auto& text) {
        return data_array(type, name, components, s.pairs, text);
    };
    const auto number = [](double value) { return fmt::format("{:.10g}", value); };
    return poly_data(
        s,
        fmt::format("NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
                    "NumberOfStrips=\"0\" NumberOfPolys=\"0\"",
                    2 * s.pairs.size(), s.pairs.size()),
        "<CellData>\n" +
            of_pairs("Float64", "normal_force", 1,
                     [&](const DrawnPair& p) { return number(p.normal_force); }) +
            of_pairs("Float64", "bridge_force", 1,
                     [&](const DrawnPair& p) { return number(p.bridge_force); }) +
            of_pairs("Int32", "touching", 1,
                     [](const DrawnPair& p) { return std::string(p.touching ? "1" : "0"); }) +
            "</CellData>\n<Points>\n" +
            of_pairs("Float64", "Points", 3,
                     [](const DrawnPair& p) { return text_of(p.from) + "\n" + text_of(p.to); }) +
            "</Points>\n" + topology("Lines", s.pairs.size(), 2));
}

Snapshots::Snapshots(fs::path folder, double every)
    : folder_(std::move(folder)),
      dump_(folder_ / "beads.dump"),
      growing_dump_(folder_ / ".beads.dump.part"),
      every_(every) {}

Snapshots::~Snapshots() {
    std::error_code ignored;
    if (begun_ && !frames_.empty()) {
        fs::rename(growing_dump_, dump_, ignored);
    }
}

void Snapshots::operator()(const ShearCell& sample, double strain) {
    const bool resumed = !begun_ && strain > 0;
    if (!begun_) {
        resumed ? resume(sample.steps(), strain) : start_anew();
        begun_ = true;
    }
    if (!resumed && strain >= static_cast<double>(next_) * every_) {
        next_ = std::max(next_, static_cast<std::uint64_t>(strain / every_));
        write(snapshot_of(sample, strain));
        ++next_;
    }
}

void Snapshots::start_anew() {
    fs::create_directories(folder_ / "vtk");
    for (const fs::path& old : {dump_, growing_dump_, folder_ / "snapshots.pvd"}) {
        fs::remove(old);
    }
}

void Snapshots::resume(std::uint64_t step, double strain) {
    fs::create_directories(folder_ / "vtk");
    if (!fs::exists(growing_dump_) && fs::exists(dump_)) {
        fs::rename(dump_, growing_dump_);
    }
    // Frames made after the checkpoint are made again.
    std::uintmax_t keep = 0, frame = 0;
    std::ifstream dump(growing_dump_);
    for (std::string line; std::getline(dump, line);) {
        const auto after = static_cast<std::uintmax_t>(dump.tellg());
        if (line == "ITEM: UNITS") {
            frame = keep = after - line.size() - 1;
        } else if (line == "ITEM: TIMESTEP" && std::getline(dump, line)) {
            if (number_after<std::uint64_t>(line, "").value_or(0) > step) {
                keep = frame;
                break;
            }
            keep = fs::file_size(growing_dump_);
        }
    }
    if (fs::exists(growing_dump_)) {
        fs::resize_file(growing_dump_, keep);
    }
    std::ifstream collection(folder_ / "snapshots.pvd");
    for (std::string line; std::getline(collection, line);) {
        const auto at = number_after<double>(line, "<DataSet timestep=\"");
        const auto number = number_after<std::uint64_t>(line, "file=\"vtk/beads_");
        if (at && number && *at < strain + block_strain / 2) {
            frames_.push_back({.number = *number, .strain = *at});
            next_ = *number + 1;
        }
    }
}

void Snapshots::write(const Snapshot& snapshot) {
    write_whole(folder_ / fmt::format("vtk/beads_{:05}.vtp", next_), grains_vtp(snapshot),
                Kept::by_system);
    write_whole(folder_ / fmt::format("vtk/pairs_{:05}.vtp", next_), pairs_vtp(snapshot),
                Kept::by_system);
    append(dump_frame(snapshot));
    frames_.push_back({next_, snapshot.strain});
    write_collection();
}

void Snapshots::append(const std::string& frame) {
    const auto before = fs::exists(growing_dump_) ? fs::file_size(growing_dump_) : 0;
    std::ofstream stream(growing_dump_, std::ios::binary | std::ios::app);
    stream << frame;
    stream.close();
    if (!stream) {
        const std::string reason = std::strerror(errno);
        std::error_code ignored;
        fs::resize_file(growing_dump_, before, ignored);
        throw std::runtime_error(fmt::format("cannot write {}: {}", dump_.string(), reason));
    }
}

void Snapshots::write_collection() const {
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<!-- pendular, {}; time is the strain -->\n"
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "<Collection>\n",
        units);
    for (const auto& frame : frames_) {
        for (const auto& [part, name] : {std::pair(0, "beads"), std::pair(1, "pairs")}) {
            text += fmt::format(
                "<DataSet timestep=\"{:.10g}\" part=\"{}\" file=\"vtk/{}_{:05}.vtp\"/>\n",
                frame.strain, part, name, frame.number);
        }
    }
    write_whole(folder_ / "snapshots.pvd", text + "</Collection>\n</VTKFile>\n", Kept::by_system);
}

}  // namespace pendular::dem
