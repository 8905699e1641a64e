// SPDX-License-Identifier: Apache-2.0
// Implements the exchange between threads by barriers. All threads publish their data, wait at a barrier, read the
// others' data, and wait again, so that no thread publishes new data before all have read the old ones. The first
// thread communicates with other programs between the two barriers.
#include "checker/refine/levels/thread_exchange.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "base/threads/threads.hpp"
#include "checker/refine/levels/shared_work.hpp"

namespace robochart::refine {
namespace {

/// The barrier of a program's threads. Each thread has its own exchange, which this object must outlive.
class Meeting {
public:
    Meeting(Exchange& programs, unsigned threads)
        : programs_(programs),
          threads_(threads),
          out_(threads),
          words_(threads),
          sums_(threads),
          to_programs_(programs.ranks()),
          from_programs_(programs.ranks()) {}
    /// Returns the exchange of a thread; threads are counted from 0.
    [[nodiscard]] std::unique_ptr<Exchange> exchange(unsigned thread);
    /// Makes all other threads that wait now or later throw RankLost.
    void leave_meeting();

private:
    class Member;
    void wait_for_all(bool able = true);
    template <class Part>
    void meet_and_run(const Part& part);
    void exchange_rows();
    void exchange_sums();
    void exchange_words();

    Exchange& programs_;
    const unsigned threads_;
    std::mutex mutex_;
    std::condition_variable all_here_;
    unsigned here_ = 0;
    std::uint64_t turn_ = 0;
    bool left_ = false;    // a thread has left
    bool unable_ = false;  // a thread has failed
    // The data published by each thread. The owner writes them between barriers while no one reads them.
    std::vector<const Messages*> out_;
    std::vector<const Words*> words_;
    std::vector<std::vector<std::uint64_t>> sums_;
    // Written by thread 0 between barriers; read by all threads. A message to another program first contains the number
    // of words from each thread of this program to each thread of the other program. Then it contains these words in
    // the same order.
    Messages to_programs_, from_programs_;
    std::vector<std::uint64_t> sum_;
    std::vector<Words> all_words_;
    std::string text_;
};

class Meeting::Member final : public Exchange {
public:
    Member(Meeting& meeting, unsigned thread) : meeting_(meeting), thread_(thread) {}
    [[nodiscard]] unsigned rank() const override { return first_rank(meeting_.programs_.rank()) + thread_; }
    [[nodiscard]] unsigned ranks() const override { return first_rank(meeting_.programs_.ranks()); }
    [[nodiscard]] unsigned ranks_here() const override { return meeting_.threads_; }

    void all_to_all(const Messages& out, Messages& in) override {
        count_messages(out);
        meeting_.out_[thread_] = &out;
        meeting_.meet_and_run([&] {
            if (thread_ == 0) meeting_.exchange_rows();
            read_those_of_threads(in);
        });
        read_those_of_programs(in);
    }
    void sum(std::span<std::uint64_t> values) override {
        meeting_.sums_[thread_].assign(values.begin(), values.end());
        meeting_.meet_and_run([&] {
            if (thread_ == 0) meeting_.exchange_sums();
        });
        assert(meeting_.sum_.size() == values.size());
        std::ranges::copy(meeting_.sum_, values.begin());
    }
    [[nodiscard]] std::vector<Words> gather(const Words& own) override {
        meeting_.words_[thread_] = &own;
        meeting_.meet_and_run([&] {
            if (thread_ == 0) meeting_.exchange_words();
        });
        return meeting_.all_words_;
    }
    void broadcast(std::string& bytes) override {
        meeting_.meet_and_run([&] {
            if (thread_ != 0) return;
            meeting_.text_ = bytes;
            meeting_.programs_.broadcast(meeting_.text_);
        });
        bytes = meeting_.text_;
    }
    [[nodiscard]] std::uint64_t bytes() const override {
        if (thread_ != 0) return 0;
        return (meeting_.to_programs_.words.capacity() + meeting_.from_programs_.words.capacity()) * sizeof(lts::Word);
    }

private:
    [[nodiscard]] unsigned first_rank(unsigned program) const { return program * meeting_.threads_; }

    void read_those_of_threads(Messages& in) const {
        std::size_t size = 0;
        for (const Messages* const messages : meeting_.out_) size += messages->sizes[rank()];
        in.words.clear();
        in.words.reserve(size);
        unsigned from = first_rank(meeting_.programs_.rank());
        for (const Messages* const messages : meeting_.out_) append(messages->message_of(rank()), in, from++);
    }
    void read_those_of_programs(Messages& in) const {
        const Messages& came = meeting_.from_programs_;
        const std::size_t threads = meeting_.threads_;
        // Each thread receives approximately the same number of words.
        in.words.reserve(in.words.size() + came.words.size() / threads);
        for (unsigned program = 0; program < came.sizes.size(); ++program) {
            if (program == meeting_.programs_.rank()) continue;
            unsigned from = first_rank(program);
            if (came.sizes[program] == 0) {
                for (unsigned thread = 0; thread < threads; ++thread) append({}, in, from++);
                continue;
            }
            const lts::StateView message = came.message_of(program);
            const lts::StateView sizes = message.first(threads * threads);
            const auto mine = sizes.begin() + static_cast<std::ptrdiff_t>(thread_ * threads);
            std::size_t at = std::accumulate(sizes.begin(), mine, sizes.size());
            for (const lts::Word size : sizes.subspan(thread_ * threads, threads)) {
                assert(at + size <= message.size());
                append(message.subspan(at, size), in, from++);
                at += size;
            }
        }
    }
    static void append(lts::StateView message, Messages& in, unsigned from) {
        in.begins[from] = in.words.size();
        in.sizes[from] = message.size();
        in.words.insert(in.words.end(), message.begin(), message.end());
    }

    Meeting& meeting_;
    unsigned thread_;
};

std::unique_ptr<Exchange> Meeting::exchange(unsigned thread) {
    return std::make_unique<Member>(*this, thread);
}

/// Waits at the barrier. `able`: whether this thread can continue afterwards. If a thread cannot, all others throw
/// RankLost.
void Meeting::wait_for_all(bool able) {
    std::unique_lock lock(mutex_);
    if (!able) unable_ = true;
    const std::uint64_t turn = turn_;
    assert(here_ < threads_);
    if (++here_ == threads_) {
        here_ = 0;
        ++turn_;
        all_here_.notify_all();
    } else {
        all_here_.wait(lock, [&] { return turn_ != turn || left_; });
    }
    const bool all_came = turn_ != turn;
    if (able && (unable_ || !all_came)) throw RankLost("another rank has ended");
}

/// Executes a part between two barriers. All threads wait before and after the part, even if one has failed, because
/// others may still read its data.
template <class Part>
void Meeting::meet_and_run(const Part& part) {
    wait_for_all();
    try {
        part();
    } catch (...) {
        wait_for_all(false);
        throw;
    }
    wait_for_all();
}

void Meeting::leave_meeting() {
    const std::scoped_lock lock(mutex_);
    left_ = true;
    all_here_.notify_all();
}

/// Collects and sends the data for the other programs, and receives their data.
void Meeting::exchange_rows() {
    const unsigned programs = programs_.ranks();
    if (programs == 1) return;
    const auto is_other = [&](std::size_t rank) { return rank / threads_ != programs_.rank(); };
    std::size_t size = std::size_t{programs} * threads_ * threads_;
    for (const Messages* const messages : out_)
        for (std::size_t rank = 0; rank < messages->sizes.size(); ++rank)
            if (is_other(rank)) size += messages->sizes[rank];
    Words& words = to_programs_.words;
    words.clear();
    words.reserve(size);
    for (unsigned program = 0; program < programs; ++program) {
        const std::size_t begin = words.size();
        if (program != programs_.rank()) {
            const unsigned first = program * threads_;
            for (unsigned to = first; to < first + threads_; ++to)
                for (const Messages* const messages : out_)
                    words.push_back(static_cast<lts::Word>(messages->sizes[to]));
            const std::size_t head = words.size();
            for (unsigned to = first; to < first + threads_; ++to)
                for (const Messages* const messages : out_)
                    words.insert(words.end(), messages->message_of(to).begin(), messages->message_of(to).end());
            if (words.size() == head) words.resize(begin);
        }
        to_programs_.begins[program] = begin;
        to_programs_.sizes[program] = words.size() - begin;
    }
    programs_.all_to_all(to_programs_, from_programs_);
}

void Meeting::exchange_sums() {
    sum_.assign(sums_.front().size(), 0);
    for (const std::vector<std::uint64_t>& of_thread : sums_)
        std::ranges::transform(sum_, of_thread, sum_.begin(), std::plus());
    assert(std::ranges::all_of(sums_, [this](const auto& own) { return own.size() == sum_.size(); }));
    programs_.sum(sum_);
}

/// A message contains, for each program, the number of words from each thread, and then these words.
void Meeting::exchange_words() {
    Words own;
    for (const Words* const of_thread : words_) own.push_back(static_cast<lts::Word>(of_thread->size()));
    for (const Words* const of_thread : words_) own.insert(own.end(), of_thread->begin(), of_thread->end());
    all_words_.clear();
    for (const Words& of_program : programs_.gather(own)) {
        assert(of_program.size() >= threads_);
        auto at = of_program.begin() + threads_;
        for (unsigned thread = 0; thread < threads_; ++thread) {
            const auto end = at + of_program[thread];
            all_words_.emplace_back(at, end);
            at = end;
        }
    }
}

/// Manages the threads of a program from their start to their end.
class Team {
public:
    Team(Exchange& programs, unsigned threads, const std::function<void(Exchange&)>& work)
        : programs_(programs),
          meeting_(programs, threads),
          work_(work),
          errors_(threads),
          heard_(threads),
          lost_(threads) {
        for (unsigned thread = 0; thread < threads; ++thread) exchanges_.push_back(meeting_.exchange(thread));
    }
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    ~Team() = default;

    /// Starts all threads except the caller's.
    void start() {
        try {
            others_.emplace(
                static_cast<unsigned>(exchanges_.size()), [this](unsigned thread) { run_as_rank(thread); },
                [this] { meeting_.leave_meeting(); });
        } catch (const diagnostics::LimitReached& limit) {
            if (programs_.ranks() == 1) throw;
            throw diagnostics::LimitReached(fmt::format("program {}: {}", programs_.rank(), limit.what()));
        }
    }
    /// Executes the part of the caller's thread, and then waits until all other threads have ended.
    void finish_all() {
        run_as_rank(0);
        others_->join();
        if (std::ranges::all_of(exchanges_, [](const auto& exchange) { return exchange->left_together(); }))
            programs_.leave_together();
        for (const auto* const kind : {&errors_, &heard_, &lost_})
            for (const std::exception_ptr& error : *kind)
                if (error) std::rethrow_exception(error);
    }

private:
    void run_as_rank(std::size_t thread) {
        try {
            return work_(*exchanges_[thread]);
        } catch (const RankLost&) {
            lost_[thread] = std::current_exception();
        } catch (const RankFailed&) {
            heard_[thread] = std::current_exception();
        } catch (...) {
            errors_[thread] = std::current_exception();
        }
        meeting_.leave_meeting();
    }

    Exchange& programs_;
    Meeting meeting_;
    const std::function<void(Exchange&)>& work_;
    std::vector<std::unique_ptr<Exchange>> exchanges_;
    std::vector<std::exception_ptr> errors_, heard_, lost_;  // exceptions by thread
    std::optional<diagnostics::Threads> others_;
};

}  // namespace

void as_ranks(Exchange& programs, unsigned threads, const std::function<void(Exchange&)>& work) {
    if (threads == 1) return work(programs);
    std::optional<Team> team;
    run_together(programs, [&] { team.emplace(programs, threads, work).start(); });
    team->finish_all();
}

void as_ranks(unsigned ranks, const std::function<void(Exchange&)>& work) {
    LoneExchange alone;
    as_ranks(alone, ranks, work);
}

}  // namespace robochart::refine
