#include "geometry/mesher_job.hpp"

namespace talus {

std::uint64_t layout_of_messages(std::string_view version) {
  ByteLayout layout;
  const auto add = [&]<class... Messages>(Messages... messages) { layout(messages...); };
  add(MesherJob(), MesherCutAhead(), MesherCutModel(), MesherSizes(), SolidSurface(), MesherProgress(), MesherBlock(),
      MesherEnd(), MesherError(), MesherFault());
  std::uint64_t hash = layout.hash();
  for (const char letter : version) hash = hash_with(hash, static_cast<unsigned char>(letter));
  return hash;
}

MessageHeader header_of(MessageKind kind, const std::string& bytes) {
  return {layout_of_messages(TALUS_VERSION), kind, bytes.size()};
}

bool is_understood(const MessageHeader& header) { return header.layout == layout_of_messages(TALUS_VERSION); }

}  // namespace talus
