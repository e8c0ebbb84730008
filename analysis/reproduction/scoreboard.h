#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/reproduction/paper_states.h"

namespace pendular {

/// Row of a table that compares simulations with publications: a number or range that Badetti et
/// al. (2018) state, with the values that simulations give.
struct ScoreboardRow {
    /// Heading of the section of the table to which the row belongs.
    std::string section;
    /// Name of the compared quantity, with the states for which the comparison holds and the unit
    /// of the quantity, such as "stress ratio, friction 0.09, I -> 0 [1]".
    std::string what;
    /// Published value or range of the quantity, as text.
    std::string published;
    /// Simulated value of the quantity with its standard error, or range of the simulated values,
    /// as text.
    std::string ours;
    /// Lower and upper end of the published range [unit of the quantity]. For a single published
    /// value, the value minus and plus its standard error.
    double lower = 0, upper = 0;
    /// Smallest and largest of the simulated values of the quantity [unit of the quantity].
    double least = 0, greatest = 0;
    /// Distance of the farthest simulated value from the published value or range, in standard
    /// errors [1]. For a published value, the standard error combines the errors of publication and
    /// simulation. For a published range, the standard error is the error of the simulated value,
    /// and the distance is 0 inside the range.
    double distance = 0;
    /// Number of simulated values of the quantity.
    int values = 0;
    /// Number of simulated values of the quantity whose distance from the published value or range
    /// exceeds `allowed_distance`.
    int outside = 0;
    /// Text that states the simulated value farthest outside the published range and the name of
    /// the simulated state. Empty if the published number is a single value, if all values agree,
    /// or if the state has no name.
    std::string where;
    /// Whether simulation and publication agree: `distance` of the farthest simulated value is at
    /// most `allowed_distance`.
    bool agrees = true;
};

/// Largest distance of a simulated value from the published value or range, in standard errors [1],
/// at which the simulated value counts as agreeing. By chance alone, one of 370 values is farther
/// away.
inline constexpr double allowed_distance = 3;

/// Simulated value with its standard error, and name of the simulated state.
struct StateValue {
    Mean mean;
    std::string where;
};

/// Table that compares the simulations of a parameter study with published numbers. The rows of the
/// table are in the order in which the rows are added.
class Scoreboard {
  public:
    using Quantity = std::function<Mean(const PaperState&)>;
    using Condition = std::function<bool(const PaperState&)>;

    explicit Scoreboard(const PaperStudy& study) : study_(study), states_(&study.states()) {}

    /// Begins a section of the table, with the heading `name`. Rows that are added after this call
    /// compare the simulated states of the parameter study of Badetti et al. (2018).
    void section(std::string name) { section(std::move(name), study_.states()); }
    /// Begins a section of the table, with the heading `name`. Rows that are added after this call
    /// compare the simulated states `states` instead of the states of the parameter study.
    /// @param states must outlive the scoreboard
    void section(std::string name, const std::vector<PaperState>& states) {
        section_ = std::move(name);
        states_ = &states;
    }
    /// Adds a row that compares a published value with a simulated value.
    /// @param what name of the compared quantity, with the compared states and the unit
    /// @param published published value as text
    /// @param expected published value with its standard error
    /// @param ours simulated value with its standard error
    void value(const std::string& what, const std::string& published, const Mean& expected,
               const Mean& ours);
    /// Adds a row that compares a published range with one or several simulated values. Adds no row
    /// if `ours` is empty.
    /// @param what name of the compared quantity, with the compared states and the unit
    /// @param published published range as text
    /// @param lower, upper ends of the published range
    /// @param ours simulated values with the names of their states
    void range(const std::string& what, const std::string& published, double lower, double upper,
               const std::vector<StateValue>& ours);
    void range(const std::string& what, const std::string& published, double lower, double upper,
               const Mean& ours) {
        range(what, published, lower, upper, std::vector<StateValue>{{ours, ""}});
    }
    /// Adds a row for each friction coefficient of the parameter study (`paper_frictions`). The row
    /// compares a published range with the values of `quantity` for the states of the current
    /// section that have the friction coefficient and for which `which` returns true. Without such
    /// a state, the row is left out.
    /// @param what name of the compared quantity, with the compared states and the unit
    /// @param published published range as text
    /// @param lower, upper ends of the published range
    void each_friction(const std::string& what, const std::string& published, double lower,
                       double upper, const Quantity& quantity, const Condition& which);
    /// Returns the values of `quantity` for the states of the current section for which `which`
    /// returns true, each with the name of its state.
    std::vector<StateValue> values(const Quantity& quantity, const Condition& which) const;

    const PaperStudy& study() const { return study_; }
    const std::vector<ScoreboardRow>& rows() const { return rows_; }

  private:
    const PaperStudy& study_;
    const std::vector<PaperState>* states_;
    std::string section_;
    std::vector<ScoreboardRow> rows_;
};

}  // namespace pendular
