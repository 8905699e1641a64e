// Everything is brought, all wait, everything is read, all wait again: nobody brings the next thing before all have
// read.
#include "checker/refine/levels/thread_exchange.hpp"

#include <exception>
#include <functional>
#include <thread>

#include "checker/refine/levels/shared_work.hpp"

namespace robochart::refine {

class Meeting::Member final : public Exchange {
public:
    Member(Meeting& meeting, unsigned rank) : meeting_(meeting), rank_(rank) {}
    [[nodiscard]] unsigned rank() const override { return rank_; }
    [[nodiscard]] unsigned ranks() const override { return meeting_.ranks_; }
    [[nodiscard]] unsigned ranks_here() const override { return meeting_.ranks_; }

    void all_to_all(const Messages& out, Messages& in) override {
        count(out);
        meeting_.out_[rank_] = &out;
        meeting_.wait();
        read([&] {
            std::size_t size = 0;
            for (unsigned from = 0; from < ranks(); ++from) {
                in.begins[from] = size;
                in.sizes[from] = meeting_.out_[from]->sizes[rank_];
                size += in.sizes[from];
            }
            in.words.clear();
            in.words.reserve(size);
            for (const Messages* const each : meeting_.out_) {
                const lts::StateView message = each->of(rank_);
                in.words.insert(in.words.end(), message.begin(), message.end());
            }
        });
    }
    void sum(std::span<std::uint64_t> values) override {
        meeting_.sums_[rank_].assign(values.begin(), values.end());
        meeting_.wait();
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = 0;
            for (const std::vector<std::uint64_t>& each : meeting_.sums_) values[i] += each[i];
        }
        meeting_.wait();
    }
    [[nodiscard]] std::vector<Words> gather(const Words& own) override {
        meeting_.words_[rank_] = &own;
        meeting_.wait();
        std::vector<Words> all;
        read([&] {
            for (const Words* const each : meeting_.words_) all.push_back(*each);
        });
        return all;
    }
    void broadcast(std::string& bytes) override {
        meeting_.texts_[rank_] = &bytes;
        meeting_.wait();
        std::string first;
        read([&] { first = *meeting_.texts_[0]; });
        bytes = std::move(first);
    }

private:
    /// Then all wait, also where memory for what is read is not there: others may still read what this one has brought.
    void read(const std::function<void()>& part) {
        try {
            part();
        } catch (...) {
            meeting_.wait();
            throw;
        }
        meeting_.wait();
    }

    Meeting& meeting_;
    unsigned rank_;
};

std::unique_ptr<Exchange> Meeting::exchange(unsigned rank) {
    return std::make_unique<Member>(*this, rank);
}

void Meeting::wait() {
    std::unique_lock lock(mutex_);
    const std::uint64_t turn = turn_;
    if (++here_ == ranks_) {
        here_ = 0;
        ++turn_;
        all_here_.notify_all();
    } else {
        all_here_.wait(lock, [&] { return turn_ != turn || left_; });
    }
    if (left_ && turn_ == turn) throw RankLost("another rank has ended");
}

void Meeting::leave() {
    const std::scoped_lock lock(mutex_);
    left_ = true;
    all_here_.notify_all();
}

void as_ranks(unsigned ranks, const std::function<void(Exchange&)>& work) {
    Meeting meeting(ranks);
    std::vector<std::exception_ptr> errors(ranks), heard(ranks), losses(ranks);
    const auto be = [&](unsigned rank) {
        try {
            work(*meeting.exchange(rank));
        } catch (const RankLost&) {
            losses[rank] = std::current_exception();
        } catch (const RankFailed&) {
            heard[rank] = std::current_exception();
        } catch (...) {
            errors[rank] = std::current_exception();
        }
        if (errors[rank] || heard[rank] || losses[rank]) meeting.leave();
    };
    std::vector<std::thread> others;
    try {
        others.reserve(ranks);
        for (unsigned rank = 1; rank < ranks; ++rank) others.emplace_back(be, rank);
        be(0);
    } catch (...) {
        // A thread cannot be started; the others lose it.
        errors[0] = std::current_exception();
        meeting.leave();
    }
    for (std::thread& each : others) each.join();
    for (const auto* const kind : {&errors, &heard, &losses})
        for (const std::exception_ptr& error : *kind)
            if (error) std::rethrow_exception(error);
}

}  // namespace robochart::refine
