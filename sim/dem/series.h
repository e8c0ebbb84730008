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

/// Strain of one block [1]: a run averages over it before it checks its state.
constexpr double block_strain = 0.02;

/// Averages over one block of strain.
struct Block {
    double strain = 0;
    double s11 = 0, s22 = 0, s33 = 0, s12 = 0, solid_fraction = 0, localization = 0;
    PairEnergy dissipation;  ///< its losses only: power per volume over shear rate [s22]
    Structure structure;
    FieldSums fields;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(strain, s11, s22, s33, s12, solid_fraction, localization, dissipation.friction,
                dissipation.viscosity, dissipation.bridges, dissipation.unloading, structure,
                fields);
    }
};

/// A block in progress. It grows step by step, so that a run can stop between any two steps.
class OpenBlock {
  public:
    OpenBlock() = default;
    explicit OpenBlock(const ShearCell& sample);

    bool full(const ShearCell& sample) const { return sample.strain() >= begin_ + block_strain; }
    double begin() const { return begin_; }  ///< strain of the sample
    /// Advances the sample by one step and adds its state to the block.
    void step(ShearCell& sample);
    /// Whether `step` has just measured every grain: a moment at which a pause costs little time.
    static bool pauses(const ShearCell& sample);
    /// Averages over all steps of the block. Profiles of solid fraction and distributions over
    /// pairs are taken from its last state only, since more would cost several per cent of a fast
    /// run's time.
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

/// Blocks of a run so far, with the averages and the transient found from them.
class Series {
  public:
    void add(Block block) { blocks_.push_back(std::move(block)); }
    std::size_t size() const { return blocks_.size(); }

    /// Strain of the blocks [from, to).
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
    /// Linearised series of a ratio of means: its mean is the ratio, its scatter the ratio's.
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
    /// One field over the blocks from `from` on; each bin a ratio of means.
    BinnedMeans field(std::size_t from, Field which, const Bins1d& bins) const;
    /// Blocks to leave out as transient, judged on stress ratio, solid fraction and, where there
    /// are bridges, Z_d, which is the slowest; empty: not steady yet.
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
