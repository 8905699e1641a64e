// SPDX-License-Identifier: Apache-2.0
// Handles processes that cannot be evaluated or have too many states. Such a process is called refused, and work on it
// fails.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>

#include "base/diagnostics/budget.hpp"

namespace robochart::process {

/// Calls a function and returns its result. If the process is refused, returns a default-constructed result. Passes on
/// exceptions for interruptions, lack of memory and internal errors.
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
