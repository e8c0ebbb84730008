#include "reports/page/page_texts.h"

#include <nlohmann/json.hpp>

namespace pendular {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PageTable, caption, head, rows, folded)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PageCopy, id, label, text)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PageSection, id, title, lines, more_title, more, commands, note,
                                   tables, copies, figures)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PageTexts, study, version, headline, details, measure, warnings,
                                   ladder, story, folded, recordings)

nlohmann::json to_json_of(const PageTexts& texts) {
    return texts;
}

PageTexts texts_from(const nlohmann::json& json) {
    return json.get<PageTexts>();
}

}  // namespace pendular
