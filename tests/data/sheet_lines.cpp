// Text of a sheet, which a short workbook may make long: one text in many cells, or in many rows.
#include "data/files/sheet_lines.h"

#include "tests/support/golden.h"

namespace pendular::sheet_lines_test {

const std::string long_text(std::size_t{1} << 20, 'x'), long_number(std::size_t{1} << 20, '0');

/// Adds rows beyond the longest text that is read.
void add_rows(SheetLines& lines, const std::string& text) {
    for (int row = 0; row < 300; ++row) {
        lines.begin_row(false);
        lines.set(0, text);
        lines.end_row();
    }
}

TEST(SheetLines, RefusesMoreTextThanIsRead) {
    const std::string file = "b.xlsx [A]";
    SheetLines lines(file, 2), merged(file, 2);
    merged.merge({0, 1}, {1000, 1});
    merged.begin_row(false);
    merged.set(1, long_number + "1");
    merged.end_row();
    expect_told({input_error([&] { add_rows(lines, long_text); }),
                 input_error([&] { add_rows(merged, "1"); })});
}

TEST(SheetLines, RefusesMoreTextInOneRow) {
    const std::string file = "b.xlsx [A]";
    SheetLines lines(file, 300);
    lines.begin_row(false);
    EXPECT_THROW(
        {
            for (std::size_t column = 0; column < 300; ++column)
                lines.set(column, long_text);
        },
        InputError);
}

/// "Time [s]" may be merged over two lines of names; a title over several columns is none.
TEST(SheetLines, HoldsANameMergedOverTwoRows) {
    SheetLines lines("b.xlsx [A]", 3);
    lines.merge({0, 0}, {1, 0});
    lines.merge({0, 1}, {0, 2});
    lines.begin_row(false);
    lines.set(0, "Time [s]");
    lines.set(1, "Answer");
    lines.end_row();
    lines.begin_row(false);
    lines.set(1, "Torque [N m]");
    lines.set(2, "Gap [mm]");
    lines.end_row();
    EXPECT_EQ(lines.take().text, "Time [s]\tAnswer\t\nTime [s]\tTorque [N m]\tGap [mm]\n");
}

}  // namespace pendular::sheet_lines_test
