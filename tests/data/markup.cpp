// Files that are XML, JSON or HTML, whatever they are called.
#include "data/files/markup.h"

#include <gmock/gmock.h>

#include "data/files/csv.h"
#include "data/files/formats/layouts.h"
#include "tests/support/golden.h"

namespace pendular::data_markup_test {

constexpr const char* xml =
    "<?xml version=\"1.0\"?><RheoML><RVM><Time unit=\"s\">1</Time></RVM></RheoML>";
constexpr const char* json =
    "{\n \"results\": [{\"time\": {\"unit\": \"s\", \"values\": [0, 1]}}]\n}\n";
constexpr const char* html =
    "<html><head></head><body><table><tr><td>Time</td></tr></table></body></html>";

TEST(Markup, IsCalledWhatItIs) {
    const TemporaryFolder folder;
    std::vector<std::string> told;
    for (const auto& [name, text] :
         {std::pair{"run.xml", xml}, {"run.json", json}, {"run.xls", html}})
        told.push_back(input_error([&] { read_blocks(folder.write(name, text)); }));
    told.push_back(input_error([&] { read_table(folder.write("readings.csv", json)); }));
    expect_told(told);
}

TEST(Markup, IsRecognisedByItsBeginning) {
    const auto refusal = [](const std::string& text) {
        return input_error([&] { refuse_markup("t.csv", text); });
    };
    expect_told({refusal("\xEF\xBB\xBF\r\n <?xml version=\"1.0\"?>"),
                 refusal("<RheoML>\n<Time>1</Time></RheoML>"), refusal("[\n {\"time\": 1}]"),
                 refusal("<?xml version=\"1.0\"?><Workbook><Table ss:x=\"1\"/></Workbook>"),
                 refusal("<!DOCTYPE html>\n<p>"),
                 refusal("<?xml version=\"1.0\"?>\n<html xmlns=\"x\"/>")});
}

TEST(Markup, IsNoTableOrExport) {
    for (const char* const text : {"", "[step]\nPeak hold\n", "[s],[Pa]\n1,2\n", "<a>;<b>\n1;2\n",
                                   "Time [s],x\n1,<b>2</b>\n", "{a},b\n1,2\n"})
        EXPECT_NO_THROW(refuse_markup("t.csv", text)) << text;
}

}  // namespace pendular::data_markup_test
