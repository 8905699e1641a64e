// Results as JUnit's XML, which continuous integration servers read: testsuites, testsuite, testcase with failure,
// error or skipped, and only attributes that all of their schemas have.
#pragma once

#include <string>
#include <vector>

namespace robochart::app {

/// One result.
struct JunitCase {
    enum class Kind : unsigned char {
        passed,
        failed,   ///< what was claimed is not so
        error,    ///< it is not known whether it is: servers count it as not passed
        skipped,  ///< it was not to be decided
    };
    std::string group;  ///< servers sort by it: a file, "conformance"
    std::string name;
    Kind kind = Kind::passed;
    std::string message;  ///< in a line; "" where it passed
    std::string text;     ///< in full; where it passed: what else is to be said, or ""
    double seconds = 0;
};

/// One document with one suite of this name.
[[nodiscard]] std::string junit_document(const std::string& suite, const std::vector<JunitCase>& cases);

}  // namespace robochart::app
