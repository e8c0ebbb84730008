#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sim/dem/fields.h"
#include "sim/dem/shear_cell.h"
#include "sim/dem/structure.h"
#include "sim/dem/trace.h"

namespace pendular::dem {

/// Shear strain of one block of a run [1]. The averages over one block are one element of the time
/// series of the run.
constexpr double block_strain = 0.02;

/// Averages of a simulation over one block (shear strain of `block_strain`). Stresses are divided
/// by the imposed normal stress [1]. Compression is positive.
struct Block {
    double strain = 0;
    double s11 = 0, s22 = 0, s33 = 0, s12 = 0, solid_fraction = 0, localization = 0;
    /// Mean volume of a liquid bridge divided by the mean volume V0 of newly formed bridges [1];
    /// the value is 1 without bridges.
    double bridge_volume = 0;
    /// Power per volume that each mechanism dissipates in the block, divided by the shear rate and
    /// the imposed normal stress [1]. The members for stored energies are 0.
    PairEnergy dissipation;
    Structure structure;
    FieldSums fields;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(strain, s11, s22, s33, s12, solid_fraction, localization, bridge_volume,
                dissipation.friction, dissipation.viscosity, dissipation.bridges,
                dissipation.unloading, structure, fields);
    }
};

/// Block (shear strain of `block_strain`) of a run that is not complete yet. The quantities to be
/// averaged are summed step by step, so that the run can be stopped and resumed between any two
/// time steps.
class OpenBlock {
  public:
    OpenBlock() = default;
    explicit OpenBlock(const ShearCell& sample);

    bool full(const ShearCell& sample) const { return sample.strain() >= begin_ + block_strain; }
    /// Returns the shear strain of the sample when the block began [1].
    double begin() const { return begin_; }
    /// Advances the sample by one time step and adds the stress and the solid fraction of the
    /// sample to the sums of the block. Dissipation, velocities, and observables of contacts and
    /// bridges are added only after some of the time steps.
    void step(ShearCell& sample);
    /// Whether a run should check now for stop requests and due checkpoints: every 16 time steps,
    /// right after the velocities of all grains were added to the sums of the block.
    static bool pauses(const ShearCell& sample);
    /// Ends the block and returns its averages. Stresses and solid fraction are averages over all
    /// time steps of the block. Profiles of solid fraction and distributions over pairs of grains
    /// come from the last state only. All other quantities are averages over some time steps of the
    /// block.
    /// @param sample state at the end of the block
    Block close(const ShearCell& sample);

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(sums_, motion_, begin_, steps_, energy_samples_, structures_);
    }

  private:
    void add_dissipation(const PairEnergy& lost, double volume, double strain);
    void add_structure(const ShearCell& sample);
    void add_fields(const ShearCell& sample);

    Block sums_;
    MotionProfile motion_;
    double begin_ = 0;
    double steps_ = 0, energy_samples_ = 0;
    int structures_ = 0;
};

/// Time series of a run: averages over successive blocks (shear strains of `block_strain`).
/// Averages of the run and the end of the transient are computed from the time series.
class Series {
  public:
    void add(Block block) { blocks_.push_back(std::move(block)); }
    std::size_t size() const { return blocks_.size(); }

    /// Returns the total shear strain [1] of the blocks from number `from` to number `to` - 1,
    /// counted from 0.
    double strain(std::size_t from, std::size_t to) const {
        double sum = 0;
        for (std::size_t k = from; k < to; ++k) {
            sum += blocks_[k].strain;
        }
        return sum;
    }

    template <typename Value>
    std::vector<double> values(std::size_t from, Value value) const {
        std::vector<double> result;
        for (std::size_t k = from; k < blocks_.size(); ++k) {
            result.push_back(value(blocks_[k]));
        }
        return result;
    }
    /// Returns a time series of the ratio of two quantities, with one value per block, from block
    /// number `from` on, counted from 0. Each value is numerator(block)/denominator(block),
    /// linearised about the means of numerator and denominator. The mean of the values is therefore
    /// the mean numerator divided by the mean denominator.
    template <typename Numerator, typename Denominator>
    std::vector<double> ratio(std::size_t from, Numerator numerator,
                              Denominator denominator) const {
        double top = 0, bottom = 0;
        for (std::size_t k = from; k < blocks_.size(); ++k) {
            top += numerator(blocks_[k]);
            bottom += denominator(blocks_[k]);
        }
        const double value = top / bottom,
                     mean = bottom / static_cast<double>(blocks_.size() - from);
        return values(from, [&](const Block& b) {
            return value + (numerator(b) - value * denominator(b)) / mean;
        });
    }
    std::vector<double> stress_ratio(std::size_t from) const {
        return ratio(
            from, [](const Block& b) { return -b.s12; }, [](const Block& b) { return b.s22; });
    }
    std::vector<double> solid_fraction(std::size_t from) const {
        return values(from, [](const Block& b) { return b.solid_fraction; });
    }
    std::vector<double> structure(std::size_t from, double Structure::*which) const {
        return values(from, [&](const Block& b) { return b.structure.*which; });
    }
    /// Returns the average of the field `which` (quantity as a function of one coordinate) in each
    /// bin, with its standard error. The average is over the blocks from number `from` on, counted
    /// from 0: the mean of `BinnedSums::sum` divided by the mean of `BinnedSums::weight`. If a bin
    /// has no data, the average is NaN.
    BinnedMeans field(std::size_t from, Field which, const Bins1d& bins) const;
    /// Returns the number of blocks at the start of a run in which the flow is not yet steady;
    /// empty if the flow has not become steady so far. Averages must exclude these blocks. The
    /// function examines the stress ratio and the solid fraction. If `wet` is true, the function
    /// also examines the number of bridges on a grain to grains that it does not touch.
    std::optional<std::size_t> transient(bool wet) const;
    Trace trace() const;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(blocks_);
    }

  private:
    std::vector<Block> blocks_;
};

}  // namespace pendular::dem
