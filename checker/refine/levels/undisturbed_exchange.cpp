// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/undisturbed_exchange.hpp"

namespace robochart::refine {

class UndisturbedExchange::Wait {
public:
    explicit Wait(UndisturbedExchange& exchange) : exchange_(exchange) {
        if (!exchange_.held_) exchange_.held_ = exchange_.undisturbed_();
    }
    Wait(const Wait&) = delete;
    Wait& operator=(const Wait&) = delete;
    ~Wait() {
        if (!exchange_.over_()) exchange_.held_.reset();
    }

private:
    UndisturbedExchange& exchange_;
};

void UndisturbedExchange::all_to_all(const Messages& out, Messages& in) {
    const Wait wait(*this);
    real_.all_to_all(out, in);
}

void UndisturbedExchange::sum(std::span<std::uint64_t> values) {
    const Wait wait(*this);
    real_.sum(values);
}

std::vector<Words> UndisturbedExchange::gather(const Words& own) {
    const Wait wait(*this);
    return real_.gather(own);
}

void UndisturbedExchange::broadcast(std::string& bytes) {
    const Wait wait(*this);
    real_.broadcast(bytes);
}

}  // namespace robochart::refine
