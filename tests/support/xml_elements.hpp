#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace talus::test {

/// The elements of an XML text in the order in which they begin, by name. Throws std::runtime_error where one is not
/// closed, closes another one, or a character stands that must be an entity: what has none of these is well-formed as
/// far as our files use XML.
inline std::vector<std::string> xml_elements(const std::string& xml) {
  std::vector<std::string> begun, open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) throw std::runtime_error("a tag has no end: " + xml.substr(at, 40));
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos) throw std::runtime_error("< in a tag or text: " + tag.substr(0, 40));
    if (tag.front() == '?' || tag.front() == '!') continue;
    const std::string name = tag.substr(tag.front() == '/', tag.find_first_of(" />", 1) - (tag.front() == '/'));
    if (tag.front() == '/') {
      if (open.empty() || open.back() != name) throw std::runtime_error("</" + name + "> closes nothing");
      open.pop_back();
      continue;
    }
    begun.push_back(name);
    if (tag.back() != '/') open.push_back(name);
  }
  if (!open.empty()) throw std::runtime_error("<" + open.back() + "> is not closed");
  for (std::size_t at = xml.find('&'); at != std::string::npos; at = xml.find('&', at + 1))
    if (xml.find(';', at) > at + 8) throw std::runtime_error("& alone: " + xml.substr(at, 20));
  return begun;
}

}  // namespace talus::test
