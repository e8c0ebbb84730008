// Snapshots read back as other programs read them, against the state they were taken of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "sim/dem/checkpoint.h"
#include "sim/dem/run.h"
#include "sim/dem/shear_cell.h"
#include "sim/dem/snapshot.h"
#include "sim/runs/run_request.h"
#include "tests/support/app_support.h"

namespace sim_snapshot_test {

using namespace pendular;
using namespace pendular::dem;
using testing::HasSubstr;

/// A wet sample in flow, its lattice tilted to one side or the other.
ShearCell tilted_sample(bool to_the_left) {
    ShearCell sample(150, {.modulus = 3e4, .friction = 0.3}, 0.1, 5,
                     BridgeLaw({.reduced_pressure = 2, .bridge_volume = 4e-3}));
    EXPECT_TRUE(sample.compress());
    const auto offset = [&] {
        dem::Cell cell = sample.cell();
        cell.reduce_offset();
        return cell.offset;
    };
    const double begin = sample.strain();
    while (sample.strain() < begin + 0.3 || (to_the_left ? offset() > -1 : offset() < 1)) {
        sample.step();
    }
    return sample;
}

/// The numbers between <DataArray ... Name="name" ...> and its end.
std::vector<double> data_array(const std::string& vtp, const std::string& name) {
    const auto at = vtp.find("Name=\"" + name + "\"");
    EXPECT_NE(at, std::string::npos) << name;
    const auto begin = vtp.find('>', at) + 1;
    std::istringstream text(vtp.substr(begin, vtp.find('<', begin) - begin));
    return {std::istream_iterator<double>(text), {}};
}

/// Whether two places differ by whole lattice vectors.
bool same_place(const dem::Cell& cell, const Vector& a, const Vector& b) {
    const Vector apart = cell.fractions(a - b);
    for (std::size_t d = 0; d < 3; ++d) {
        if (std::abs(apart[d] - std::round(apart[d])) > 1e-8) {
            return false;
        }
    }
    return true;
}

struct ReadFrame {
    double time = 0;
    long step = 0;
    dem::Cell cell;
    std::map<int, Vector> position, velocity, angular_velocity;
    std::map<int, int> coordination;
};

/// Frame of a LAMMPS dump of a triclinic cell, by the LAMMPS manual, "Howto triclinic": the bounds
/// are those of the box around the cell, xlo_bound = xlo + min(0, xy), xhi_bound = xhi + max(0,
/// xy).
ReadFrame read_frame(std::istream& text) {
    ReadFrame frame;
    std::string line;
    std::getline(text, line);
    EXPECT_EQ(line, "ITEM: UNITS");
    std::getline(text, line);
    EXPECT_THAT(line, HasSubstr("reduced units"));
    std::size_t count = 0;
    double low = 0, high = 0, zero = 0;
    std::getline(text, line), text >> frame.time, std::getline(text, line);
    std::getline(text, line);
    EXPECT_EQ(line, "ITEM: TIMESTEP");
    text >> frame.step, std::getline(text, line), std::getline(text, line);
    text >> count, std::getline(text, line), std::getline(text, line);
    EXPECT_EQ(line, "ITEM: BOX BOUNDS xy xz yz pp pp pp");
    text >> low >> high >> frame.cell.offset;
    const double xlo = low - std::min(0.0, frame.cell.offset);
    EXPECT_NEAR(xlo, 0, 1e-12);
    frame.cell.length = high - std::max(0.0, frame.cell.offset) - xlo;
    text >> zero >> frame.cell.height >> zero >> zero >> frame.cell.width >> zero;
    std::getline(text, line), std::getline(text, line);
    EXPECT_EQ(line,
              "ITEM: ATOMS id type radius x y z vx vy vz angular_velocity_x angular_velocity_y "
              "angular_velocity_z coordination");
    for (std::size_t k = 0; k < count; ++k) {
        int id = 0, type = 0;
        double radius = 0;
        std::array<double, 9> v{};
        text >> id >> type >> radius;
        for (double& component : v) {
            text >> component;
        }
        text >> frame.coordination[id];
        EXPECT_EQ(radius, 0.5);
        frame.position[id] = {v[0], v[1], v[2]};
        frame.velocity[id] = {v[3], v[4], v[5]};
        frame.angular_velocity[id] = {v[6], v[7], v[8]};
    }
    std::getline(text, line);
    return frame;
}

std::size_t frames_in(const std::string& dump) {
    std::size_t count = 0;
    std::istringstream text(dump);
    while (text.peek() != std::istringstream::traits_type::eof()) {
        read_frame(text);
        ++count;
    }
    return count;
}

RunParameters small_run() {
    return {.friction = 0.2,
            .inertial_number = 0.05,
            .stiffness_number = 300,
            .grains = 100,
            .strain = 0.5,
            .seed = 3};
}

TEST(Dump, HoldsTheStateInATiltedCell) {
    for (const bool to_the_left : {false, true}) {
        const ShearCell sample = tilted_sample(to_the_left);
        std::istringstream text(dump_frame(snapshot_of(sample, 0.4)));
        const ReadFrame frame = read_frame(text);
        EXPECT_NEAR(frame.time, 0.4 / 0.1, 1e-9);
        EXPECT_EQ(frame.step, static_cast<long>(sample.steps()));
        EXPECT_NEAR(frame.cell.length, sample.cell().length, 1e-12);
        EXPECT_NEAR(frame.cell.height, sample.cell().height, 1e-12);
        EXPECT_EQ(frame.cell.offset < 0, to_the_left);
        ASSERT_EQ(frame.position.size(), sample.grains().size());
        for (std::size_t i = 0; i < sample.grains().size(); ++i) {
            const int id = sample.grains().number[i] + 1;
            const Vector& place = frame.position.at(id);
            EXPECT_TRUE(same_place(frame.cell, place, sample.grains().position(i)));
            const Vector at = frame.cell.fractions(place);
            for (std::size_t d = 0; d < 3; ++d) {
                EXPECT_GE(at[d], -1e-9);
                EXPECT_LE(at[d], 1 + 1e-9);
            }
            const Vector v = sample.grains().velocity(i);
            EXPECT_NEAR(frame.velocity.at(id)[0], v[0] + 0.1 * place[1], 1e-8);
            EXPECT_NEAR(frame.velocity.at(id)[1], v[1] + sample.flow().height_rate * place[1],
                        1e-8);
            EXPECT_NEAR(frame.angular_velocity.at(id)[2], sample.grains().angular_velocity(i)[2],
                        1e-8);
        }
    }
}

TEST(Vtp, DrawsContactsAndBridgesToTheImagesAcrossTheFaces) {
    const ShearCell sample = tilted_sample(true);
    const Snapshot snapshot = snapshot_of(sample, 0.4);
    const std::string vtp = pairs_vtp(snapshot);
    const auto points = data_array(vtp, "Points"), force = data_array(vtp, "normal_force"),
               attraction = data_array(vtp, "bridge_force"), touching = data_array(vtp, "touching");
    const auto& near = sample.pairs().narrow();
    const auto& distant = sample.pairs().distant();
    std::size_t contacts = 0, bridges = 0;
    for (std::size_t k = 0; k < near.size(); ++k) {
        contacts += near.root[k] > 0;
        bridges += near.root[k] == 0 && near.bridge[k] > 0;
    }
    bridges += static_cast<std::size_t>(std::ranges::count(distant.bridge, 1.0));
    ASSERT_GT(contacts, 100u);
    ASSERT_GT(bridges, 10u);
    ASSERT_EQ(touching.size(), contacts + bridges);
    ASSERT_EQ(points.size(), 6 * touching.size());
    EXPECT_EQ(std::ranges::count(touching, 1.0), static_cast<long>(contacts));
    std::size_t across = 0;
    const auto is_a_grain = [&](const Vector& place) {
        return std::ranges::any_of(sample.grains().motion, [&](const Grains::Motion& bead) {
            return same_place(snapshot.cell, place, bead.position);
        });
    };
    for (std::size_t k = 0; k < touching.size(); ++k) {
        const double* p = points.data() + 6 * k;
        const Vector from{p[0], p[1], p[2]}, to{p[3], p[4], p[5]};
        EXPECT_TRUE(is_a_grain(from) && is_a_grain(to));
        const double length = std::sqrt(dot(to - from, to - from));
        EXPECT_EQ(force[k] > 0, touching[k] == 1);
        EXPECT_TRUE(touching[k] == 1 ? length < 1.01 : length > 0.99);  // moved one step since
        EXPECT_LT(length, 1.01 + std::cbrt(4e-3));
        EXPECT_NEAR(attraction[k], touching[k] == 1 ? 0.5 : attraction[k], 1e-9);  // 1/P*
        EXPECT_GT(attraction[k], 0);
        const Vector wrapped = snapshot.cell.wrapped(to) - to;
        across += dot(wrapped, wrapped) > 1e-6;
    }
    EXPECT_GT(across, 10u);
    EXPECT_EQ(data_array(vtp, "offsets").back(), static_cast<double>(2 * touching.size()));
}

TEST(Vtp, HoldsEveryBead) {
    const ShearCell sample = tilted_sample(false);
    const std::string vtp = grains_vtp(snapshot_of(sample, 0.4));
    const auto points = data_array(vtp, "Points"), id = data_array(vtp, "id"),
               coordination = data_array(vtp, "coordination");
    ASSERT_EQ(points.size(), 3 * sample.grains().size());
    double contacts = 0;
    for (std::size_t i = 0; i < id.size(); ++i) {
        EXPECT_EQ(id[i], sample.grains().number[i] + 1);
        EXPECT_TRUE(same_place(sample.cell(), {points[3 * i], points[3 * i + 1], points[3 * i + 2]},
                               sample.grains().position(i)));
        contacts += coordination[i];
    }
    double expected = 0;
    for (const double root : sample.pairs().narrow().root) {
        expected += 2 * (root > 0);
    }
    EXPECT_EQ(contacts, expected);
}

TEST(Snapshots, ComeEverySoMuchStrainAndAreTheSameAfterAnInterruption) {
    const TemporaryFolder whole, pieces;
    {
        Snapshots snapshots(whole.path(), 0.1);
        simulate(small_run(), {.observers = {std::ref(snapshots)}});
        EXPECT_FALSE(std::filesystem::exists(whole.path() / "beads.dump"));  // not yet
    }
    for (const double until : {0.25, 1e9}) {
        Checkpoint checkpoint(pieces.path() / "checkpoint");
        Snapshots snapshots(pieces.path(), 0.1);
        std::stop_source stop;
        const Observer stop_there = [&](const ShearCell&, double strain) {
            if (strain > until) {
                stop.request_stop();
            }
        };
        const RunOptions options{.stop = stop.get_token(),
                                 .observers = {std::ref(snapshots), stop_there},
                                 .checkpoint = &checkpoint};
        if (until < 1) {
            EXPECT_THROW(simulate(small_run(), options), Interrupted);
        } else {
            // As if the process had been killed after a frame that came after the checkpoint.
            const auto dump = pieces.path() / "beads.dump";
            const std::string saved = content_of(dump);
            std::string later = saved.substr(0, saved.find("ITEM: UNITS", 1));
            const auto step = later.find("TIMESTEP\n") + 9;
            later.replace(step, later.find('\n', step) - step, "999999999");
            std::ofstream(dump, std::ios::app) << later;
            simulate(small_run(), options);
        }
    }
    EXPECT_EQ(content_of(pieces.path() / "beads.dump"), content_of(whole.path() / "beads.dump"));
    EXPECT_EQ(content_of(pieces.path() / "snapshots.pvd"),
              content_of(whole.path() / "snapshots.pvd"));
    const std::size_t frames = frames_in(content_of(whole.path() / "beads.dump"));
    EXPECT_GE(frames, 15u);  // strain 1 to 2 in all, one at the start
    std::size_t listed = 0;
    std::istringstream collection(content_of(whole.path() / "snapshots.pvd"));
    for (std::string line; std::getline(collection, line);) {
        const auto at = line.find("file=\"");
        if (at != std::string::npos) {
            const std::string name = line.substr(at + 6, line.find('"', at + 6) - at - 6);
            EXPECT_TRUE(std::filesystem::exists(whole.path() / name)) << name;
            ++listed;
        }
    }
    EXPECT_EQ(listed, 2 * frames);
}

}  // namespace sim_snapshot_test
