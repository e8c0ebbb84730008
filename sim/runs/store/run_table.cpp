#include "sim/runs/store/run_table.h"

#include <fmt/format.h>

#include <dlfcn.h>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <stdexcept>

#include "data/files/csv.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_columns.h"

namespace pendular {
namespace {

constexpr const char* version_column = "physics_version";

std::string text_of(const RunCell& cell) {
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) {
        return fmt::format("{}", *whole);
    }
    if (const auto* number = std::get_if<double>(&cell)) {
        return fmt::format("{}", *number);
    }
    const auto* text = std::get_if<std::string>(&cell);
    return text ? csv_cell(*text) : "";
}

std::string row_of(const StoredRun& stored) {
    std::string row = fmt::format("{}", stored.physics_version);
    for (const RunColumn& column : run_columns()) {
        row += ',' + text_of(column.get(stored.run));
    }
    return row;
}

template <typename Number>
Number number(const Table& table, const Row& row, std::size_t at, const std::string& meaning) {
    const std::string& text = row.cells[at].text;
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        throw InputError(table.at(row, at), fmt::format("'{}' is not {}", text, meaning));
    }
    return value;
}

RunCell cell_of(const Table& table, const Row& row, std::size_t at, RunColumn::Type type) {
    const std::string& text = row.cells[at].text;
    if (text.empty()) {
        return {};
    }
    switch (type) {
        case RunColumn::Type::integer:
            return number<std::int64_t>(table, row, at, "a whole number");
        case RunColumn::Type::real:
            return number<double>(table, row, at, "a number");
        default:
            return text;
    }
}

/// Quantity of a run that a column of the file holds; null: the physics version.
using Meaning = const RunColumn*;

std::vector<Meaning> meanings_of(const Table& table) {
    std::vector<std::string> known = {version_column}, there;
    for (const RunColumn& column : run_columns()) {
        known.push_back(column.name);
    }
    std::vector<Meaning> meanings;
    for (std::size_t k = 0; k < table.header.cells.size(); ++k) {
        const std::string& name = table.header.cells[k].text;
        const auto found = std::ranges::find(run_columns(), name, &RunColumn::name);
        if (found == run_columns().end() && name != version_column) {
            throw InputError(table.at_header(k), fmt::format("unknown column '{}'; {}", name,
                                                             did_you_mean(name, known)));
        }
        meanings.push_back(found == run_columns().end() ? nullptr : &*found);
        there.push_back(name);
    }
    for (const RunColumn& column : run_columns()) {
        // Tables from program versions without effects do not have this column.
        const bool needed = column.determines && column.name != "effects";
        if (needed && std::ranges::find(there, column.name) == there.end()) {
            throw InputError(table.at_header(0),
                             fmt::format("the column '{}' is missing; without it a run cannot be "
                                         "told from others",
                                         column.name));
        }
    }
    return meanings;
}

StoredRun run_of(const Table& table, const Row& row, const std::vector<Meaning>& meanings) {
    StoredRun stored{.physics_version = dem::physics_version};
    for (std::size_t k = 0; k < meanings.size(); ++k) {
        if (!meanings[k]) {
            stored.physics_version = number<int>(table, row, k, "a whole number");
            continue;
        }
        const RunCell cell = cell_of(table, row, k, meanings[k]->type);
        const bool empty = std::holds_alternative<std::monostate>(cell);
        if (!empty) {
            try {
                meanings[k]->set(stored.run, cell);
            } catch (const std::exception& error) {
                throw InputError(table.at(row, k), error.what());
            }
        }
    }
    try {
        check_run(stored.run.parameters);
    } catch (const std::invalid_argument& error) {
        throw InputError(table.at(row, 0), error.what());
    }
    return stored;
}

}  // namespace

void write_runs(const std::filesystem::path& file, const std::vector<StoredRun>& runs) {
    std::string text = version_column;
    for (const RunColumn& column : run_columns()) {
        text += ',' + column.name;
    }
    text += '\n';
    for (const StoredRun& stored : runs) {
        text += row_of(stored) + '\n';
    }
    write_whole(file, text);
}

std::string run_fingerprint(const StoredRun& stored) {
    return fmt::format("{:016x}", fingerprint(row_of(stored)));
}

std::vector<StoredRun> read_runs(const std::filesystem::path& file) {
    const Table table = read_table(file);
    const auto meanings = meanings_of(table);
    std::vector<StoredRun> runs;
    for (const Row& row : table.rows) {
        runs.push_back(run_of(table, row, meanings));
    }
    return runs;
}

namespace {

/// Folder of an atlas beside a library that holds this code, as the Python module is one; empty if
/// `program` itself holds it. A program's name may be its first argument as it was typed: an atlas
/// beside that would be one of the working folder, which anybody may have written.
std::filesystem::path beside_library(const std::filesystem::path& program) {
    Dl_info own{};
    if (dladdr(reinterpret_cast<const void*>(&atlas_file), &own) == 0 || !own.dli_fname) return {};
    const std::filesystem::path library = own.dli_fname;
    std::error_code error;
    if (!library.is_absolute() || std::filesystem::equivalent(library, program, error)) return {};
    return library.parent_path() / "atlas";
}

}  // namespace

std::filesystem::path atlas_file() {
    if (const char* named = std::getenv("PENDULAR_ATLAS"); named && *named) {
        return named;
    }
    std::error_code error;
    // An installed program may have been moved, or installed with another --prefix.
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto beside = program.parent_path().parent_path() / "share" / "pendular";
    for (const std::filesystem::path& folder :
         {beside_library(program), beside, std::filesystem::path(PENDULAR_INSTALLED_ATLAS),
          std::filesystem::path(PENDULAR_SOURCE_ATLAS)}) {
        if (!folder.is_absolute()) continue;  // never an atlas of the working folder
        auto file = folder / "atlas.csv";
        if (std::filesystem::exists(file, error)) {
            return file;
        }
    }
    return {};
}

}  // namespace pendular
