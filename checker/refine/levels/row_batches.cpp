#include "checker/refine/levels/row_batches.hpp"

namespace robochart::refine {

void RowBatches::exchange(Exchange& with) {
    for (unsigned rank = 0; rank < out_.size(); ++rank) {
        Words& message = out_[rank];
        if (message.empty() && by_tau_[rank].empty()) continue;
        if (message.empty()) message.push_back(0);
        message[0] = static_cast<lts::Word>((message.size() - 1) / width_);
        message.insert(message.end(), by_tau_[rank].begin(), by_tau_[rank].end());
        by_tau_[rank].clear();
    }
    with.all_to_all(out_, in_);
    for (Words& message : out_) message.clear();
    rows_ += waiting_;
    waiting_ = 0;
    largest_ = 0;
}

std::uint64_t RowBatches::bytes() const {
    std::uint64_t words = 0;
    for (const auto* lists : {&by_tau_, &out_, &in_})
        for (const Words& each : *lists) words += each.capacity();
    return words * sizeof(lts::Word);
}

}  // namespace robochart::refine
