#include "io/json_merge.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "io/json_format.hpp"
#include "io/json_pieces.hpp"

namespace talus {
namespace {

/// For each element of `after`, the element of `before` it was, each used once.
std::vector<std::optional<std::size_t>> match_elements(const OrderedJson& before, const OrderedJson& after) {
  std::vector<std::optional<std::size_t>> match(after.size());
  std::vector<bool> used(before.size(), false);
  const auto pair = [&](std::size_t i, std::size_t j) {
    match[i] = j;
    used[j] = true;
  };
  const auto is_object = [](const OrderedJson& item) { return item.is_object(); };
  const bool things = std::any_of(after.begin(), after.end(), is_object);
  if (!things && before.size() == after.size()) {  // a vector, a list of vertices: places matter, not values
    for (std::size_t i = 0; i < after.size(); ++i) pair(i, i);
    return match;
  }
  // What is equal from both ends: one insertion or removal leaves all others in place.
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t front = 0, back = 0;
  for (; front < shorter && before[front] == after[front]; ++front) pair(front, front);
  while (front + back < shorter && before[before.size() - 1 - back] == after[after.size() - 1 - back]) {
    pair(after.size() - 1 - back, before.size() - 1 - back);
    ++back;
  }
  const auto pair_where = [&](const auto& same) {
    for (std::size_t i = front; i < after.size() - back; ++i) {
      for (std::size_t j = front; j < before.size() - back && !match[i]; ++j) {
        if (!used[j] && same(before[j], after[i])) pair(i, j);
      }
    }
  };
  const auto name = [](const OrderedJson& value) {
    return value.is_object() && value.contains("name") ? value.at("name") : OrderedJson();
  };
  pair_where([](const OrderedJson& a, const OrderedJson& b) { return a == b; });
  pair_where([&](const OrderedJson& a, const OrderedJson& b) { return !name(a).is_null() && name(a) == name(b); });
  if (before.size() == after.size()) {
    for (std::size_t i = front; i < after.size() - back; ++i) {
      if (!match[i] && !used[i]) pair(i, i);
    }
  }
  return match;
}

class Merger {
 public:
  Merger(const std::string& text, JsonLayout layout) : text_(text), layout_(std::move(layout)) {}

  std::string value(const JsonSpan& span, const OrderedJson& before, const OrderedJson& after) const {
    if (before == after) return text_.substr(span.begin, span.end - span.begin);
    if (is_bare(span)) return format_json(after, indent_at(text_, span.start), layout_);
    if (before.is_object() && after.is_object()) return members(span, before, after);
    if (before.is_array() && after.is_array()) return elements(span, before, after);
    return format_json(after, indent_at(text_, span.start), layout_);
  }

 private:
  /// "{}" and "[]" on lines of their own have neither layout nor comments to be kept.
  bool is_bare(const JsonSpan& span) const {
    const bool is_empty = text_.find_first_not_of(" \t\r\n", span.begin + 1) == span.end - 1;
    const std::size_t line = text_.rfind('\n', span.start) + 1;
    return is_empty && line + indent_at(text_, span.start) == span.start;
  }

  std::string elements(const JsonSpan& span, const OrderedJson& before, const OrderedJson& after) const {
    const JsonPieces pieces = split_json(text_, span);
    const auto match = match_elements(before, after);
    JsonAssembly assembly(pieces, layout_);
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (match[i]) {
        assembly.keep(*match[i], value(span.children[*match[i]], before[*match[i]], after[i]));
      } else {
        assembly.add(format_json(after[i], pieces.indent, layout_));
      }
    }
    return assembly.text();
  }

  std::string members(const JsonSpan& span, const OrderedJson& before, const OrderedJson& after) const {
    const JsonPieces pieces = split_json(text_, span);
    JsonAssembly assembly(pieces, layout_);
    for (const auto& key : key_order(span, before, after)) {
      const auto old = find(span, key);
      if (!old) {
        if (const auto renamed = find_renamed(span, key, before, after))
          assembly.keep(*renamed, quoted(key) + behind_key(span.children[*renamed]));
        else
          assembly.add(quoted(key) + ": " + format_json(after.at(key), pieces.indent, layout_));
        continue;
      }
      const JsonSpan& member = span.children[*old];
      const std::string head = text_.substr(member.start, member.begin - member.start);
      if (!after.contains(key)) {  // an empty list or the like that means the same as nothing
        assembly.keep(*old, text_.substr(member.start, member.end - member.start));
      } else if (before.contains(key)) {
        assembly.keep(*old, head + value(member, before.at(key), after.at(key)));
      } else {
        assembly.keep(*old, head + format_json(after.at(key), pieces.indent, layout_));
      }
    }
    return assembly.text();
  }

  static std::optional<std::size_t> find(const JsonSpan& span, const std::string& key) {
    const auto found = std::find_if(span.children.begin(), span.children.end(),
                                    [&](const JsonSpan& child) { return child.key == key; });
    if (found == span.children.end()) return std::nullopt;
    return static_cast<std::size_t>(found - span.children.begin());
  }

  /// The member that has another key in `before`, and else is the one that `key` has in `after`.
  static std::optional<std::size_t> find_renamed(const JsonSpan& span, const std::string& key,
                                                 const OrderedJson& before, const OrderedJson& after) {
    if (before.contains(key)) return std::nullopt;
    for (std::size_t i = 0; i < span.children.size(); ++i) {
      const std::string& old = span.children[i].key;
      if (before.contains(old) && !after.contains(old) && before.at(old) == after.at(key)) return i;
    }
    return std::nullopt;
  }

  /// From the colon, or a comment before it, to the end of the value.
  std::string behind_key(const JsonSpan& member) const {
    std::size_t quote = member.start + 1;
    while (text_[quote] != '"') quote += text_[quote] == '\\' ? 2 : 1;
    return text_.substr(quote + 1, member.end - quote - 1);
  }

  /// The author's order as long as `after` only changes, adds and removes; the order of `after` where it moves keys
  /// that both have. An added key goes behind the one it follows in `after`.
  static std::vector<std::string> key_order(const JsonSpan& span, const OrderedJson& before, const OrderedJson& after) {
    std::vector<std::string> common_before, common_after, order;
    for (const auto& [key, value] : before.items()) {
      if (after.contains(key)) common_before.push_back(key);
    }
    for (const auto& [key, value] : after.items()) {
      if (before.contains(key)) common_after.push_back(key);
    }
    if (common_before == common_after) {
      for (const auto& child : span.children) {
        if (after.contains(child.key) || !before.contains(child.key)) order.push_back(child.key);
      }
    }
    std::string previous;
    for (const auto& [key, value] : after.items()) {
      const bool left_out = !find(span, key) && before.contains(key) && before.at(key) == value;
      if (left_out) continue;
      if (std::find(order.begin(), order.end(), key) == order.end()) {
        const auto anchor = std::find(order.begin(), order.end(), previous);
        order.insert(previous.empty() ? order.begin() : anchor == order.end() ? anchor : anchor + 1, key);
      }
      previous = key;
    }
    return order;
  }

  const std::string& text_;
  JsonLayout layout_;
};

}  // namespace

std::string merge_json(const JsonText& old, const OrderedJson& before, const OrderedJson& after) {
  JsonLayout layout;
  if (old.text.find("\r\n") != std::string::npos) layout.newline = "\r\n";
  const Merger merger(old.text, layout);
  return old.text.substr(0, old.root.begin) + merger.value(old.root, before, after) + old.text.substr(old.root.end);
}

}  // namespace talus
