#include "data/files/csv.h"

#include "data/files/text_file.h"
#include "tests/support/data_support.h"

namespace pendular::data_csv_test {

using testing::HasSubstr;

class ReadTable : public testing::Test {
  protected:
    Table read(const std::string& content) { return read_table(folder_.write("t.csv", content)); }
    std::string error(const std::string& content) {
        return input_error([&] { read(content); });
    }
    std::string at(const std::string& position) const {
        return (folder_.path() / "t.csv").string() + position;
    }
    static std::vector<std::string> texts(const Row& row) {
        std::vector<std::string> result;
        for (const Cell& cell : row.cells)
            result.push_back(cell.text);
        return result;
    }

    TemporaryFolder folder_;
};

using testing::ElementsAre;

TEST_F(ReadTable, FindsTheDelimiter) {
    for (const std::string delimiter : {",", ";", "\t"}) {
        const Table table = read("a" + delimiter + "b\n1" + delimiter + "2\n");
        EXPECT_THAT(texts(table.header), ElementsAre("a", "b"));
        EXPECT_THAT(texts(table.rows.at(0)), ElementsAre("1", "2"));
    }
    EXPECT_THAT(texts(read("a;b [N,m,s]\n1;2\n").header), ElementsAre("a", "b [N,m,s]"));
}

TEST_F(ReadTable, KeepsLineAndColumnOfEachCell) {
    const Table table = read("# comment\n\ntime [µs], torque\n1, 2\n,,\n 3,\"4\"\n");
    EXPECT_EQ(to_string(table.at_header(0)), at(":3:1"));
    EXPECT_EQ(to_string(table.at_header(1)), at(":3:12"));  // counts characters, µ being one
    EXPECT_EQ(to_string(table.at(table.rows.at(0), 1)), at(":4:4"));
    ASSERT_EQ(table.rows.size(), 2u);  // the line of commas alone is passed over
    EXPECT_EQ(to_string(table.at(table.rows[1], 0)), at(":6:2"));
    EXPECT_THAT(texts(table.rows[1]), ElementsAre("3", "4"));
}

TEST_F(ReadTable, KeepsEmptyCells) {
    const Table table = read("a,b,c\n,2,\n1,,3\n");
    EXPECT_THAT(texts(table.rows.at(0)), ElementsAre("", "2", ""));
    EXPECT_THAT(texts(table.rows.at(1)), ElementsAre("1", "", "3"));
}

TEST_F(ReadTable, ReadsQuotedCells) {
    const Table table = read("a,b\n\"x, \"\"y\"\"\",2\n");
    EXPECT_THAT(texts(table.rows.at(0)), ElementsAre("x, \"y\"", "2"));
}

TEST_F(ReadTable, ReadsAnyLineEndAndEncoding) {
    const std::string plain = "µ,b\n1,2\n";
    std::string little = "\xFF\xFE", big = "\xFE\xFF";
    for (const char c : std::string("\xB5,b\r\n1,2\r\n")) {
        little += {c, '\0'};
        big += {'\0', c};
    }
    for (const std::string& content :
         {plain, "\xEF\xBB\xBF" + plain, std::string("µ,b\r\n1,2"), std::string("µ,b\r1,2\r"),
          std::string("\xB5,b\n1,2\n"), little, big}) {
        const Table table = read(content);
        EXPECT_THAT(texts(table.header), ElementsAre("µ", "b"));
        EXPECT_THAT(texts(table.rows.at(0)), ElementsAre("1", "2"));
        EXPECT_EQ(table.rows.at(0).line, 2);
    }
}

TEST_F(ReadTable, RefusesAnEmptyFile) {
    EXPECT_EQ(error(""), at(": is empty; a header and rows of numbers are needed"));
    EXPECT_EQ(error("\n# only a comment\n"),
              at(": is empty; a header and rows of numbers are needed"));
}

TEST_F(ReadTable, RefusesAHeaderWithoutRows) {
    EXPECT_EQ(error("a,b\n\n"), at(":1: no rows follow the header; at least one is needed"));
}

TEST_F(ReadTable, RefusesNumbersWithoutHeader) {
    EXPECT_THAT(error("1.5,2\n3,4\n"), AllOf(HasSubstr(at(":1:1:")), HasSubstr("header")));
}

TEST_F(ReadTable, RefusesRaggedRows) {
    EXPECT_THAT(
        error("a;b\n1;2\n1;2;3\n4;5\n"),
        AllOf(HasSubstr(at(":3:5: this row has 3 columns, the header 2")), HasSubstr("complete")));
    EXPECT_THAT(error("a,b\n1\n"), AllOf(HasSubstr(at(":2:1: this row has 1 column, the header 2")),
                                         HasSubstr("if the file was cut off")));
    EXPECT_THAT(error("a,b\n1,5,2,5\n"), HasSubstr("if commas are decimal signs"));
}

TEST_F(ReadTable, RefusesAnUnclosedQuoteOnItsLine) {
    EXPECT_THAT(error("a,b\n1,\"2\n3,4\n5,\"6\"\n"),
                AllOf(HasSubstr(at(":2:3: a quote")), HasSubstr("close it")));
    EXPECT_THAT(error("a,b\n1,2\"x\n"), HasSubstr(at(":2:4: a quote")));
}

TEST_F(ReadTable, RefusesAColumnNameThatStandsTwice) {
    EXPECT_THAT(error("a,b,a\n1,2,3\n"), HasSubstr(at(":1:5: column 'a' occurs twice")));
}

TEST_F(ReadTable, RefusesWhatIsNoText) {
    EXPECT_THAT(error("PK\x03\x04zip"), HasSubstr("save it as CSV"));
    EXPECT_THAT(input_error([&] { read_table(folder_.path() / "none.csv"); }),
                HasSubstr("none.csv: cannot be read"));
    EXPECT_THAT(input_error([&] { read_table(folder_.path()); }), HasSubstr("is a folder"));
}

}  // namespace pendular::data_csv_test
