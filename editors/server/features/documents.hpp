// SPDX-License-Identifier: Apache-2.0
// Notifications about texts, files and folders (LSP 3.17, text document synchronization).
#pragma once

#include "editors/server/workspace/session.hpp"

namespace robochart::lsp {

void did_initialize(Session&, View params);
void did_open(Session&, View params);
/// Changes with a range are applied in order, each to the result of the one before.
void did_change(Session&, View params);
void did_close(Session&, View params);
void did_save(Session&, View params);
void did_change_watched_files(Session&, View params);
void did_change_folders(Session&, View params);

}  // namespace robochart::lsp
