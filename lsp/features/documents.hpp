// Notifications about texts, files and folders (LSP 3.17, text document synchronization).
#pragma once

#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

void did_initialize(Session&, const Json& params);
void did_open(Session&, const Json& params);
/// Changes with a range are applied one after the other, each to the result of the one before.
void did_change(Session&, const Json& params);
void did_close(Session&, const Json& params);
void did_save(Session&, const Json& params);
void did_change_watched_files(Session&, const Json& params);
void did_change_folders(Session&, const Json& params);

}  // namespace robochart::lsp
