// SPDX-License-Identifier: Apache-2.0
// Generates processes from lists of numbers. A random list gives a random process over all operators. A shorter list or
// smaller numbers give a simpler process, so shrinking the list shrinks the process.
#pragma once

#include <vector>

#include "process_tree.hpp"

namespace robochart::refine::naive {

inline constexpr int letters_used = 3;

class Decoder {
public:
    explicit Decoder(const std::vector<unsigned>& numbers) : numbers_(numbers) {}

    /// Returns two named sequential processes with recursion, and main processes that use them.
    Script script(int mains);

private:
    unsigned take_below(unsigned below);
    Letter make_letter() { return static_cast<Letter>(take_below(letters_used)); }
    std::set<Letter> set();
    /// Returns a process in which calls occur only in tail position, so that recursion has finitely many states. If
    /// `guarded`, calls occur only after an event.
    Process sequential(int depth, bool guarded);
    Process sequential_leaf(bool guarded);
    Process prefix(int depth);
    /// Returns a process without calls. It is one mode of a machine with several modes that lead to parallel
    /// components.
    Process make_mode(int depth);
    Process closed(int depth);
    Process static_leaf();
    Process composite(int depth);
    Process with_levels(Kind kind, std::vector<Process> operands, unsigned sets = 2);
    Process renamed(int depth);
    Process linked(int depth);
    Process make_ordered(int depth);
    Process compressed(Process operand);

    const std::vector<unsigned>& numbers_;
    std::size_t next_ = 0;
    int definitions_ = 0;  // 0 if calls are not allowed
};

}  // namespace robochart::refine::naive
