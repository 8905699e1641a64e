// SPDX-License-Identifier: Apache-2.0
// Finds the names in a script by place.
#pragma once

#include <optional>
#include <string_view>

#include "editors/server/cspm/scripts.hpp"

namespace robochart::lsp {

/// Returns the name without its modules.
[[nodiscard]] std::string_view short_name(std::string_view qualified);
/// Returns the place of the name in a declaration, or the beginning of the declaration if it does not contain the name.
[[nodiscard]] Span name_place(const SourceManager&, Span declaration, std::string_view name);

/// A name at some place in a script.
struct NameAt {
    const cspm::KnownName* known = nullptr;
    Span span;  ///< the place where it was found
};
/// Returns the name that is used or declared at an offset, or directly before the offset.
[[nodiscard]] std::optional<NameAt> name_at(const ScriptReading&, SourceId, std::uint32_t offset);

}  // namespace robochart::lsp
