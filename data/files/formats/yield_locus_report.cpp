#include "data/files/formats/layouts.h"

namespace pendular {

/// Report of RheoCompass on a yield locus, which holds results instead of recorded rows.
Layout yield_locus_report_layout() {
    return {"yield-locus-report", "RheoCompass report on a yield locus",
            [](const SourceLines& source) {
                for (std::size_t i = 0; i < source.lines.size() && i < 5; ++i)
                    if (source.lines[i].starts_with("Yield locus function")) return true;
                return false;
            },
            [](const SourceLines& source, const FileFormat&, BlockFile&) {
                throw InputError(
                    {source.file, 1},
                    "is the instrument's report on a yield locus, not a recording; export the "
                    "interval data of the same test and name that file, and compare its points "
                    "of failure with this report");
            }};
}

}  // namespace pendular
