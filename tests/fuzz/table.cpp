// Tables: header cells, delimiters, cells, positions.
#include "data/files/columns.h"
#include "data/files/csv.h"
#include "data/files/header_cell.h"
#include "tests/fuzz/support.h"

using namespace pendular;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    parse_header_cell(text);
    fuzz::refuse_or([&] {
        const Table table = read_table(fuzz::file_of("table.csv", text));
        const Columns columns(table);
        for (const Row& row : table.rows) {
            fuzz::demand(row.cells.size() == table.header.cells.size());
            columns.value_if_any(row, "normal_stress");
            columns.standard_error(row, "normal_stress");
        }
        columns.resolutions("normal_stress");
    });
    return 0;
}
