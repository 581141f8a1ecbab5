#include "io/json_pieces.hpp"

#include <algorithm>

namespace talus {
namespace {

std::size_t skip_blanks(const std::string& text, std::size_t offset) {
  return std::min(text.find_first_not_of(" \t", offset), text.size());
}

bool is_line_end(const std::string& text, std::size_t offset) {
  return offset >= text.size() || text[offset] == '\n' || text[offset] == '\r';
}

/// Where the comments end that follow `offset` on its line; `offset` itself when something else follows them there,
/// for then they belong to that.
std::size_t end_of_line_comments(const std::string& text, std::size_t offset) {
  std::size_t at = offset;
  while (true) {
    const std::size_t next = skip_blanks(text, at);
    if (text.compare(next, 2, "//") == 0) return std::min(text.find_first_of("\r\n", next), text.size());
    if (text.compare(next, 2, "/*") != 0) return is_line_end(text, next) ? at : offset;
    at = text.find("*/", next + 2) + 2;
  }
}

bool ends_in_line_comment(const std::string& text) {
  const auto line = text.find_last_of("\r\n");
  std::size_t at = line == std::string::npos ? 0 : line + 1;
  // Only white space and comments are asked about here, so that a slash pair outside /* */ opens a line comment.
  for (at = skip_blanks(text, at); at < text.size(); at = skip_blanks(text, at)) {
    if (text.compare(at, 2, "//") == 0) return true;
    const auto close = text.find("*/", at);
    if (close == std::string::npos) return false;
    at = close + 2;
  }
  return false;
}

bool is_white(const std::string& text) { return text.find_first_not_of(" \t\r\n") == std::string::npos; }

bool starts_new_line(const std::string& text) { return !text.empty() && (text[0] == '\n' || text[0] == '\r'); }

}  // namespace

std::size_t indent_at(const std::string& text, std::size_t offset) {
  const auto line = offset == 0 ? std::string::npos : text.find_last_of("\r\n", offset - 1);
  const std::size_t begin = line == std::string::npos ? 0 : line + 1;
  return skip_blanks(text, begin) - begin;
}

JsonPieces split_json(const std::string& text, const JsonSpan& span) {
  JsonPieces pieces;
  pieces.open = text[span.begin];
  pieces.close = text[span.end - 1];
  const auto slice = [&](std::size_t begin, std::size_t end) { return text.substr(begin, end - begin); };

  std::size_t at = end_of_line_comments(text, span.begin + 1);
  pieces.head = slice(span.begin + 1, at);
  for (const auto& child : span.children) {
    JsonPiece piece;
    piece.lead = slice(at, child.start);
    at = child.end;
    const std::size_t separator = skip_white_space_and_comments(text, child.end);
    if (text[separator] == ',') {
      piece.gap = slice(child.end, separator);
      at = separator + 1;
    }
    const std::size_t tail = end_of_line_comments(text, at);
    piece.tail = slice(at, tail);
    at = tail;
    pieces.items.push_back(std::move(piece));
  }
  pieces.foot = slice(at, span.end - 1);

  pieces.one_item_a_line = pieces.foot.find_first_of("\r\n") != std::string::npos;
  for (const auto& item : pieces.items) pieces.one_item_a_line |= item.lead.find_first_of("\r\n") != std::string::npos;
  const std::size_t own = indent_at(text, span.begin);
  pieces.indent = own + JsonLayout().step;
  const auto first_on_own_line = std::find_if(span.children.begin(), span.children.end(), [&](const JsonSpan& child) {
    return text.substr(span.begin, child.start - span.begin).find_first_of("\r\n") != std::string::npos;
  });
  if (first_on_own_line != span.children.end()) pieces.indent = indent_at(text, first_on_own_line->start);
  return pieces;
}

JsonAssembly::JsonAssembly(const JsonPieces& pieces, const JsonLayout& layout) : pieces_(pieces), layout_(layout) {}

std::string JsonAssembly::margin() const { return std::string(layout_.newline) + std::string(pieces_.indent, ' '); }

void JsonAssembly::keep(std::size_t old_index, const std::string& text) {
  JsonPiece around = pieces_.items[old_index];
  // White space alone belongs to the position, not to the item: [1, 2] without its first is [2], not [ 2].
  if (is_white(around.lead)) {
    if (items_.empty() && is_white(pieces_.items.front().lead)) around.lead = pieces_.items.front().lead;
    if (!items_.empty() && old_index == 0 && !pieces_.one_item_a_line) around.lead = " ";
  }
  items_.push_back({text, around});
}

void JsonAssembly::add(const std::string& text) {
  JsonPiece around;
  if (pieces_.one_item_a_line)
    around.lead = margin();
  else if (!items_.empty())
    around.lead = " ";
  items_.push_back({text, around});
}

std::string JsonAssembly::text() const {
  std::string out(1, pieces_.open);
  out += pieces_.head;
  std::string before = pieces_.head;  // white space and comments since the last thing that is neither
  const auto append = [&](const std::string& blank) {
    if (ends_in_line_comment(before) && !starts_new_line(blank)) out += margin();
    out += blank;
    before = blank;
  };
  for (std::size_t i = 0; i < items_.size(); ++i) {
    append(items_[i].around.lead);
    if (ends_in_line_comment(before)) out += margin();
    out += items_[i].text;
    before.clear();
    append(items_[i].around.gap);
    if (i + 1 < items_.size()) {
      if (ends_in_line_comment(before)) out += margin();
      out += ',';
      before.clear();
    }
    append(items_[i].around.tail);
  }
  append(pieces_.foot);
  if (ends_in_line_comment(before)) out += margin();
  return out + pieces_.close;
}

}  // namespace talus
