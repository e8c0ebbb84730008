#include "sim/dem/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>

#include "sim/dem/shear_cell.h"
#include "sim/dem/structure.h"

namespace pendular::dem {
namespace {

constexpr double block_strain = 0.02;
/// Before that no state is called steady; bridges live a strain of order 1.
constexpr double first_look_strain = 1.0, first_wet_look_strain = 2.0;
constexpr double look_every_strain = 0.25;
constexpr int structures_per_block = 4;
constexpr int steps_between_profiles = 16;
/// Sheared random samples showed 0.04 to 0.05 with 1000 beads, 0.10 with 100, crystals 0.3 to 0.55.
constexpr double crystal_bond_order = 0.2;

void demand(bool holds, const std::string& what) {
    if (!holds) {
        throw std::invalid_argument(what);
    }
}

void check(const Wetting& w, double edge) {
    demand(w.reduced_pressure >= 0.05 && w.reduced_pressure <= 1e6,
           fmt::format("reduced pressure {} is not between 0.05 and 1e6", w.reduced_pressure));
    demand(w.bridge_volume >= 1e-6,
           fmt::format("bridge volume {} a^3 is not at least 1e-6", w.bridge_volume));
    const double rupture_distance = BridgeLaw(w).rupture_distance;
    demand(rupture_distance <= edge / 4,
           fmt::format("the rupture distance of a bridge of volume {} a^3, {:.3g} diameters, is "
                       "beyond a quarter of the box, {:.3g} diameters: use more beads or a smaller "
                       "bridge volume",
                       w.bridge_volume, rupture_distance, edge));
}

}  // namespace

void check(const RunParameters& p) {
    demand(p.friction >= 0 && p.friction <= 2,
           fmt::format("friction {} is not between 0 and 2", p.friction));
    demand(p.inertial_number >= 1e-5 && p.inertial_number <= largest_inertial_number,
           fmt::format("inertial number {} is not between 1e-5 and {}", p.inertial_number,
                       largest_inertial_number));
    demand(p.stiffness_number >= 100 && p.stiffness_number <= 1e6,
           fmt::format("stiffness number {} is not between 100 and 1e6", p.stiffness_number));
    demand(p.poisson_ratio > -1 && p.poisson_ratio <= 0.5,
           fmt::format("Poisson ratio {} is not between -1 and 0.5", p.poisson_ratio));
    demand(p.damping >= 0 && p.damping <= 10,
           fmt::format("damping {} is not between 0 and 10", p.damping));
    demand(
        p.beads >= ShearCell::fewest_beads && p.beads <= 10'000'000,
        fmt::format("{} beads: a sample needs {} to 10000000", p.beads, ShearCell::fewest_beads));
    demand(
        p.strain >= 0.5 && p.strain <= 1e4,
        fmt::format(
            "averaged strain {} is not between 0.5 and 10000; solid fractions decorrelate over a "
            "strain of 0.1 to 0.2",
            p.strain));
    if (p.wetting) {
        check(*p.wetting, ShearCell::edge(p.beads));
    }
}

namespace {

/// Averages over one block of strain.
struct Block {
    double strain = 0;
    double s11 = 0, s22 = 0, s33 = 0, s12 = 0, solid_fraction = 0, localization = 0;
    Structure structure;
};

/// Shears by one block and averages over it.
/// @throws Interrupted
Block shear_block(ShearCell& sample, const std::stop_token& stop) {
    Block block;
    VelocityProfile profile;
    const double begin = sample.strain();
    double steps = 0;
    int structures = 0;
    while (sample.strain() < begin + block_strain) {
        sample.step();
        const Stress& stress = sample.stress();
        block.s11 += stress.s11, block.s22 += stress.s22, block.s33 += stress.s33,
            block.s12 += stress.s12;
        block.solid_fraction += sample.solid_fraction();
        if (sample.steps() % steps_between_profiles == 0) {
            if (stop.stop_requested()) {
                throw Interrupted();
            }
            profile.add(sample.beads(), sample.cell().height);
        }
        if (sample.strain() - begin >= block_strain * (structures + 1) / structures_per_block) {
            block.structure +=
                structure_of(sample.beads(), sample.cell(), sample.pairs().narrow(),
                             sample.pairs().distant(), sample.material(), sample.bridges());
            profile.add(sample.beads(), sample.cell().height);
            ++structures;
        }
        steps += 1;
    }
    block.structure /= structures;
    block.strain = sample.strain() - begin;
    for (double* sum : {&block.s11, &block.s22, &block.s33, &block.s12, &block.solid_fraction}) {
        *sum /= steps;
    }
    block.localization = profile.localization(sample.cell().height, sample.shear_rate());
    return block;
}

/// A run in progress: its blocks so far and what they say.
class Series {
  public:
    void add(const Block& block) { blocks_.push_back(block); }
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
    /// Blocks to leave out as transient, judged on stress ratio, solid fraction and, where there
    /// are bridges, Z_d, which is the slowest; empty: not steady yet.
    std::optional<std::size_t> transient(bool wet) const {
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

  private:
    std::vector<Block> blocks_;
};

/// Whether any quarter of the averaged part is denser than random packings can be or ordered: a
/// sample that crystallises on the way must not pass for its average.
bool crystallised(const Series& series, std::size_t from) {
    const auto dense = series.values(from, [](const Block& b) {
        return b.solid_fraction - rigidity_shift(b.solid_fraction, b.structure.mean_overlap);
    });
    const auto order = series.values(from, [](const Block& b) { return b.structure.bond_order; });
    const std::size_t quarter = std::max<std::size_t>(1, dense.size() / 4);
    for (std::size_t begin = 0; begin + quarter <= dense.size(); begin += quarter) {
        const auto mean = [&](const std::vector<double>& v) {
            const auto at = v.begin() + static_cast<std::ptrdiff_t>(begin);
            return std::accumulate(at, at + static_cast<std::ptrdiff_t>(quarter), 0.0) /
                   static_cast<double>(quarter);
        };
        if (mean(dense) > crystal_solid_fraction || mean(order) > crystal_bond_order) {
            return true;
        }
    }
    return false;
}

/// Observables that are plain means over the networks.
constexpr std::pair<Observable, double Structure::*> of_structure[] = {
    {Observable::contact_coordination, &Structure::contact_coordination},
    {Observable::distant_coordination, &Structure::distant_coordination},
    {Observable::fabric_12_contact, &Structure::fabric_12},
    {Observable::fabric_12_distant, &Structure::fabric_12_distant},
    {Observable::force_anisotropy_12_contact, &Structure::force_anisotropy_12_contact},
    {Observable::force_anisotropy_12_distant, &Structure::force_anisotropy_12_distant},
    {Observable::length_anisotropy_12_distant, &Structure::length_anisotropy_12_distant},
    {Observable::contact_force, &Structure::contact_force},
    {Observable::distant_force, &Structure::distant_force},
    {Observable::distant_force_gap, &Structure::distant_force_gap},
    {Observable::distant_length, &Structure::distant_length},
    {Observable::mean_overlap, &Structure::mean_overlap},
    {Observable::bond_order, &Structure::bond_order},
    {Observable::capillary_stress_22, &Structure::capillary_stress_22},
    {Observable::capillary_pressure, &Structure::capillary_pressure},
    {Observable::capillary_shear_stress_contact, &Structure::capillary_shear_stress_contact},
    {Observable::capillary_shear_stress_distant, &Structure::capillary_shear_stress_distant}};

void average(const Series& series, std::size_t from, RunResult& result) {
    const auto set = [&](Observable which, const std::vector<double>& samples) {
        result.means[static_cast<std::size_t>(which)] = mean_of_correlated(samples);
    };
    const auto s22 = [](const Block& b) { return b.s22; };
    const auto stress_ratio = series.stress_ratio(from);
    const auto solid_fraction = series.solid_fraction(from);
    set(Observable::stress_ratio, stress_ratio);
    set(Observable::solid_fraction, solid_fraction);
    for (const auto& [which, member] : of_structure) {
        set(which, series.structure(from, member));
    }
    set(Observable::capillary_shear_stress, series.values(from, [](const Block& b) {
        return b.structure.capillary_shear_stress_contact +
               b.structure.capillary_shear_stress_distant;
    }));
    // eq:defzstar: Z* F0 = Z_c F0 + Z_d F_d.
    set(Observable::effective_coordination, series.values(from, [](const Block& b) {
        return b.structure.contact_coordination +
               b.structure.distant_coordination * b.structure.distant_force;
    }));
    if (result.parameters.wetting) {
        const double volume = result.parameters.wetting->bridge_volume;
        set(Observable::liquid_content, series.values(from, [&](const Block& b) {
            return liquid_content(
                volume, b.structure.contact_coordination + b.structure.distant_coordination);
        }));
    }
    set(Observable::first_normal_stress_difference,
        series.ratio(
            from, [](const Block& b) { return b.s11 - b.s22; }, s22));
    set(Observable::second_normal_stress_difference,
        series.ratio(
            from, [](const Block& b) { return b.s22 - b.s33; }, s22));
    set(Observable::localization,
        series.values(from, [](const Block& b) { return b.localization; }));
    set(Observable::held_normal_stress, series.values(from, s22));
    result.covariance = covariance_of_means(stress_ratio, solid_fraction);
    result.crystallised = crystallised(series, from);
    result.strain_transient = series.strain(0, from);
    result.strain_averaged = series.strain(from, series.size());
}

}  // namespace

bool needs_bridges(Observable which) {
    using enum Observable;
    switch (which) {
        case distant_coordination:
        case liquid_content:
        case fabric_12_distant:
        case force_anisotropy_12_distant:
        case length_anisotropy_12_distant:
        case distant_force:
        case distant_force_gap:
        case distant_length:
        case capillary_stress_22:
        case capillary_pressure:
        case capillary_shear_stress:
        case capillary_shear_stress_contact:
        case capillary_shear_stress_distant:
            return true;
        default:
            return false;
    }
}

double rigidity_shift(double solid_fraction, double mean_overlap) {
    return rigidity_factor * 3 * solid_fraction * mean_overlap;
}

RunResult run(const RunParameters& parameters, std::stop_token stop, const Progress& progress) {
    check(parameters);
    const auto started = std::chrono::steady_clock::now();
    const Material material{.modulus = std::pow(parameters.stiffness_number, 1.5),
                            .poisson_ratio = parameters.poisson_ratio,
                            .friction = parameters.friction,
                            .damping = parameters.damping};
    const bool wet = parameters.wetting.has_value();
    ShearCell sample(parameters.beads, material, parameters.inertial_number, parameters.seed,
                     wet ? BridgeLaw(*parameters.wetting) : BridgeLaw());
    if (!sample.compress(stop)) {
        throw SimulationError(
            "the sample never reached its normal stress; use more beads or another seed");
    }
    const double begin = sample.strain();
    const auto first_step = sample.steps();

    const auto blocks_in = [](double strain) {
        return static_cast<std::size_t>(std::lround(strain / block_strain));
    };
    const std::size_t wanted = blocks_in(parameters.strain);
    const std::size_t most = 2 * wanted + blocks_in(4);
    Series series;
    RunResult result;
    result.parameters = parameters;
    const std::size_t first_look = blocks_in(wet ? first_wet_look_strain : first_look_strain);
    std::size_t transient = first_look;
    while (series.size() < most) {
        series.add(shear_block(sample, stop));
        if (progress) {
            progress(sample.strain() - begin,
                     static_cast<double>(transient + wanted) * block_strain);
        }
        const bool look = series.size() % blocks_in(look_every_strain) == 0;
        if (look && series.size() >= wanted + first_look) {
            const auto found = series.transient(wet);
            transient = found ? *found : series.size() - wanted + blocks_in(look_every_strain);
            if (found && series.size() - transient >= wanted) {
                result.steady = true;
                break;
            }
        }
    }
    average(series, result.steady ? transient : series.size() - wanted, result);

    result.steps = sample.steps();
    result.time_step = (sample.strain() - begin) / parameters.inertial_number /
                       static_cast<double>(sample.steps() - first_step);
    result.wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    const double held = result[Observable::held_normal_stress].value;
    if (std::abs(held - 1) > 0.02 + 4 * result[Observable::held_normal_stress].standard_error) {
        throw SimulationError(
            fmt::format("the sample did not hold its normal stress: {:.3f} of the imposed one "
                        "over a strain of {:.3g}; use more beads or a longer strain",
                        held, result.strain_averaged));
    }
    return result;
}

}  // namespace pendular::dem
