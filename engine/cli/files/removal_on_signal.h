#pragma once

namespace graze::cli {

/// Makes SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGXCPU remove files that are half written, and then
/// end the program as they would without; those that are ignored stay so. A file that grows beyond
/// its limit is an error of writing, and no longer a death (SIGXFSZ).
void remove_temporary_files_on_signals();

}  // namespace graze::cli
