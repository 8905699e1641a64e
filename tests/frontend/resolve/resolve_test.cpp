// SPDX-License-Identifier: Apache-2.0
// Tests targets of names, and types of expressions.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

#include "frontend/names/names.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/types/type_algebra.hpp"
#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

using testing::resolved;

/// Returns the type of a constant's value, in an interface that first declares these members.
std::string type_of(const std::string& expression, const std::string& members = "", const std::string& before = "") {
    const auto reading =
        resolved(before + "\ninterface I { " + members + " const result_value : ?Z = " + expression + " }");
    EXPECT_TRUE(reading->findings.ok()) << reading->report();
    const auto* interface = dynamic_cast<const Context*>(reading->file().declarations.back().get());
    return to_string(interface->variables.back()->initial->type);
}

// The types follow from language reference 2, Types.
TEST(Types, OfOperators) {
    EXPECT_EQ(type_of("1 + 2"), "nat");
    EXPECT_EQ(type_of("1 - 2"), "int");
    EXPECT_EQ(type_of("-1"), "int");
    EXPECT_EQ(type_of("1 / 2"), "real");
    EXPECT_EQ(type_of("7 % 2"), "nat");
    EXPECT_EQ(type_of("1 * 0.5"), "real");
    EXPECT_EQ(type_of("1 < 2"), "boolean");
    EXPECT_EQ(type_of("v * v", "const v : vector(nat, 3)"), "nat");
    EXPECT_EQ(type_of("m * v", "const v : vector(int, 3) const m : matrix(nat, 2, 3)"), "vector(int, 2)");
    EXPECT_EQ(type_of("m * m", "const m : matrix(nat, 2, 2)"), "matrix(nat, 2, 2)");
    EXPECT_EQ(type_of("-7 % 2"), "int");
    EXPECT_EQ(type_of("v * m", "const v : vector(nat, 3) const m : matrix(int, 1, 2)"), "matrix(int, 3, 2)");
    EXPECT_EQ(type_of("transpose(v)", "const v : vector(nat, 3)"), "matrix(nat, 1, 3)");
    EXPECT_EQ(type_of("-v", "const v : vector(int, 3)"), "vector(int, 3)");
    EXPECT_EQ(type_of("2 * v", "const v : vector(real, 3)"), "vector(real, 3)");
    EXPECT_EQ(type_of("< 1 > cat < -1 >"), "Seq(int)");
}

/// The minimum and the maximum of a set have the type of the elements, which must be numbers.
TEST(Types, OfTheLeastAndTheGreatestElement) {
    const std::string toolkit = "import sequence_toolkit::*";
    for (const std::string function : {"min", "max"}) {
        EXPECT_EQ(type_of(function + "({ 1, 2 })", "", toolkit), "nat");
        EXPECT_EQ(type_of(function + "({ 1, -2 })", "", toolkit), "int");
        EXPECT_EQ(type_of(function + "({ 1, 0.5 })", "", toolkit), "real");
        EXPECT_EQ(type_of(function + "(s)", "const s : Set(real)", toolkit), "real");
        EXPECT_EQ(type_of(function + "({ })", "", toolkit), "nat");
        EXPECT_EQ(type_of(function + "({ 1, -2 }) + 0.5", "", toolkit), "real");
    }
    for (const std::string function : {"hasMin", "hasMax"})
        EXPECT_EQ(type_of(function + "({ 1, 0.5 })", "", toolkit), "boolean");
}

TEST(Types, OnlySetsOfNumbersHaveALeastAndAGreatestElement) {
    for (const std::string function : {"min", "max", "hasMin", "hasMax"})
        for (const std::string argument : {"{ true }", "{ { 1 } }", "{ (| 1, 0.5 |) }", "{ 'a' }", "< 1 >", "0.5"}) {
            const auto reading = resolved("import sequence_toolkit::*\ninterface I { const c : ?Z = " + function + "(" +
                                          argument + ") }");
            EXPECT_EQ(reading->codes(), "RC-T14@2") << function << argument << "\n" << reading->report();
        }
    const auto reading = resolved("import sequence_toolkit::* interface I { const c : ?Z = min({ true }) }");
    EXPECT_NE(reading->report().find("must be Set(real), but this is Set(boolean)"), std::string::npos)
        << reading->report();
}

/// In models ?Number is an ordinary type variable, unlike in the toolkit.
TEST(Types, ATypeVariableOfAModelIsOfEveryType) {
    EXPECT_EQ(type_of("same(true)", "", "function same(x : ?Number) : ?Number { }"), "boolean");
    EXPECT_EQ(type_of("least({ 0.5 })", "",
                      "import sequence_toolkit::* "
                      "function least(s : Set(?X)) : ?X { postcondition result == min(s) }"),
              "real");
}

/// A result of type real does not fit int.
TEST(Types, TheLeastRealDoesNotFitAnInt) {
    const auto reading = resolved("import sequence_toolkit::*\ninterface I { const c : int = min({ 0.5 }) }");
    EXPECT_FALSE(reading->findings.ok()) << reading->report();
}

TEST(Types, OfForms) {
    EXPECT_EQ(type_of("{ }"), "Set(?)");
    EXPECT_EQ(type_of("{ 1, -1 }"), "Set(int)");
    EXPECT_EQ(type_of("{ 1 to 3 }"), "Set(nat)");
    EXPECT_EQ(type_of("(| 1, true |)"), "nat * boolean");
    EXPECT_EQ(type_of("[| 1, 2; 3, 4 |]"), "matrix(nat, 2, 2)");
    EXPECT_EQ(type_of("[| 1, 2 |]"), "vector(nat, 2)");
    EXPECT_EQ(type_of("lambda x:nat, y:real @ x > y"), "nat * real -> boolean");
    EXPECT_EQ(type_of("{ x:nat | x > 1 @ (| x, true |) }"), "Set(nat * boolean)");
    EXPECT_EQ(type_of("{ x:nat, y:real }"), "Set(nat * real)");
    EXPECT_EQ(type_of("let a == 1, b == a + 0.5 @ b"), "real");
    EXPECT_EQ(type_of("the x:nat | x > 1 @ x"), "nat");
    EXPECT_EQ(type_of("[ 1, 2.5 ]"), "Set(real)");
    EXPECT_EQ(type_of("if true then 1 else 0.5 end"), "real");
    EXPECT_EQ(type_of("1 as real"), "real");
    EXPECT_EQ(type_of("d.x", "const d : D", "datatype D { x:boolean }"), "boolean");
    EXPECT_EQ(type_of("D(| x = true |)", "", "datatype D { x:boolean }"), "D");
    EXPECT_EQ(type_of("E::L", "", "enumeration E { L }"), "E");
    EXPECT_EQ(type_of("L", "", "enumeration E { L }"), "E");
}

// ---------------------------------------------------------------- compat(a, b)

/// Draws random types without type variables and with known sizes. Smaller types are drawn more often.
class RandomTypes {
public:
    TypePtr next(int depth = 3) {
        constexpr TypeForm base[] = {TypeForm::nat, TypeForm::integer, TypeForm::real, TypeForm::boolean};
        const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); };
        if (depth == 0 || pick(3) == 0) return make_type(base[pick(4)]);
        const auto inner = [&] { return next(depth - 1); };
        switch (pick(6)) {
            case 0:
                return make_type(TypeForm::set, {inner()});
            case 1:
                return make_type(TypeForm::sequence, {inner()});
            case 2:
                return make_type(TypeForm::relation, {inner(), inner()});
            case 3:
                return make_type(TypeForm::function, {inner(), inner()});
            case 4:
                return make_type(TypeForm::product, {inner(), inner()});
            default:
                return make_vector(inner(), 2);
        }
    }

private:
    std::mt19937 random_{1};
};

/// Returns a wider type, another form of a type with the same values, or the type itself.
TypePtr widened(const TypePtr& type) {
    if (type->form == TypeForm::nat) return make_type(TypeForm::integer);
    if (type->form == TypeForm::integer) return make_type(TypeForm::real);
    if (type->form == TypeForm::sequence || type->form == TypeForm::function || type->form == TypeForm::relation)
        return as_set(type);
    if (type->form == TypeForm::vector) return as_product(type);
    auto result = std::make_shared<Type>(*type);
    for (TypePtr& arg : result->args) arg = widened(arg);
    return result;
}

TEST(Compatibility, IsReflexiveAndWidens) {
    RandomTypes types;
    for (int i = 0; i < 2000; ++i) {
        const TypePtr type = types.next();
        EXPECT_TRUE(is_compatible(type, type)) << to_string(type);
        EXPECT_TRUE(is_compatible(type, widened(type))) << to_string(type) << " to " << to_string(widened(type));
    }
}

TEST(Compatibility, IsTransitive) {
    RandomTypes types;
    for (int i = 0; i < 2000; ++i) {
        const TypePtr a = types.next();
        const TypePtr b = widened(a);
        const TypePtr c = widened(b);
        EXPECT_TRUE(is_compatible(a, c)) << to_string(a) << ", " << to_string(b) << ", " << to_string(c);
        const TypePtr other = types.next();
        EXPECT_TRUE(!is_compatible(b, other) || is_compatible(a, other)) << to_string(a) << ", " << to_string(other);
    }
}

TEST(Compatibility, OfNumbersGoesOneWay) {
    const TypeForm forms[] = {TypeForm::nat, TypeForm::integer, TypeForm::real};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) EXPECT_EQ(is_compatible(make_type(forms[i]), make_type(forms[j])), i <= j);
    EXPECT_FALSE(is_compatible(make_type(TypeForm::boolean), make_type(TypeForm::nat)));
    EXPECT_FALSE(is_compatible(make_type(TypeForm::string), make_type(TypeForm::boolean)));
}

TEST(Compatibility, SequencesAndFunctionsAreRelationsAndRelationsAreSets) {
    const TypePtr nat = make_type(TypeForm::nat);
    const TypePtr truth = make_type(TypeForm::boolean);
    const TypePtr relation = make_type(TypeForm::relation, {nat, truth});
    const TypePtr pairs = make_type(TypeForm::set, {make_type(TypeForm::product, {nat, truth})});
    const TypePtr function = make_type(TypeForm::function, {nat, truth});
    const TypePtr sequence = make_type(TypeForm::sequence, {truth});
    for (const TypePtr& from : {relation, pairs, function, sequence})
        for (const TypePtr& to : {relation, pairs}) EXPECT_TRUE(is_compatible(from, to)) << to_string(from);
    EXPECT_FALSE(is_compatible(relation, function));
    EXPECT_FALSE(is_compatible(relation, sequence));
    EXPECT_FALSE(is_compatible(make_type(TypeForm::set, {truth}), relation));
}

TEST(Compatibility, OfVectorsLooksAtSizesAndProducts) {
    const TypePtr nat = make_type(TypeForm::nat);
    const TypePtr real = make_type(TypeForm::real);
    EXPECT_TRUE(is_compatible(make_vector(nat, 2), make_vector(real, 2)));
    EXPECT_FALSE(is_compatible(make_vector(nat, 2), make_vector(nat, 3)));
    EXPECT_TRUE(is_compatible(make_vector(nat, 2), make_vector(nat, -1)));  // a constant without value
    EXPECT_TRUE(is_compatible(make_vector(nat, 2), make_type(TypeForm::product, {nat, real})));
    EXPECT_TRUE(is_compatible(make_type(TypeForm::product, {nat, nat}), make_vector(real, 2)));
    EXPECT_FALSE(is_compatible(make_type(TypeForm::product, {nat, nat, nat}), make_vector(nat, 2)));
    EXPECT_FALSE(is_compatible(make_matrix(nat, 2, 3), make_matrix(nat, 3, 2)));
}

TEST(Compatibility, EmptyCollectionsFitAny) {
    const TypePtr empty = make_type(TypeForm::set, {make_type(TypeForm::any)});
    EXPECT_TRUE(is_compatible(empty, make_type(TypeForm::set, {make_type(TypeForm::string)})));
    EXPECT_TRUE(is_compatible(make_type(TypeForm::set, {make_type(TypeForm::string)}), empty));
    EXPECT_FALSE(is_compatible(empty, make_type(TypeForm::nat)));
}

TEST(Types, OfGenericCalls) {
    const std::string imports = "import set_toolkit::* import relation_toolkit::* import sequence_toolkit::*";
    EXPECT_EQ(type_of("union({1}, {})", "", imports), "Set(nat)");
    EXPECT_EQ(type_of("union({}, {-1})", "", imports), "Set(int)");
    EXPECT_EQ(type_of("dom({(| 1, true |)})", "", imports), "Set(nat)");
    EXPECT_EQ(type_of("ran(<true>)", "", imports), "Set(boolean)");
    EXPECT_EQ(type_of("head(<true>)", "", imports), "boolean");
    EXPECT_EQ(type_of("f", "", "function f(a:nat):real { }"), "nat -> real");
    EXPECT_EQ(type_of("(lambda x:nat @ x + 1)(1)"), "nat");
    EXPECT_EQ(type_of("s(1)", "const s : Seq(boolean)"), "boolean");
}

/// Returns the type that this text in RoboChart's notation denotes.
TypePtr written(const std::string& text) {
    const auto reading = resolved("interface I { var v : " + text + " }");
    EXPECT_TRUE(reading->findings.ok()) << reading->report();
    return dynamic_cast<const Context*>(reading->file().declarations.back().get())->variables.back()->type;
}

TEST(Types, CompatibilityIsOneWayWhereItNarrows) {
    const auto fits = [](const char* from, const char* to) { return is_compatible(written(from), written(to)); };
    EXPECT_TRUE(fits("nat", "int"));
    EXPECT_TRUE(fits("nat", "real"));
    EXPECT_FALSE(fits("int", "nat"));
    EXPECT_FALSE(fits("real", "int"));
    EXPECT_FALSE(fits("nat", "boolean"));
    EXPECT_TRUE(fits("Seq(nat)", "Seq(real)"));
    EXPECT_FALSE(fits("Seq(real)", "Seq(nat)"));
    EXPECT_TRUE(fits("Seq(boolean)", "nat <-> boolean"));
    EXPECT_TRUE(fits("Seq(boolean)", "Set(nat * boolean)"));
    EXPECT_TRUE(fits("nat <-> boolean", "Set(nat * boolean)"));
    EXPECT_TRUE(fits("Set(nat * boolean)", "nat <-> boolean"));
    EXPECT_TRUE(fits("nat -> boolean", "nat <-> boolean"));
    EXPECT_FALSE(fits("nat <-> boolean", "nat -> boolean"));
    EXPECT_TRUE(fits("nat * int", "real * real"));
    EXPECT_FALSE(fits("nat * int", "nat * int * int"));
    EXPECT_TRUE(fits("vector(nat, 2)", "nat * nat"));
    EXPECT_FALSE(fits("vector(nat, 2)", "vector(nat, 3)"));
    EXPECT_TRUE(fits("?X", "nat"));
}

TEST(Types, ATypeIsDeclaredWhereItsFileSees) {
    EXPECT_EQ(resolved("type T interface I { var v : T }")->codes(), "");
    EXPECT_EQ(resolved("package P type T interface I { var v : P::T var w : core::nat }")->codes(), "");
    EXPECT_EQ(resolved("package P interface I { var v : Q::T }")->codes(), "RC-N01@1");
}

/// Returns the findings of several files, resolved in the given order.
std::string codes_of(const std::vector<std::string>& texts) {
    testing::Reading reading;
    for (const std::string& text : texts) {
        const auto id = reading.sources.add("t" + std::to_string(reading.sources.size()), text);
        reading.model.files.push_back(parse(reading.sources, id, false, reading.findings));
    }
    resolve(reading.model, reading.findings);
    return reading.codes();
}

TEST(Names, PackagesNeedImportsUnnamedOnesDoNot) {
    const std::string user = "package U interface I { var v : T }";
    EXPECT_EQ(codes_of({user, "package L type T"}), "RC-N01@1");
    EXPECT_EQ(codes_of({user, "type T"}), "");
    EXPECT_EQ(codes_of({user, "package U type T"}), "");
    const std::string importer = "package U import L::* interface I { var v : T }";
    EXPECT_EQ(codes_of({importer, "package L type T"}), "");
    EXPECT_EQ(codes_of({"package L type T", importer}), "");
    EXPECT_EQ(codes_of({"package U import L::T interface I { var v : T }", "package L type T"}), "");
    EXPECT_EQ(codes_of({"package U import L::S interface I { var v : T }", "package L type T"}), "RC-N04@1 RC-N01@1");
    EXPECT_EQ(codes_of({"package U interface I { var v : A::B::T }", "package A::B type T"}), "");
}

TEST(Names, TheFilesOwnDeclarationsComeFirst) {
    testing::Reading reading;
    for (const char* text : {"interface I { event a }",
                             "interface I { event b } stm S { uses I initial i state s { entry b } "
                             "transition t { from i to s } }"}) {
        const auto id = reading.sources.add("t", text);
        reading.model.files.push_back(parse(reading.sources, id, false, reading.findings));
    }
    resolve(reading.model, reading.findings);
    EXPECT_EQ(reading.codes(), "RC-N03@1") << reading.report();
}

/// A package and a controller have the same name, and the controller refers to the machine. The literal path has
/// precedence over the path through the reference (language reference 1.3 has no such paths).
TEST(Names, APathAsWrittenGoesBeforeTheNameOfADefinition) {
    testing::Reading reading;
    const auto add = [&](const char* name, const char* text, bool assertions) {
        const auto id = reading.sources.add(name, text);
        reading.model.files.push_back(parse(reading.sources, id, assertions, reading.findings));
    };
    add("a.rct",
        "package Brain stm Wander { initial i state s { } transition t { from i to s } } "
        "controller Brain { sref wander = Wander }",
        false);
    add("a.assertions",
        "package claims import Brain::* assertion A : Brain::Wander is deadlock-free "
        "assertion B : Brain::wander is deadlock-free assertion C : Brain::Brain::Wander is deadlock-free",
        true);
    resolve(reading.model, reading.findings);
    ASSERT_TRUE(reading.findings.ok()) << reading.report();
    const auto& assertions = reading.model.files.back()->assertions;
    EXPECT_EQ(assertions[0].subject_path.steps.size(), 1U) << "the machine of the package";
    EXPECT_EQ(assertions[1].subject_path.steps.size(), 2U) << "the controller's reference";
    EXPECT_EQ(assertions[2].subject_path.steps.size(), 2U) << "by the name of what is behind it";
}

TEST(Names, AssertionsOfAPackageInAFolderHaveNamesOfTheirOwn) {
    const auto codes = [](const char* second_folder, const char* second) {
        testing::Reading reading;
        for (const auto& [folder, text] :
             {std::pair("/p/", "package c assertion A : S is deadlock-free"), std::pair(second_folder, second)}) {
            const auto id = reading.sources.add("t.assertions", text);
            reading.model.files.push_back(parse(reading.sources, id, true, reading.findings));
            reading.model.files.back()->folder = folder;
        }
        const auto id = reading.sources.add("m.rct", "stm S { initial i state s { } transition t { from i to s } }");
        reading.model.files.push_back(parse(reading.sources, id, false, reading.findings));
        resolve(reading.model, reading.findings);
        return reading.codes();
    };
    EXPECT_EQ(codes("/p/", "package c assertion A : S is divergence-free"), "RC-N03@1");
    EXPECT_EQ(codes("/p/", "package c prob property A : Prob=? of [Finally true]"), "RC-N03@1");
    EXPECT_EQ(codes("/p/", "package d assertion A : S is divergence-free"), "");
    EXPECT_EQ(codes("/q/", "package c assertion A : S is divergence-free"), "");
    EXPECT_EQ(codes("/p/", "package c assertion B : S is divergence-free"), "");
}

TEST(Names, AMachineDoesNotSeeItsController) {
    const auto reading = resolved(
        "controller C {\n var v : nat event e\n stm S {\n initial i\n state s { entry v = 1 ; e }\n transition t { "
        "from i to s "
        "}\n } }");
    EXPECT_EQ(reading->codes(), "RC-N01@5 RC-N01@5");
    EXPECT_NE(reading->report().find("controller `C` has one"), std::string::npos) << reading->report();
}

/// The qualifier before `::` is the declaring element. Any other qualifier is an error.
TEST(Names, QualifiersOfOperationsAndVariablesAreLookedAt) {
    const auto entering = [](const std::string& statement) {
        const auto reading = testing::resolved(
            "package P interface I { op(p : nat) } interface V { var v : nat } stm S { requires I uses V "
            "event e : nat initial i state s { entry " +
            statement + " } transition t { from i to s } }");
        return reading->findings.error_count();
    };
    for (const char* right : {"op(1)", "I::op(1)", "P::I::op(1)", "e?v", "e?V::v", "e?P::V::v"})
        EXPECT_EQ(entering(right), 0U) << right;
    for (const char* wrong : {"V::op(1)", "X::op(1)", "Q::I::op(1)", "e?I::v", "e?X::v", "e?Q::V::v"})
        EXPECT_EQ(entering(wrong), 1U) << wrong;
}

TEST(Names, SuggestsWhatWasMeant) {
    const auto reading = resolved("type Colour interface I { var v : Color }");
    ASSERT_EQ(reading->findings.sorted_findings().size(), 1U);
    ASSERT_EQ(reading->findings.sorted_findings()[0].fixes.size(), 1U);
    EXPECT_EQ(reading->findings.sorted_findings()[0].fixes[0].replacement, "Colour");
}

TEST(Names, ManyUnknownNamesStayCheap) {
    std::string text = "interface I {\n";
    for (int i = 0; i < 5'000; ++i)
        text += "var v" + std::to_string(i) + " : T" + std::to_string(i) + " const c" + std::to_string(i) +
                " : nat = q" + std::to_string(i) + "\n";
    EXPECT_EQ(resolved(text + "}")->findings.error_count(), 10'000U);
}

const Transition& transition_of(const Machine& machine, const std::string& name) {
    const auto found = std::ranges::find_if(machine.transitions, [&](const auto& t) { return t->name == name; });
    return **found;
}

TEST(Names, SinceEntryLooksBreadthFirst) {
    const auto reading = resolved(R"(stm S {
        initial i
        state a { initial i state s { initial i state deep { } transition t { from i to deep } } transition t { from i to s } }
        state s { }
        transition t { from i to a }
        transition u { from a to s condition sinceEntry(s) > 1 }
        transition v { from s to s condition sinceEntry(a::s) > 1 }
    })");
    EXPECT_EQ(reading->codes(), "RC-U01@6 TE5@7") << reading->report();
    const auto& machine = dynamic_cast<const Machine&>(*reading->file().declarations[0]);
    const auto* outer = transition_of(machine, "u").condition->args[0]->target;
    EXPECT_EQ(outer, machine.nodes[2].get());
    EXPECT_EQ(transition_of(machine, "v").condition->args[0]->target, machine.nodes[1]->nodes[1].get());
}

TEST(Names, EveryFieldIsFilled) {
    const auto reading = resolved(R"(interface Ops { op ( p : nat ) }
        interface Events { event e : nat clock T }
        operation op ( p : nat ) { }
        stm S {
            requires Ops uses Events
            var x : nat
            initial i
            state s { entry op ( x ) ; #T ; e ! x }
            transition t { from i to s }
            transition u { from s to s trigger e ? x #T condition since ( T ) > x }
        }
        controller C { uses Events opref o = op sref s = S connection C on e to s on e [ mult ] })");
    // C10: a machine must declare its clocks. RC-U01: time in conditions.
    EXPECT_EQ(reading->codes(), "RC-U01@10 C10@12") << reading->report();
    EXPECT_EQ(reading->dumped(true).find("-> nothing"), std::string::npos) << reading->dumped(true);
    const auto& machine = dynamic_cast<const Machine&>(*reading->file().declarations[3]);
    EXPECT_EQ(machine.interfaces[0].target, reading->file().declarations[0].get());
    const Transition& transition = transition_of(machine, "u");
    EXPECT_EQ(transition.trigger->variable_target, machine.variables[0].get());
    EXPECT_EQ(transition.trigger->event_target->parent, reading->file().declarations[1].get());
    EXPECT_EQ(transition.resets[0].clock, transition.condition->args[0]->target);
    const Stmt& call = *machine.nodes[1]->actions[0].statement->body[0];
    EXPECT_EQ(call.declaration->parent, reading->file().declarations[0].get());
    EXPECT_EQ(transition.parent, &machine);
    const auto& controller = dynamic_cast<const Component&>(*reading->file().declarations[4]);
    EXPECT_EQ(controller.references[1]->target, &machine);
    EXPECT_EQ(controller.connections[0]->to.node_target, controller.references[1].get());
    EXPECT_EQ(controller.connections[0]->from.node_target, &controller);
}

}  // namespace
}  // namespace robochart::frontend
