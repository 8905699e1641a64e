// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/levels/row_batches.hpp"

#include <cassert>

namespace robochart::refine {

RowBatches::RowBatches(unsigned ranks, std::size_t width)
    : width_(width), space_(1 + 16 * width), messages_(ranks), out_(ranks), in_(ranks) {
    out_.words.resize(ranks * space_);
}

/// Makes the space for each message a quarter larger.
void RowBatches::make_space() {
    const std::size_t larger = space_ + std::max(space_ / 4, width_);
    Words words(messages_.size() * larger);
    for (unsigned rank = 0; rank < messages_.size(); ++rank) {
        const Message& message = messages_[rank];
        const auto from = out_.words.begin() + static_cast<std::ptrdiff_t>(begin_of(rank));
        const auto end = from + static_cast<std::ptrdiff_t>(space_);
        const auto to = words.begin() + static_cast<std::ptrdiff_t>(rank * larger);
        std::copy_n(from, message.front, to);
        std::copy_backward(end - static_cast<std::ptrdiff_t>(message.back), end,
                           to + static_cast<std::ptrdiff_t>(larger));
    }
    out_.words = std::move(words);
    space_ = larger;
}

void RowBatches::exchange(Exchange& with) {
    assert(out_.words.size() == messages_.size() * space_);
    for (unsigned rank = 0; rank < messages_.size(); ++rank) {
        Message& message = messages_[rank];
        const std::size_t begin = begin_of(rank);
        const auto first = out_.words.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto end = first + static_cast<std::ptrdiff_t>(space_);
        assert(message.front + message.back <= space_ && message.back % width_ == 0);
        *first = static_cast<lts::Word>((message.front - 1) / width_);
        std::copy(end - static_cast<std::ptrdiff_t>(message.back), end,
                  first + static_cast<std::ptrdiff_t>(message.front));
        const std::size_t size = message.front + message.back;
        out_.begins[rank] = begin;
        out_.sizes[rank] = size > 1 ? size : 0;
        message = {};
    }
    with.all_to_all(out_, in_);
    rows_ += waiting_;
    waiting_ = 0;
    largest_ = 0;
}

}  // namespace robochart::refine
