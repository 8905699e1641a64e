// SPDX-License-Identifier: Apache-2.0
// The formats of logs (docs/traces.md).
#pragma once

namespace robochart::simulation {

enum class LogFormat {
    text,
    mcap,  ///< recordings of rosbag2
};

}  // namespace robochart::simulation
