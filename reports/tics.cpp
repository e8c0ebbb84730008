#include "reports/tics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pendular {
namespace {

/// Round number near `rough`: 1, 2 or 5 times a power of ten.
double round_step(double rough) {
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / decade;
    return decade * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

/// Width of a character of a number at an axis, and distance between two numbers [in].
constexpr double width_of_character = 0.09, between_numbers = 0.15;

/// Positive round numbers at even distances in a range, about four.
std::vector<double> even_tics(AxisRange range) {
    const double step = round_step((range.second - range.first) / 4);
    std::vector<double> tics;
    const auto first = std::max(1L, std::lround(std::ceil(range.first / step)));
    for (long k = first; static_cast<double>(k) * step <= range.second; ++k) {
        tics.push_back(static_cast<double>(k) * step);
    }
    return tics;
}

/// Multiples of powers of ten in a range by these digits.
std::vector<double> multiples(AxisRange range, const std::vector<double>& digits) {
    std::vector<double> tics;
    const int first = static_cast<int>(std::floor(std::log10(range.first)));
    const int last = static_cast<int>(std::ceil(std::log10(range.second)));
    for (int decade = first; decade <= last; ++decade) {
        for (const double digit : digits) {
            const double tic = digit * std::pow(10.0, decade);
            if (tic >= range.first && tic <= range.second) tics.push_back(tic);
        }
    }
    return tics;
}

/// Whether the numbers at two tics of a logarithmic axis of this width [in] do not touch.
bool are_apart(double a, double b, AxisRange range, double width) {
    const auto width_of = [](double tic) {
        return width_of_character * static_cast<double>(fmt::format("{:g}", tic).size());
    };
    const double distance = std::log(b / a) / std::log(range.second / range.first) * width;
    return distance >= (width_of(a) + width_of(b)) / 2 + between_numbers;
}

bool have_room(const std::vector<double>& tics, AxisRange range, double width) {
    for (std::size_t k = 1; k < tics.size(); ++k) {
        if (!are_apart(tics[k - 1], tics[k], range, width)) return false;
    }
    return true;
}

/// The first tic, and those of the others that are apart from the last one kept.
std::vector<double> with_room(const std::vector<double>& tics, AxisRange range, double width) {
    std::vector<double> kept;
    for (const double tic : tics) {
        if (kept.empty() || are_apart(kept.back(), tic, range, width)) kept.push_back(tic);
    }
    return kept;
}

}  // namespace

double step_of_tics(AxisRange range, double width) {
    constexpr double most = 7;  // numbers on an axis: more are not read
    const double span = range.second - range.first;
    double step = round_step(span / most);
    // Numbers have the most digits where they are no multiples of the next larger step.
    const double middle = step * std::round((range.first + span / 2) / step) + step;
    const auto characters = static_cast<double>(fmt::format("{:.6g}", middle).size());
    while (span / step * (width_of_character * characters + between_numbers) > width) {
        step = round_step(2.2 * step);  // the next of 1, 2, 5, 10
    }
    return step;
}

std::string tics_of_logarithm(AxisRange range, double width) {
    const std::vector<std::vector<double>> series = {
        {1}, {1, 3}, {1, 2, 5}, {1, 2, 3, 4, 6}, {1, 2, 3, 6}};
    std::vector<double> tics;
    for (const std::size_t enough : {4, 3}) {
        for (const std::vector<double>& digits : series) {
            if (!tics.empty()) break;
            const std::vector<double> some = multiples(range, digits);
            if (some.size() >= enough && have_room(some, range, width)) tics = some;
        }
    }
    if (tics.empty()) tics = with_room(even_tics(range), range, width);
    std::vector<std::string> texts;
    for (const double tic : tics)
        texts.push_back(fmt::format("{:g}", tic));
    return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace pendular
