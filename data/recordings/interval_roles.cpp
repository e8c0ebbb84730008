#include "data/recordings/interval_roles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "data/recordings/robust.h"

namespace pendular {
namespace {

/// What the roles of an interval depend on.
struct Loading {
    bool sheared = false;
    double normal = 0;            ///< median normal stress or force
    std::optional<double> angle;  ///< angle by which the lid turned [rad], if known
};

double largest_known(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest;
}

/// Angle by which the lid turned during an interval [rad]; empty without time and speed.
std::optional<double> angle_turned(const IntervalSeries& series) {
    if (series.time.empty() || series.angular_velocity.empty() || series.size() < 2)
        return std::nullopt;
    double angle = 0;
    for (std::size_t i = 1; i < series.size(); ++i) {
        const double part = std::abs(series.angular_velocity[i]) *
                            std::max(series.time[i] - series.time[i - 1], 0.0);
        if (std::isfinite(part)) angle += part;
    }
    return angle;
}

std::vector<Loading> loadings(const std::vector<IntervalSeries>& series) {
    double most_shear = 0;
    for (const IntervalSeries& each : series)
        most_shear = std::max(most_shear, largest_known(each.shear()));
    std::vector<Loading> result;
    for (const IntervalSeries& each : series) {
        Loading loading;
        loading.sheared = largest_known(each.shear()) > 0.05 * most_shear;
        loading.normal = median_of_known(each.normal());
        loading.angle = angle_turned(each);
        result.push_back(loading);
    }
    return result;
}

/// Whether the numbers of a test's intervals are 4, 8, 12 and so on, with the others left out.
bool only_every_fourth(const std::vector<Block>& blocks) {
    return blocks.size() > 1 && std::ranges::all_of(blocks, [](const Block& block) {
               return block.number > 0 && block.number % 4 == 0;
           });
}

std::optional<IntervalRole> stated_role(const Block& block, const FileFormat& format) {
    for (const auto& [role, intervals] : format.roles)
        for (const std::string& interval : intervals)
            if (interval == std::to_string(block.number) || interval == block.name ||
                interval == block.test)
                return IntervalRole{role, "stated by the user", true};
    return std::nullopt;
}

/// Index of the sheared interval of the same test before (`step` -1) or after (+1) an interval.
std::optional<std::size_t> sheared_neighbour(const BlockFile& file,
                                             const std::vector<Loading>& loading, std::size_t i,
                                             int step) {
    for (std::size_t k = i + static_cast<std::size_t>(step); k < loading.size();
         k += static_cast<std::size_t>(step)) {
        if (file.blocks[k].test != file.blocks[i].test) return std::nullopt;
        if (loading[k].sheared) return k;
    }
    return std::nullopt;
}

IntervalRole role_of_sheared(const BlockFile& file, const std::vector<Loading>& loading,
                             std::size_t i) {
    constexpr double higher = 1.05;
    const double own = loading[i].normal;
    const auto before = sheared_neighbour(file, loading, i, -1);
    const auto after = sheared_neighbour(file, loading, i, +1);
    if (only_every_fourth(file.blocks))
        return {"failure", "only intervals 4, 8, 12 ... of a powder cell's test were exported"};
    if (before && loading[*before].normal > higher * own)
        return {"failure", fmt::format("normal stress {:.2f} times that of interval {} before it",
                                       own / loading[*before].normal, file.blocks[*before].number)};
    if (after && own > higher * loading[*after].normal)
        return {"preshear", fmt::format("normal stress {:.2f} times that of interval {} after it",
                                        own / loading[*after].normal, file.blocks[*after].number)};
    constexpr double short_turn = 0.3;
    if (loading[i].angle && *loading[i].angle < short_turn)
        return {"failure", fmt::format("the lid turned by {:.2g} rad, too little for steady shear",
                                       *loading[i].angle)};
    return {"steady", "sheared at constant set points"};
}

IntervalRole role_of_resting(const BlockFile& file, const std::vector<Loading>& loading,
                             std::size_t i) {
    const auto before = sheared_neighbour(file, loading, i, -1);
    if (!before) return {"filling", "without shear, before the first sheared interval"};
    const bool lower = loading[i].normal < 0.95 * loading[*before].normal;
    return {lower ? "unloading" : "reloading", "without shear, between sheared intervals"};
}

}  // namespace

double median_of_known(const std::vector<double>& values) {
    std::vector<double> known;
    for (const double value : values)
        if (std::isfinite(value)) known.push_back(value);
    return known.empty() ? std::numeric_limits<double>::quiet_NaN() : median(known);
}

std::vector<IntervalRole> roles_of(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const FileFormat& format) {
    const std::vector<Loading> loading = loadings(series);
    std::vector<IntervalRole> roles;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (const auto stated = stated_role(file.blocks[i], format))
            roles.push_back(*stated);
        else if (series[i].shear().empty() || series[i].normal().empty())
            roles.push_back({"other", "no column of shear stress or no column of normal stress"});
        else if (!loading[i].sheared)
            roles.push_back(role_of_resting(file, loading, i));
        else
            roles.push_back(role_of_sheared(file, loading, i));
    }
    return roles;
}

}  // namespace pendular
