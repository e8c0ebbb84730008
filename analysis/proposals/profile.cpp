#include "analysis/proposals/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "sim/catalogue/instrument.h"

namespace pendular {
namespace {

/// Smallest ratio of the largest to the smallest value of a quantity that counts as varied [1].
/// Chosen: set points that are meant to be equal differ by less.
constexpr double varied = 1.1;
/// Largest number of places between values of a coordinate at which a step or kink is tried.
/// Chosen: neighbouring places of a long series give nearly the same change.
constexpr std::size_t most_places = 40;
/// Number of periods, and of phases for each period, with which oscillations are tried. Phases
/// beyond half a turn are the same with the other sign; the best ones are refined.
constexpr int most_periods = 60, phases = 4;
constexpr int decay_times = 12;  ///< see `add_decays`
/// Exponents of simple laws, from inverse to square.
constexpr std::array powers = {-1.0, -0.5, 0.5, 1.0, 2.0};

double penalty_of(double choices) {
    return 2 * std::log(choices);
}

struct Range {
    double least, greatest;
};

/// Range of the positive values of a coordinate.
Range range_of(const ReadingCoordinate& coordinate) {
    Range range{INFINITY, 0};
    for (const double x : coordinate.at) {
        if (x > 0) range = {std::min(range.least, x), std::max(range.greatest, x)};
    }
    return range;
}

/// Midpoints between the distinct values of a coordinate, at most `most_places` of them. Set points
/// that differ by less than 1 % are replicates of one another; times are not.
std::vector<double> midpoints(const ReadingCoordinate& coordinate) {
    std::vector<double> values(coordinate.at.begin(), coordinate.at.end());
    std::ranges::sort(values);
    std::vector<double> middles;
    const double close = coordinate.variable == "time" ? 0 : 1e-2;
    for (std::size_t k = 1; k < values.size(); ++k) {
        if (values[k] - values[k - 1] > close * values[k]) {
            middles.push_back(0.5 * (values[k - 1] + values[k]));
        }
    }
    if (middles.size() <= most_places) return middles;
    std::vector<double> some;
    for (std::size_t k = 0; k < most_places; ++k) {
        some.push_back(middles[k * middles.size() / most_places]);
    }
    return some;
}

/// Size of a profile at a value x of its coordinate [1]; 0 where it is not defined.
double size_at(const Profile& p, double x) {
    const double c = p.constant, full = p.full_at;
    switch (p.dependence) {
        case Dependence::none:
            return 1;
        case Dependence::power:
            return x > 0 ? std::pow(x / full, c) : 0;
        case Dependence::logarithm:
            return x > 0 ? std::log(x / c) / std::log(full / c) : 0;
        case Dependence::above:
            return x > c ? 1 : 0;
        case Dependence::below:
            return x < c ? 1 : 0;
        case Dependence::beyond:
            return x > c ? (x - c) / (full - c) : 0;
        case Dependence::short_of:
            return x < c ? (c - x) / (c - full) : 0;
        case Dependence::decay:
            return std::exp(-x / c);
        default:
            return std::sin(2 * std::numbers::pi * x / c + p.phase);
    }
}

Profile sized(Profile profile, const ReadingCoordinate& coordinate) {
    profile.variable = coordinate.variable;
    profile.unit = coordinate.unit;
    profile.along = coordinate.at;
    profile.at = coordinate.at.unaryExpr([&](double x) { return size_at(profile, x); });
    return profile;
}

/// Whether an oscillation changes any reading; readings at equal phases may all lie at its zeros.
bool is_visible(const Profile& oscillation) {
    constexpr double least = 0.3;  // |sin| within a twentieth of a period of a zero: chosen
    return oscillation.at.cwiseAbs().maxCoeff() > least;
}

void add_powers(const ReadingCoordinate& coordinate, std::vector<Profile>& profiles) {
    const auto [least, greatest] = range_of(coordinate);
    if (greatest <= varied * least) return;  // present or absent: a step says the same
    for (const double power : powers) {
        profiles.push_back(sized({.dependence = Dependence::power,
                                  .constant = power,
                                  .full_at = power < 0 ? least : greatest,
                                  .penalty = penalty_of(powers.size() + 1)},
                                 coordinate));
    }
    profiles.push_back(sized({.dependence = Dependence::logarithm,
                              .constant = least,
                              .full_at = greatest,
                              .penalty = penalty_of(powers.size() + 1)},
                             coordinate));
}

void add_steps_and_kinks(const ReadingCoordinate& coordinate, std::vector<Profile>& profiles) {
    const std::vector<double> places = midpoints(coordinate);
    const double least = coordinate.at.minCoeff(), greatest = coordinate.at.maxCoeff();
    for (const double place : places) {
        for (const auto& [dependence, full] :
             {std::pair{Dependence::above, 0.0}, std::pair{Dependence::below, 0.0},
              std::pair{Dependence::beyond, greatest}, std::pair{Dependence::short_of, least}}) {
            profiles.push_back(
                sized({.dependence = dependence,
                       .constant = place,
                       .full_at = full,
                       .penalty = penalty_of(4.0 * static_cast<double>(places.size()))},
                      coordinate));
        }
    }
}

void add_decays(const ReadingCoordinate& coordinate, std::vector<Profile>& profiles) {
    const double span = coordinate.at.maxCoeff() - coordinate.at.minCoeff();
    // From 1/16 to 2.8 times the span of the readings, by factors of sqrt(2).
    for (int k = 0; k < decay_times; ++k) {
        const double share = std::pow(2.0, 0.5 * k - decay_times / 2.0 + 2);
        profiles.push_back(sized({.dependence = Dependence::decay,
                                  .constant = share * span,
                                  .penalty = penalty_of(decay_times)},
                                 coordinate));
    }
}

void add_oscillations(const ReadingCoordinate& coordinate, std::vector<Profile>& profiles) {
    const double span = coordinate.at.maxCoeff() - coordinate.at.minCoeff();
    // Readings resolve at most one half period each (Nyquist).
    const int periods = std::min(most_periods, static_cast<int>(coordinate.at.size()));
    for (int k = 1; k <= periods; ++k) {
        for (int phase = 0; phase < phases; ++phase) {
            Profile oscillation = sized({.dependence = Dependence::oscillation,
                                         .constant = 2 * span / k,
                                         .phase = std::numbers::pi * phase / phases,
                                         .penalty = penalty_of(periods * phases)},
                                        coordinate);
            if (is_visible(oscillation)) profiles.push_back(std::move(oscillation));
        }
    }
}

}  // namespace

std::vector<ReadingCoordinate> coordinates_of(const std::vector<Reading>& readings,
                                              const Study& study, bool of_instrument) {
    struct Choice {
        const char* variable;
        const char* unit;
        double (*value)(const Condition&, double angular_velocity);
    };
    constexpr Choice choices[] = {
        {"normal_stress", "Pa", [](const Condition& c, double) { return c.normal_stress; }},
        {"inertial_number", "1", [](const Condition& c, double) { return c.inertial_number; }},
        {"angular_velocity", "rad/s", [](const Condition&, double rate) { return rate; }},
        {"liquid_content", "1", [](const Condition& c, double) { return c.liquid_content; }},
        {"time", "s", [](const Condition& c, double) { return c.time; }}};
    std::vector<ReadingCoordinate> result;
    for (const auto& [variable, unit, value] : choices) {
        const std::string name = variable;
        if (name == (of_instrument ? "inertial_number" : "angular_velocity")) continue;
        ReadingCoordinate coordinate{name, unit,
                                     Eigen::VectorXd(static_cast<Eigen::Index>(readings.size()))};
        for (std::size_t k = 0; k < readings.size(); ++k) {
            const Reading& reading = readings[k];
            const double rate =
                of_instrument ? shown_state(reading.condition, reading.value(0), reading.value(1),
                                            study.cell.value(), study.grains)
                                    .angular_velocity
                              : 0;
            coordinate.at(static_cast<Eigen::Index>(k)) = value(reading.condition, rate);
        }
        if (coordinate.at.maxCoeff() > varied * coordinate.at.minCoeff()) {
            result.push_back(std::move(coordinate));
        }
    }
    return result;
}

std::string Profile::formula() const {
    const std::string x = variable;
    switch (dependence) {
        case Dependence::none:
            return "1";
        case Dependence::power:
            return fmt::format("({0} > 0 ? ({0}/{1:.6g})^({2:.6g}) : 0)", x, full_at, constant);
        case Dependence::logarithm:
            return fmt::format("({0} > 0 ? ln({0}/{1:.6g})/{2:.6g} : 0)", x, constant,
                               std::log(full_at / constant));
        case Dependence::above:
            return fmt::format("({} > {:.6g} ? 1 : 0)", x, constant);
        case Dependence::below:
            return fmt::format("({} < {:.6g} ? 1 : 0)", x, constant);
        case Dependence::beyond:
            return fmt::format("({0} > {1:.6g} ? ({0} - {1:.6g})/{2:.6g} : 0)", x, constant,
                               full_at - constant);
        case Dependence::short_of:
            return fmt::format("({0} < {1:.6g} ? ({1:.6g} - {0})/{2:.6g} : 0)", x, constant,
                               constant - full_at);
        case Dependence::decay:
            return fmt::format("exp(-{}/{:.6g})", x, constant);
        default:
            return fmt::format("sin(2*pi*{}/{:.6g} + {:.6g})", x, constant, phase);
    }
}

Profile same_everywhere(std::size_t readings) {
    return {.at = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(readings))};
}

std::vector<Profile> profiles_along(const ReadingCoordinate& coordinate, bool oscillations) {
    std::vector<Profile> profiles;
    const bool in_time = coordinate.variable == "time";
    if (in_time) {
        // Time counts from the start of the study, an arbitrary zero: the only power of time that
        // is tried is the linear one.
        profiles.push_back(sized(
            {.dependence = Dependence::power, .constant = 1, .full_at = coordinate.at.maxCoeff()},
            coordinate));
        add_decays(coordinate, profiles);
        if (oscillations) add_oscillations(coordinate, profiles);
    } else {
        add_powers(coordinate, profiles);
    }
    add_steps_and_kinks(coordinate, profiles);
    return profiles;
}

std::vector<Profile> finer_profiles(const Profile& profile, const ReadingCoordinate& coordinate) {
    std::vector<Profile> finer;
    if (profile.dependence != Dependence::oscillation) return finer;
    const double span = coordinate.at.maxCoeff() - coordinate.at.minCoeff();
    const double frequency = 1 / profile.constant;
    constexpr int steps = 8;  // chosen: 1/16 of a turn more over all readings with each
    for (int f = -steps; f <= steps; ++f) {
        // Up to the neighbouring frequencies of add_oscillations.
        const double near = frequency + 0.5 / span * f / steps;
        if (near <= 0) continue;
        for (int phase = 0; phase < 4 * phases; ++phase) {
            Profile other = profile;
            other.constant = 1 / near;
            other.phase = std::numbers::pi * phase / (4 * phases);
            other = sized(std::move(other), coordinate);
            if (is_visible(other)) finer.push_back(std::move(other));
        }
    }
    return finer;
}

}  // namespace pendular
