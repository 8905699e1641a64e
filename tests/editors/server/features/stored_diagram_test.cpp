// SPDX-License-Identifier: Apache-2.0
// Tests the diagram next to the text with the layout that was drawn in RoboTool, if the project has its file. The
// server loads the layout again when the file changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tests/editors/server/client.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::lsp {
namespace {

using testing::Client;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* drawn_machine = "stm S { initial i state A { } transition t { from i to A } }\n";

/// Returns a file with the machine's state at this place and its initial junction at the left.
std::string drawn_at(int x) {
    const auto element = [](const std::string& id, const std::string& name, const std::string& path,
                            const std::string& mapping) {
        return fmt::format(
            "<ownedDiagramElements uid=\"{}\" name=\"{}\"><target href=\"a.rct#//@machines.0{}\"/>"
            "<actualMapping href=\"x[name='{}']\"/></ownedDiagramElements>",
            id, name, path, mapping);
    };
    return "<XMI xmlns:xmi=\"m\"><d:DSemanticDiagram xmlns:d=\"d\">" + element("s", "S", "", "StateMachineID") +
           element("n", "", "", "NodesID") + element("i", "i", "/@nodes.0", "InitialID") +
           element("a", "A", "/@nodes.1", "StateID") +
           "<ownedAnnotationEntries><data xmi:type=\"notation:Diagram\"><children type=\"2002\" element=\"s\">"
           "<children type=\"3008\" element=\"n\"><children type=\"3007\" element=\"i\"><layoutConstraint y=\"9\"/>"
           "</children>" +
           fmt::format("<children type=\"3008\" element=\"a\"><layoutConstraint x=\"{}\"/></children>", x) +
           "</children></children></data></ownedAnnotationEntries></d:DSemanticDiagram></XMI>";
}

class StoredDiagram : public ::testing::Test {
protected:
    StoredDiagram() {
        folder_.write("a.rct", drawn_machine);
        client_.open(uri(), drawn_machine);
    }

    [[nodiscard]] std::string uri() const { return uri_of_path(folder_.in("a.rct")); }
    void store(const std::string& text) const { folder_.write("representations.aird", text); }
    std::string svg() {
        return client_
            .request("robochart/diagram",
                     Json::object({{"textDocument", Json::object({{"uri", uri()}})}, {"component", "S"}}))["svg"]
            .text();
    }

    Client client_;

private:
    tests::TemporaryFolder folder_;
};

/// The area of nodes is 5 pixels inside the frame, which is 14 pixels inside the picture.
TEST_F(StoredDiagram, IsWhereAPersonDrewIt) {
    const std::string own = svg();
    EXPECT_THAT(own, Not(HasSubstr("x=\"619\"")));
    store(drawn_at(600));
    EXPECT_THAT(svg(), HasSubstr("x=\"619\""));
    store(drawn_at(1000));
    EXPECT_THAT(svg(), HasSubstr("x=\"1019\"")) << "the file has changed";
    store("<XMI");
    EXPECT_EQ(svg(), own) << "no diagram can be read";
}

TEST_F(StoredDiagram, StaysInEdits) {
    store(drawn_at(600));
    client_.change(uri(), "stm S { initial i state New { } state A { } transition t { from i to A } }\n");
    EXPECT_THAT(svg(), HasSubstr("x=\"619\""));
}

}  // namespace
}  // namespace robochart::lsp
