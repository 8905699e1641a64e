// SPDX-License-Identifier: Apache-2.0
// Looks up names, and reports unknown names with suggestions (private to the front end).
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/names/names.hpp"

namespace robochart::frontend {

class Finder {
public:
    Finder(const Names& names, diagnostics::Diagnostics& out) : names_(names), out_(&out) {}

    /// Returns the declaration that a name refers to. If the name is unknown, reports this and returns null.
    const Declaration* find(const Place& place, const QualifiedName& name, const Kinds& kinds, std::string_view what);
    /// Reports an unknown name, with the nearest candidate as a fix. A name is reported once in a file for each value
    /// of `where`. Nothing is reported if the name may be declared in text that could not be parsed. `where` completes
    /// "there is no X `x` …".
    diagnostics::Diagnostic& report_unknown(const QualifiedName& name, std::string_view what, std::string_view where,
                                            const std::vector<std::string>& candidates);
    /// Returns true only at the first call for a component and an interface. If a component has no clause for an
    /// interface, all members of the interface are missing there, but only the first one is reported.
    bool first_missing(const Declaration* component, const Context* interface) {
        return missing_.emplace(component, interface).second;
    }
    /// Returns the simple names of these kinds, for suggestions. The result is empty if there are so many errors that
    /// no suggestion is shown.
    [[nodiscard]] std::vector<std::string> candidate_names(const Kinds& kinds) const;
    /// Returns the keys of a scope's table, for suggestions. The result is empty if there are so many errors that no
    /// suggestion is shown.
    template <class Map>
    [[nodiscard]] std::vector<std::string> keys_of(const Map& map) const {
        std::vector<std::string> result;
        if (out_->error_count() >= diagnostics::Diagnostics::max_kept) return result;
        for (const auto& entry : map) result.emplace_back(entry.first);
        return result;
    }
    [[nodiscard]] const Names& names() const { return names_; }
    [[nodiscard]] diagnostics::Diagnostics& out() { return *out_; }
    /// Sends later reports to `out`. Returns the previous receiver.
    diagnostics::Diagnostics& redirect_reports(diagnostics::Diagnostics& out) { return *std::exchange(out_, &out); }

private:
    [[nodiscard]] std::string lost_import(const Place& place) const;

    const Names& names_;
    diagnostics::Diagnostics* out_;
    std::set<std::pair<diagnostics::SourceId, std::string>> reported_;  ///< unknown names reported: kind, name, place
    /// For lookup only; the order of pointers is never used.
    std::set<std::pair<const Declaration*, const Context*>> missing_;
    diagnostics::Diagnostic untold_;  ///< receives notes that belong to no reported finding
};

}  // namespace robochart::frontend
