#include "reports/page/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include "reports/page/page_data.h"
#include "reports/page/page_files.h"
#include "reports/page/page_sections.h"
#include "reports/page/page_story.h"
#include "reports/with_error.h"
#include "reports/words.h"

namespace pendular {
namespace {

using kainjow::mustache::data;
using Cells = std::vector<std::string>;

data list_of(const std::vector<std::string>& texts) {
    data list{data::type::list};
    for (const std::string& text : texts) {
        list << page_text(text);
    }
    return list;
}

/// Whether a column holds words: these are aligned on the left, numbers on the right.
bool holds_words(const PageTable& table, std::size_t column) {
    return std::ranges::all_of(table.rows, [&](const Cells& row) {
        return row[column].find_first_of("<~+-0123456789") != 0;
    });
}

data cells_of(const Cells& cells, const std::vector<bool>& words) {
    data list{data::type::list};
    for (std::size_t column = 0; column < cells.size(); ++column) {
        data cell;
        cell.set("text", page_text(cells[column]));
        cell.set("words", words[column]);
        list << cell;
    }
    return list;
}

data to_data(const PageTable& table) {
    std::vector<bool> words;
    for (std::size_t column = 0; column < table.head.size(); ++column) {
        words.push_back(holds_words(table, column));
    }
    data rows{data::type::list};
    for (const Cells& cells : table.rows) {
        rows << data{"cells", cells_of(cells, words)};
    }
    data result;
    result.set("caption", page_text(table.caption));
    result.set("folded", table.folded);
    result.set("head", cells_of(table.head, words));
    result.set("rows", rows);
    return result;
}

/// A part of the template that is left out where its list is empty.
void set_part(data& values, const std::string& name, const data& content, bool present) {
    if (present) values.set(name, content);
}

data to_data(const PageSection& section) {
    data one, tables{data::type::list};
    for (const PageTable& table : section.tables) {
        if (!table.rows.empty()) tables << to_data(table);
    }
    one.set("id", section.id);
    one.set("title", section.title);
    one.set("lines", list_of(section.lines));
    data commands{data::type::list};
    for (const std::string& each : section.commands)
        commands << each;
    one.set("commands", commands);
    if (!section.note.empty()) one.set("note", page_text(section.note));
    one.set("tables", tables);
    data copies{data::type::list};
    for (const PageCopy& each : section.copies) {
        data copy{"id", each.id};
        copy.set("label", each.label);
        copy.set("text", each.text);
        copies << copy;
    }
    one.set("copies", copies);
    data pictures{data::type::list};
    for (const PagePicture& each : section.pictures) {
        data picture{"effect", each.effect};
        if (!each.standing.empty()) picture.set("standing", each.standing);
        picture.set("summary", each.summary);
        picture.set("cell", each.cell);
        picture.set("change", each.change);
        pictures << picture;
    }
    set_part(one, "pictured", data{"pictures", pictures}, !section.pictures.empty());
    set_part(one, "figures", data{"place", section.figures}, !section.figures.empty());
    data more{"title", section.more_title};
    more.set("more_lines", list_of(section.more));
    set_part(one, "more", more, !section.more.empty());
    return one;
}

data to_data(const std::vector<PageSection>& sections) {
    data result{data::type::list};
    for (const PageSection& section : sections) {
        result << to_data(section);
    }
    return result;
}

/// JSON that can stand in a script element: no text in it can end the element.
template <class Json>
std::string for_script(const Json& json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string safe;
    for (const char c : text) {
        if (c == '<') {
            safe += "\\u003c";
        } else {
            safe += c;
        }
    }
    return safe;
}

}  // namespace

std::string page_policy(bool served) {
    return fmt::format(
        "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; "
        "connect-src {}; base-uri 'none'; form-action 'none'",
        served ? "'self'" : "'none'");
}

namespace {

/// Parts of the template that do not depend on results. `served_version`: version of the page of a
/// server; empty: a page without a server.
data frame_of_page(const std::string& study, const std::string& version,
                   const std::optional<std::size_t>& served_version) {
    data values;
    values.set("study", study);
    values.set("policy", page_policy(served_version.has_value()));
    values.set("style", std::string(page_style));
    std::string script = page_script;
    if (served_version) script += page_serve_script;
    values.set("script", script);
    values.set("section", kainjow::mustache::partial{[] { return std::string(page_section); }});
    values.set("made_by", "Pendular " + version);
    if (served_version) values.set("served", data{"version", std::to_string(*served_version)});
    return values;
}

}  // namespace

namespace {

/// Sets what the page says; `figures`: the data of its figures as they stand in a script.
void set_texts(data& values, const PageTexts& texts, const std::string& figures) {
    values.set("results", data::type::bool_true);
    values.set("verdict", page_text(texts.headline));
    values.set("details", list_of(texts.details));
    values.set("measure", page_text(texts.measure));
    values.set("warnings", list_of(texts.warnings));
    values.set("ladder", to_data(texts.ladder));
    values.set("story", to_data(texts.story));
    values.set("folded_sections", to_data(texts.folded));
    values.set("recordings", texts.recordings);
    values.set("data", figures);
}

/// Content of the script element of a page with this id; empty if there is none.
std::string script_of(const std::string& page, const std::string& id) {
    const std::string begin = fmt::format("<script type=\"application/json\" id=\"{}\">", id);
    const auto from = page.find(begin);
    if (from == std::string::npos) return "";
    const auto to = page.find("</script>", from);
    return page.substr(from + begin.size(), to - from - begin.size());
}

/// Sets the results of an earlier page, and returns whether they could be read.
bool set_earlier_page(data& values, const std::string& page, const std::string& version) {
    const auto texts = nlohmann::json::parse(script_of(page, "texts"), nullptr, false);
    const auto figures = nlohmann::ordered_json::parse(script_of(page, "data"), nullptr, false);
    if (texts.is_discarded() || figures.is_discarded()) return false;
    try {
        const PageTexts said = texts_from(texts);
        if (said.version != version) return false;  // another version's script reads other data
        set_texts(values, said, for_script(figures));
    } catch (const nlohmann::json::exception&) {
        return false;
    }
    return true;
}

/// Sets what the last step of a ladder says.
void set_ladder(data& values, const LadderStep& step) {
    values.set("verdict", fmt::format("The model {} has chi2/dof {:.2f}.",
                                      step.effects.empty() ? std::string("without effects")
                                                           : "with " + joined(step.effects, "and"),
                                      step.chi2_per_dof()));
    std::vector<std::string> parameters;
    for (const LadderParameter& p : step.parameters) {
        parameters.push_back(fmt::format("{}: {}", parameter_in_words(p.name),
                                         with_error(p.value, p.standard_error, p.unit)));
    }
    values.set("details", list_of(parameters));
}

}  // namespace

std::string waiting_page(const std::string& study, const std::string& version,
                         const EarlierResults& earlier) {
    kainjow::mustache::mustache page{page_template};
    data values = frame_of_page(study, version, 0);
    values.set("verdict", "There are no results on this study yet.");
    const bool whole = set_earlier_page(values, earlier.page, version);
    if (whole || !earlier.ladder.empty()) {
        if (!whole) set_ladder(values, earlier.ladder.back());
        const std::string when = whole ? earlier.when : "";
        values.set("as_of",
                   fmt::format("These are earlier results{}. Pendular is computing new ones.",
                               when.empty() ? "" : ", of " + when));
    }
    return page.render(values);
}

std::string report_page(const PageContent& content) {
    kainjow::mustache::mustache page{page_template};
    const PageTexts texts = page_texts(content);
    data values = frame_of_page(content.study, content.version, content.served_version);
    set_texts(
        values, texts,
        for_script(page_data(content.switched, content.panels, content.recordings,
                             page_story(content.ladder, content.diagnosis, content.switched))));
    if (!content.served_version) values.set("texts", for_script(to_json_of(texts)));
    return page.render(values);
}

}  // namespace pendular
