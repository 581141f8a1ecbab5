#pragma once

#include <string>
#include <vector>

#include "io/json_format.hpp"
#include "io/json_text.hpp"

namespace talus {

/// The text around one member or element of an object or list.
struct JsonPiece {
  std::string lead;  ///< white space and comments before it
  std::string gap;   ///< between it and its comma
  std::string tail;  ///< comments behind its comma (or behind it when it is the last) on the same line
};

/// The text of an object or list without its members or elements.
struct JsonPieces {
  char open = '{', close = '}';
  std::string head;  ///< comments behind the opening bracket on the same line
  std::vector<JsonPiece> items;
  std::string foot;  ///< white space and comments before the closing bracket
  bool one_item_a_line = false;
  std::size_t indent = 0;  ///< spaces before items that stand on lines of their own
};

/// Spaces and tabs at the start of the line that holds `offset`, counted.
std::size_t indent_at(const std::string& text, std::size_t offset);

JsonPieces split_json(const std::string& text, const JsonSpan& span);

/// Puts an object or list together again from kept and new items, in any order.
class JsonAssembly {
 public:
  JsonAssembly(const JsonPieces& pieces, const JsonLayout& layout);

  /// An item of the old text with what stood around it; `text` is the item itself.
  void keep(std::size_t old_index, const std::string& text);
  /// A new item.
  void add(const std::string& text);

  std::string text() const;

 private:
  struct Item {
    std::string text;
    JsonPiece around;
  };

  std::string margin() const;

  const JsonPieces& pieces_;
  const JsonLayout& layout_;
  std::vector<Item> items_;
};

}  // namespace talus
