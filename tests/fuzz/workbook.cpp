// Workbooks (.xlsx and .xls, by their first bytes): the sheets, and their rows as a recording.
#include "data/files/workbook.h"

#include "data/recordings/recording.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(fuzz::text_of(data, size));
    fuzz::refuse_or([&] {
        for (const auto& [sheet, hidden] : sheet_names(bytes, "book.xlsx")) {
            const std::string text = sheet_text(bytes, "book.xlsx", sheet).text;
            fuzz::demand(text.empty() || text.ends_with('\n'));
        }
        read_recording(fuzz::file_of("book.xlsx", bytes));
    });
    return 0;
}
