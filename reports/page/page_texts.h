#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace pendular {

/// Table of a page: a caption, a heading and rows of cells.
struct PageTable {
    std::string caption;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows = {};
    /// Whether the page shows the caption alone until the reader opens the table.
    bool folded = false;
};

/// Text of a page with a button that copies it.
struct PageCopy {
    std::string id, label, text;
};

/// Pictures of an effect: what happens in the cell, and how the readings change.
struct PagePicture {
    std::string effect;
    std::string standing;  ///< "in the model", or empty
    std::string summary;
    std::string cell, change;  ///< SVG; `change` may be empty
};

/// Section of a page: lines of text, further lines behind a fold, commands to give, tables, and
/// text to copy.
struct PageSection {
    std::string id, title;
    std::vector<std::string> lines = {};
    std::string more_title = {};
    std::vector<std::string> more = {};
    std::vector<std::string> commands = {};
    std::string note = {};  ///< what the tables' words mean
    std::vector<PageTable> tables = {};
    std::vector<PageCopy> copies = {};
    std::vector<PagePicture> pictures = {};
    /// Id of the place where the page's script draws figures; empty: none.
    std::string figures = {};
};

/// Words and tables of a page, without the data of its figures.
struct PageTexts {
    std::string study, version;
    std::string headline;              ///< answer in one sentence
    std::vector<std::string> details;  ///< of the answer
    std::string measure;               ///< what to do next; may be empty
    std::vector<std::string> warnings;
    PageSection ladder;               ///< the error as it fell
    std::vector<PageSection> story;   ///< after model and measurement
    std::vector<PageSection> folded;  ///< for those who want to know more
    bool recordings = false;          ///< whether there are figures of recordings
};

/// Writes and reads texts, with which a later program shows an earlier page; pictures are left out.
/// @throws nlohmann::json::exception for JSON that is none
nlohmann::json to_json_of(const PageTexts& texts);
PageTexts texts_from(const nlohmann::json& json);

}  // namespace pendular
