// SPDX-License-Identifier: Apache-2.0
// Simulates an error of one rank during a collective operation.
#pragma once

#include <chrono>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <thread>

#include "checker/refine/levels/exchange.hpp"

namespace robochart::ranks {

/// Forwards all calls to another exchange. At the call with the given number, it either throws before the other ranks
/// receive its message, or sleeps for three seconds.
class FaultyExchange final : public refine::Exchange {
public:
    enum class Fault { error, memory, sleep };
    /// `call` is the number of the failing call, from 0.
    FaultyExchange(refine::Exchange& real, std::uint64_t call, Fault fault) : real_(real), left_(call), fault_(fault) {}

    [[nodiscard]] unsigned rank() const override { return real_.rank(); }
    [[nodiscard]] unsigned ranks() const override { return real_.ranks(); }
    void all_to_all(const refine::Messages& out, refine::Messages& in) override {
        call();
        real_.all_to_all(out, in);
    }
    void sum(std::span<std::uint64_t> values) override {
        call();
        real_.sum(values);
    }
    [[nodiscard]] std::vector<refine::Words> gather(const refine::Words& own) override {
        call();
        return real_.gather(own);
    }
    void broadcast(std::string& bytes) override {
        call();
        real_.broadcast(bytes);
    }
    [[nodiscard]] bool has_failed() const { return failed_; }
    /// Returns how many calls remain before the failing one.
    [[nodiscard]] std::uint64_t calls_left() const { return left_; }

private:
    void call() {
        if (left_-- != 0) return;
        if (fault_ == Fault::sleep) return std::this_thread::sleep_for(std::chrono::seconds(3));
        failed_ = true;
        if (fault_ == Fault::memory) throw std::bad_alloc();
        throw std::logic_error("an injected error");
    }

    refine::Exchange& real_;
    std::uint64_t left_;
    Fault fault_;
    bool failed_ = false;
};

}  // namespace robochart::ranks
