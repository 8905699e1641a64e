// SPDX-License-Identifier: Apache-2.0
#include "app/mpi/mpi_exchange.hpp"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <thread>

namespace robochart::app {

using refine::Messages;
using refine::Words;

namespace {

int as_count(std::size_t words) {
    if (words > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw std::length_error("more than 2^31 words in a message");
    return static_cast<int>(words);
}

/// Computes the offsets of parts that are stored consecutively, and returns their total length.
std::size_t compute_offsets(const std::vector<int>& counts, std::vector<int>& places) {
    std::size_t end = 0;
    places.clear();
    for (const int count : counts) {
        places.push_back(as_count(end));
        end += static_cast<std::size_t>(count);
    }
    return static_cast<std::size_t>(as_count(end));
}

/// Waits until the request is complete. MPI itself would poll without pause. If the wait is longer than a moment, this
/// function sleeps between polls.
void await_request(MPI_Request request) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds moment{2}, pause{1};
    const Clock::time_point start = Clock::now();
    for (int done = 0;;) {
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (done != 0) return;
        if (Clock::now() - start > moment) std::this_thread::sleep_for(pause);
    }
}

}  // namespace

MpiProgram::MpiProgram(int& argc, char**& argv) {
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
}

MpiProgram::~MpiProgram() {
    MPI_Finalize();
}

bool MpiProgram::serves_threads() {
    int provided = MPI_THREAD_SINGLE;
    MPI_Query_thread(&provided);
    return provided >= MPI_THREAD_FUNNELED;
}

void MpiProgram::abort(int code) {
    MPI_Abort(MPI_COMM_WORLD, code);
    std::abort();
}

MpiExchange::MpiExchange() {
    int rank = 0, ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    rank_ = static_cast<unsigned>(rank);
    ranks_ = static_cast<unsigned>(ranks);
    send_counts_.resize(ranks_);
    send_places_.resize(ranks_);
    counts_.resize(ranks_);
}

void MpiExchange::all_to_all(const Messages& out, Messages& in) {
    count_messages(out);
    as_count(out.words.size());
    for (unsigned to = 0; to < ranks_; ++to) {
        send_counts_[to] = as_count(out.sizes[to]);
        send_places_[to] = as_count(out.begins[to]);
    }
    MPI_Alltoall(send_counts_.data(), 1, MPI_INT, counts_.data(), 1, MPI_INT, MPI_COMM_WORLD);
    in.words.resize(compute_offsets(counts_, places_));
    MPI_Alltoallv(out.words.data(), send_counts_.data(), send_places_.data(), MPI_UINT32_T, in.words.data(),
                  counts_.data(), places_.data(), MPI_UINT32_T, MPI_COMM_WORLD);
    in.begins.assign(places_.begin(), places_.end());
    in.sizes.assign(counts_.begin(), counts_.end());
}

void MpiExchange::sum(std::span<std::uint64_t> values) {
    MPI_Allreduce(MPI_IN_PLACE, values.data(), as_count(values.size()), MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
}

std::vector<Words> MpiExchange::gather(const Words& own) {
    const int size = as_count(own.size());
    MPI_Allgather(&size, 1, MPI_INT, counts_.data(), 1, MPI_INT, MPI_COMM_WORLD);
    received_.resize(compute_offsets(counts_, places_));
    MPI_Allgatherv(own.data(), size, MPI_UINT32_T, received_.data(), counts_.data(), places_.data(), MPI_UINT32_T,
                   MPI_COMM_WORLD);
    std::vector<Words> all(ranks_);
    for (unsigned from = 0; from < ranks_; ++from)
        all[from].assign(received_.begin() + places_[from], received_.begin() + places_[from] + counts_[from]);
    return all;
}

void MpiExchange::broadcast(std::string& bytes) {
    std::uint64_t size = bytes.size();
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD, &request);
    await_request(request);
    bytes.resize(size);
    constexpr std::size_t most = std::size_t{1} << 30U;
    for (std::size_t first = 0; first < bytes.size(); first += most)
        MPI_Bcast(bytes.data() + first, as_count(std::min(most, bytes.size() - first)), MPI_BYTE, 0, MPI_COMM_WORLD);
}

}  // namespace robochart::app
