#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/dem/shear_cell.h"

namespace pendular::dem {

/// Two grains in contact or joined by a bridge, for drawing.
struct DrawnPair {
    Vector from, to;          ///< centres; `to` may be that of an image outside the cell
    double normal_force = 0;  ///< elastic, of contacts [a^2 s22]
    double bridge_force = 0;  ///< attraction of the bridge [a^2 s22]
    bool touching = false;
};

/// A state for other programs: every grain inside the cell, velocities with the imposed flow
/// included. Reduced units: grain diameter, mass and imposed normal stress are 1.
struct Snapshot {
    struct Grain {
        std::int32_t id = 0;  ///< from 1 on, the same throughout a run
        double radius = 0.5;
        Vector position, velocity, angular_velocity;
        int contacts = 0;
    };
    std::uint64_t step = 0;
    double time = 0;    ///< [sqrt(m/(a s22))]
    double strain = 0;  ///< since the flow began
    Cell cell;          ///< its offset between -length/2 and length/2
    std::vector<Grain> grains;
    std::vector<DrawnPair> pairs;
};
Snapshot snapshot_of(const ShearCell& sample, double strain);

/// One frame of a LAMMPS text dump, as OVITO reads it: a triclinic cell with its corner at the
/// origin, whose bounds are those of the box around it; columns id, type, radius, place, velocity,
/// angular velocity and number of contacts.
std::string dump_frame(const Snapshot& snapshot);

/// ParaView XML PolyData: the grains as points with radius, velocity and contacts.
std::string grains_vtp(const Snapshot& snapshot);
/// ParaView XML PolyData: contacts and bridges as lines between centres with normal_force,
/// bridge_force and touching (1 or 0). A line across a face of the cell leads to the image outside.
std::string pairs_vtp(const Snapshot& snapshot);

/// Writes a run's snapshots into a folder every so much strain, from strain 0 on: `grains.dump`
/// with all frames, and for ParaView `snapshots.pvd` with `vtk/beads_NNNNN.vtp` and
/// `vtk/pairs_NNNNN.vtp`, strain as time. Each file is there whole or not at all; the dump grows as
/// `.grains.dump.part` and takes its name when the object goes, be the run done or stopped. A run
/// resumed from a checkpoint goes on where it was; frames that were made after it are made again.
class Snapshots {
  public:
    Snapshots(std::filesystem::path folder, double every);
    ~Snapshots();
    Snapshots(const Snapshots&) = delete;
    Snapshots& operator=(const Snapshots&) = delete;

    /// An Observer of a run.
    /// @throws std::runtime_error where a file cannot be written
    void operator()(const ShearCell& sample, double strain);
    std::size_t count() const { return frames_.size(); }

  private:
    struct Frame {
        std::uint64_t number = 0;
        double strain = 0;
    };
    void start_anew();
    void resume(std::uint64_t step, double strain);
    void write(const Snapshot& snapshot);
    void append(const std::string& frame);
    void write_collection() const;

    std::filesystem::path folder_, dump_, growing_dump_;
    double every_;
    bool begun_ = false;
    std::uint64_t next_ = 0;  ///< frame
    std::vector<Frame> frames_;
};

}  // namespace pendular::dem
