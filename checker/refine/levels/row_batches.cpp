#include "checker/refine/levels/row_batches.hpp"

#include <array>

#include "checker/lts/state_store.hpp"

namespace robochart::refine {

void RowBatches::exchange(Exchange& with) {
    for (unsigned rank = 0; rank < out_.size(); ++rank) {
        Words& message = out_[rank];
        message.clear();
        if (by_tau_[rank].empty() && others_[rank].empty()) continue;
        message.push_back(static_cast<lts::Word>(by_tau_[rank].size() / width_));
        for (Words* rows : {&by_tau_[rank], &others_[rank]}) {
            message.insert(message.end(), rows->begin(), rows->end());
            rows->clear();
        }
    }
    largest_ = 0;
    with.all_to_all(out_, in_);
}

void RowBatches::receive(const std::function<void(std::uint64_t)>& prefetch,
                         const std::function<void(lts::StateView, std::uint64_t, bool)>& enter) {
    constexpr std::size_t ahead = 64;
    std::array<std::uint64_t, ahead> hashes{};
    for (const Words& message : in_) {
        if (message.empty()) continue;
        const lts::StateView rows = lts::StateView(message).subspan(1);
        const std::size_t count = rows.size() / width_;
        for (std::size_t first = 0; first < count; first += ahead) {
            const std::size_t end = std::min(count, first + ahead);
            for (std::size_t i = first; i < end; ++i) {
                hashes[i - first] = lts::StateStore::hash(rows.subspan(i * width_, width_));
                prefetch(hashes[i - first]);
            }
            for (std::size_t i = first; i < end; ++i)
                enter(rows.subspan(i * width_, width_), hashes[i - first], i < message[0]);
        }
    }
}

std::uint64_t RowBatches::bytes() const {
    std::uint64_t words = 0;
    for (const auto* lists : {&by_tau_, &others_, &out_, &in_})
        for (const Words& each : *lists) words += each.capacity();
    return words * sizeof(lts::Word);
}

}  // namespace robochart::refine
