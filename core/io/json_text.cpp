#include "io/json_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>
#include <utility>

#include "base/error.hpp"

namespace talus {
namespace {

constexpr int deepest_nesting = 64;  // a project needs 6; bounds the recursion over the parsed text

std::string line_and_column(const std::string& text, std::size_t offset) {
  const auto line_start = offset == 0 ? std::string::npos : text.rfind('\n', offset - 1);
  const auto column = line_start == std::string::npos ? offset + 1 : offset - line_start;
  return line_text(text, offset) + ", column " + std::to_string(column);
}

bool part_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.' || c == '_';
}

/// How many letters, digits, signs and points stand just before `offset` when it is itself one of them.
std::size_t letters_before(const std::string& text, std::size_t offset) {
  if (offset >= text.size() || !part_of_word(text[offset])) return 0;
  std::size_t begin = offset;
  while (begin > 0 && part_of_word(text[begin - 1])) --begin;
  return offset - begin;
}

/// What the writer took for one word.
std::string word_at(const std::string& text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && part_of_word(text[end])) ++end;
  return text.substr(begin, std::min<std::size_t>(end - begin, 40));
}

bool means_not_finite(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  word.erase(0, word.find_first_not_of("+-"));
  return word == "nan" || word == "inf" || word == "infinity";
}

/// The library's own words without its numbering: "unexpected ']'; expected …".
std::string plain_words(std::string message) {
  if (const auto dash = message.find(" - "); dash != std::string::npos) message.erase(0, dash + 3);
  if (const auto last_read = message.find("; last read"); last_read != std::string::npos) {
    const auto next = message.find(';', last_read + 1);
    message.erase(last_read, next == std::string::npos ? next : next - last_read);
  }
  std::replace(message.begin(), message.end(), ';', ',');
  return message;
}

/// Reads the text once to find its first fault; the value is built afterwards.
class FaultFinder {
 public:
  explicit FaultFinder(const std::string& text) : text_(text) {}

  bool null() { return true; }
  bool boolean(bool) { return true; }
  bool number_integer(OrderedJson::number_integer_t) { return true; }
  bool number_unsigned(OrderedJson::number_unsigned_t) { return true; }
  bool number_float(OrderedJson::number_float_t, const std::string&) { return true; }
  bool string(std::string&) { return true; }
  bool binary(OrderedJson::binary_t&) { return true; }
  bool key(std::string&) { return true; }
  bool start_object(std::size_t) { return deeper(); }
  bool start_array(std::size_t) { return deeper(); }
  bool end_object() { return --depth_, true; }
  bool end_array() { return --depth_, true; }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& error) {
    const std::size_t offset = start_of(token, std::min(position == 0 ? 0 : position - 1, text_.size()));
    const std::string place = line_and_column(text_, offset);
    const std::string word = word_at(text_, offset);
    if (means_not_finite(word)) throw InputError(place, "'" + word + "' is not a number", "give a finite number");
    if (error.id == 406) throw InputError(place, "the number " + word + " is too large", "give one below 1.8e308");
    if (offset >= text_.size()) {
      throw InputError(place, "the text ends before the project does", "close what is open: '}', ']' or '\"'");
    }
    if ((text_[offset] == '}' || text_[offset] == ']') && comes_after_comma(offset)) {
      throw InputError(place, "a comma stands before the closing '" + text_.substr(offset, 1) + "'",
                       "remove the comma or add what is missing");
    }
    const std::string words = plain_words(error.what());
    if (words == "unexpected string literal, expected '}'" || words == "unexpected string literal, expected ']'") {
      throw InputError(place, "a comma is missing before this text", "put a comma behind what stands before it");
    }
    throw InputError(place, "this is not JSON: " + words, "look for a missing comma, quote or bracket just before");
  }

 private:
  /// The library tells where it stopped and what it read since it last began a word; a person looks for the start.
  std::size_t start_of(const std::string& token, std::size_t last) const {
    const bool is_text = token.starts_with('"') && token.find('"', 1) >= token.size() - 1;
    if (!is_text || last + 1 < token.size()) return last - letters_before(text_, last);
    const std::size_t first = last + 1 - token.size();
    return text_.compare(first, token.size(), token) == 0 ? first : last;
  }

  bool deeper() {
    if (++depth_ <= deepest_nesting) return true;
    throw InputError("the text", "is nested deeper than " + std::to_string(deepest_nesting) + " levels",
                     "a project needs no more than a few; check the brackets");
  }

  bool comes_after_comma(std::size_t offset) const {
    const auto before = text_.find_last_not_of(" \t\r\n", offset - 1);
    return offset > 0 && before != std::string::npos && text_[before] == ',';
  }

  const std::string& text_;
  int depth_ = 0;
};

std::size_t end_of_string(const std::string& text, std::size_t quote) {
  std::size_t i = quote + 1;
  while (text[i] != '"') i += text[i] == '\\' ? 2 : 1;
  return i + 1;
}

/// Walks over a text that is known to be JSON and notes where things stand.
class SpanFinder {
 public:
  explicit SpanFinder(const std::string& text) : text_(text) {}

  JsonSpan root() {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
    skip();
    JsonSpan span;
    span.start = at_;
    value(span);
    return span;
  }

 private:
  void skip() { at_ = skip_white_space_and_comments(text_, at_); }

  void value(JsonSpan& span) {
    span.begin = at_;
    const char first = text_[at_];
    if (first == '{')
      members(span);
    else if (first == '[')
      elements(span);
    else if (first == '"')
      string();
    else
      while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '+' ||
                                    text_[at_] == '-' || text_[at_] == '.'))
        ++at_;
    span.end = at_;
  }

  void members(JsonSpan& span) {
    std::set<std::string> keys;
    for (open(); text_[at_] != '}'; next()) {
      JsonSpan member;
      member.start = at_;
      string();
      member.key = OrderedJson::parse(text_.substr(member.start, at_ - member.start)).get<std::string>();
      if (!keys.insert(member.key).second) {
        throw InputError(line_and_column(text_, member.start), "the key '" + member.key + "' is given twice",
                         "keep one of the two");
      }
      skip();
      ++at_;  // the colon
      skip();
      value(member);
      span.children.push_back(std::move(member));
    }
    ++at_;
  }

  /// A zero would end a name early wherever a library takes texts as C does.
  void string() {
    const std::size_t begin = at_;
    at_ = end_of_string(text_, at_);
    for (std::size_t i = begin; i < at_; ++i) {
      if (text_[i] != '\\') continue;
      if (text_.compare(i, 6, "\\u0000") == 0)
        throw InputError(line_and_column(text_, i), "\\u0000 stands in a text", "remove it");
      ++i;  // what is escaped, a backslash perhaps
    }
  }

  void elements(JsonSpan& span) {
    for (open(); text_[at_] != ']'; next()) {
      JsonSpan element;
      element.start = at_;
      value(element);
      span.children.push_back(std::move(element));
    }
    ++at_;
  }

  void open() {
    ++at_;
    skip();
  }

  void next() {
    skip();
    if (text_[at_] != ',') return;
    ++at_;
    skip();
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

std::string unescaped(const std::string& token) {
  std::string key;
  for (std::size_t i = 0; i < token.size(); ++i) {
    if (token[i] == '~' && i + 1 < token.size())
      key += token[++i] == '1' ? '/' : '~';
    else
      key += token[i];
  }
  return key;
}

/// The child that a pointer's token names, or nothing.
const JsonSpan* child(const JsonSpan& span, const std::string& token) {
  const bool list = !span.children.empty() && span.children.front().start == span.children.front().begin;
  if (list) {  // without a search: lists may be long
    std::size_t index = 0;
    const auto [end, problem] = std::from_chars(token.data(), token.data() + token.size(), index);
    const bool whole = problem == std::errc{} && end == token.data() + token.size();
    return whole && index < span.children.size() ? &span.children[index] : nullptr;
  }
  const std::string key = unescaped(token);
  const auto named = std::ranges::find(span.children, key, &JsonSpan::key);
  return named == span.children.end() ? nullptr : &*named;
}

}  // namespace

JsonText parse_json_text(std::string text) {
  if (const auto zero = text.find('\0'); zero != std::string::npos) {
    throw InputError(line_and_column(text, zero), "there is a zero byte: this is no UTF-8 text",
                     "open a .talus file, or save it as UTF-8");
  }
  if (skip_white_space_and_comments(text, 0) >= text.size()) {
    throw InputError("line 1", "the text is empty", "a project begins with { \"talus\": 1, …");
  }
  FaultFinder faults(text);
  OrderedJson::sax_parse(text, &faults, OrderedJson::input_format_t::json, true, true);
  JsonText json{std::move(text), {}, {}};
  json.root = SpanFinder(json.text).root();
  json.value = OrderedJson::parse(json.text, nullptr, true, true);
  return json;
}

std::size_t skip_white_space_and_comments(const std::string& text, std::size_t offset) {
  while (offset < text.size()) {
    if (std::string_view(" \t\r\n").find(text[offset]) != std::string_view::npos)
      ++offset;
    else if (text.compare(offset, 2, "//") == 0)
      offset = std::min(text.find_first_of("\r\n", offset), text.size());
    else if (text.compare(offset, 2, "/*") == 0) {
      const auto close = text.find("*/", offset + 2);
      offset = close == std::string::npos ? text.size() : close + 2;
    } else
      break;
  }
  return offset;
}

std::string line_text(const std::string& text, std::size_t offset) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
  return "line " + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

std::size_t offset_in_text(const JsonText& json, const std::string& pointer) {
  const JsonSpan* span = &json.root;
  std::size_t begin = 1;
  while (begin < pointer.size()) {
    const auto end = std::min(pointer.find('/', begin), pointer.size());
    const JsonSpan* inner = child(*span, pointer.substr(begin, end - begin));
    if (!inner) break;
    span = inner;
    begin = end + 1;
  }
  return span->start;
}

std::string place_in_text(const JsonText& json, const std::string& pointer) {
  return line_text(json.text, offset_in_text(json, pointer)) + ", " + pointer;
}

}  // namespace talus
