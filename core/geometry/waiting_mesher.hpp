#pragma once

#include <filesystem>
#include <string_view>

#include "base/socket.hpp"

namespace talus {

/// Hands a job to the program talus-mesher by its first bytes, of which there must be one. Returns the socket to who
/// does it, a process of its own: it ends once the job is done, or this end is closed. The program is started with the
/// first job, whose socket is its standard input, and waits for the others, for each of which it forks: what a start
/// costs, most of it the search for names in ninety libraries, is paid once. Any thread may call this. Throws
/// std::system_error when the program does not start.
Socket begin_mesher_job(const std::filesystem::path& program, std::string_view first_bytes);

/// The program that waits is ended, and waited for, as at the end of this one. The next job starts another.
void end_waiting_mesher();

}  // namespace talus
