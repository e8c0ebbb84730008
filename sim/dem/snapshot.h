#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/dem/cell.h"

namespace pendular::dem {

class ShearCell;

/// Pair of grains in contact or joined by a bridge, which other programs draw as a line between the
/// centres.
struct DrawnPair {
    /// Centres of the two grains [grain diameters]; `to` may be in a periodic image outside the
    /// cell.
    Vector from, to;
    double normal_force = 0;  ///< elastic force over a^2 s22; 0 without contact
    double bridge_force = 0;  ///< attraction over a^2 s22; 0 without bridge
    bool touching = false;
};

/// State of a sample for export to other programs, in reduced units: grain diameter a, grain mass
/// and imposed normal stress s22 are 1. All grains are inside the cell. Velocities include the
/// imposed flow.
struct Snapshot {
    struct Grain {
        std::int32_t id = 0;  ///< from 1, constant throughout a run
        double radius = 0.5;
        Vector position, velocity, angular_velocity;
        int contacts = 0;
    };
    std::uint64_t step = 0;
    double time = 0;    ///< since the flow began
    double strain = 0;  ///< since the flow began
    Cell cell;          ///< with its offset between -length/2 and length/2
    std::vector<Grain> grains;
    std::vector<DrawnPair> pairs;
};
Snapshot snapshot_of(const ShearCell& sample, double strain);

/// Returns a snapshot as one frame of a LAMMPS text dump, which OVITO reads. The cell is triclinic,
/// with a corner at the origin, given by the bounds of the surrounding box and the tilt factors.
/// The columns are id, type, radius, position, velocity, angular velocity and number of contacts.
std::string dump_frame(const Snapshot& snapshot);

/// Returns the grains as a VTK PolyData file (XML) for ParaView: points with id, radius, velocity,
/// angular velocity and number of contacts (coordination).
std::string grains_vtp(const Snapshot& snapshot);
/// Returns contacts and bridges as a VTK PolyData file (XML) for ParaView: lines between the
/// centres of two grains, with normal_force, bridge_force and touching (1 or 0). A line that
/// crosses a face of the cell ends outside the cell.
std::string pairs_vtp(const Snapshot& snapshot);

/// Writer of snapshots of a run into a folder, at shear strains 0, `every`, 2 `every` and so on.
/// The file `beads.dump` (LAMMPS text dump) contains all snapshots; until the object is destroyed,
/// its name is `.beads.dump.part`. For ParaView, `snapshots.pvd` lists the files
/// `vtk/beads_NNNNN.vtp` and `vtk/pairs_NNNNN.vtp` with the strain as time. If a run resumes from a
/// checkpoint, all snapshots after the checkpoint are written anew.
class Snapshots {
  public:
    Snapshots(std::filesystem::path folder, double every);
    ~Snapshots();
    Snapshots(const Snapshots&) = delete;
    Snapshots& operator=(const Snapshots&) = delete;

    /// Writes a snapshot if one is due; makes the object an `Observer` of a run.
    /// @param strain shear strain since the flow began [1]
    /// @throws std::runtime_error if a file cannot be written
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
    std::uint64_t next_ = 0;  ///< from 0
    std::vector<Frame> frames_;
};

}  // namespace pendular::dem
