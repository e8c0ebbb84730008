#include "sim/dem/series.h"

#include <algorithm>
#include <limits>

#include "data/recordings/time_series.h"

namespace pendular::dem {
namespace {

/// Structures that are measured in a block. Chosen: those of neighbouring steps are nearly equal,
/// so that more of them cost time and add little.
constexpr int structures_per_block = 4;
/// Steps between two samples of the grains' velocities, and between two samples of the dissipated
/// energies, which are also sampled at the first step of a block. Energy accounting nearly doubles
/// the time of a step.
constexpr int steps_between_samples = 16, steps_between_accounts = 64;

}  // namespace

OpenBlock::OpenBlock(const ShearCell& sample) : begin_(sample.strain()) {
    const auto bins = [&](Coordinate coordinate) {
        return bins_of(coordinate, static_cast<int>(sample.grains().size()),
                       sample.bridges().rupture_distance)
            .count;
    };
    motion_ = MotionProfile(bins(Coordinate::height));
    for (std::size_t k = 0; k < field_count; ++k) {
        sums_.fields[k] = BinnedSums(bins(fields[k].coordinate));
    }
}

bool OpenBlock::pauses(const ShearCell& sample) {
    return sample.steps() % steps_between_samples == 0;
}

void OpenBlock::step(ShearCell& sample) {
    const bool accounted = steps_ == 0 || (sample.steps() + 1) % steps_between_accounts == 0;
    const double volume = sample.cell().volume(), strain = sample.strain();
    sample.step(accounted ? EnergyAccounting::on : EnergyAccounting::off);
    const Stress& stress = sample.stress();
    sums_.s11 += stress.s11, sums_.s22 += stress.s22, sums_.s33 += stress.s33,
        sums_.s12 += stress.s12;
    sums_.solid_fraction += sample.solid_fraction();
    steps_ += 1;
    if (accounted) {
        add_dissipation(sample.energy(), volume, sample.strain() - strain);
    }
    if (sample.steps() % steps_between_samples == 0) {
        motion_.add(sample.grains(), sample.cell().height);
    }
    if (sample.strain() - begin_ >= block_strain * (structures_ + 1) / structures_per_block) {
        add_structure(sample);
    }
}

void OpenBlock::add_dissipation(const PairEnergy& lost, double volume, double strain) {
    const double share = 1 / (volume * strain);
    PairEnergy& sum = sums_.dissipation;
    sum.friction += share * lost.friction;
    sum.viscosity += share * lost.viscosity;
    sum.bridges += share * lost.bridges;
    sum.unloading += share * lost.unloading;
    energy_samples_ += 1;
}

void OpenBlock::add_structure(const ShearCell& sample) {
    sums_.structure += structure_of(sample.grains(), sample.cell(), sample.pairs().narrow(),
                                    sample.pairs().distant(), sample.material(), sample.bridges(),
                                    sample.effects());
    sums_.bridge_volume += mean_bridge_volume(sample.pairs(), sample.effects());
    motion_.add(sample.grains(), sample.cell().height);
    ++structures_;
}

void OpenBlock::add_fields(const ShearCell& sample) {
    FieldSums& sums = sums_.fields;
    const double height = sample.cell().height, rate = sample.shear_rate();
    add_distributions(sample.grains(), sample.cell(), sample.pairs().narrow(),
                      sample.pairs().distant(), sample.material(), sample.bridges(), sums);
    add_solid_fraction(sample.grains(), sample.cell(),
                       sums[static_cast<std::size_t>(Field::solid_fraction)]);
    sums[static_cast<std::size_t>(Field::velocity)] = motion_.velocity(height, rate);
    sums[static_cast<std::size_t>(Field::granular_temperature)] = motion_.temperature(rate);
}

Block OpenBlock::close(const ShearCell& sample) {
    add_fields(sample);
    Block block = std::move(sums_);
    block.strain = sample.strain() - begin_;
    block.structure /= structures_;
    block.bridge_volume /= structures_;
    for (double* sum : {&block.s11, &block.s22, &block.s33, &block.s12, &block.solid_fraction}) {
        *sum /= steps_;
    }
    PairEnergy& lost = block.dissipation;
    for (double* sum : {&lost.friction, &lost.viscosity, &lost.bridges, &lost.unloading}) {
        *sum /= energy_samples_;
    }
    block.localization = motion_.localization(sample.cell().height, sample.shear_rate());
    return block;
}

BinnedMeans Series::field(std::size_t from, Field which, const Bins1d& bins) const {
    const auto of = [&](const Block& block) -> const BinnedSums& {
        return block.fields[static_cast<std::size_t>(which)];
    };
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    BinnedMeans result;
    for (std::size_t bin = 0; bin < bins.count; ++bin) {
        const auto weight = [&](const Block& block) { return of(block).weight[bin]; };
        const auto weights = values(from, weight);
        const bool seen = std::ranges::any_of(weights, [](double w) { return w > 0; });
        result.at.push_back(bins.middle(bin));
        result.means.push_back(
            seen ? mean_of_correlated(ratio(
                       from, [&](const Block& b) { return of(b).sum[bin]; }, weight))
                 : Mean{nothing, nothing});
    }
    return result;
}

std::optional<std::size_t> Series::transient(bool wet) const {
    std::size_t end = 0;
    std::vector<std::vector<double>> all = {stress_ratio(0), solid_fraction(0)};
    if (wet) {
        all.push_back(structure(0, &Structure::distant_coordination));
    }
    for (const auto& series : all) {
        const auto found = end_of_transient(series);
        if (!found) {
            return std::nullopt;
        }
        end = std::max(end, *found);
    }
    return end;
}

Trace Series::trace() const {
    Trace trace;
    const auto single = [](double value) { return static_cast<float>(value); };
    for (const Block& b : blocks_) {
        trace.push_back({.strain = single(b.strain),
                         .s11 = single(b.s11),
                         .s22 = single(b.s22),
                         .s33 = single(b.s33),
                         .s12 = single(b.s12),
                         .solid_fraction = single(b.solid_fraction),
                         .contact_coordination = single(b.structure.contact_coordination),
                         .distant_coordination = single(b.structure.distant_coordination),
                         .localization = single(b.localization)});
    }
    return trace;
}

}  // namespace pendular::dem
