// A valid store with one bad cell: the first byte says which, the second its type and how the run
// is read, the rest is the value.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <cstring>
#include <map>

#include "sim/dem/archive.h"
#include "sim/runs/store/run_columns.h"
#include "sim/runs/store/run_store.h"
#include "sim/runs/store/store_file.h"
#include "tests/fuzz/support.h"

using namespace pendular;

namespace {

const std::filesystem::path& store_file() {
    static const std::filesystem::path file = [] {
        const auto path = fuzz::folder() / "store.sqlite";
        dem::RunResult run;
        run.parameters.friction = 0.1;
        run.trace.resize(3);
        run.final_state.grains.resize(4);
        RunStore(path).add(run);
        return path;
    }();
    return file;
}

/// Statement that sets a column of the only run.
SQLite::Statement& change_of(const std::string& column) {
    static const SQLite::Database database(store_file().string(), SQLite::OPEN_READWRITE);
    static std::map<std::string, SQLite::Statement> prepared;
    const auto found = prepared.find(column);
    if (found != prepared.end()) return found->second;
    return prepared.try_emplace(column, database, fmt::format("UPDATE runs SET \"{}\" = ?", column))
        .first->second;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 3) return -1;
    const std::size_t count = run_columns().size();
    const std::size_t which = data[0] % (count + 2);
    const std::string name = which < count    ? run_columns()[which].name
                             : which == count ? "trace"
                                              : "final_state";
    std::string value(fuzz::text_of(data + 2, size - 2));
    const bool packed = data[1] % 5 == 4;
    if (packed) value = compressed(value);  // else no input would be valid zlib
    SQLite::Statement& change = change_of(name);
    double number = 0;
    std::memcpy(&number, value.data(), std::min(value.size(), sizeof number));
    std::int64_t whole = 0;
    std::memcpy(&whole, value.data(), std::min(value.size(), sizeof whole));
    switch (data[1] % 5) {
        case 0:
            change.bind(1, whole);
            break;
        case 1:
            change.bind(1, number);
            break;
        case 2:
            change.bind(1, value);
            break;
        default:
            change.bind(1, value.data(), static_cast<int>(value.size()));
    }
    change.exec();
    change.reset();
    static const RunStore store(store_file(), true);
    // One of the two readers for each input: libFuzzer finds inputs for both.
    if (data[1] < 128)
        fuzz::refuse_or([&] { store.select(); });
    else
        fuzz::refuse_or([&] { store.get(1); });
    // What was changed is put back for the next input.
    change.clearBindings();  // NULL
    change.exec();
    change.reset();
    return 0;
}
