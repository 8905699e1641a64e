// SPDX-License-Identifier: Apache-2.0
// Compiles generated sources with the system's compiler and loads them into this process through the C interface of
// cpp_emit/runtime/explore_abi.h.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/emit.hpp"
#include "cpp_emit/load/shared_library.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

using BuildOptions = cpp_emit::BuildOptions;

/// A loaded controller. Its code runs in this process, so only code that this toolkit or its tests wrote may be loaded.
class SharedObject {
public:
    /// Writes `files` below the work folder, compiles `sources` (paths as in `files`) into one shared object and loads
    /// it. If this fails, returns null, and `error` contains the cause and the compiler's output if there is any.
    static std::unique_ptr<SharedObject> build(const std::vector<cpp_emit::OutputFile>& files,
                                               const std::vector<std::string>& sources, const BuildOptions&,
                                               std::string& error);
    [[nodiscard]] const rc_interface& interface() const { return *interface_; }

private:
    SharedObject() = default;
    [[nodiscard]] bool find_interface(std::string& error);

    std::unique_ptr<cpp_emit::SharedLibrary> library_;
    const rc_interface* interface_ = nullptr;
};

/// Returns the reason why the interface cannot be used (version, null pointers, sizes), or "" if it can be used.
[[nodiscard]] std::string interface_fault(const rc_interface&);

}  // namespace robochart::conformance
