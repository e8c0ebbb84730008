#pragma once

#include <optional>
#include <string>

#include "data/recordings/interval_series.h"

namespace pendular {

/// Returns the words "load ramp: ..." for an interval whose normal stress or force still changes in
/// its second half, as `speed_ramp` does for the speed of the lid; empty for others.
std::optional<std::string> load_ramp(const IntervalSeries& series);

/// Whether a table has a column that the points of a yield locus lack but readings of steady shear
/// have: of a speed or a rate or, without a column of preshears, of a gap or a solid fraction. A
/// bulk density is what shear testers give at each point.
bool has_column_of_readings(const Block& block);

/// Whether a table without time states that each of its rows is a point of failure, as failure.csv
/// of a study that `import` began.
bool is_stated_failure(const Block& block);

/// Whether the load changes from row to row so often that each row may be a test of its own, or the
/// mean of one.
bool loads_differ_by_row(const IntervalSeries& series);

/// Whether a table holds one test in each row, such as the points of a yield locus: no time and no
/// column of readings (`has_column_of_readings`), both stresses, and a normal stress that differs
/// by more than 5 %, which no control of a load does, from that of the row before in a quarter of
/// the rows. So does one whose rows are points of failure (`is_stated_failure`).
bool is_table_of_points(const Block& block, const IntervalSeries& series);

/// Whether a table is one of readings: with both stresses, a solid fraction and a rate, and without
/// time unless it states, as readings.csv does, how each reading was averaged.
bool is_table_of_readings(const Block& block);

/// Returns what shows that grains were sheared along a wall: the name of a column, such as "Wall
/// shear stress", or of the file, its sheet or its tests, such as "Wandreibung", or a line above
/// the table that names the test so. Empty for nothing, and where only some of the tests have such
/// a name (`named_wall`). A line that states an angle of wall friction, or that there is none,
/// names no test.
std::string shown_wall(const BlockFile& file);

/// Returns the name of the test of a block, as `shown_wall` does, if it is one of wall friction.
std::string named_wall(const Block& block);

/// Name of the quantity that shows the shear of an interval, such as "torque".
const char* shear_word(const IntervalSeries& series);

/// Returns "stress growth: ..." for an interval at constant speed and load whose shear stress still
/// rises at its end: by more than 2 % over each of the last two tenths of the rows, and by more
/// than noise does (`finding_significance`). Empty for others, and for fewer than `shortest_step`
/// rows.
std::optional<std::string> stress_growth(const IntervalSeries& series);

/// Returns "stick-slip: ..." for an interval whose shear stress rises slowly and drops suddenly,
/// again and again, by more than a tenth of itself; empty for others.
std::optional<std::string> stick_slip(const IntervalSeries& series);

}  // namespace pendular
