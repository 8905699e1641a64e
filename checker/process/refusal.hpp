// SPDX-License-Identifier: Apache-2.0
// Handles work that fails because a process cannot be evaluated or is too large to be explored. Such a process is
// called refused.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>

#include "base/diagnostics/budget.hpp"

namespace robochart::process {

/// Does the work and returns its result, or a default-constructed result if the process is refused. Exceptions for
/// interruptions, lack of memory and internal errors are passed on.
template <typename Work>
auto unless_refused(const Work& work) -> decltype(work()) {
    try {
        return work();
    } catch (const diagnostics::LimitReached&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::logic_error&) {
        throw;  // an internal error
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace robochart::process
