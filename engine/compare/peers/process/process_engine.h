#pragma once

#include <memory>
#include <string>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/peers/process/peer_session.h>

namespace graze::compare {

/// An engine that is asked over pipes, in as many processes as there are threads that ask it at
/// once: what crashes or hangs there is the engine's error, and its globals are nobody else's. A
/// process that failed is ended, and the next question starts another. Safe to ask from many
/// threads. What it is asked about must be plain (Question::is_plain) and of the questions any,
/// pairs, distance, within, contacts, first_contact and free.
std::unique_ptr<Engine> make_process_engine(PeerProgram program);

/// An engine of this project's adaptors, in graze-peer.
PeerProgram built_in_peer(const std::string& name, const PeerSettings& settings);

/// What a line for the shell starts.
PeerProgram program_of_command(const std::string& command, const PeerSettings& settings);

}  // namespace graze::compare
