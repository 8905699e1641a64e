// SPDX-License-Identifier: Apache-2.0
// Finds the names in a script by place.
#pragma once

#include <optional>
#include <string_view>

#include "editors/server/cspm/scripts.hpp"

namespace robochart::lsp {

/// The name without its modules.
[[nodiscard]] std::string_view short_name(std::string_view qualified);
/// The place of the name in a declaration; the beginning of the declaration if the declaration does not contain the
/// name.
[[nodiscard]] Span name_place(const SourceManager&, Span declaration, std::string_view name);

/// A name at some place in a script.
struct NameAt {
    const cspm::KnownName* known = nullptr;
    Span span;  ///< the place where it was found
};
/// The name at or directly before an offset, used or declared.
[[nodiscard]] std::optional<NameAt> name_at(const ScriptReading&, SourceId, std::uint32_t offset);

}  // namespace robochart::lsp
