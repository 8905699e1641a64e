// SPDX-License-Identifier: Apache-2.0
// Tests faulty mappings and their findings. Each row contains one mistake, whose place was counted by hand.
#include <fmt/format.h>

#include <fstream>

#include "base/diagnostics/splitmix64.hpp"
#include "cpp_emit/ros2/messages.hpp"
#include "cpp_emit/ros2/ros_names.hpp"
#include "tests/cpp_emit/models.hpp"
#include "tests/cpp_emit/ros2/package.hpp"

namespace robochart::cpp_emit::ros2::mapping_test {
namespace {

const char* const model_text = R"(package p
enumeration Light { Red Green }
datatype Point { x : real y : real }
interface I { move(lv : real, av : real) stop() lamp(l : Light) goal(at : Point) count(n : nat) flag(b : boolean)
    all(s : Seq(nat)) var level : int }
interface T { turn() }
interface E { event obstacle : real event seen : Point event bump event done : nat event list : Seq(nat) }
stm M { requires I requires T uses E var d : real var q : Point var s : Seq(nat) initial i
    state A { entry move(1, 0.25) ; stop() ; lamp(Light::Red) ; goal(q) ; count(1) ; flag(true) ; all(s) ; turn() }
    transition t0 { from i to A }
    transition t1 { from A to A trigger obstacle?d } transition t2 { from A to A trigger bump action done!1 }
    transition t3 { from A to A trigger seen?q action level = 7 } transition t4 { from A to A trigger list?s }
}
operation turn() { initial i final F transition t { from i to F } }
controller C { requires I uses E sref m = M opref turn_ref = turn
    connection C on obstacle to m on obstacle connection C on seen to m on seen
    connection C on bump to m on bump connection m on done to C on done connection C on list to m on list }
)";

/// Returns the findings for one item. Findings for the elements that every mapping here omits are left out.
std::string findings_of(const std::string& item) {
    static const ir::System system = testing::load_model(model_text);
    const Planned planned = emit_package(system, "C", "ros2 for C {\n" + item + "\n}");
    std::string result;
    std::size_t from = 0;
    for (std::size_t end = planned.findings.find('\n'); end != std::string::npos;
         from = end + 1, end = planned.findings.find('\n', from)) {
        const std::string line = planned.findings.substr(from, end - from);
        const bool other = line.starts_with("RC-G14") || line.starts_with("RC-R10");
        if (!other) result += line + "\n";
    }
    return result;
}

struct Row {
    const char* item;
    const char* expected;
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << ::testing::PrintToString(row.item);
}

class WrongMapping : public ::testing::TestWithParam<Row> {};

TEST_P(WrongMapping, IsSaidWithItsPlace) {
    EXPECT_EQ(findings_of(GetParam().item), GetParam().expected) << GetParam().item;
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, WrongMapping,
    ::testing::Values(
        Row{"move", "RC-R01 2:1 expected 'publish', 'receive', 'call', 'on', 'parameter' or '}', found 'move'\n"},
        Row{"publish move", "RC-R01 2:9 expected 'operation', 'event' or 'variable', found 'move'\n"},
        Row{"publish operation move on", "RC-R01 2:24 expected 'as', found 'on'\n"},
        Row{"publish operation stop as Twist on \"t\"", "RC-R01 2:33 expected '/', found 'on'\n"},
        Row{"publish operation stop as std_msgs/Empty on t", "RC-R01 2:45 expected a topic in quotes, found 't'\n"},
        Row{"publish operation stop as std_msgs/Empty on \"t\" with",
            "RC-R01 3:1 expected 'reliable', 'best_effort', 'transient_local', 'volatile' or 'depth', found '}'\n"},
        Row{"publish operation stop as std_msgs/Empty on \"t\" with depth 0",
            "RC-R01 2:60 expected a number from 1 to 10000, found '0'\n"},
        Row{"publish operation stop as std_msgs/Empty on \"t\" with depth 99999999999",
            "RC-R01 2:60 expected a number from 1 to 10000, found '99999999999'\n"},
        Row{"publish operation stop as std_msgs/Empty on \"t\" with reliable best_effort",
            "RC-R03 2:63 the reliability is given twice\n"},
        Row{"publish operation stop as std_msgs/Empty on \"t\" with volatile volatile",
            "RC-R03 2:63 the durability is given twice\n"},
        Row{"publish operation stop as std_msgs/Empty on \"t\" with depth 1 depth 2",
            "RC-R03 2:68 the depth is given twice\n"},
        Row{"receive event list as my_msgs/List on \"t\" { value = data capacity 0 }",
            "RC-R01 2:67 expected a number from 1 to 65536, found '0'\n"},
        Row{"receive event list as my_msgs/List on \"t\" { value = data capacity 65537 }",
            "RC-R01 2:67 expected a number from 1 to 65536, found '65537'\n"},
        Row{"receive event list as my_msgs/List on \"t\" { value = data capacity -1 }",
            "RC-R01 2:67 expected a number from 1 to 65536, found '-'\n"},
        Row{"receive event list as my_msgs/List on \"t\" { value = data capacity many }",
            "RC-R01 2:67 expected a number from 1 to 65536, found 'many'\n"}));

INSTANTIATE_TEST_SUITE_P(
    Calls, WrongMapping,
    ::testing::Values(
        Row{"call event bump as action nav2_msgs/NavigateToPose on \"n\"",
            "RC-R04 2:12 'bump' is not a valid name of a called element: only an operation calls a service or an "
            "action\n"},
        Row{"call operation stop as cancel goal", "RC-R01 2:31 expected 'of', found 'goal'\n"},
        Row{"call operation stop as cancel of move",
            "RC-R02 2:34 the mapping has no operation that calls an action 'move'\n"},
        Row{"call operation turn as std_srvs/Trigger on \"t\"",
            "RC-R02 2:16 'C' has no operation to publish 'turn'; the model defines it, so it runs as modelled\n"},
        Row{"call operation stop as action nav2_msgs/NavigateToPose on \"n\" { pose.position.x = 1.0 }",
            "RC-R05 2:70 the message geometry_msgs/PoseStamped has no field 'position'\n"},
        Row{"call operation stop as nav2_msgs/action/NavigateToPose on \"n\" receive event bump as answer of stop",
            "RC-R02 2:95 the mapping has no operation that calls a service 'stop'\n"},
        Row{"call operation stop as std_srvs/Trigger on \"n\" receive event bump as succeeded of stop",
            "RC-R02 2:83 the mapping has no operation that calls an action 'stop'\n"},
        Row{"call operation stop as action nav2_msgs/NavigateToPose on \"n\" receive event bump as accepted of stop "
            "when "
            "x == 1",
            "RC-R01 2:102 expected 'publish', 'receive', 'call', 'on', 'parameter' or '}', found 'when'\n"},
        Row{"call operation stop as action nav2_msgs/NavigateToPose on \"n\" receive event obstacle as feedback of "
            "stop "
            "{ value = remaining }",
            "RC-R07 2:77 no field of the message provides 'value' of event 'obstacle'\n"
            "RC-R05 2:116 the message nav2_msgs/NavigateToPose_Feedback has no field 'remaining'\n"},
        Row{"parameter SPEED as \"speed\"", "RC-R02 2:11 'C' has no constant without a value 'SPEED'\n"},
        Row{"parameter SPEED as \"a b\"",
            "RC-R04 2:20 'a b' is not a valid name of a parameter: it may contain only letters, digits, underscores, "
            "and "
            "dots between its parts\n"},
        Row{"parameter SPEED as \"cycle\"",
            "RC-R04 2:20 'cycle' is not a valid name of a parameter: it is a parameter of the node itself\n"}));

INSTANTIATE_TEST_SUITE_P(
    Names, WrongMapping,
    ::testing::Values(
        Row{"publish operation mvoe as std_msgs/Empty on \"t\"",
            "RC-R02 2:19 'C' has no operation to publish 'mvoe'; did you mean 'move'?\n"},
        Row{"publish operation turn as std_msgs/Empty on \"t\"",
            "RC-R02 2:19 'C' has no operation to publish 'turn'; the model defines it, so it runs as modelled\n"},
        Row{"publish event obstacle as std_msgs/Empty on \"t\"",
            "RC-R02 2:15 'C' has no event to publish 'obstacle'; write 'receive event obstacle'\n"},
        Row{"receive variable obstacle as std_msgs/Empty on \"t\"",
            "RC-R02 2:18 'C' has no variable to receive 'obstacle'; write 'receive event obstacle'\n"},
        Row{"receive operation stop as std_msgs/Empty on \"t\"",
            "RC-R04 2:19 'stop' is not a valid name of a received element: the controller calls its operations "
            "itself\n"},
        Row{"publish operation stop as std_msgs/Empty on \"t\" publish operation stop as std_msgs/Empty on \"u\"",
            "RC-R03 2:67 operation 'stop' is given twice\n"},
        Row{"publish operation move as geometry_msgs/Twist on \"cmd_vel\" { linear.x = lw angular.z = av }",
            "RC-R08 2:19 no field of the message contains 'lv' of operation 'move'\n"
            "RC-R02 2:73 operation 'move' has no parameter 'lw'; did you mean 'lv'?\n"},
        Row{"publish operation goal as geometry_msgs/Point on \"t\" { x = at.x y = at.z }",
            "RC-R08 2:19 no field of the message contains 'at.y' of operation 'goal'\n"
            "RC-R02 2:72 operation 'goal' has no field 'z'\n"},
        Row{"receive event obstacle as sensor_msgs/Range on \"t\" { vlaue = range }",
            "RC-R07 2:15 no field of the message provides 'value' of event 'obstacle'\n"
            "RC-R02 2:54 event 'obstacle' has no value 'vlaue'; did you mean 'value'?\n"},
        Row{"receive event bump as sensor_msgs/Range on \"t\" { value = range }",
            "RC-R02 2:50 event 'bump' has no value 'value'\n"}));

INSTANTIATE_TEST_SUITE_P(
    NamesOfRos, WrongMapping,
    ::testing::Values(
        Row{"publish operation stop as Std_msgs/Empty on \"t\"",
            "RC-R04 2:27 'Std_msgs' is not a valid name of a package: it must begin with a small letter\n"},
        Row{"publish operation stop as std__msgs/Empty on \"t\"",
            "RC-R04 2:27 'std__msgs' is not a valid name of a package: it must not contain a double underscore or end "
            "with an underscore\n"},
        Row{"publish operation stop as class/Empty on \"t\"",
            "RC-R04 2:27 'class' is not a valid name of a package: it is reserved in C++\n"},
        Row{"publish operation stop as my_msgs/empty on \"t\"",
            "RC-R04 2:35 'empty' is not a valid name of a message: it must begin with a capital letter\n"},
        Row{"publish operation stop as my_msgs/Em_pty on \"t\"",
            "RC-R04 2:35 'Em_pty' is not a valid name of a message: it may contain only letters and digits\n"},
        Row{"publish operation stop as std_msgs/Empty on \"\"",
            "RC-R04 2:45 '' is not a valid name of a topic: it is empty\n"},
        Row{"publish operation stop as std_msgs/Empty on \"a//b\"",
            "RC-R04 2:45 'a//b' is not a valid name of a topic: it must not contain an empty part\n"},
        Row{"publish operation stop as std_msgs/Empty on \"a/\"",
            "RC-R04 2:45 'a/' is not a valid name of a topic: it must end with a name\n"},
        Row{"publish operation stop as std_msgs/Empty on \"a/2b\"",
            "RC-R04 2:45 'a/2b' is not a valid name of a topic: no part may begin with a digit\n"},
        Row{"publish operation stop as std_msgs/Empty on \"a__b\"",
            "RC-R04 2:45 'a__b' is not a valid name of a topic: it must not contain a double underscore\n"},
        Row{"publish operation stop as std_msgs/Empty on \"~a\"",
            "RC-R04 2:45 '~a' is not a valid name of a topic: it may contain only letters, digits, underscores and /, "
            "and ~/ at the beginning\n"},
        Row{"publish operation stop as std_msgs/Empty on \"a{node}\"",
            "RC-R04 2:45 'a{node}' is not a valid name of a topic: it may contain only letters, digits, underscores "
            "and /, and ~/ at the beginning\n"},
        Row{"publish operation stop as std_msgs/Empty on \"/rosout\"",
            "RC-R04 2:45 '/rosout' is not a valid name of a topic: it is a topic of ROS itself\n"},
        Row{"publish operation stop as my_msgs/Foo on \"t\" { class = 1 }",
            "RC-R04 2:48 'class' is not a valid name of a field: it is reserved in C++\n"},
        Row{"publish operation stop as my_msgs/Foo on \"t\" { a.Big = 1 }",
            "RC-R04 2:50 'Big' is not a valid name of a field: it must begin with a small letter\n"}));

INSTANTIATE_TEST_SUITE_P(
    Fields, WrongMapping,
    ::testing::Values(
        Row{"publish operation stop as geometry_msgs/Twist on \"t\" { linaer.x = 1 }",
            "RC-R05 2:56 the message geometry_msgs/Twist has no field 'linaer'; did you mean 'linear'?\n"},
        Row{"publish operation stop as geometry_msgs/Twist on \"t\" { linear.w = 1 }",
            "RC-R05 2:63 the message geometry_msgs/Vector3 has no field 'w'\n"},
        Row{"publish operation stop as std_msgs/Int8 on \"t\" { data.x = 1 }",
            "RC-R05 2:55 the message int8 has no field 'x'\n"},
        Row{"publish operation stop as geometry_msgs/Twist on \"t\" { linear.x = 1 linear.x = 2 }",
            "RC-R03 2:69 the field 'linear.x' is given twice\n"},
        Row{"receive event seen as geometry_msgs/Point on \"t\" { value.x = x value.x = y value.y = y }",
            "RC-R03 2:64 'value.x' is given twice\n"},
        Row{"receive event seen as geometry_msgs/Point on \"t\" { value.x = x }",
            "RC-R07 2:15 no field of the message provides 'value.y' of event 'seen'\n"},
        Row{"publish operation stop as geometry_msgs/Twits on \"t\"",
            "RC-R11 2:27 the fields of geometry_msgs/Twits are not known here; did you mean 'Twist'?\n"},
        Row{"publish operation stop as my_msgs/Foo on \"t\" { anything = 1 }",
            "RC-R11 2:27 the fields of my_msgs/Foo are not known here\n"}));

INSTANTIATE_TEST_SUITE_P(
    Types, WrongMapping,
    ::testing::Values(
        Row{"publish operation lamp as std_msgs/Bool on \"t\" { data = l }",
            "RC-R08 2:19 no field of the message contains 'l' of operation 'lamp'\n"
            "RC-R06 2:57 'l' is an enumeration Light, and the field 'data' is a bool\n"},
        Row{"publish operation flag as std_msgs/Int8 on \"t\" { data = b }",
            "RC-R08 2:19 no field of the message contains 'b' of operation 'flag'\n"
            "RC-R06 2:57 'b' is a boolean, and the field 'data' is a int8\n"},
        Row{"publish operation goal as geometry_msgs/PointStamped on \"t\" { point = at }",
            "RC-R08 2:19 no field of the message contains 'at.x' of operation 'goal'\n"
            "RC-R08 2:19 no field of the message contains 'at.y' of operation 'goal'\n"
            "RC-R06 2:71 'at' is a record Point, and the field 'point' is a message geometry_msgs/Point\n"},
        Row{"publish operation all as std_msgs/Float64MultiArray on \"t\" { data = s }",
            "RC-R08 2:19 no field of the message contains 's' of operation 'all'\n"
            "RC-R06 2:69 's' is a Seq(nat), and the field 'data' is an array float64[]\n"},
        Row{"receive event obstacle as std_msgs/String on \"t\" { value = data }",
            "RC-R07 2:15 no field of the message provides 'value' of event 'obstacle'\n"
            "RC-R06 2:52 'value' is a real, and the field 'data' is a string\n"},
        Row{"receive event list as std_msgs/Int8 on \"t\"",
            "RC-R07 2:15 no field of the message provides 'value' of event 'list'\n"},
        Row{"receive event obstacle as sensor_msgs/Range on \"t\" { value = range capacity 3 }",
            "RC-R06 2:68 a capacity is for an array, and the field 'range' is a float32\n"},
        Row{"publish operation stop as std_msgs/UInt8 on \"t\" { data = 256 }",
            "RC-R06 2:58 the value is out of its range, and the field 'data' is a uint8\n"},
        Row{"publish operation stop as std_msgs/UInt64 on \"t\" { data = -1 }",
            "RC-R06 2:59 the value is out of its range, and the field 'data' is a uint64\n"},
        Row{"publish operation stop as std_msgs/Int8 on \"t\" { data = 0.5 }",
            "RC-R06 2:57 the value is a number, and the field 'data' is a int8\n"},
        Row{"publish operation stop as std_msgs/Int8 on \"t\" { data = now }",
            "RC-R06 2:57 the value is a time, and the field 'data' is a int8\n"},
        Row{"publish operation stop as std_msgs/Int8 on \"t\" { data = true }",
            "RC-R06 2:57 the value is a truth value, and the field 'data' is a int8\n"},
        Row{"publish operation stop as std_msgs/Int8 on \"t\" { data = \"x\" }",
            "RC-R06 2:57 the value is a text, and the field 'data' is a int8\n"},
        Row{"receive event bump as std_msgs/Bool on \"t\" when data < true",
            "RC-R06 2:56 the value is no number, or the field is none; only numbers are ordered, and the field 'data' "
            "is "
            "a bool\n"},
        Row{"receive event bump as std_msgs/Bool on \"t\" when data == 1",
            "RC-R06 2:57 the value is no value that can be equal to the field, and the field 'data' is a bool\n"},
        Row{"receive event bump as std_msgs/Int8 on \"t\" when data == other",
            "RC-R06 2:57 the value is no value that can be equal to the field, and the field 'data' is a int8\n"},
        Row{"receive event bump as std_msgs/Bool on \"t\" when date == true",
            "RC-R05 2:49 the message std_msgs/Bool has no field 'date'; did you mean 'data'?\n"},
        Row{"receive event bump as std_msgs/Bool on \"t\" when data = true",
            "RC-R01 2:54 expected '==', '!=', '<', '<=', '>' or '>=', found '='\n"},
        Row{"receive event bump as std_msgs/Bool on \"t\"",
            "RC-R12 2:15 every std_msgs/Bool raises 'bump', regardless "
            "of the contents of 'data'\n"},
        Row{"receive event bump as deadline 0.5 on \"t\"", "RC-R02 2:39 the mapping has no received topic 't'\n"},
        Row{"receive event bump as deadline 0 on \"t\"",
            "RC-R04 2:32 '0' is not a valid name of a deadline: it must be from 0.001 to 3600 seconds\n"},
        Row{"receive event bump as answer of stop",
            "RC-R02 2:33 the mapping has no operation that calls a service 'stop'\n"},
        Row{"call operation stop as std_srvs/Trigger on \"t\"\nreceive event bump as answer of stop when done == true",
            "RC-R05 3:43 the message std_srvs/Trigger_Response has no field 'done'\n"},
        Row{"call event bump as std_srvs/Trigger on \"t\"",
            "RC-R04 2:12 'bump' is not a valid name of a called element: only an operation calls a service or an "
            "action\n"},
        Row{"call operation stop as std_srvs/Trigger on \"t\"\ncall operation flag as std_srvs/SetBool on \"/t\" { "
            "data = "
            "b }",
            "RC-R09 3:44 'flag' cannot be on topic '/t' with 'stop': it is a service\n"},
        Row{"receive event obstacle as deadline 1 on \"t\"",
            "RC-R02 2:15 'C' has no event without a value to receive 'obstacle'\n"},
        Row{"on deactivate publish geometry_msgs/Twist on \"t\" { linear.x = lv }",
            "RC-R02 2:63 operation 'deactivate' has no parameter 'lv'\n"}));

INSTANTIATE_TEST_SUITE_P(
    Topics, WrongMapping,
    ::testing::Values(
        Row{"publish operation stop as std_msgs/Empty on \"t\"\nreceive event bump as std_msgs/Empty on \"/t\"",
            "RC-R09 3:41 'bump' cannot be on topic '/t' with 'stop': one is published, and the other is received\n"},
        Row{"publish operation stop as std_msgs/Empty on \"t\"\npublish event done as std_msgs/Int8 on \"t\" { data = "
            "value }",
            "RC-R09 3:40 'done' cannot be on topic 't' with 'stop': one is std_msgs/Empty and the other "
            "std_msgs/Int8\n"},
        Row{"publish operation stop as std_msgs/Int8 on \"t\" with depth 3\npublish event done as std_msgs/Int8 on "
            "\"t\" "
            "{ data = value }",
            "RC-R09 3:40 'done' cannot be on topic 't' with 'stop': they differ in quality of service\n"},
        Row{"publish operation stop as std_msgs/Empty on \"/c/state\"",
            "RC-R09 2:45 'stop' cannot be on topic '/c/state' with 'state': one is std_msgs/String and the other "
            "std_msgs/Empty\n"}));

INSTANTIATE_TEST_SUITE_P(
    Right, WrongMapping,
    ::testing::Values(
        Row{"publish operation count as std_msgs/Float32 on \"t\" { data = n }", ""},
        Row{"publish operation flag as std_msgs/Bool on \"t\" { data = b }", ""},
        Row{"publish operation lamp as std_msgs/UInt8 on \"t\" { data = l }", ""},
        Row{"receive event obstacle as std_msgs/msg/Int32 on \"t\" { value = data }", ""},
        Row{"publish operation stop as std_msgs/Int8 on \"t\" { data = -128 }", ""},
        Row{"receive event bump as std_msgs/Bool on \"t\" when data == true", ""},
        Row{"receive event bump as std_msgs/String on \"t\" when data != \"x\" and data != \"y\"", ""},
        Row{"on deactivate publish geometry_msgs/Twist on \"t\"", ""},
        Row{"call operation stop as std_srvs/Trigger on \"t\"\nreceive event bump as answer of stop when success == "
            "true",
            ""},
        Row{"call operation flag as std_srvs/srv/SetBool on \"t\" { data = b }\nreceive event bump as deadline 2 of "
            "flag",
            ""},
        Row{"publish operation stop as geometry_msgs/TwistStamped on \"~/t\" with best_effort volatile depth 3 "
            "{ header.stamp = now header.frame_id = \"x\" twist.linear.x = -0.5 }",
            ""}));

/// Text with a meaning in C++, CMake, XML, YAML, Python or a shell is rejected as a name. In a literal it is data.
TEST(HostileMapping, DoesNotReachTheCode) {
    for (const char* const name : {"t\\\"); abort(); (\\\"", "$(touch x)", "a;b", "<evil/>", "a b", "a\\nb", "../x",
                                   "a'b", "@CLASS@", "%s", "é"}) {
        const std::string findings =
            findings_of(fmt::format("publish operation stop as std_msgs/Empty on \"{}\"", name));
        EXPECT_TRUE(findings.starts_with("RC-R04 2:45")) << name << "\n" << findings;
    }
    const ir::System system = testing::load_model(
        "interface I { stop() } stm M { requires I initial i state A { entry stop() } transition t { from i to A } }");
    const Planned planned = emit_package(
        system, "M",
        "ros2 for M { publish operation stop as std_msgs/String on \"t\" { data = \"a\nb?\?/\x01*/\\\" @CLASS@\" } }");
    std::string code;
    for (const OutputFile& file : planned.emission.files)
        if (file.path == "include/robot_m/M_messages.hpp") code = file.text;
    EXPECT_NE(code.find("message.data = \"a\\012b\\077\\077/\\001*/\\134\\042 @CLASS@\";"), std::string::npos) << code;
}

/// The test changes, removes and doubles characters and words of mappings. Each mapping is rejected with a finding, or
/// the package is generated. In a generated package, changed text stays within its name or literal.
TEST(HostileMapping, ChangedAtRandomIsRefusedOrWritten) {
    const ir::System system = testing::load_model(
        "enumeration L { A B } datatype P { x : real l : L } interface I { move(p : P, n : nat) var v : real }\n"
        "interface E { event e : P event f : boolean event g : int }\n"
        "stm M { requires I uses E var p : P var b : boolean initial i state S { entry move(p, 1) ; v = 1 }\n"
        "transition t { from i to S } transition u { from S to S trigger e?p action g!1 }\n"
        "transition w { from S to S trigger f?b } }");
    const std::string whole = R"(ros2 for M { // all of it
    publish operation move as my_msgs/msg/Goal on "~/go" with best_effort depth 3 { x = p.x kind = p.l count = n }
    publish variable v as std_msgs/Float32 on "/v" { data = value }
    publish event g as std_msgs/UInt8 on "g" with transient_local { data = value }
    receive event e as geometry_msgs/PoseStamped on "pose" { value.x = pose.position.x value.l = header.stamp.sec }
    receive event f as std_msgs/Bool on "flag" { value = data } }
)";
    const std::string pieces = "{}=.\"/~:-0a_Z \n@%$\\\t'*\x01\xff";
    std::uint64_t state = 1;
    const auto random = [&state] { return diagnostics::splitmix64(state); };
    std::size_t written = 0, refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::string text = whole;
        for (std::uint64_t changes = 1 + random() % 3; changes > 0; --changes) {
            const std::size_t at = random() % text.size();
            const std::size_t length = std::min<std::size_t>(random() % 12, text.size() - at);
            switch (random() % 4) {
                case 0:
                    text.erase(at, length);
                    break;
                case 1:
                    text.insert(at, text.substr(random() % text.size(), length));
                    break;
                case 2:
                    text[at] = pieces[random() % pieces.size()];
                    break;
                default:
                    text.insert(at, 1, pieces[random() % pieces.size()]);
            }
        }
        const Planned planned = emit_package(system, "M", text);
        ++(planned.emission.files.empty() ? refused : written);
        EXPECT_TRUE(!planned.emission.files.empty() || !planned.findings.empty()) << text;
    }
    EXPECT_GT(written, 100U);
    EXPECT_GT(refused, 100U);
}

TEST(Names, OfRosAreThoseOfRosidl) {
    EXPECT_EQ(header_of_message("Twist"), "twist");
    EXPECT_EQ(header_of_message("BatteryState"), "battery_state");
    EXPECT_EQ(header_of_message("UInt8"), "u_int8");
    EXPECT_EQ(header_of_message("Float64MultiArray"), "float64_multi_array");
    EXPECT_EQ(header_of_message("ColorRGBA"), "color_rgba");
    EXPECT_EQ(header_of_message("Point32"), "point32");
    EXPECT_EQ(header_of_message("Pose2D"), "pose2_d");
    EXPECT_EQ(header_of_message("NavSatFix"), "nav_sat_fix");
    EXPECT_EQ(package_name("SwarmTaxis", {}), "swarm_taxis");
    EXPECT_EQ(package_name("M", {}), "robot_m");
    EXPECT_EQ(package_name("GeometryMsgs", {"geometry_msgs"}), "geometry_msgs_controller");
    EXPECT_EQ(package_name("_", {}), "robot");
    EXPECT_EQ(topic_part("a__b_", NameStyle::snake), "a_b");
    EXPECT_EQ(topic_part("callHelp", NameStyle::snake), "call_help");
    EXPECT_EQ(topic_part("callHelp", NameStyle::model), "callHelp");
    EXPECT_EQ(topic_part("goTo__Goal2", NameStyle::snake), "go_to_goal2");
}

/// The package's name differs from those of the packages that it needs.
TEST(Names, OfAPackageAreItsOwn) {
    for (const char* const name : {"Launch", "Rclcpp", "StdMsgs", "Rcl_Interfaces"}) {
        const ir::System system =
            testing::load_model(fmt::format("interface I {{ stop() }} stm {} {{ requires I initial i state A {{ entry "
                                            "stop() }} transition t {{ from i to A }} }}",
                                            name));
        const Planned planned = emit_package(system, name, "");
        std::string text;
        for (const OutputFile& file : planned.emission.files)
            if (file.path == "package.xml") text = file.text;
        EXPECT_NE(text.find("_controller</name>"), std::string::npos) << text;
        EXPECT_FALSE(planned.emission.files.empty());
    }
}

/// The table contains the message type of every field in it, and all names in it are valid.
TEST(Messages, OfTheTableAreWhole) {
    std::size_t fields = 0;
    for (const char* const package :
         {"builtin_interfaces", "std_msgs", "geometry_msgs", "sensor_msgs", "nav_msgs", "ackermann_msgs"}) {
        EXPECT_FALSE(known_messages(package).empty()) << package;
        for (const std::string& type : known_messages(package)) {
            EXPECT_EQ(wrong_message(type), "");
            const MessageName message{package, type, {}};
            for (const std::string& name : fields_of(message.full_name())) {
                EXPECT_EQ(wrong_field(name), "") << type;
                const FoundField found = find_field(message, {{{name, {}}}});
                EXPECT_EQ(found.missing, 1U) << type << " " << name;
                EXPECT_NE(found.type.kind, FieldKind::unknown) << type << " " << name;
                const bool whole = found.type.kind != FieldKind::message || !fields_of(found.type.written).empty();
                EXPECT_TRUE(whole || found.type.written == "std_msgs/MultiArrayLayout") << found.type.written;
                ++fields;
            }
        }
    }
    EXPECT_GT(fields, 100U);
}

}  // namespace
}  // namespace robochart::cpp_emit::ros2::mapping_test
