#include "data/files/csv.h"

#include "data/files/text_file.h"
#include "tests/support/golden.h"

namespace pendular::data_csv_test {

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
    expect_told({error(""), error("\n# only a comment\n")});
}

TEST_F(ReadTable, RefusesAHeaderWithoutRows) {
    expect_told({error("a,b\n\n")});
}

TEST_F(ReadTable, RefusesNumbersWithoutHeader) {
    expect_told({error("1.5,2\n3,4\n")});
}

TEST_F(ReadTable, RefusesRaggedRows) {
    expect_told({error("a;b\n1;2\n1;2;3\n4;5\n"), error("a,b\n1\n"), error("a,b\n1,5,2,5\n")});
}

TEST_F(ReadTable, RefusesAnUnclosedQuoteOnItsLine) {
    expect_told({error("a,b\n1,\"2\n3,4\n5,\"6\"\n"), error("a,b\n1,2\"x\n")});
}

TEST_F(ReadTable, RefusesAColumnNameThatStandsTwice) {
    expect_told({error("a,b,a\n1,2,3\n")});
}

TEST_F(ReadTable, RefusesWhatIsNoText) {
    expect_told({error("PK\x03\x04zip"),
                 input_error([&] { read_table(folder_.path() / "none.csv"); }),
                 input_error([&] { read_table(folder_.path()); })});
}

}  // namespace pendular::data_csv_test
