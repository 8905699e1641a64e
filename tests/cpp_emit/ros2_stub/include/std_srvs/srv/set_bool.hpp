// SPDX-License-Identifier: Apache-2.0
// std_srvs/srv/SetBool, for tests.
#pragma once

#include <string>

namespace std_srvs::srv {

struct SetBool {
    struct Request {
        bool data{};
    };
    struct Response {
        bool success{};
        std::string message{};
    };
};

}  // namespace std_srvs::srv
