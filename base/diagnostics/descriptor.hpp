// SPDX-License-Identifier: Apache-2.0
// Owns a POSIX file descriptor, which the destructor closes.
#pragma once

#include <unistd.h>

#include <utility>

namespace robochart::diagnostics {

/// An open file or folder. The number is -1 if nothing is open.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return number_; }
    [[nodiscard]] bool is_open() const { return number_ >= 0; }
    /// Closes the file. Returns false and sets errno if the written data could not be stored.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

}  // namespace robochart::diagnostics
