// Names of a script by place.
#pragma once

#include <optional>
#include <string_view>

#include "lsp/cspm/scripts.hpp"

namespace robochart::lsp {

/// The name without the modules around it.
[[nodiscard]] std::string_view short_name(std::string_view qualified);
/// Where in a declaration its name stands; the declaration's beginning if it does not.
[[nodiscard]] Span name_place(const SourceManager&, Span declaration, std::string_view name);

/// A name as it stands somewhere in a script.
struct NameAt {
    const cspm::KnownName* known = nullptr;
    Span span;  ///< where it was found
};
/// The name at or directly before an offset, used or declared.
[[nodiscard]] std::optional<NameAt> name_at(const ScriptReading&, SourceId, std::uint32_t offset);

}  // namespace robochart::lsp
