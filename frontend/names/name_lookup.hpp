// Finding names and saying well that there are none (private to the front end).
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "frontend/names/names.hpp"

namespace robochart::frontend {

class Finder {
public:
    Finder(const Names& names, diagnostics::Diagnostics& out) : names_(names), out_(&out) {}

    /// A name of the project; reported if there is none.
    const Declaration* find(const Place& place, const QualifiedName& name, const Kinds& kinds, std::string_view what);
    /// Reports an unknown name with the nearest candidate as a fix, once in a file for each place that `where`
    /// names. Nothing is
    /// reported where the declaration may have been in text that was not understood. `where` completes "there is no X
    /// `x` …".
    diagnostics::Diagnostic& unknown(const QualifiedName& name, std::string_view what, std::string_view where,
                                     const std::vector<std::string>& candidates);
    /// A component without a clause for an interface misses all that the interface declares: is this the first time
    /// that it is asked about the two? What is missing is reported then and only then.
    bool first_missing(const Declaration* component, const Context* interface) {
        return missing_.emplace(component, interface).second;
    }
    /// Simple names of these kinds for a suggestion; none once nobody will see it.
    [[nodiscard]] std::vector<std::string> candidates(const Kinds& kinds) const;
    /// The keys of a scope's table, likewise.
    template <class Map>
    [[nodiscard]] std::vector<std::string> keys(const Map& map) const {
        std::vector<std::string> result;
        if (out_->errors() >= diagnostics::Diagnostics::max_kept) return result;
        for (const auto& entry : map) result.emplace_back(entry.first);
        return result;
    }
    [[nodiscard]] const Names& names() const { return names_; }
    [[nodiscard]] diagnostics::Diagnostics& out() { return *out_; }
    /// Reports to another place from now on; returns the place so far.
    diagnostics::Diagnostics& redirect(diagnostics::Diagnostics& out) { return *std::exchange(out_, &out); }

private:
    [[nodiscard]] std::string lost_import(const Place& place) const;

    const Names& names_;
    diagnostics::Diagnostics* out_;
    std::set<std::pair<diagnostics::SourceId, std::string>> reported_;  ///< unknown names reported: kind, name, place
    std::set<std::pair<const Declaration*, const Context*>> missing_;   ///< asked for, never walked through
    diagnostics::Diagnostic untold_;                                    ///< takes the notes of what is not reported
};

}  // namespace robochart::frontend
