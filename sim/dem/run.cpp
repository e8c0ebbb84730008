#include "sim/dem/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include "data/input_error.h"
#include "sim/dem/archive.h"
#include "sim/dem/checkpoint.h"
#include "sim/dem/series.h"

namespace pendular::dem {
namespace {

/// Strain before which no state counts as steady [1]; longer for wet grains, as bridges persist
/// over a strain of order 1.
constexpr double first_look_strain = 1.0, first_wet_look_strain = 2.0;
/// Strain between two looks [1]: chosen, about that over which the solid fraction decorrelates (0.1
/// to 0.2), as a look between would see the same state.
constexpr double look_every_strain = 0.25;
/// Number of successive checks at which the standard errors must be small enough to stop a run.
/// Standard errors are estimates: stopping at the first small value would favour underestimates.
constexpr std::uint64_t looks_to_be_precise = 6;
/// Bond order Q6 above which a sample counts as crystallised [1]. Sheared random samples have 0.04
/// to 0.05 with 1000 grains and 0.10 with 100 grains; crystals have 0.3 to 0.55.
constexpr double crystal_bond_order = 0.2;

/// Whether the sample is denser than random packings can be, or ordered, in any quarter of the
/// averaged part of a run; a sample that crystallises during the run must not be averaged.
bool crystallised(const Series& series, std::size_t from) {
    const auto dense = series.values(from, [](const Block& b) {
        return b.solid_fraction - rigidity_shift(b.solid_fraction, b.structure.overlap);
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

/// Observables that are plain means over states, with the members of Structure that hold them.
constexpr std::pair<Observable, double Structure::*> of_structure[] = {
#define STRUCTURE_OBSERVABLE(name, ...) {Observable::name, &Structure::name},
#include "data/quantities/observables.def"
};

void average_fields(const Series& series, std::size_t from, double rupture_distance,
                    RunResult& result) {
    const auto& p = result.parameters;
    for (std::size_t k = 0; k < field_count; ++k) {
        if (p.wetting || !fields[k].needs_bridges) {
            const Bins1d bins = bins_of(fields[k].coordinate, p.grains, rupture_distance);
            result.fields[k] = series.field(from, static_cast<Field>(k), bins);
        }
    }
}

void average_observables(const Series& series, std::size_t from, RunResult& result) {
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
    // Eq. (21): Z* F0 = Z_c F0 + Z_d F_d.
    set(Observable::effective_coordination, series.values(from, [](const Block& b) {
        return b.structure.contact_coordination +
               b.structure.distant_coordination * b.structure.distant_force;
    }));
    if (result.parameters.wetting) {
        const double volume = result.parameters.wetting->bridge_volume;
        set(Observable::liquid_content, series.values(from, [&](const Block& b) {
            return liquid_content(volume * b.bridge_volume, b.structure.contact_coordination +
                                                                b.structure.distant_coordination);
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
    const auto lost = [&](Observable which, double PairEnergy::*part) {
        set(which, series.ratio(
                       from, [&](const Block& b) { return b.dissipation.*part; }, s22));
    };
    lost(Observable::dissipation_friction, &PairEnergy::friction);
    lost(Observable::dissipation_viscosity, &PairEnergy::viscosity);
    lost(Observable::dissipation_bridges, &PairEnergy::bridges);
    lost(Observable::dissipation_springs, &PairEnergy::unloading);
    result.covariance = covariance_of_means(stress_ratio, solid_fraction);
}

/// Whether every requested standard error is reached.
bool precise(const RunResult& result) {
    return std::ranges::all_of(result.parameters.precision, [&](const Precision& wanted) {
        return result[wanted.which].standard_error <= wanted.standard_error;
    });
}

void average(const Series& series, std::size_t from, double rupture_distance, RunResult& result) {
    average_observables(series, from, result);
    average_fields(series, from, rupture_distance, result);
    result.precise = precise(result);
    result.crystallised = crystallised(series, from);
    result.strain_transient = series.strain(0, from);
    result.strain_averaged = series.strain(from, series.size());
}

}  // namespace

namespace {

std::size_t blocks_in(double strain) {
    return static_cast<std::size_t>(std::lround(strain / block_strain));
}

/// Everything that changes during a run: the content of a checkpoint.
struct RunState {
    ShearCell sample;
    bool flowing = false;  ///< compression has ended and shear has begun
    double begin = 0;      ///< strain of the sample when the flow began
    std::uint64_t first_step = 0;
    Series series;
    OpenBlock block;
    std::uint64_t transient = 0;      ///< blocks in the transient, as found so far
    std::uint64_t precise_looks = 0;  ///< successive checks that found the precision reached
    double seconds = 0;               ///< wall time of earlier processes [s]

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(sample, flowing, begin, first_step, series, block, transient, precise_looks,
                seconds);
    }
};

/// Strain before which no state counts as steady in a run that starts from a stored state [1]. It
/// is shorter than from a random gas, as the packing is nearly steady; bridges without contact must
/// form anew.
constexpr double first_warm_look_strain = 0.25, first_warm_wet_look_strain = 1.0;

double first_look(const RunParameters& p) {
    return p.start == 0 ? (p.wetting ? first_wet_look_strain : first_look_strain)
                        : (p.wetting ? first_warm_wet_look_strain : first_warm_look_strain);
}

ShearCell new_sample(const RunParameters& p, const GrainEffects& effects,
                     const RunOptions& options) {
    const Material material{.modulus = std::pow(p.stiffness_number, 1.5),
                            .poisson_ratio = p.poisson_ratio,
                            .friction = p.friction,
                            .damping = p.damping};
    const BridgeLaw bridges = p.wetting ? BridgeLaw(*p.wetting) : BridgeLaw();
    if (p.start == 0) {
        return ShearCell(p.grains, material, p.inertial_number, p.seed, bridges, options.threads,
                         effects);
    }
    if (!options.start || options.start->grains.size() != static_cast<std::size_t>(p.grains)) {
        throw std::invalid_argument("the state to start from has another number of grains");
    }
    return ShearCell(options.start->sample(), material, {.shear_rate = p.inertial_number}, bridges,
                     options.threads, effects);
}

/// One run, from its initial state or its checkpoint to its averages.
class Run {
  public:
    Run(const RunParameters& parameters, const GrainEffects& effects, const RunOptions& options)
        : parameters_(parameters),
          options_(options),
          wet_(parameters.wetting.has_value()),
          wanted_(blocks_in(parameters.strain)),
          fewest_(parameters.precision.empty()
                      ? wanted_
                      : std::min(wanted_, blocks_in(shortest_precise_strain))),
          first_look_(blocks_in(first_look(parameters))),
          state_{.sample = new_sample(parameters, effects, options), .transient = first_look_} {}

    RunResult simulate_to_end() {
        if (options_.checkpoint) {
            if (const auto saved = options_.checkpoint->read(options_.description)) {
                resume(*saved);
            }
        }
        if (!state_.flowing) {
            start_flow();
        }
        tell_observers(state_.block.begin());
        const bool steady = shear();
        return result(steady);
    }

  private:
    void resume(const std::string& saved) {
        if (!restore(saved, state_)) {
            throw InputError(fmt::format(
                "checkpoint {} was written by another build of pendular; remove it to start anew, "
                "or name another file",
                options_.checkpoint->file().string()));
        }
    }

    void start_flow() {
        if (parameters_.start != 0) {
            state_.sample.hold_normal_stress(true);
            state_.sample.let_bridges_form(true);
        } else {
            compress();
        }
        state_.begin = state_.sample.strain();
        state_.first_step = state_.sample.steps();
        state_.block = OpenBlock(state_.sample);
        state_.flowing = true;
    }

    void compress() {
        const bool reached = guarded([&] { return state_.sample.compress(options_.stop); });
        if (!reached) {
            throw SimulationError(
                "the sample never reached its normal stress; use more grains or another seed");
        }
    }

    /// Shears the sample block by block until the run may end.
    /// @return whether a steady state was found
    bool shear() {
        // Chosen: a run that is not steady after twice the requested strain and 4 more is returned
        // as not steady.
        const std::size_t most = 2 * wanted_ + blocks_in(4);
        while (state_.series.size() < most) {
            guarded([&] { return fill_block(); });
            state_.series.add(state_.block.close(state_.sample));
            state_.block = OpenBlock(state_.sample);
            tell_observers(state_.sample.strain());
            if (options_.progress) {
                options_.progress(state_.sample.strain() - state_.begin,
                                  static_cast<double>(state_.transient + wanted_) * block_strain);
            }
            if (is_steady()) {
                return true;
            }
        }
        return false;
    }

    /// Whether the flow is steady, and has been averaged over the requested strain or to the
    /// requested precision.
    bool is_steady() {
        const std::size_t done = state_.series.size();
        if (done % blocks_in(look_every_strain) != 0 || done < fewest_ + first_look_) {
            return false;
        }
        const auto found = state_.series.transient(wet_);
        // Where no end of the transient is found, progress is reported as if the next look found
        // it.
        state_.transient = found ? *found : done - fewest_ + blocks_in(look_every_strain);
        const std::size_t averaged = done - state_.transient;
        if (!found || averaged < fewest_) {
            return false;
        }
        state_.precise_looks = is_precise() ? state_.precise_looks + 1 : 0;
        return averaged >= wanted_ || state_.precise_looks >= looks_to_be_precise;
    }

    bool is_precise() const {
        if (parameters_.precision.empty()) {
            return false;
        }
        RunResult so_far{.parameters = parameters_};
        average_observables(state_.series, state_.transient, so_far);
        return precise(so_far);
    }

    /// Advances the sample to the end of the block and writes checkpoints that are due.
    /// @throws Interrupted when a stop is requested
    bool fill_block() {
        ShearCell& sample = state_.sample;
        while (!state_.block.full(sample)) {
            state_.block.step(sample);
            if (!OpenBlock::pauses(sample)) {
                continue;
            }
            if (options_.stop.stop_requested()) {
                throw Interrupted();
            }
            if (options_.checkpoint && options_.checkpoint->due()) {
                save();
            }
        }
        return true;
    }

    /// Runs `work` and returns its result; saves a checkpoint if it is interrupted.
    template <typename Work>
    bool guarded(const Work& work) {
        try {
            return work();
        } catch (const Interrupted&) {
            if (options_.checkpoint) {
                save();
            }
            throw;
        }
    }

    void save() {
        const double before = std::exchange(state_.seconds, seconds());
        options_.checkpoint->write(options_.description, archived(state_));
        state_.seconds = before;
    }

    double seconds() const {
        return state_.seconds +
               std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    }

    void tell_observers(double strain) const {
        for (const auto& observer : options_.observers) {
            observer(state_.sample, strain - state_.begin);
        }
    }

    RunResult result(bool steady) const;

    const RunParameters& parameters_;
    const RunOptions& options_;
    bool wet_;
    /// Number of blocks to average, and the smallest number if a precision is requested.
    std::size_t wanted_, fewest_;
    std::size_t first_look_;
    RunState state_;
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

RunResult Run::result(bool steady) const {
    RunResult result{.parameters = parameters_, .threads = options_.threads, .steady = steady};
    const ShearCell& sample = state_.sample;
    result.trace = state_.series.trace();
    result.final_state = StoredSample(sample);
    average(state_.series, steady ? state_.transient : state_.series.size() - wanted_,
            wet_ ? sample.bridges().rupture_distance : 0, result);
    result.steps = sample.steps();
    result.time_step = (sample.strain() - state_.begin) / parameters_.inertial_number /
                       static_cast<double>(sample.steps() - state_.first_step);
    result.wall_seconds = seconds();
    const Mean& held = result[Observable::held_normal_stress];
    // Chosen: 2 % is the error that readings without replicates are given; beside it, short runs of
    // few grains have an error of their own.
    if (std::abs(held.value - 1) > 0.02 + 4 * held.standard_error) {
        throw SimulationError(
            fmt::format("the sample did not hold its normal stress: {:.3f} of the imposed one "
                        "over a strain of {:.3g}; use more grains or a longer strain",
                        held.value, result.strain_averaged));
    }
    return result;
}

}  // namespace

RunResult run(const RunParameters& parameters, const GrainEffects& effects,
              const RunOptions& options) {
    check_run_parameters(parameters, effects);
    if (options.threads < 1 || options.threads > most_threads) {
        throw std::invalid_argument(
            fmt::format("{} threads: a run takes 1 to {}", options.threads, most_threads));
    }
    return Run(parameters, effects, options).simulate_to_end();
}

}  // namespace pendular::dem
