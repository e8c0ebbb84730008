#include "sim/runs/mpi_ensemble.h"

#include <mpi.h>

#include <algorithm>
#include <cereal/types/string.hpp>
#include <cereal/types/variant.hpp>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>

#include "sim/dem/archive.h"
#include "sim/runs/run_checkpoints.h"
#include "sim/runs/store/run_columns.h"
#include "sim/runs/store/run_store.h"

namespace pendular {
namespace {

enum Tag { job = 1, result = 2, no_more = 3 };

/// Message between processes: the cells of a run's columns with its trace and final state.
struct Message {
    std::vector<RunCell> cells;
    dem::Trace trace;
    dem::StoredSample final_state;

    template <typename Archive>
    void serialize(Archive& archive) {
        archive(cells, trace, final_state);
    }
};

std::string packed(const dem::RunResult& run) {
    Message message{{}, run.trace, run.final_state};
    for (const RunColumn& column : run_columns()) {
        message.cells.push_back(column.get(run));
    }
    return dem::archived(message);
}

dem::RunResult unpacked(const std::string& bytes) {
    Message message;
    if (!dem::restore(bytes, message) || message.cells.size() != run_columns().size()) {
        throw std::runtime_error("another version of pendular runs on one of the machines");
    }
    dem::RunResult run;
    for (std::size_t k = 0; k < message.cells.size(); ++k) {
        if (!std::holds_alternative<std::monostate>(message.cells[k])) {
            run_columns()[k].set(run, message.cells[k]);
        }
    }
    run.trace = std::move(message.trace);
    run.final_state = std::move(message.final_state);
    return run;
}

void send(int to, Tag tag, const std::string& bytes) {
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
}

struct Received {
    int from = 0, tag = 0;
    std::string bytes;
};

/// Waits for a message and returns it. Unlike MPI_Recv, the wait does not keep a core busy.
/// @throws dem::Interrupted when a stop is requested
Received receive(const std::stop_token& stop) {
    for (;;) {
        int there = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
        if (there) {
            int size = 0;
            MPI_Get_count(&status, MPI_CHAR, &size);
            Received message{status.MPI_SOURCE, status.MPI_TAG,
                             std::string(static_cast<std::size_t>(size), '\0')};
            MPI_Recv(message.bytes.data(), size, MPI_CHAR, message.from, message.tag,
                     MPI_COMM_WORLD, MPI_STATUS_IGNORE);
            return message;
        }
        if (stop.stop_requested()) {
            throw dem::Interrupted();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

}  // namespace

bool MpiProcesses::there() {
    return std::ranges::any_of(
        std::to_array({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK", "MPI_LOCALNRANKS"}),
        [](const char* name) { return std::getenv(name) != nullptr; });
}

MpiProcesses::MpiProcesses() {
    MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

MpiProcesses::~MpiProcesses() {
    MPI_Finalize();
}

void MpiProcesses::abort(int exit_code) const {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
}

void MpiProcesses::manage(const std::vector<dem::RunParameters>& runs,
                          const Workers& workers) const {
    const auto order = longest_first(runs);
    double total = 0, done = 0;
    for (const auto& run : runs) {
        total += expected_cost(run);
    }
    const auto started = std::chrono::steady_clock::now();
    std::size_t next = 0, busy = 0, finished = 0;
    const auto hand_on = [&](int worker) {
        if (next < runs.size()) {
            send(worker, Tag::job, packed({.parameters = runs[order[next++]]}));
            ++busy;
        } else {
            send(worker, Tag::no_more, "");
        }
    };
    for (int worker = 1; worker < size_; ++worker) {
        hand_on(worker);
    }
    while (busy > 0) {
        const Received message = receive(workers.stop);
        const dem::RunResult run = unpacked(message.bytes);
        workers.store->add(run);
        --busy, ++finished;
        done += expected_cost(run.parameters);
        hand_on(message.from);
        if (workers.report) {
            const double spent =
                std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
            workers.report({.runs_done = finished,
                            .runs = runs.size(),
                            .fraction = done / total,
                            .seconds_left = spent * (total / done - 1)});
        }
    }
}

void MpiProcesses::work(const std::stop_token& stop, const std::filesystem::path& store) const {
    const RunCheckpoints checkpoints(store);
    for (;;) {
        const Received message = receive(stop);
        if (message.tag == Tag::no_more) {
            return;
        }
        const dem::RunParameters parameters = unpacked(message.bytes).parameters;
        checkpoints.simulated(parameters, {.stop = stop}, [&](const dem::RunResult& run) {
            send(message.from, Tag::result, packed(run));
        });
    }
}

}  // namespace pendular
