#include "data/files/formats/rejected_rows.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "data/files/folded_name.h"

namespace pendular {
namespace {

bool names_validity(std::string_view name) {
    constexpr std::array names = {
        "valid",    "ok",         "used",      "used for fit",   "use",    "in fit",
        "accepted", "gültig",     "verwendet", "berücksichtigt", "valide", "valable",
        "utilisé",  "retenu",     "válido",    "valido",         "usado",  "utilizado",
        "usato",    "utilizzato", "geldig",    "ważny"};
    return is_among_names(folded_name(name), names);
}

bool names_rejection(std::string_view name) {
    constexpr std::array names = {
        "excluded",   "exclude",        "rejected",  "reject",    "outlier",   "invalid",
        "discarded",  "ausgeschlossen", "verworfen", "ausreißer", "ungültig",  "exclu",
        "exclus",     "rejeté",         "écarté",    "aberrant",  "excluido",  "rechazado",
        "descartado", "anómalo",        "escluso",   "scartato",  "rifiutato", "anomalo"};
    return is_among_names(folded_name(name), names);
}

/// Whether a column may have words on single rows.
bool names_remarks(std::string_view name) {
    constexpr std::array names = {
        "flag",        "status",       "state",    "remark",      "remarks",       "comment",
        "comments",    "note",         "notes",    "quality",     "bemerkung",     "bemerkungen",
        "kommentar",   "zustand",      "hinweis",  "anmerkung",   "remarque",      "remarques",
        "commentaire", "statut",       "état",     "observación", "observaciones", "comentario",
        "estado",      "osservazioni", "commento", "nota",        "stato",         "esito",
        "result",      "ergebnis",     "résultat", "resultado",   "opmerking",     "uwagi",
        "valid",       "ok",           "check"};
    return is_among_names(folded_name(name), names);
}

/// Whether a remark rejects its row, by a word at its begin: "no outlier" rejects none. Words for
/// an overload that mean a surcharge too, "sobrecarga 5 kPa", are left out.
bool rejects(std::string_view text) {
    constexpr std::array<std::string_view, 24> begins = {
        "reject",   "invalid", "discard",  "exclud",  "outlier",   "overload",
        "ungultig", "verworf", "ausreiss", "ausreiß", "ausgeschl", "uberlast",
        "rejet",    "ecarte",  "aberrant", "exclu",   "rechaz",    "descart",
        "anomal",   "esclus",  "scart",    "rifiut",  "nichtverw", "notused"};
    const std::string word = folded_name(text);
    return std::ranges::any_of(begins,
                               [&](std::string_view each) { return word.starts_with(each); });
}

bool is_yes(std::string_view word) {
    constexpr std::array<std::string_view, 11> words = {"1",  "x", "yes", "y",  "tru", "true",
                                                        "ja", "j", "oui", "si", "wahr"};
    return std::ranges::find(words, word) != words.end();
}

bool is_no(std::string_view word) {
    constexpr std::array<std::string_view, 9> words = {"0",     "no",     "n",    "nein", "non",
                                                       "false", "falsch", "faux", ""};
    return std::ranges::find(words, word) != words.end();
}

/// Rows that a column rejects; none if it is no column of that kind.
std::vector<bool> rejected_by(const Block& block, std::size_t column) {
    const std::string_view name = block.columns[column].name;
    const bool validity = names_validity(name), rejection = names_rejection(name);
    const bool remarks = names_remarks(name);
    if (!validity && !rejection && !remarks) return {};
    std::vector<bool> rejected;
    bool all_answers = true;
    for (std::size_t i = 0; i < block.table.rows.size(); ++i) {
        const std::string& text = block.table.rows[i].cells[column].text;
        // In a long recording, most rows say the same as the row before.
        if (i > 0 && text == block.table.rows[i - 1].cells[column].text) {
            rejected.push_back(rejected.back());
            continue;
        }
        const std::string word = folded_name(text);
        all_answers = all_answers && (is_yes(word) || is_no(word));
        rejected.push_back((validity && is_no(word)) || (rejection && is_yes(word)) ||
                           (remarks && rejects(text)));
    }
    if (!remarks && !all_answers) return {};
    if (2 * std::ranges::count(rejected, true) >= std::ssize(rejected)) return {};
    return rejected;
}

}  // namespace

void leave_out_rejected_rows(BlockFile& file) {
    for (Block& block : file.blocks) {
        std::vector<bool> rejected(block.table.rows.size(), false);
        for (std::size_t i = 0; i < block.columns.size(); ++i) {
            if (!block.columns[i].quantity.empty()) continue;
            const std::vector<bool> own = rejected_by(block, i);
            for (std::size_t k = 0; k < own.size(); ++k)
                rejected[k] = rejected[k] || own[k];
        }
        if (std::ranges::none_of(rejected, [](bool each) { return each; })) continue;
        std::vector<Row> kept;
        for (std::size_t k = 0; k < rejected.size(); ++k)
            if (rejected[k])
                skip_line(file, block.table.rows[k].line, Remark::Kind::marked_invalid);
            else
                kept.push_back(std::move(block.table.rows[k]));
        block.table.rows = std::move(kept);
    }
}

}  // namespace pendular
