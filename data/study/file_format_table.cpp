#include "data/study/file_format_table.h"

#include "data/files/formats/layouts.h"

namespace pendular {

FileFormat read_file_format(const StudyTable& entry) {
    FileFormat format;
    if (entry.has("layout")) format.layout = entry.choice("layout", layout_names());
    if (entry.has("decimal")) format.decimal = entry.choice("decimal", {".", ","});
    format.sheet = entry.text("sheet").value_or("");
    format.encoding = entry.text("encoding").value_or("");
    format.columns = entry.words("columns", {});
    format.repair = entry.flag("repair").value_or(false);
    if (const auto intervals = entry.table("intervals", interval_roles())) {
        for (const std::string& role : interval_roles())
            if (intervals->has(role)) format.roles[role] = intervals->words(role, {});
    }
    return format;
}

}  // namespace pendular
