// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/packed/packed_system.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "checker/cspm/packed/not_packed.hpp"

namespace robochart::cspm {

namespace {

std::span<const std::uint8_t> bytes_of(lts::StateView state) {
    return {reinterpret_cast<const std::uint8_t*>(state.data()), state.size() * sizeof(lts::Word)};
}

class CallUnderWay {
public:
    explicit CallUnderWay(std::size_t& calls) : calls_(calls) { ++calls_; }
    ~CallUnderWay() { --calls_; }
    CallUnderWay(const CallUnderWay&) = delete;
    CallUnderWay& operator=(const CallUnderWay&) = delete;

private:
    std::size_t& calls_;
};

}  // namespace

PackedSystem::PackedSystem(std::shared_ptr<PackedProcesses> processes, std::size_t side, Span span)
    : processes_(std::move(processes)), side_(side), span_(span) {
    const std::size_t first = processes_->initial(side).size();
    width_ = std::max(width_, (first + sizeof(lts::Word) - 1) / sizeof(lts::Word));
}

void PackedSystem::fill_row(std::span<const std::uint8_t> bytes, std::span<lts::Word> row) {
    const std::size_t words = (bytes.size() + sizeof(lts::Word) - 1) / sizeof(lts::Word);
    if (words > width_) {
        needed_ = words;
        throw RowsTooNarrow{};
    }
    assert(row.size() == width_ && bytes.size() <= row.size_bytes());
    std::ranges::fill(row.subspan(bytes.size() / sizeof(lts::Word)), 0);
    std::memcpy(row.data(), bytes.data(), bytes.size());
}

void PackedSystem::initial(std::span<lts::Word> state) {
    fill_row(processes_->initial(side_), state);
}

void PackedSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    const CallUnderWay call(calls_);
    if (workspaces_.size() < calls_) workspaces_.emplace_back();
    assert(calls_ > 0 && calls_ <= workspaces_.size());
    Workspace& work = workspaces_[calls_ - 1];
    processes_->steps(bytes_of(state), span_, work.steps);
    work.row.resize(width_);
    for (const PackedSteps::Step& step : work.steps.steps) {
        fill_row(work.steps.target(step), work.row);
        sink.add(step.event, work.row, step.revealed);
    }
}

std::vector<std::vector<lts::Word>> PackedSystem::choice_operands(lts::StateView state) {
    std::vector<std::vector<lts::Word>> operands;
    for (const Bytes& operand : processes_->choice_operands(bytes_of(state), span_))
        fill_row(operand, operands.emplace_back(width_));
    return operands;
}

std::string PackedSystem::describe(lts::StateView state) const {
    return processes_->describe(bytes_of(state));
}

// Increases the width by at least one half, because each increase restarts the search.
void PackedSystem::widen_rows() {
    constexpr std::size_t most_words = 256;
    if (needed_ <= width_) return;
    width_ = std::max(needed_, width_ + width_ / 2);
    if (width_ > most_words) throw NotPacked{"a state takes more than 1024 bytes"};
}

}  // namespace robochart::cspm
