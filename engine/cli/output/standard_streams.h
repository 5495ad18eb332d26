#pragma once

namespace graze::cli {

/// Gives back the numbers of standard input, output and error where the caller has closed them:
/// else the next file that is opened would get one, and have written into it whatever the program,
/// or a library, says. What is written to such a stream fails, as it does to a closed one.
void reserve_standard_streams();

}  // namespace graze::cli
