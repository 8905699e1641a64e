// SPDX-License-Identifier: Apache-2.0
// Decides whether guards can be true (private to the front end). The procedure handles boolean combinations of linear
// comparisons of numbers, enumeration literals and boolean terms. Any other expression is an unknown boolean. The
// procedure answers "impossible" only with a proof and "possible" only with a consistent example. Otherwise it answers
// "unknown", and the lints report nothing.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend::logic {

/// A boolean combination of atoms. The atoms and their terms belong to the Reasoner that read the formula.
struct Formula {
    enum class Form { constant, atom, negation, conjunction, disjunction, equivalence, choice };
    Form form = Form::constant;
    bool value = true;           ///< constant
    std::size_t atom = 0;        ///< atom
    std::vector<Formula> parts;  ///< choice: condition, then, else
};

[[nodiscard]] Formula constant_formula(bool value);
[[nodiscard]] Formula negate_formula(Formula part);
[[nodiscard]] Formula all_of(std::vector<Formula> parts);
[[nodiscard]] Formula any_of(std::vector<Formula> parts);

enum class Answer { possible, impossible, unknown };

/// The answer whether a formula can be true, and an example of values that make it true: "`x` is 3 and `b` is false".
struct Finding {
    Answer answer = Answer::unknown;
    std::string example;
    /// False if the example depends on unknown terms (calls, quantifiers, …), or on several relations between terms (`t
    /// >= m`, `t < n`): the author may know a relation between m and n.
    bool trusted = true;
};

/// A linear form: the sum of coefficient * term over some terms, plus a constant. Terms are identified by their text.
struct Linear {
    std::map<std::string, double> terms;
    double constant = 0;
};

enum class Relation { less, less_equal, equal };

class Reasoner {
public:
    /// If `fold` is true, constants are replaced by their values. Otherwise a constant may have any value.
    explicit Reasoner(bool fold) : fold_(fold) {}

    /// Reads a boolean expression.
    [[nodiscard]] Formula read(const Expr& expr);
    /// Reads `expr RELATION 0`. The result is an unknown boolean if `expr` is not a number.
    [[nodiscard]] Formula compare_to_zero(const Expr& expr, Relation relation);
    /// Decides the formula within a bounded number of steps.
    [[nodiscard]] Finding decide(const Formula& formula) const;

private:
    friend class Search;

    /// Known facts about a term: whether it is an integer, and its least value.
    struct Term {
        bool integer = false;
        std::optional<double> least;
    };
    enum class KeyKind { boolean, enumeration, number };
    /// Something to which the search assigns a value: a boolean term, an enumeration term, or a linear form without its
    /// constant.
    struct Key {
        KeyKind kind = KeyKind::boolean;
        std::string text;
        bool opaque = false;                ///< boolean: a call or another unknown term
        std::vector<std::string> literals;  ///< enumeration
        std::map<std::string, double> form;
        bool integer = false;
        std::vector<double> bounds;  ///< the numbers with which the form is compared
    };
    /// A condition on one key.
    struct Atom {
        std::size_t key = 0;
        Relation relation = Relation::equal;
        bool reversed = false;  ///< key > bound, key >= bound
        double bound = 0;
        std::size_t literal = 0;
        std::string text;  ///< the text of the condition in messages
    };

    Formula read_binary(const Expr& expr);
    Formula read_equality(const Expr& left, const Expr& right);
    Formula read_comparison(const Expr& expr);
    Formula read_membership(const Expr& expr);
    Formula range_membership(const Expr& value, const Expr& range, const Expr& whole);
    std::optional<Formula> enumeration_equality(const Expr& left, const Expr& right);
    std::optional<Formula> linear_atom(const Expr& left, const Expr& right, Relation relation, const std::string& text);
    Formula comparison_with_zero(Linear difference, Relation relation, const std::string& text);
    Formula opaque_atom(const std::string& text, bool trusted);
    Formula read_name(const Expr& expr);

    std::optional<Linear> read_linear(const Expr& expr);
    std::optional<Linear> linear_binary(const Expr& expr);
    Linear read_term(const Expr& expr);
    const Expr* folded_definition(const Expr& expr) const;

    std::size_t key_index(KeyKind kind, const std::string& text);
    std::size_t add(Atom atom);

    bool fold_;
    unsigned depth_ = 0;
    std::map<std::string, Term> terms_;
    std::map<std::pair<KeyKind, std::string>, std::size_t> key_index_;
    std::vector<Key> keys_;
    std::vector<Atom> atoms_;
};

}  // namespace robochart::frontend::logic
