// SPDX-License-Identifier: Apache-2.0
// Evaluates small scripts, and returns outcomes of assertions, values or errors.
#pragma once

#include <gtest/gtest.h>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {

inline std::vector<refine::Outcome> outcomes(const std::string& text) {
    Reading reading(text);
    (void)check_types(reading.script, reading.diagnostics);
    EXPECT_TRUE(reading.ok()) << reading.report();
    std::vector<refine::Outcome> result;
    try {
        Session session(reading.script);
        for (const DeclPtr& assertion : session.assertions()) {
            result.push_back(session.check(*assertion, {}).verdict.outcome);
        }
    } catch (const EvaluationError& error) {
        ADD_FAILURE() << reading.sources.path_and_line(error.span) << " " << error.what();
    }
    return result;
}

// Checks the outcomes of the assertions: in `marks`, h means holds and f means fails.
inline void expect_outcomes(const std::string& text, const std::string& marks) {
    std::string found;
    for (const refine::Outcome outcome : outcomes(text)) found += outcome_letter(outcome);
    EXPECT_EQ(found, marks) << text;
}

struct Failure {
    std::string message;
    std::size_t stack = 0;
};

inline Failure failure_of(const std::string& text, const std::string& name) {
    const Reading reading(text);
    EXPECT_TRUE(reading.ok()) << reading.report();
    try {
        Session session(reading.script);
        return {"no error: " + session.evaluate(build::name(name)), 0};
    } catch (const EvaluationError& error) {
        return {error.what(), error.stack.size()};
    }
}

/// Returns the error that occurs when the process X is explored.
inline std::string process_failure(const std::string& text) {
    const Reading reading(text + "assert X :[deadlock free]\n");
    EXPECT_TRUE(reading.ok()) << reading.report();
    try {
        Session session(reading.script);
        (void)session.check(*session.assertions().back(), {});
        return "no error";
    } catch (const EvaluationError& error) {
        EXPECT_TRUE(error.span.is_known()) << "no place: " << error.what();
        return error.what();
    }
}

inline std::string value(const std::string& text) {
    const Reading reading("x = " + text + "\n");
    EXPECT_TRUE(reading.ok()) << reading.report();
    try {
        return Session(reading.script).evaluate(build::name("x"));
    } catch (const EvaluationError& error) {
        return std::string("error: ") + error.what();
    }
}

}  // namespace robochart::cspm::test
