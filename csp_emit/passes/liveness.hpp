// Which parameters the functions of a family need. Calls are first written with only those arguments that differ from
// what the caller holds; what matters at all is found by going backwards along the calls. A variable that will be
// overwritten before it is read, a clock that will be reset, is no parameter: the processes stay the same, their states
// become fewer.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::csp_emit {

/// One of a family of mutually recursive functions, called `name(arguments)`, or `name` if it has no parameters.
struct Function {
    std::string name;
    std::vector<std::string> parameters;
    cspm::ExprPtr body;
};

/// The index of each function of a family, by its name.
using FamilyIndex = std::unordered_map<std::string, std::size_t>;  // looked up only
[[nodiscard]] FamilyIndex index_of(const std::vector<Function>& functions);
/// The function that an expression calls, with arguments or without, if it is one of the family; else null.
[[nodiscard]] const std::size_t* called(const FamilyIndex& index, const cspm::Expr& expr);
/// Calls `visit` on the direct parts of an expression.
template <class Visit>
void for_each_part(const cspm::Expr& expr, const Visit& visit) {
    for (const auto& part : expr.args)
        if (part) visit(*part);
    for (const auto& field : expr.fields)
        if (field.value) visit(*field.value);
    for (const auto& clause : expr.clauses)
        if (clause.value) visit(*clause.value);
}

/// The expression with `change` done to its arguments; itself where they stay what they are.
template <class Change>
[[nodiscard]] cspm::ExprPtr with_parts(const cspm::ExprPtr& expr, const Change& change) {
    std::shared_ptr<cspm::Expr> result;
    for (std::size_t i = 0; i < expr->args.size(); ++i) {
        cspm::ExprPtr part = change(expr->args[i]);
        if (part == expr->args[i]) continue;
        if (!result) result = std::make_shared<cspm::Expr>(*expr);
        result->args[i] = std::move(part);
    }
    return result ? result : expr;
}

/// Arguments by the name of the parameter.
using Arguments = std::vector<std::pair<std::string, cspm::ExprPtr>>;
/// A call within a family that gives only some arguments: the other parameters keep the caller's values.
struct SparseCall {
    std::string function;
    Arguments changed;
    bool after_tock = false;  ///< parameters that count time count on
};

/// The calls within a family before its parameters are known, and the arguments that nobody needs. In the trees a node
/// stands for each, which is known here by its address.
class FamilyCalls {
public:
    /// The node for such a call.
    [[nodiscard]] cspm::ExprPtr add(std::string function, Arguments changed = {}, bool after_tock = false);
    /// The call that the node stands for; null if it stands for none.
    [[nodiscard]] const SparseCall* find(const cspm::Expr&) const;
    /// The function that is called with nothing changed, if the expression is such a call; else null.
    [[nodiscard]] const std::string* only_calls(const cspm::Expr&) const;
    /// Makes a call one of another function.
    void redirect(const cspm::Expr& call, const std::string& function);

    /// The argument for a parameter that nothing reads where this call returns to.
    [[nodiscard]] const cspm::ExprPtr& unneeded() const { return unneeded_; }
    [[nodiscard]] bool is_unneeded(const cspm::ExprPtr& argument) const { return argument == unneeded_; }

private:
    struct Known {
        cspm::ExprPtr node;  ///< kept, so that no other gets its address
        SparseCall call;
    };
    std::unordered_map<const cspm::Expr*, Known> calls_;  // looked up only
    cspm::ExprPtr unneeded_ = std::make_shared<const cspm::Expr>();
};

/// What the functions of a family may have as parameters.
struct Candidates {
    std::vector<std::string> names;                ///< in the order in which they become parameters
    std::map<std::string, cspm::ExprPtr> ticking;  ///< what one that counts time becomes with a tock
    std::vector<std::string> kept;                 ///< those that every function has, whether or not it reads them
    std::vector<std::vector<std::string>>
        read;             ///< by function: what it reads although its body does not; may be short
    std::string returns;  ///< the one that holds where calls return to; may be empty
    /// For a value given to it: the function that goes on behind the call, and the value before.
    struct Entry {
        std::string behind;
        cspm::ExprPtr outer;
    };
    std::map<const cspm::Expr*, Entry> entries;
};

/// Gives every function the parameters that matter, and every call of `calls`, in `initial` too, arguments for them.
/// What `initial` needs and is not given stays as a name there: its result is those names.
[[nodiscard]] std::vector<std::string> find_parameters(std::vector<Function>& functions, cspm::ExprPtr& initial,
                                                       const FamilyCalls& calls, const Candidates&);
/// Puts values of no interest, by parameter, for the unneeded arguments of all calls.
void fill_unneeded(std::vector<Function>& functions, const FamilyCalls& calls,
                   const std::map<std::string, cspm::ExprPtr>& values);

}  // namespace robochart::csp_emit
