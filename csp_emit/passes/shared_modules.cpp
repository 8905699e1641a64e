// SPDX-License-Identifier: Apache-2.0
// See shared_modules.hpp. FDR's front end does not resolve names of an instance that is inside a parameterised module.
// So a module that contains an instance is never shared, and the modules inside a shared module are written in full.
// Among nested modules, those that save the most text are shared.
#include "csp_emit/passes/shared_modules.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/fingerprint.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "csp_emit/passes/liveness.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::Decl;
using cspm::DeclKind;
using cspm::DeclPtr;
using cspm::Expr;
using cspm::ExprKind;

namespace {

/// Below this size (cspm::Fingerprint) an instance does not shorten the script enough.
constexpr std::size_t worth_sharing = 250;

/// Positions in nested lists of exported declarations.
using Path = std::vector<std::size_t>;

struct Place {
    Path path;
    DeclPtr module;
    std::vector<const Decl*> around;  ///< enclosing modules, outermost first
};

std::string first_part(const std::string& name) {
    return name.substr(0, name.find("::"));
}

void used_names(const Expr& expr, std::set<std::string>& result) {
    if (expr.kind == ExprKind::name) result.insert(first_part(expr.text));
    for_each_part(expr, [&](const Expr& part) { used_names(part, result); });
    for (const cspm::Link& link : expr.links) {
        used_names(*link.from, result);
        used_names(*link.to, result);
    }
    for (const DeclPtr& decl : expr.decls)
        if (decl->body) used_names(*decl->body, result);
}

void used_names(const Decl& decl, std::set<std::string>& result) {
    if (decl.body) used_names(*decl.body, result);
    for (const cspm::Constructor& constructor : decl.constructors)
        if (constructor.fields) used_names(*constructor.fields, result);
    for (const auto* parts : {&decl.decls, &decl.exports})
        for (const DeclPtr& part : *parts) used_names(*part, result);
    if (decl.kind == DeclKind::instance) result.insert(first_part(decl.text));
}

std::set<std::string> names_inside(const Decl& module) {
    std::set<std::string> result;
    for (const auto* parts : {&module.decls, &module.exports})
        for (const DeclPtr& part : *parts)
            for (const std::string& name : cspm::declared_names(*part)) result.insert(name);
    return result;
}

class Sharer {
public:
    Sharer(std::vector<DeclPtr> decls, NameManager names)
        : decls_(std::move(decls)), names_(std::move(names)), parameter_(names_.unique_name("u__")) {}

    std::vector<DeclPtr> share_all() {
        while (share_most()) {
        }
        return decls_;
    }

private:
    /// Places of modules with equal text.
    struct Group {
        std::size_t size = 0;
        std::vector<Place> places;

        [[nodiscard]] std::size_t saved_size() const { return size * (places.size() - 1); }
    };

    bool share_most() {
        std::vector<Group> groups;
        std::map<std::uint64_t, std::vector<std::size_t>> by_hash;
        collect_modules(decls_, {}, {}, groups, by_hash);
        std::erase_if(groups,
                      [](const Group& group) { return group.places.size() < 2 || group.size <= worth_sharing; });
        std::ranges::stable_sort(groups,
                                 [](const Group& a, const Group& b) { return a.saved_size() > b.saved_size(); });
        const auto best = std::ranges::find_if(groups, [](const Group& group) { return is_movable(group.places); });
        if (best == groups.end()) return false;
        share_module(best->places);
        return true;
    }

    /// Collects modules that may be shared. Returns true if the declarations contain an instance, at any depth.
    bool collect_modules(const std::vector<DeclPtr>& decls, const Path& path, const std::vector<const Decl*>& around,
                         std::vector<Group>& groups, std::map<std::uint64_t, std::vector<std::size_t>>& by_hash) {
        bool instances = false;
        for (std::size_t i = 0; i < decls.size(); ++i) {
            const Decl& decl = *decls[i];
            if (decl.kind == DeclKind::instance) instances = true;
            if (decl.kind != DeclKind::module || !decl.decls.empty() || !decl.parameters.empty()) continue;
            Path here = path;
            here.push_back(i);
            std::vector<const Decl*> inside = around;
            inside.push_back(&decl);
            if (collect_modules(decl.exports, here, inside, groups, by_hash))
                instances = true;
            else
                group_of(decls[i], groups, by_hash).places.push_back({here, decls[i], around});
        }
        return instances;
    }

    Group& group_of(const DeclPtr& module, std::vector<Group>& groups,
                    std::map<std::uint64_t, std::vector<std::size_t>>& by_hash) {
        const cspm::Fingerprint fingerprint = fingerprints_.of_exports(module);
        std::vector<std::size_t>& candidates = by_hash[fingerprint.hash];
        for (const std::size_t candidate : candidates)
            if (same_exports(*groups[candidate].places.front().module, *module)) return groups[candidate];
        candidates.push_back(groups.size());
        return groups.emplace_back(Group{fingerprint.size, {}});
    }

    static bool same_exports(const Decl& a, const Decl& b) {
        return std::ranges::equal(a.exports, b.exports,
                                  [](const DeclPtr& x, const DeclPtr& y) { return cspm::equal(*x, *y); });
    }

    static std::size_t common_depth(const std::vector<Place>& places) {
        std::size_t depth = places.front().around.size();
        for (const Place& place : places) {
            std::size_t same = 0;
            while (same < depth && same < place.around.size() && place.around[same] == places.front().around[same])
                ++same;
            depth = same;
        }
        return depth;
    }

    /// True if all names have the same meaning at the place of the shared module.
    static bool is_movable(const std::vector<Place>& places) {
        std::set<std::string> outside;
        used_names(*places.front().module, outside);
        for (const std::string& own : names_inside(*places.front().module)) outside.erase(own);
        for (const Place& place : places)
            for (std::size_t depth = common_depth(places); depth < place.around.size(); ++depth)
                for (const std::string& name : names_inside(*place.around[depth]))
                    if (outside.count(name) != 0) return false;
        return true;
    }

    void share_module(const std::vector<Place>& places) {
        const std::string name = names_.unique_name(places.front().module->names.front() + "__");
        const DeclPtr shared =
            b::module_(name, {parameter_}, {}, places.front().module->exports, places.front().module->comment);
        const Path scope(places.front().path.begin(),
                         places.front().path.begin() + static_cast<std::ptrdiff_t>(common_depth(places)));
        for (const Place& place : places) {
            Decl instance = *b::instance(place.module->names.front(), name, {b::number(0)});
            decls_ = replace_at(decls_, place.path, 0, std::make_shared<const Decl>(std::move(instance)));
        }
        Path before = scope;
        before.push_back(places.front().path[scope.size()]);
        for (const Place& place : places) before.back() = std::min(before.back(), place.path[scope.size()]);
        decls_ = insert_at(decls_, before, 0, shared);
    }

    /// Applies `change` to the list that contains the declaration at the path.
    template <class Change>
    static std::vector<DeclPtr> change_at(std::vector<DeclPtr> decls, const Path& path, std::size_t depth,
                                          const Change& change) {
        if (depth + 1 == path.size()) {
            change(decls, decls.begin() + static_cast<std::ptrdiff_t>(path[depth]));
            return decls;
        }
        Decl outer = *decls[path[depth]];
        outer.exports = change_at(outer.exports, path, depth + 1, change);
        decls[path[depth]] = std::make_shared<const Decl>(std::move(outer));
        return decls;
    }
    static std::vector<DeclPtr> replace_at(const std::vector<DeclPtr>& decls, const Path& path, std::size_t depth,
                                           const DeclPtr& by) {
        return change_at(decls, path, depth, [&](std::vector<DeclPtr>&, auto at) { *at = by; });
    }
    static std::vector<DeclPtr> insert_at(const std::vector<DeclPtr>& decls, const Path& path, std::size_t depth,
                                          const DeclPtr& decl) {
        return change_at(decls, path, depth, [&](std::vector<DeclPtr>& list, auto at) { list.insert(at, decl); });
    }

    std::vector<DeclPtr> decls_;
    NameManager names_;
    std::string parameter_;
    cspm::Fingerprints fingerprints_;
};

}  // namespace

std::vector<DeclPtr> share_modules(std::vector<DeclPtr> decls, NameManager names) {
    return Sharer(std::move(decls), std::move(names)).share_all();
}

}  // namespace robochart::csp_emit
