#include "sim/runs/store/run_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>

#include "data/input_error.h"
#include "sim/dem/archive.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_columns.h"
#include "sim/runs/store/store_file.h"

namespace pendular {
namespace {

constexpr int most_text = 100'000;  ///< largest size of a text of a run [bytes]
/// Largest text or blob that a condition on runs may make [bytes].
constexpr int most_in_condition = 10'000'000;
/// Largest number of steps of SQLite's virtual machine for a condition on runs. A row of 200 cells
/// takes 203 steps (measured), a million of them 2e8; 1e9 steps take 6 s of a processor. A join of
/// 759 runs with themselves three times needs 1e9, another one more days.
constexpr std::int64_t most_steps = 1'000'000'000;
constexpr int steps_between_checks = 1'000'000;  ///< some milliseconds

std::string key_of(const dem::RunResult& run, int version) {
    return fmt::format("{}physics version = {}\n", run_description(run.parameters, run.threads),
                       version);
}

template <typename Work>
auto explained(const std::filesystem::path& file, const Work& work) {
    try {
        return work();
    } catch (const SQLite::Exception& error) {
        explain(file, error);
    }
}

/// Names that a condition on runs may use.
std::vector<std::string> column_names() {
    std::vector<std::string> names = {"id", "physics_version", "added"};
    std::ranges::transform(run_columns(), std::back_inserter(names), &RunColumn::name);
    return names;
}

/// Advice on an error of SQLite in a condition: for an unknown column, the nearest one.
std::string advice_on(const std::string& error) {
    constexpr std::string_view unknown = "no such column: ";
    const auto at = error.find(unknown);
    if (at == std::string::npos) return "the header of 'pendular runs export' names the columns";
    std::string name = error.substr(at + unknown.size());
    std::erase(name, '"');
    name = name.substr(0, name.find(' '));  // newer versions of SQLite add a sentence
    return nearest(name, column_names()) ? did_you_mean(name, column_names())
                                         : "the header of 'pendular runs export' names the columns";
}

/// Refuses a condition on runs that SQLite cannot carry out: some errors, such as an overflow, come
/// only with the runs that it is applied to. Does nothing about other errors.
/// @throws InputError where the error is one of the condition or, without one, of the store
void refuse_condition(const std::filesystem::path& file, const std::string& condition,
                      const SQLite::Exception& error) {
    if (error.getErrorCode() == SQLITE_INTERRUPT && !condition.empty()) {
        throw InputError(fmt::format(
            "condition '{}': takes more than {:g} steps of SQLite, five times as many as for a "
            "million runs; give a condition on the columns of a run alone, without a table in it",
            condition, static_cast<double>(most_steps)));
    }
    if (error.getErrorCode() != SQLITE_ERROR && error.getErrorCode() != SQLITE_AUTH) return;
    if (condition.empty())
        throw InputError(
            fmt::format("store {}: {}; name another file", file.string(), error.what()));
    throw InputError(
        fmt::format("condition '{}': {}; {}", condition, error.what(), advice_on(error.what())));
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
    if (column.size() > most_text) {
        throw std::invalid_argument(fmt::format("holds {} bytes", column.size()));
    }
    return column.isText() ? RunCell(column.getString()) : RunCell();
}

[[noreturn]] void refuse_run(const std::filesystem::path& file, std::int64_t id,
                             const std::string& why) {
    throw InputError(
        fmt::format("store {}: run {} is corrupt: {}; to remove it: pendular runs prune "
                    "--where \"id = {}\" --yes",
                    file.string(), id, why, id));
}

/// Returns the run of a row of "id, physics_version, columns...".
/// @throws InputError where a cell holds a value that no run can have
StoredRun run_of(SQLite::Statement& row, const std::filesystem::path& file) {
    StoredRun stored{row.getColumn(0).getInt64(), row.getColumn(1).getInt(), {}};
    int at = 2;
    for (const RunColumn& column : run_columns()) {
        try {
            const RunCell cell = cell_of(row.getColumn(at++));
            if (!std::holds_alternative<std::monostate>(cell)) {
                column.set(stored.run, cell);
            }
        } catch (const std::invalid_argument& error) {
            refuse_run(file, stored.id, fmt::format("column '{}' {}", column.name, error.what()));
        }
    }
    try {
        check_run(stored.run.parameters);
    } catch (const std::invalid_argument& error) {
        refuse_run(file, stored.id, error.what());
    }
    return stored;
}

/// Whether a state can be that of a run: its cell has a volume, and all numbers are finite.
bool can_be_state(const dem::StoredSample& state) {
    if (state.grains.empty()) return true;
    const dem::Cell& cell = state.cell;
    return std::isfinite(cell.volume()) && std::isfinite(cell.offset) &&
           std::min({cell.length, cell.height, cell.width}) > 0 &&
           std::ranges::all_of(state.grains, [](const auto& grain) {
               return std::ranges::all_of(grain, [](float x) { return std::isfinite(x); });
           });
}

std::string selection() {
    return "SELECT id, physics_version, " + column_list();
}

void bind_blob(SQLite::Statement& statement, int at, const std::string& bytes) {
    statement.bind(at, bytes.data(), static_cast<int>(bytes.size()));
}

/// Checks that an SQL text is a single command, without a second command after it.
/// @throws InputError where a second command follows
void refuse_more_commands(SQLite::Database& database, const std::string& command,
                          const std::string& condition) {
    sqlite3_stmt* statement = nullptr;
    const char* rest = "";
    const int status =
        sqlite3_prepare_v2(database.getHandle(), command.c_str(), -1, &statement, &rest);
    sqlite3_finalize(statement);
    if (status == SQLITE_OK && rest && *rest != '\0') {
        throw InputError(fmt::format(
            "condition '{}': contains more than one condition; remove ';' and the text after it",
            condition));
    }
}

/// Limits the size of texts and blobs that SQLite makes, during the life of the object.
class SizeLimit {
  public:
    SizeLimit(SQLite::Database& database, int bytes)
        : handle_(database.getHandle()),
          before_(sqlite3_limit(handle_, SQLITE_LIMIT_LENGTH, bytes)) {}
    SizeLimit(const SizeLimit&) = delete;
    SizeLimit& operator=(const SizeLimit&) = delete;
    ~SizeLimit() { sqlite3_limit(handle_, SQLITE_LIMIT_LENGTH, before_); }

  private:
    sqlite3* handle_;
    int before_;
};

/// Interrupts SQLite after `most_steps` steps, during the life of the object.
class StepLimit {
  public:
    explicit StepLimit(SQLite::Database& database) : handle_(database.getHandle()) {
        sqlite3_progress_handler(
            handle_, steps_between_checks,
            [](void* left) {
                return int{(*static_cast<std::int64_t*>(left) -= steps_between_checks) < 0};
            },
            &left_);
    }
    StepLimit(const StepLimit&) = delete;
    StepLimit& operator=(const StepLimit&) = delete;
    ~StepLimit() { sqlite3_progress_handler(handle_, 0, nullptr, nullptr); }

  private:
    sqlite3* handle_;
    std::int64_t left_ = most_steps;
};

std::string blob_of(const SQLite::Column& column) {
    return {static_cast<const char*>(column.getBlob()), static_cast<std::size_t>(column.size())};
}

}  // namespace

RunStore::RunStore(const std::filesystem::path& file, bool must_exist)
    : file_(file == in_memory ? file : std::filesystem::absolute(file)) {
    database_ = explained(file_, [&] { return open_store_file(file_, must_exist); });
    identity_ = identity_of(file_);
}

RunStore::~RunStore() = default;

void RunStore::demand_present() const {
    if (identity_of(file_) != identity_) {
        throw std::runtime_error(fmt::format(
            "store {} was removed or replaced while this command used it; the runs that "
            "it held are lost: put it back, or start the same command again",
            file_.string()));
    }
}

std::optional<dem::RunResult> RunStore::find(const dem::RunParameters& parameters,
                                             int threads) const {
    const std::lock_guard lock(mutex_);
    return explained(file_, [&]() -> std::optional<dem::RunResult> {
        SQLite::Statement query(*database_, selection() + " FROM runs WHERE key = ?");
        query.bind(1, key_of({.parameters = parameters, .threads = threads}, dem::physics_version));
        if (!query.executeStep()) {
            return std::nullopt;
        }
        dem::RunResult run = run_of(query, file_).run;
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
    return explained(file_, [&] {
        const bool added = insert(*database_, run, version);
        demand_present();
        return added;
    });
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
        // A tenth in friction counts as much as a factor of e in the others: chosen.
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

void RunStore::query(const std::string& columns, const std::string& condition,
                     const std::function<void(SQLite::Statement&)>& take) const {
    const std::lock_guard lock(mutex_);
    explained(file_, [&] {
        // The bracket closes on the next line, so that a comment in the condition does not extend
        // to it.
        const std::string where = condition.empty() ? "" : " WHERE (" + condition + "\n)";
        const std::string command = columns + " FROM runs" + where + " ORDER BY id";
        const SizeLimit limit(*database_, most_in_condition);
        std::optional<StepLimit> steps;
        if (!condition.empty()) steps.emplace(*database_);
        try {
            refuse_more_commands(*database_, command, condition);
            SQLite::Statement query(*database_, command);
            while (query.executeStep()) {
                take(query);
            }
        } catch (const SQLite::Exception& error) {
            refuse_condition(file_, condition, error);
            throw;
        }
    });
}

std::vector<StoredRun> RunStore::select(const std::string& condition) const {
    std::vector<StoredRun> runs;
    query(selection(), condition,
          [&](SQLite::Statement& row) { runs.push_back(run_of(row, file_)); });
    return runs;
}

std::vector<std::int64_t> RunStore::numbers(const std::string& condition) const {
    std::vector<std::int64_t> result;
    query("SELECT id", condition,
          [&](SQLite::Statement& row) { result.push_back(row.getColumn(0).getInt64()); });
    return result;
}

StoredRun RunStore::get(std::int64_t id) const {
    const std::lock_guard lock(mutex_);
    return explained(file_, [&] {
        SQLite::Statement query(*database_,
                                selection() + ", trace, final_state FROM runs WHERE id = ?");
        query.bind(1, id);
        if (!query.executeStep()) {
            throw InputError(
                fmt::format("store {} has no run {}; 'pendular runs list' lists the stored runs",
                            file_.string(), id));
        }
        StoredRun stored = run_of(query, file_);
        const int at = 2 + static_cast<int>(run_columns().size());
        const auto expand = [&](int column, auto& into) {
            if (!query.getColumn(column).isBlob()) return;
            try {
                if (dem::restore(expanded(blob_of(query.getColumn(column))), into)) return;
            } catch (const std::runtime_error&) {  // the run is corrupt
            }
            refuse_run(file_, id, "its trace or final state cannot be read");
        };
        expand(at, stored.run.trace);
        expand(at + 1, stored.run.final_state);
        if (!can_be_state(stored.run.final_state)) {
            refuse_run(file_, id, "its final state does not belong to such a run");
        }
        return stored;
    });
}

std::size_t RunStore::remove(const std::vector<std::int64_t>& ids) {
    const std::lock_guard lock(mutex_);
    if (sqlite3_db_readonly(database_->getHandle(), "main") == 1) {
        throw InputError(
            fmt::format("store {} cannot be written, so that no run can be removed; "
                        "change the permissions of the file or of its folder",
                        file_.string()));
    }
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
