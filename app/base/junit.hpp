// SPDX-License-Identifier: Apache-2.0
// Writes results as JUnit XML, which continuous integration servers read. The elements are testsuites, testsuite and
// testcase with failure, error or skipped. All attributes are defined in the schemas of all servers.
#pragma once

#include <string>
#include <vector>

namespace robochart::app {

/// The result of one case.
struct JunitCase {
    enum class Kind : unsigned char {
        passed,
        failed,   ///< the claim is false
        error,    ///< the answer is unknown; for servers, the case did not pass
        skipped,  ///< no decision was necessary
    };
    std::string group;  ///< the group by which servers sort: a file, or "conformance"
    std::string name;
    Kind kind = Kind::passed;
    std::string message;  ///< one line; "" if it passed
    std::string text;     ///< the full text; if it passed, additional text or ""
    double seconds = 0;
};

/// Returns a document with one suite of this name.
[[nodiscard]] std::string junit_document(const std::string& suite, const std::vector<JunitCase>& cases);

}  // namespace robochart::app
