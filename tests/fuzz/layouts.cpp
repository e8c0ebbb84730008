// Files of instruments in every layout: the first byte says which layout is stated (or none), the
// second how numbers and damaged rows are read, the rest is the file.
#include "data/files/formats/layouts.h"

#include "data/recordings/file_view.h"
#include "data/recordings/locus_table.h"
#include "data/recordings/recording.h"
#include "tests/fuzz/support.h"

using namespace pendular;

namespace {

FileFormat format_of(std::uint8_t layout, std::uint8_t style) {
    static const std::vector<std::string> names = layout_names();
    FileFormat format;
    if (const std::size_t which = layout % (names.size() + 1); which > 0)
        format.layout = names[which - 1];
    if (style % 4 == 1) format.decimal = ".";
    if (style % 4 == 2) format.decimal = ",";
    if (style % 8 >= 4) format.encoding = "windows-1252";
    if (style % 16 >= 8) format.repair = true;
    if (style % 64 >= 32) {
        format.prorate = true;
        format.wall = style % 2 == 1;
    }
    if (style % 32 >= 16) format.columns = {"Time [s]", "Torque [mN m]"};
    return format;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 3) return -1;
    const FileFormat format = format_of(data[0], data[1]);
    const auto file = fuzz::file_of("measured.txt", fuzz::text_of(data + 2, size - 2));
    // One of the two readers for each input: libFuzzer finds inputs for both.
    fuzz::refuse_or([&] {
        if (data[1] >= 128) {
            read_recording(file, format);
            return;
        }
        const FileView view = view_of_file(file, format);
        fuzz::demand(view.roles.size() == view.file.blocks.size());
        fuzz::demand(locus_table({view}).starts_with(locus_table_begin));
    });
    return 0;
}
