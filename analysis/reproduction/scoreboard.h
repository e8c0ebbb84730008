#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/reproduction/paper_states.h"

namespace pendular {

/// Comparison of a number or range that Badetti et al. (2018) state with simulations. Numbers have
/// the unit of the compared quantity.
struct ScoreboardRow {
    std::string section;
    /// Compared quantity, states and unit, such as "stress ratio, friction 0.09, I -> 0 [1]".
    std::string what;
    std::string published;  ///< value or range as text
    std::string ours;       ///< simulated value with its standard error, or range, as text
    /// Ends of the published range; for a single value, minus and plus its standard error.
    double lower = 0, upper = 0;
    double least = 0, greatest = 0;  ///< smallest and largest simulated value
    /// Distance of the farthest simulated value in standard errors [1]: those of publication and
    /// simulation for a published value; those of the simulation for a range, with 0 inside.
    double distance = 0;
    int values = 0;   ///< number of simulated values
    int outside = 0;  ///< number of them beyond `allowed_distance`
    /// Simulated value farthest outside a published range, with its state; may be empty.
    std::string where;
    bool agrees = true;  ///< whether `distance` is at most `allowed_distance`
};

/// Largest distance [standard errors] at which a simulated value agrees: by chance alone, one of
/// 370 values is farther away.
inline constexpr double allowed_distance = 3;

/// Simulated value and the name of its state.
struct StateValue {
    Mean mean;
    std::string where;
};

/// Table that compares the simulations of a parameter study with published numbers, in the order in
/// which rows are added. In its functions, `what` and `published` are those of the row.
class Scoreboard {
  public:
    using Quantity = std::function<Mean(const PaperState&)>;
    using Condition = std::function<bool(const PaperState&)>;

    explicit Scoreboard(const PaperStudy& study) : study_(study), states_(&study.states()) {}

    /// Begins a section on the states of the parameter study.
    void section(std::string name) { section(std::move(name), study_.states()); }
    /// Begins a section on other states, which must outlive the scoreboard.
    void section(std::string name, const std::vector<PaperState>& states) {
        section_ = std::move(name);
        states_ = &states;
    }
    /// Adds a row on a published value.
    void value(const std::string& what, const std::string& published, const Mean& expected,
               const Mean& ours);
    /// Adds a row on a published range, unless there are no simulated values.
    void range(const std::string& what, const std::string& published, double lower, double upper,
               const std::vector<StateValue>& ours);
    void range(const std::string& what, const std::string& published, double lower, double upper,
               const Mean& ours) {
        range(what, published, lower, upper, std::vector<StateValue>{{ours, ""}});
    }
    /// Adds a row on a published range for each of `paper_frictions`, with the states of the
    /// current section that have this friction coefficient and satisfy `which`, if there are any.
    void each_friction(const std::string& what, const std::string& published, double lower,
                       double upper, const Quantity& quantity, const Condition& which);
    /// Returns `quantity` of the states of the current section that satisfy `which`.
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
