#include "sim/runs/store/run_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "data/input_error.h"
#include "sim/dem/archive.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/blob.h"
#include "sim/runs/store/run_columns.h"

namespace pendular {
namespace {

/// Application id "pend" in the header of an SQLite file, which marks it as a store.
constexpr int application_id = 0x70656e64;
constexpr int patience_ms = 120'000;  ///< longest wait for other processes to finish writing [ms]

std::string key_of(const dem::RunResult& run, int version) {
    return fmt::format("{}physics version = {}\n", run_description(run.parameters, run.threads),
                       version);
}

/// Throws the error for a user that an error of SQLite means: InputError where the file
/// cannot be opened or is not a valid store, else std::runtime_error.
[[noreturn]] void explain(const std::filesystem::path& file, const SQLite::Exception& error) {
    const std::string name = fmt::format("store {}", file.string());
    switch (error.getErrorCode()) {
        case SQLITE_NOTADB:
            throw InputError(fmt::format("{} is no store of runs; name another file", name));
        case SQLITE_CORRUPT:
            throw InputError(
                fmt::format("{} is corrupt ({}); 'sqlite3 FILE .recover' may save its runs, or "
                            "name another file",
                            name, error.what()));
        case SQLITE_CANTOPEN:
            throw InputError(fmt::format("{} cannot be opened: {}", name, error.what()));
        case SQLITE_FULL:
            throw std::runtime_error(
                fmt::format("{}: the disk is full; the runs it holds are safe, free some space and "
                            "start the same command again",
                            name));
        default:
            throw std::runtime_error(fmt::format(
                "{}: {}; the runs it holds are safe, start the same command again once that is "
                "put right",
                name, error.what()));
    }
}

template <typename Work>
auto explained(const std::filesystem::path& file, const Work& work) {
    try {
        return work();
    } catch (const SQLite::Exception& error) {
        explain(file, error);
    }
}

std::string sql_type(RunColumn::Type type) {
    return type == RunColumn::Type::integer ? "INTEGER"
           : type == RunColumn::Type::real  ? "REAL"
                                            : "TEXT";
}

int pragma(SQLite::Database& database, const std::string& name) {
    return database.execAndGet("PRAGMA " + name).getInt();
}

std::vector<const RunColumn*> missing_columns(SQLite::Database& database) {
    std::vector<std::string> there;
    SQLite::Statement columns(database, "SELECT name FROM pragma_table_info('runs')");
    while (columns.executeStep()) {
        there.push_back(columns.getColumn(0).getString());
    }
    std::vector<const RunColumn*> missing;
    for (const RunColumn& column : run_columns()) {
        if (std::ranges::find(there, column.name) == there.end()) {
            missing.push_back(&column);
        }
    }
    return missing;
}

/// Creates the table of runs, or adds the columns that the file lacks. Another process may be doing
/// the same, so that the file is inspected only after this process has locked it for writing.
void make_table(SQLite::Database& database, const std::string& name) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    const int id = pragma(database, "application_id"), version = pragma(database, "user_version");
    const bool fresh = id == 0 && version == 0 &&
                       database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
    if (!fresh && id != application_id) {
        throw InputError(
            fmt::format("{} is a database of another program; name another file", name));
    }
    if (version > RunStore::format) {
        throw InputError(fmt::format(
            "{} was written by a newer version of pendular (format {}, this one knows {}); update "
            "pendular or name another file",
            name, version, RunStore::format));
    }
    database.exec(
        "CREATE TABLE IF NOT EXISTS runs (id INTEGER PRIMARY KEY AUTOINCREMENT, key TEXT NOT NULL "
        "UNIQUE, physics_version INTEGER NOT NULL, added TEXT NOT NULL DEFAULT CURRENT_TIMESTAMP, "
        "trace BLOB, final_state BLOB)");
    for (const RunColumn* column : missing_columns(database)) {
        database.exec(
            fmt::format("ALTER TABLE runs ADD COLUMN {} {}", column->name, sql_type(column->type)));
    }
    database.exec(fmt::format("PRAGMA application_id = {}", application_id));
    database.exec(fmt::format("PRAGMA user_version = {}", RunStore::format));
    transaction.commit();
}

std::string column_list() {
    std::vector<std::string> names;
    for (const RunColumn& column : run_columns()) {
        names.push_back(column.name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

void bind_cell(SQLite::Statement& statement, int at, const RunCell& cell) {
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) {
        statement.bind(at, *whole);
    } else if (const auto* number = std::get_if<double>(&cell)) {
        statement.bind(at, *number);  // SQLite keeps no NaN: it becomes NULL
    } else if (const auto* text = std::get_if<std::string>(&cell)) {
        statement.bind(at, *text);
    }
}

RunCell cell_of(const SQLite::Column& column) {
    if (column.isInteger()) {
        return column.getInt64();
    }
    if (column.isFloat()) {
        return column.getDouble();
    }
    return column.isText() ? RunCell(column.getString()) : RunCell();
}

/// Returns the run of a row of "id, physics_version, columns...".
StoredRun run_of(SQLite::Statement& row) {
    StoredRun stored{row.getColumn(0).getInt64(), row.getColumn(1).getInt(), {}};
    int at = 2;
    for (const RunColumn& column : run_columns()) {
        const RunCell cell = cell_of(row.getColumn(at++));
        if (!std::holds_alternative<std::monostate>(cell)) {
            column.set(stored.run, cell);
        }
    }
    return stored;
}

std::string selection() {
    return "SELECT id, physics_version, " + column_list();
}

void bind_blob(SQLite::Statement& statement, int at, const std::string& bytes) {
    statement.bind(at, bytes.data(), static_cast<int>(bytes.size()));
}

std::string blob_of(const SQLite::Column& column) {
    return {static_cast<const char*>(column.getBlob()), static_cast<std::size_t>(column.size())};
}

}  // namespace

RunStore::RunStore(const std::filesystem::path& file, bool must_exist)
    : file_(file == in_memory ? file : std::filesystem::absolute(file)) {
    std::error_code error;
    if (must_exist && !std::filesystem::exists(file_, error)) {
        throw InputError(
            fmt::format("store {}: no such file; 'pendular simulate', 'calibrate' and "
                        "'campaign' make a store, --store FILE names another",
                        file_.string()));
    }
    if (std::filesystem::is_directory(file_, error)) {
        throw InputError(fmt::format("store {} is a folder; name a file", file_.string()));
    }
    if (file_ != in_memory) {
        std::filesystem::create_directories(file_.parent_path(), error);
    }
    explained(file_, [&] {
        database_ = std::make_unique<SQLite::Database>(
            file_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, patience_ms);
        const bool made = pragma(*database_, "application_id") == application_id &&
                          pragma(*database_, "user_version") == format &&
                          missing_columns(*database_).empty();
        if (!made) {
            make_table(*database_, fmt::format("store {}", file_.string()));
        }
        // Readers and one writer go side by side; a commit is on disk before it is reported.
        database_->exec("PRAGMA journal_mode = WAL");
        database_->exec("PRAGMA synchronous = FULL");
    });
}

RunStore::~RunStore() = default;

std::optional<dem::RunResult> RunStore::find(const dem::RunParameters& parameters,
                                             int threads) const {
    const std::lock_guard lock(mutex_);
    return explained(file_, [&]() -> std::optional<dem::RunResult> {
        SQLite::Statement query(*database_, selection() + " FROM runs WHERE key = ?");
        query.bind(1, key_of({.parameters = parameters, .threads = threads}, dem::physics_version));
        if (!query.executeStep()) {
            return std::nullopt;
        }
        dem::RunResult run = run_of(query).run;
        run.parameters = parameters;
        return run;
    });
}

namespace {

bool insert(SQLite::Database& database, const dem::RunResult& run, int version) {
    const std::size_t count = run_columns().size();
    std::string places = "?, ?, ?, ?";
    for (std::size_t k = 0; k < count; ++k) {
        places += ", ?";
    }
    SQLite::Statement insertion(
        database, fmt::format("INSERT OR IGNORE INTO runs (key, physics_version, trace, "
                              "final_state, {}) VALUES ({})",
                              column_list(), places));
    insertion.bind(1, key_of(run, version));
    insertion.bind(2, version);
    if (!run.trace.empty()) {
        bind_blob(insertion, 3, compressed(dem::archived(run.trace)));
    }
    if (!run.final_state.grains.empty()) {
        bind_blob(insertion, 4, compressed(dem::archived(run.final_state)));
    }
    int at = 5;
    for (const RunColumn& column : run_columns()) {
        bind_cell(insertion, at++, column.get(run));
    }
    return insertion.exec() > 0;
}

}  // namespace

bool RunStore::add(const dem::RunResult& run, int version) {
    const std::lock_guard lock(mutex_);
    return explained(file_, [&] { return insert(*database_, run, version); });
}

std::optional<StoredRun> RunStore::nearest(const dem::RunParameters& p) const {
    std::optional<std::int64_t> id;
    double least = std::numeric_limits<double>::infinity();
    const std::string like = fmt::format(
        "beads = {} AND steady AND NOT crystallised AND failure IS NULL AND final_state IS NOT "
        "NULL AND reduced_pressure IS {}",
        p.grains, p.wetting ? "NOT NULL" : "NULL");
    for (const StoredRun& stored : select(like)) {
        const auto& other = stored.run.parameters;
        const auto squared = [](double x) { return x * x; };
        double distance = squared((p.friction - other.friction) / 0.1) +
                          squared(std::log(p.inertial_number / other.inertial_number)) +
                          squared(std::log(p.stiffness_number / other.stiffness_number));
        if (p.wetting) {
            distance +=
                squared(std::log(p.wetting->reduced_pressure / other.wetting->reduced_pressure)) +
                squared(std::log(p.wetting->bridge_volume / other.wetting->bridge_volume));
        }
        if (distance < least) {
            least = distance, id = stored.id;
        }
    }
    return id ? std::optional(get(*id)) : std::nullopt;
}

std::size_t RunStore::size() const {
    const std::lock_guard lock(mutex_);
    return explained(file_, [&] {
        return static_cast<std::size_t>(
            database_->execAndGet("SELECT count(*) FROM runs").getInt64());
    });
}

std::vector<StoredRun> RunStore::select(const std::string& condition) const {
    const std::lock_guard lock(mutex_);
    return explained(file_, [&] {
        std::vector<StoredRun> runs;
        const std::string where = condition.empty() ? "" : " WHERE (" + condition + ")";
        SQLite::Statement query = [&] {
            try {
                return SQLite::Statement(*database_,
                                         selection() + " FROM runs" + where + " ORDER BY id");
            } catch (const SQLite::Exception& error) {
                if (error.getErrorCode() != SQLITE_ERROR) {
                    throw;
                }
                throw InputError(
                    fmt::format("condition '{}': {}; the header of "
                                "'pendular runs export' names the columns",
                                condition, error.what()));
            }
        }();
        while (query.executeStep()) {
            runs.push_back(run_of(query));
        }
        return runs;
    });
}

StoredRun RunStore::get(std::int64_t id) const {
    const std::lock_guard lock(mutex_);
    return explained(file_, [&] {
        SQLite::Statement query(*database_,
                                selection() + ", trace, final_state FROM runs WHERE id = ?");
        query.bind(1, id);
        if (!query.executeStep()) {
            throw InputError(
                fmt::format("store {} has no run {}; 'pendular runs list' shows those there are",
                            file_.string(), id));
        }
        StoredRun stored = run_of(query);
        const int at = 2 + static_cast<int>(run_columns().size());
        const auto expand = [&](int column, auto& into) {
            if (query.getColumn(column).isBlob() &&
                !dem::restore(expanded(blob_of(query.getColumn(column))), into)) {
                throw InputError(fmt::format("store {}: run {} is corrupt", file_.string(), id));
            }
        };
        expand(at, stored.run.trace);
        expand(at + 1, stored.run.final_state);
        return stored;
    });
}

std::size_t RunStore::remove(const std::vector<std::int64_t>& ids) {
    const std::lock_guard lock(mutex_);
    return explained(file_, [&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        SQLite::Statement removal(*database_, "DELETE FROM runs WHERE id = ?");
        std::size_t removed = 0;
        for (const std::int64_t id : ids) {
            removal.bind(1, id);
            removed += static_cast<std::size_t>(removal.exec());
            removal.reset();
        }
        transaction.commit();
        return removed;
    });
}

std::size_t RunStore::merge(const RunStore& other) {
    std::size_t added = 0;
    for (const StoredRun& listed : other.select()) {
        added += add(other.get(listed.id).run, listed.physics_version);
    }
    return added;
}

std::filesystem::path RunStore::standard_file() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value ? value : "");
    };
    if (const auto file = variable("PENDULAR_STORE"); !file.empty()) {
        return file;
    }
    if (const auto data = variable("XDG_DATA_HOME"); !data.empty()) {
        return std::filesystem::path(data) / "pendular" / "runs.sqlite";
    }
    const auto home = variable("HOME");
    return std::filesystem::path(home.empty() ? "." : home) / ".local" / "share" / "pendular" /
           "runs.sqlite";
}

}  // namespace pendular
