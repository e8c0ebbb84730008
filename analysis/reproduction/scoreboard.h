#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/reproduction/paper_states.h"

namespace pendular {

/// A number or range that Badetti et al. (2018) state, with what the simulations give.
struct ScoreboardRow {
    std::string section;    ///< heading under which the row stands
    std::string what;       ///< quantity and condition, with its unit
    std::string published;  ///< published value or range, as text
    std::string ours;       ///< value with its standard error, or range of the values, as text
    double lower = 0, upper = 0;     ///< published range; of a value, the value -+ its error
    double least = 0, greatest = 0;  ///< smallest and largest of our values
    /// Distance of our most distant value from the published range, in combined standard errors
    /// [1]; 0 inside the range.
    double distance = 0;
    int values = 0;      ///< number of our values
    int outside = 0;     ///< number of our values that are further outside than allowed
    std::string where;   ///< states of the values outside, as text; empty: none
    bool agrees = true;  ///< whether `distance` is at most `allowed_distance`
};

/// Largest distance of a value that agrees from a published value or range, in combined standard
/// errors [1]. By chance, one of 370 values is further away.
inline constexpr double allowed_distance = 3;

/// A value of ours with the state that it belongs to, as text.
struct StateValue {
    Mean mean;
    std::string where;
};

/// Rows on one parameter study, in the order in which they are added.
class Scoreboard {
  public:
    using Quantity = std::function<Mean(const PaperState&)>;
    using Condition = std::function<bool(const PaperState&)>;

    explicit Scoreboard(const PaperStudy& study) : study_(study), states_(&study.states()) {}

    /// Begins a section, under whose heading the next rows stand.
    void section(std::string name) { section(std::move(name), study_.states()); }
    /// Begins a section whose rows are of other states than those of the grid.
    /// @param states must live as long as the scoreboard
    void section(std::string name, const std::vector<PaperState>& states) {
        section_ = std::move(name);
        states_ = &states;
    }
    /// Adds a row of a published value with its standard error.
    void value(const std::string& what, const std::string& published, const Mean& expected,
               const Mean& ours);
    /// Adds a row of values of ours that a published range should contain; none without values.
    void range(const std::string& what, const std::string& published, double lower, double upper,
               const std::vector<StateValue>& ours);
    void range(const std::string& what, const std::string& published, double lower, double upper,
               const Mean& ours) {
        range(what, published, lower, upper, std::vector<StateValue>{{ours, ""}});
    }
    /// Adds a row for each friction, of the states that fulfil a condition.
    void each_friction(const std::string& what, const std::string& published, double lower,
                       double upper, const Quantity& quantity, const Condition& which);
    /// Values of a quantity at the states of the section that fulfil a condition.
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
