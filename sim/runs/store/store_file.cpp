#include "sim/runs/store/store_file.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string>
#include <vector>

#include "data/input_error.h"
#include "sim/runs/store/run_columns.h"

namespace pendular {
namespace {

/// Application id "pend" in the header of an SQLite file, which marks it as a store.
constexpr int application_id = 0x70656e64;
constexpr int patience_ms = 120'000;  ///< longest wait for other processes to finish writing [ms]

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

/// Whether a database has neither tables nor the marks of a program.
bool is_empty(SQLite::Database& database) {
    return pragma(database, "application_id") == 0 && pragma(database, "user_version") == 0 &&
           database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
}

/// Refuses a database that is neither empty nor a store that this version can read.
void check_format(SQLite::Database& database, const std::string& name) {
    const int version = pragma(database, "user_version");
    if (!is_empty(database) && pragma(database, "application_id") != application_id) {
        throw InputError(
            fmt::format("{} is a database of another program; name another file", name));
    }
    if (version > store_format) {
        throw InputError(fmt::format(
            "{} was written by a newer version of pendular (format {}, this one knows {}); update "
            "pendular or name another file",
            name, version, store_format));
    }
}

/// Creates the table of runs, or adds the columns that the file lacks. Another process may be doing
/// the same, so that the file is inspected only after this process has locked it for writing.
void make_table(SQLite::Database& database, const std::string& name) {
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    check_format(database, name);
    database.exec(
        "CREATE TABLE IF NOT EXISTS runs (id INTEGER PRIMARY KEY AUTOINCREMENT, key TEXT NOT NULL "
        "UNIQUE, physics_version INTEGER NOT NULL, added TEXT NOT NULL DEFAULT CURRENT_TIMESTAMP, "
        "trace BLOB, final_state BLOB)");
    for (const RunColumn* column : missing_columns(database)) {
        database.exec(
            fmt::format("ALTER TABLE runs ADD COLUMN {} {}", column->name, sql_type(column->type)));
    }
    database.exec(fmt::format("PRAGMA application_id = {}", application_id));
    database.exec(fmt::format("PRAGMA user_version = {}", store_format));
    transaction.commit();
}

/// Lets a file of an older format that cannot be written be read as if it had all columns: a
/// temporary view, which SQLite keeps outside of the file, takes the place of the table of runs.
void show_missing_columns(SQLite::Database& database, const std::string& name) {
    check_format(database, name);
    if (is_empty(database)) {
        throw InputError(fmt::format("{} is empty and cannot be written; name another file", name));
    }
    if (!database.tableExists("runs")) {
        throw InputError(fmt::format("{} is no store of runs; name another file", name));
    }
    std::string columns = "*";
    for (const RunColumn* column : missing_columns(database)) {
        columns += fmt::format(", CAST(NULL AS {}) AS {}", sql_type(column->type), column->name);
    }
    database.exec("CREATE TEMP VIEW runs AS SELECT " + columns + " FROM main.runs");
}

/// Authorizer callback of SQLite that denies recursive queries, which may never end and which no
/// condition on runs needs.
int allow_no_recursion(void*, int action, const char*, const char*, const char*, const char*) {
    return action == SQLITE_RECURSIVE ? SQLITE_DENY : SQLITE_OK;
}

/// Sets up a connection for a file that somebody else may have made: no code in its schema is run,
/// neither views nor triggers nor functions.
void distrust(SQLite::Database& database) {
    sqlite3* const handle = database.getHandle();
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    // SQLite takes an unknown name in double quotes for a text, so that NOT "no_such_column"
    // selects every run.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DQS_DDL, 0, nullptr);
    sqlite3_set_authorizer(handle, allow_no_recursion, nullptr);
}

/// Whether a store can be written. SQLite must be able to write the file and, for the files that it
/// puts beside it, the folder.
bool can_be_written(const std::filesystem::path& file) {
    return access(file.c_str(), W_OK) == 0 && access(file.parent_path().c_str(), W_OK) == 0;
}

/// URI with which SQLite opens a file for reading only. If no process has the file open, it is
/// opened as immutable, since SQLite could not create the files that coordinate readers and
/// writers.
std::string read_only_uri(const std::filesystem::path& file) {
    std::string name;
    for (const unsigned char c : file.string()) {
        name += std::isalnum(c) || c == '/' || c == '.' || c == '-' || c == '_'
                    ? std::string(1, static_cast<char>(c))
                    : fmt::format("%{:02x}", c);
    }
    std::error_code error;
    const bool open = std::filesystem::exists(file.string() + "-wal", error);
    return fmt::format("file:{}?{}", name, open ? "mode=ro" : "immutable=1");
}

}  // namespace

void explain(const std::filesystem::path& file, const SQLite::Exception& error) {
    const std::string name = fmt::format("store {}", file.string());
    switch (error.getErrorCode()) {
        case SQLITE_NOTADB:
            throw InputError(fmt::format("{} is no store of runs; name another file", name));
        case SQLITE_CORRUPT:
            throw InputError(
                fmt::format("{} is corrupt ({}); 'sqlite3 FILE .recover' may save its runs, or "
                            "name another file",
                            name, error.what()));
        case SQLITE_TOOBIG:
        case SQLITE_AUTH:
            throw InputError(fmt::format("{}: {}: that is more than the runs of a store need", name,
                                         error.what()));
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

std::array<std::uint64_t, 2> identity_of(const std::filesystem::path& file) {
    struct stat status = {};
    if (stat(file.c_str(), &status) != 0) return {0, 0};
    return {status.st_dev, status.st_ino};
}

std::unique_ptr<SQLite::Database> open_store_file(const std::filesystem::path& file,
                                                  bool must_exist) {
    std::error_code error;
    if (must_exist && !std::filesystem::exists(file, error)) {
        throw InputError(
            fmt::format("store {}: no such file; 'pendular simulate', 'calibrate' and "
                        "'campaign' make a store, --store FILE names another",
                        file.string()));
    }
    if (std::filesystem::is_directory(file, error)) {
        throw InputError(fmt::format("store {} is a folder; name a file", file.string()));
    }
    if (file != store_in_memory && !must_exist) {
        std::filesystem::create_directories(file.parent_path(), error);
    }
    const bool writable = file == store_in_memory || !must_exist || can_be_written(file);
    auto database =
        writable ? std::make_unique<SQLite::Database>(
                       file.string(),
                       SQLite::OPEN_READWRITE | (must_exist ? 0 : SQLite::OPEN_CREATE), patience_ms)
                 : std::make_unique<SQLite::Database>(read_only_uri(file),
                                                      SQLite::OPEN_READONLY | SQLite::OPEN_URI);
    distrust(*database);
    const bool made = pragma(*database, "application_id") == application_id &&
                      pragma(*database, "user_version") == store_format &&
                      missing_columns(*database).empty();
    const std::string name = fmt::format("store {}", file.string());
    if (!made && writable) make_table(*database, name);
    if (!made && !writable) show_missing_columns(*database, name);
    if (writable) {
        // Readers and one writer can work at the same time; a commit is on the disk before it is
        // reported.
        database->exec("PRAGMA journal_mode = WAL");
        database->exec("PRAGMA synchronous = FULL");
    }
    return database;
}

namespace {

constexpr std::size_t most_expansion = 100;  ///< states of grains compress to about half

Bytef* as_bytes(const char* text) {
    return reinterpret_cast<Bytef*>(const_cast<char*>(text));  // zlib does not write to its input
}

[[noreturn]] void refuse_corrupt() {
    throw std::runtime_error("compressed bytes are corrupt");
}

}  // namespace

std::string compressed(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    if (compress(as_bytes(result.data()), &size, as_bytes(bytes.data()), bytes.size()) != Z_OK) {
        throw std::runtime_error("bytes cannot be compressed");  // memory is exhausted
    }
    result.resize(size);
    return result;
}

std::string expanded(const std::string& bytes) {
    const std::size_t most = most_expansion * bytes.size() + 65536;
    z_stream stream{};
    stream.next_in = as_bytes(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    if (inflateInit(&stream) != Z_OK) refuse_corrupt();
    const struct Ended {
        z_stream* stream;
        ~Ended() { inflateEnd(stream); }
    } ended{&stream};
    std::string result;
    std::array<char, 65536> part{};
    for (int state = Z_OK; state != Z_STREAM_END;) {
        stream.next_out = as_bytes(part.data());
        stream.avail_out = static_cast<uInt>(part.size());
        state = inflate(&stream, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END) refuse_corrupt();
        result.append(part.data(), part.size() - stream.avail_out);
        if (result.size() > most) {
            throw std::runtime_error("compressed bytes expand to more than a state can have");
        }
    }
    return result;
}

}  // namespace pendular
