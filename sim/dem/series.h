#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sim/dem/fields.h"
#include "sim/dem/run_result.h"
#include "sim/dem/shear_cell.h"
#include "sim/dem/structure.h"

namespace pendular::dem {

/// Shear strain of one block [1]. The averages over one block are one element of the time series. A
/// block is shorter than the strain over which the stress ratio decorrelates, 0.03.
constexpr double block_strain = 0.02;

/// Averages over one block. Stresses are divided by the imposed normal stress [1]. Compression is
/// positive.
struct Block {
    double strain = 0;
    double s11 = 0, s22 = 0, s33 = 0, s12 = 0, solid_fraction = 0, localization = 0;
    /// Mean volume of a bridge over the mean volume V0 of newly formed bridges [1]; 1 without
    /// bridges.
    double bridge_volume = 0;
    /// Power per volume that each mechanism dissipates, over shear rate and imposed normal stress
    /// [1]. The members for stored energies are 0.
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

/// Block that is not complete yet. Quantities are summed step by step, so that the run can be
/// stopped and resumed between any two time steps.
class OpenBlock {
  public:
    OpenBlock() = default;
    explicit OpenBlock(const ShearCell& sample);

    bool full(const ShearCell& sample) const { return sample.strain() >= begin_ + block_strain; }
    /// Returns the shear strain of the sample when the block began [1].
    double begin() const { return begin_; }
    /// Advances the sample by one time step and adds stress and solid fraction to the sums.
    /// Dissipation, velocities, and observables of contacts and bridges are added only after some
    /// of the time steps.
    void step(ShearCell& sample);
    /// Whether a run should check now for stop requests and due checkpoints: every 16 time steps,
    /// right after the velocities of all grains were added to the sums.
    static bool pauses(const ShearCell& sample);
    /// Returns the averages of the block. Stresses and solid fraction are averages over all time
    /// steps, profiles of solid fraction and distributions over pairs come from the last state
    /// only, all other quantities are averages over some time steps.
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

/// Time series of a run, block by block, from which its averages and the end of the transient are
/// computed. Blocks are counted from 0.
class Series {
  public:
    void add(Block block) { blocks_.push_back(std::move(block)); }
    std::size_t size() const { return blocks_.size(); }

    /// Returns the total shear strain [1] of the blocks from number `from` to number `to` - 1.
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
    /// Returns a time series of the ratio of two quantities, from block number `from` on. Each
    /// value is numerator(block)/denominator(block), linearised about the means of both, so that
    /// the mean of the values is the mean numerator over the mean denominator.
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
    /// Returns the average of a field in each bin, with its standard error, over the blocks from
    /// number `from` on: the mean of `BinnedSums::sum` over the mean of `BinnedSums::weight`; NaN
    /// for a bin without data.
    BinnedMeans field(std::size_t from, Field which, const Bins1d& bins) const;
    /// Returns the number of blocks at the start of a run in which the flow is not yet steady,
    /// which averages must exclude; empty if it has not become steady so far. Stress ratio and
    /// solid fraction decide and, if `wet`, the number of bridges without contact on a grain.
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
