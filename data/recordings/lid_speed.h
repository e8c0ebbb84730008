#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pendular {

/// Short rests, run-ins and reversals of the lid within a step of constant set points. A row is off
/// the speed of the step if it differs from it by more than 20 % (`settled_speed`) and by more than
/// 5 times the scatter.

/// Largest relative change of a speed [1] that counts as constant: a speed that changes by 20 %
/// about its mean changes the stress ratio of dry grains by less than 3 %, nearly in proportion, so
/// that the mean stays that at the mean speed.
constexpr double settled_speed = 0.2;

/// Whether the lid turns: the mean angular velocity differs from 0 by more than 3 standard errors;
/// or, spikes aside, all angular velocities but a few have one sign, with magnitudes within a
/// factor of ten, as where the lid ran in slowly.
bool turns(std::span<const double> angular_velocity);

/// Returns the indices at which rows off the speed begin within a step: at least four in
/// succession, fewer at the end of the step. Rows before the lid has its first speed are none.
/// Empty if most rows off the speed stand alone, as where a slow speed is rounded.
/// @param angular_velocity of the rows, finite
std::vector<std::size_t> breaks_of_speed(std::span<const double> angular_velocity);

/// Returns the index of the first row from which on the lid has the speed of the end of the step:
/// the median over its last quarter.
std::size_t begin_at_speed(std::span<const double> angular_velocity);

/// Whether the lid turns back and forth: its path is longer than 0.6 rad, it moves in both
/// directions by at least a quarter of the path, and its speed varies far beyond the noise from row
/// to row.
/// @param angular_velocity,time of the rows, [rad/s] and [s]
bool turns_back_and_forth(std::span<const double> angular_velocity, std::span<const double> time);

}  // namespace pendular
