#include "data/study/stated_uncertainty.h"

#include "data/study/study_table.h"

namespace pendular {

InstrumentTable read_instrument(const StudyTable& root) {
    InstrumentTable instrument;
    const auto table = root.open_table("instrument");
    if (!table) return instrument;
    for (const std::string& name : table->keys()) {
        if (name == "class") {
            instrument.kind = table->choice("class", {"rheometer", "table"}) == "table"
                                  ? InstrumentTable::Class::table
                                  : InstrumentTable::Class::rheometer;
            instrument.class_position = table->at("class");
            continue;
        }
        const Word value = table->stated(name).value();
        instrument.stated.push_back({name, value.text, value.position});
    }
    return instrument;
}

}  // namespace pendular
