#include "io/project_file.hpp"

#include <stdexcept>
#include <string>

#include "fuzz/given.hpp"

// What is read as a project is written so that it reads as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace talus;
  const std::string text(fuzz::text_of(bytes, size));
  fuzz::allow_refusal([&] {
    const Project project = parse_project(text);
    const std::string written = write_project(project);
    if (!(parse_project(written) == project)) throw std::logic_error("a project is not as it was written");
    write_project(project, text);
  });
  fuzz::allow_refusal([&] { parse_project(text, {.allow_outside = true, .unfinished = true}); });
  return 0;
}
