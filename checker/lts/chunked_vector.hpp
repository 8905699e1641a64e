// SPDX-License-Identifier: Apache-2.0
// A vector that grows by adding chunks. Elements never move, so growing never needs memory for two copies of an
// element.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <vector>

namespace robochart::lts {

template <class T>
class ChunkedVector {
public:
    void push_back(T value) {
        if (size_ % chunk_size == 0) chunks_.push_back(std::make_unique<T[]>(chunk_size));
        chunks_[size_ / chunk_size][size_ % chunk_size] = value;
        ++size_;
    }
    [[nodiscard]] T operator[](std::size_t index) const {
        assert(index < size_);
        return chunks_[index / chunk_size][index % chunk_size];
    }
    [[nodiscard]] T& operator[](std::size_t index) {
        assert(index < size_);
        return chunks_[index / chunk_size][index % chunk_size];
    }
    [[nodiscard]] std::size_t size() const { return size_; }

private:
    static constexpr std::size_t chunk_size = 4096;
    std::vector<std::unique_ptr<T[]>> chunks_;
    std::size_t size_ = 0;
};

}  // namespace robochart::lts
