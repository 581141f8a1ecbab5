#include "geometry/mesher_process.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "base/error.hpp"
#include "base/installed.hpp"
#include "geometry/waiting_mesher.hpp"

namespace talus {
namespace {

std::filesystem::path find_mesher() {
  if (const char* named = std::getenv("TALUS_MESHER")) return named;
  for (const std::filesystem::path& candidate :
       {program_folder() / "talus-mesher", installed_or("libexec/talus/talus-mesher", TALUS_MESHER_BUILT)})
    if (access(candidate.c_str(), X_OK) == 0) return candidate;
  throw std::runtime_error("the program talus-mesher is not beside this program; set TALUS_MESHER to its path");
}

std::string_view bytes_of(const MessageHeader& header) {
  return {reinterpret_cast<const char*>(&header), sizeof header};
}

}  // namespace

MesherProcess::MesherProcess(MessageKind kind, const std::string& bytes)
    : program_(find_mesher()), socket_(begin_mesher_job(program_, bytes_of(header_of(kind, bytes)))) {
  socket_.send(bytes);
}

MesherProcess::~MesherProcess() {
  socket_.finish();               // it ends, and closes its end
  constexpr int patience = 1000;  // ms, for what cannot be ended in the middle of writing to a disk
  char unread[4096];
  while (socket_.wait(patience) && socket_.read(unread, sizeof unread) > 0) {
  }
}

void MesherProcess::send(MessageKind kind, const std::string& bytes) {
  socket_.send(bytes_of(header_of(kind, bytes)));
  socket_.send(bytes);
}

std::optional<MesherProcess::Message> MesherProcess::receive() {
  const auto receive_exactly = [this](char* into, std::size_t size) {
    while (size > 0) {
      const std::size_t count = socket_.read(into, size);
      if (count == 0) return false;
      into += count;
      size -= count;
    }
    return true;
  };
  MessageHeader header;
  if (!receive_exactly(reinterpret_cast<char*>(&header), sizeof header)) return std::nullopt;
  if (!is_understood(header))
    throw InputError(program_.string(), "is the mesher of another version of Talus",
                     std::getenv("TALUS_MESHER") ? "unset TALUS_MESHER, or set it to the mesher of this version"
                                                 : "install Talus again, with both");
  Message message{header.kind, std::string(header.size, '\0')};
  if (!receive_exactly(message.bytes.data(), message.bytes.size())) return std::nullopt;
  return message;
}

}  // namespace talus
