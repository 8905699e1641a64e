// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/component_processes.hpp"

#include <array>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::driver {
namespace {

/// The suffixes of names of component processes.
constexpr std::array<std::string_view, 6> variants{"::D__", "::O__", "::VS__", "::VS_O__", "::AS_O__", "::FVS__"};

/// Returns the suffix of the component process that the expression calls; "" if it calls none.
std::string_view variant_of(const cspm::Expr& expr) {
    if (expr.kind != cspm::ExprKind::apply || expr.args[0]->kind != cspm::ExprKind::name) return "";
    for (const std::string_view variant : variants)
        if (expr.args[0]->text.ends_with(variant)) return variant;
    return "";
}

/// Replaces the names of component processes. Recursion depth: the depth of the expression.
cspm::ExprPtr replaced(const cspm::ExprPtr& expr, const std::function<std::string(std::string_view)>& variant) {
    if (!expr) return expr;
    if (const std::string_view old = variant_of(*expr); !old.empty()) {
        const std::string other = variant(old);
        if (other == old) return expr;
        cspm::Expr plain = *expr;
        plain.args[0] = cspm::build::name(component_of(*expr) + other);
        return std::make_shared<const cspm::Expr>(std::move(plain));
    }
    cspm::Expr result = *expr;
    for (cspm::ExprPtr& part : result.args) part = replaced(part, variant);
    return result.args == expr->args ? expr : std::make_shared<const cspm::Expr>(std::move(result));
}

}  // namespace

std::string component_of(const cspm::Expr& expr) {
    const std::string_view variant = variant_of(expr);
    if (variant.empty()) return "";
    const std::string& name = expr.args[0]->text;
    return name.substr(0, name.size() - variant.size());
}

cspm::ExprPtr with_variant(const cspm::ExprPtr& expr, const std::string& variant) {
    return replaced(expr, [&](std::string_view) { return "::" + variant; });
}

cspm::ExprPtr without_compression(const cspm::ExprPtr& expr) {
    return replaced(expr, [](std::string_view variant) {
        if (variant == "::O__") return std::string("::D__");
        return std::string(variant == "::VS_O__" ? "::VS__" : variant);
    });
}

}  // namespace robochart::driver
