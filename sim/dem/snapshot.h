#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/dem/shear_cell.h"

namespace pendular::dem {

/// Pair of grains in contact or joined by a liquid bridge. Other programs draw the pair as a line
/// between the centres. Forces are in units of a^2 s22, with grain diameter a and imposed normal
/// stress s22.
struct DrawnPair {
    /// Centres of the first and the second grain of the pair [grain diameters]; `to` may be in a
    /// periodic image outside the cell.
    Vector from, to;
    /// Elastic normal force of the contact divided by a^2 s22 [1], with grain diameter a and
    /// imposed normal stress s22. The force is 0 if the grains do not touch.
    double normal_force = 0;
    /// Attraction of the pair by its liquid bridge divided by a^2 s22 [1], with grain diameter a
    /// and imposed normal stress s22. The attraction is 0 without bridge.
    double bridge_force = 0;
    bool touching = false;
};

/// State of a sample for export to other programs, in reduced units (grain diameter, grain mass and
/// imposed normal stress are 1). All grains are inside the cell. Velocities include the imposed
/// flow.
struct Snapshot {
    struct Grain {
        std::int32_t id = 0;  ///< number of the grain from 1 on, constant throughout a run
        double radius = 0.5;
        Vector position, velocity, angular_velocity;
        int contacts = 0;
    };
    std::uint64_t step = 0;
    double time = 0;    ///< time of the snapshot since the flow began, in reduced units
    double strain = 0;  ///< shear strain of the snapshot since the flow began [1]
    /// Periodic cell that contains the grains. The shear offset of its images (Lees-Edwards
    /// boundary conditions) is between -length/2 and length/2.
    Cell cell;
    std::vector<Grain> grains;
    std::vector<DrawnPair> pairs;
};
Snapshot snapshot_of(const ShearCell& sample, double strain);

/// Returns a snapshot as one frame of a LAMMPS text dump, which OVITO reads. The cell is triclinic,
/// with a corner at the origin, and is given by the bounds of the surrounding box and the tilt
/// factors. The columns are id, type, radius, position, velocity, angular velocity and number of
/// contacts.
std::string dump_frame(const Snapshot& snapshot);

/// Returns the grains of a snapshot as the text of a VTK PolyData file (XML) for ParaView. Each
/// grain is a point with id, radius, velocity, angular velocity and number of contacts
/// (coordination), in reduced units (grain diameter, grain mass and imposed normal stress are 1).
std::string grains_vtp(const Snapshot& snapshot);
/// Returns the contacts and bridges of a snapshot as the text of a VTK PolyData file (XML) for
/// ParaView. Each pair is a line between the centres of two grains, with normal_force, bridge_force
/// and touching (1 or 0). Forces are in units of a^2 s22, with grain diameter a and imposed normal
/// stress s22. A line that crosses a face of the cell ends outside the cell.
std::string pairs_vtp(const Snapshot& snapshot);

/// Writer of snapshots of a run into a folder, at shear strains 0, `every`, 2 `every` and so on.
/// The file `beads.dump` (LAMMPS text dump) contains all snapshots. Until the object is destroyed,
/// the name of this file is `.beads.dump.part`. For ParaView, `snapshots.pvd` lists the files
/// `vtk/beads_NNNNN.vtp` and `vtk/pairs_NNNNN.vtp` with the strain as time. If a run resumes from a
/// checkpoint, the object writes all snapshots after the checkpoint anew.
class Snapshots {
  public:
    Snapshots(std::filesystem::path folder, double every);
    ~Snapshots();
    Snapshots(const Snapshots&) = delete;
    Snapshots& operator=(const Snapshots&) = delete;

    /// Writes a snapshot of the sample if a snapshot is due. With this operator, the object can be
    /// an `Observer` of a run.
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
    std::uint64_t next_ = 0;  ///< number, from 0, of the next snapshot to be written
    std::vector<Frame> frames_;
};

}  // namespace pendular::dem
