#pragma once

#include <memory>
#include <string>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/peers/process/peer_session.h>

namespace graze::compare {

/// Makes an engine that is asked over pipes, in as many processes as there are threads that ask it
/// at once: what crashes or hangs there is the engine's error, and its globals are nobody else's. A
/// process that failed is ended, and the next question starts another. Many threads may ask it.
/// Questions must be plain (Question::is_plain) and one of any, pairs, distance, within, contacts,
/// first_contact and free.
std::unique_ptr<Engine> make_process_engine(PeerProgram program);

/// Returns the program of an engine of this project's adaptors, in graze-peer.
PeerProgram built_in_peer(const std::string& name, const PeerSettings& settings);

/// Returns the program that a line for the shell starts.
PeerProgram program_of_command(const std::string& command, const PeerSettings& settings);

}  // namespace graze::compare
