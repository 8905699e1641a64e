// SPDX-License-Identifier: Apache-2.0
// Tests that the generators produce every construct in the table of constructs, alone and in every composition in the
// table. If a new construct of the table is not generated, the test fails.
#include "tests/frontend/syntax/constructs.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "features.hpp"
#include "frontend/project/occurrences.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/syntax/any_syntax.hpp"
#include "tests/random_models/syntax/structure.hpp"

namespace robochart::random_models {
namespace {

namespace table = frontend::testing;

void add_rows(const std::vector<table::Row>& rows, const table::Frame& frame, const char* path, Features& features) {
    for (const table::Row& row : rows) {
        const auto read = parse({{path, frame(row.text)}});
        ASSERT_EQ(read->findings.error_count(), 0U) << row.text << "\n" << read->report();
        add_features(structure_text(*read->model.files.front()), features);
    }
}

/// Returns the features of the rows for `.rct` files.
Features of_models() {
    Features features;
    add_rows(table::atoms(), table::as_guard, "t.rct", features);
    add_rows(table::operators(), table::as_guard, "t.rct", features);
    add_rows(table::types(), table::as_type, "t.rct", features);
    add_rows(table::statements(), table::as_entry, "t.rct", features);
    add_rows(table::clauses(), table::as_clauses, "t.rct", features);
    add_rows(table::declarations(), table::as_file, "t.rct", features);
    return features;
}

TEST(Constructs, AnySyntaxReachesTheTable) {
    Features made;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) add_features(structure_text(*any_syntax(seed)), made);
    const Features expected = of_models();
    EXPECT_EQ(lacking(expected.constructs, made.constructs), "");
    EXPECT_EQ(lacking(expected.compositions, made.compositions), "");
}

TEST(Constructs, AnyAssertionsReachTheTable) {
    Features expected;
    add_rows(table::assertions(), table::as_file, "t.assertions", expected);
    Features made;
    for (std::uint64_t seed = 0; seed < 15000; ++seed) add_features(structure_text(*any_assertions(seed)), made);
    EXPECT_EQ(lacking(expected.constructs, made.constructs), "");
    EXPECT_EQ(lacking(expected.compositions, made.compositions), "");
}

/// Returns features in the table that no model without errors has.
const std::map<std::string, std::string>& never_well_formed() {
    static const std::map<std::string, std::string> reasons = {
        {"controller/0", "C1: at least one machine"},
        {"module > stm", "M: machines stand in controllers"},
        {"record-type/0", "DT: at least one field"},
        {"stm/0", "STM3: exactly one initial node"},
        {"tuple/0", "its type cannot be written, so nothing holds it"},
    };
    return reasons;
}

/// Returns whether a composition is one of declarations. All of these must be generated. Expressions have too many
/// compositions.
bool declares(const std::string& composition) {
    static const std::set<std::string> owners = {"clauses",   "controller", "enumeration", "function-declaration",
                                                 "interface", "literal",    "module",      "operation",
                                                 "platform",  "signature",  "state",       "stm"};
    return composition.find(" > ") != std::string::npos &&
           owners.contains(composition.substr(0, composition.find(' ')));
}

TEST(Constructs, WellFormedModelsReachWhatCanBeWellTyped) {
    Features made;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const auto read = parse(well_formed(seed));
        for (const auto& file : read->model.files) add_features(structure_text(*file), made);
    }
    Features expected = of_models();
    for (const std::string& composition : expected.compositions)
        if (declares(composition)) expected.constructs.insert(composition);
    expected.constructs.insert({"function > product", "relation > product"});
    made.constructs.merge(made.compositions);
    for (const auto& [construct, reason] : never_well_formed()) {
        EXPECT_EQ(expected.constructs.erase(construct), 1U) << construct << " is not in the table";
        EXPECT_FALSE(made.constructs.contains(construct)) << construct << " is made after all: " << reason;
    }
    EXPECT_EQ(lacking(expected.constructs, made.constructs), "");
}

TEST(Constructs, WellFormedModelsCallEveryToolkitFunction) {
    std::set<std::string> called;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const auto loaded = load(well_formed(seed));
        for (const frontend::Occurrence& found : frontend::find_occurrences(loaded->model))
            if (found.target != nullptr && found.target->kind == frontend::DeclKind::function)
                called.insert(found.target->name);
    }
    std::set<std::string> functions;
    for (const frontend::Toolkit& toolkit : frontend::all_toolkits()) {
        const auto read = parse({{"toolkit.rct", std::string(toolkit.text)}});
        for (const auto& declaration : read->model.files.front()->declarations)
            if (declaration->kind == frontend::DeclKind::function) functions.insert(declaration->name);
    }
    EXPECT_GE(functions.size(), 50U);
    EXPECT_EQ(lacking(functions, called), "");
}

}  // namespace
}  // namespace robochart::random_models
