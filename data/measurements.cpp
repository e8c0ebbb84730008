#include "data/readings.h"
#include "data/recording.h"
#include "data/replicates.h"
#include "data/steady_state.h"
#include "data/study.h"

namespace pendular {
namespace {

Measurements read_file(const std::filesystem::path& file, const Source& source,
                       const Study& study) {
    if (source.kind == Source::Kind::readings) return read_points(file, source, study);
    AnnularCell cell = *study.cell;
    cell.bead_volume = source.bead_volume.value_or(cell.bead_volume);
    return reduce_recording(read_recording(file), cell, study.grains,
                            source.liquid_content.value_or(0));
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Measurements read_measurements(const Study& study) {
    Measurements all;
    for (const Source& source : study.sources) {
        for (const std::filesystem::path& file : source.files) {
            const Measurements part = read_file(file, source, study);
            append(all.readings, part.readings);
            append(all.excluded, part.excluded);
            append(all.notes, part.notes);
        }
    }
    pool_replicates(all);
    return all;
}

}  // namespace pendular
